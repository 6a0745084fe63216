// The actual set: one set of balls in general position, very near the input. Every decision about creases of the smooth
// surface is the sign of a number of this one set. So no two decisions contradict each other, and the surface is
// closed. Doubles with an error bound decide where they are certain, else floats of 384 to 2,048 bits.
//
// With c the centre of a ball seen from the origin of its component, w = R^2 its weight, and M the quadratic form of
// the boundary's symbolic perturbation (exact/PROOFS.md, section 3), the actual ball has
//   the weight  w (1 + 2^-192) + 2^-460 M(c)    so that the boundary of the actual set is that of the perturbed one
//   the centre  c + 2^-600 (three numbers below 1, pseudo-random functions of c)
// in lattice steps. The centres have to move, too: if they lie in a plane, vertices come in mirrored pairs, and two
// such pairs always lie on one circle. They move so little that no decision of the boundary changes.
#pragma once

#include "core/small_code.hpp"
#include "surface/border_points.hpp"
#include "surface/kept_vertices.hpp"

namespace hsp {

class ActualBalls {
 public:
  // Widths, in bits, of the floats that are tried one after the other where doubles are not certain.
  static constexpr uint32_t widest = 2048, widths[] = {384, 768, 1024, widest};

  ActualBalls(const BallSet &balls, const Boundary &boundary) : balls_(balls), boundary_(boundary) {}

  // Signs are 1 or -1; 0 only where no width decides, which has not been seen.

  // Whether the probes at two vertices overlap.
  int overlap(uint32_t v, uint32_t w) const;
  // Whether the probe at a vertex may cut off something of the patch of another one.
  bool may_cut_patch(uint32_t other, uint32_t v) const;
  // The probes' spheres at vertices a, b and c have two points in common. Returns which of them are in the patch of a
  // and in no other probe of the list `near`: 1 for the point with the negative sign, 2 for the other one, 3 for both,
  // 0 for none. Returns 0 also if no width decides.
  uint32_t corners(uint32_t a, uint32_t b, uint32_t c, Span<const uint32_t> near) const;
  // The same for one point of a crease: whether it is in the patch of vertex point.id[0] and in no probe of the list
  // `near` but that at point.id[1].
  int is_left(const BorderPoint &point, Span<const uint32_t> near) const;
  // A crease of vertices v < w runs counter-clockwise about the axis from v to w. Whether it starts, rather than ends,
  // at a corner, which it has in common with the probe at a third vertex; and at a cusp, if v and w are at the two ends
  // of a covered gap of the cusp's circle.
  static bool starts_at_corner(const BorderPoint &corner, uint32_t v, uint32_t w);
  int starts_at_cusp(const BorderPoint &cusp, uint32_t v, uint32_t w) const;
  // For two points on the circle of the crease of v and w: 1 if the second follows the first within half a turn
  // counter-clockwise about the axis from v to w, else -1.
  int turn(uint32_t v, uint32_t w, const BorderPoint &first, const BorderPoint &second) const;
  // Whether the saddles of two balls' circle reach its axis.
  bool has_cusps(uint32_t a, uint32_t b) const;

  // The vector from a vertex to a point, or to another vertex, in lattice steps. False if its relative error is above
  // 2^-36 in every width.
  bool find_way(uint32_t v, const BorderPoint &point, Vec3 &way) const;
  bool find_way_to_vertex(uint32_t v, uint32_t w, Vec3 &way) const;

  // How many questions were answered by doubles, by floats of some width, and by none.
  struct Answers {
    uint64_t by_doubles = 0, by_floats = 0, by_none = 0;
  };
  const Answers &answers() const { return answers_; }

  // Lends memory in which positions of vertices are kept for later questions. It must have no other use until the next
  // call lends other memory, or none.
  void keep_vertices(Span<uint64_t> memory) const {
    if constexpr (!small_code) kept_ = KeptVertices(memory);
  }

  const BallSet &balls() const { return balls_; }
  const Boundary &boundary() const { return boundary_; }

  // Asks question(points) in doubles, then in each width of floats, and returns the first answer that is not 0.
  // Positions are relative to the centre of `ball`, in the next two functions to that of the vertex's first ball
  // (actual_decisions.hpp).
  template <class Question>
  int decide_about(uint32_t ball, Question question) const;
  // decide_at finds a sign, which is the same in every width that is certain of it: code that has to be small asks
  // floats alone. measure_at finds figures.
  template <class Question>
  int decide_at(uint32_t vertex, Question question) const;
  template <class Question>
  int measure_at(uint32_t vertex, Question question) const;

 private:
  template <class Question>
  int decide_in_floats(uint32_t ball, Question question) const;

  const BallSet &balls_;
  const Boundary &boundary_;
  mutable Answers answers_;
  mutable KeptVertices kept_;
};

}  // namespace hsp
