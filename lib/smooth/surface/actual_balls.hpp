// One actual set of balls in general position, very near the input: every decision about creases of the smooth surface
// is the sign of a number of this set, so that none of them contradict each other, and the surface is closed. Doubles
// with a bound answer if they are certain, else floats of 384 to 2,048 bits.
//
// With c the centre of a ball seen from the origin of its component, w = R^2 its weight, and M the quadratic form of
// the boundary's symbolic perturbation (exact/PROOFS.md, section 3), the actual ball has
//   the weight  w (1 + 2^-192) + 2^-460 M(c)    so that the boundary of the actual set is that of the perturbed one
//   the centre  c + 2^-600 (three numbers of c, less than 1, without a pattern)
// in lattice steps. Centres have to move, too: for centres in a plane vertices come in pairs, and two such pairs always
// lie on one circle; but so little that no decision of the boundary changes.
#pragma once

#include "core/small_code.hpp"
#include "surface/border_points.hpp"
#include "surface/kept_vertices.hpp"

namespace hsp {

class ActualBalls {
 public:
  // Bits of the floats that are asked one after the other where doubles are not certain.
  static constexpr uint32_t widest = 2048, widths[] = {384, 768, 1024, widest};

  ActualBalls(const BallSet &balls, const Boundary &boundary) : balls_(balls), boundary_(boundary) {}

  // Signs are 1 or -1; 0 only where no width decides, which has not been seen.

  // Whether the probes at two vertices overlap.
  int overlap(uint32_t v, uint32_t w) const;
  // Whether the probe at a vertex may cut off something of the patch of another one.
  bool may_cut_patch(uint32_t other, uint32_t v) const;
  // Which of the two points that the probes at three vertices have in common are in the patch of the first, and in none
  // of the probes near it: 1 for that with the negative sign, 2 for the other one, or both. 0 also if not decided.
  uint32_t corners(uint32_t a, uint32_t b, uint32_t c, Span<const uint32_t> near) const;
  // The same of a point of the crease of a vertex and another one.
  int is_left(const BorderPoint &point, Span<const uint32_t> near) const;
  // Whether the crease of vertices v < w, counter-clockwise about the axis from v to w, starts where it meets the probe
  // at a third vertex, rather than ends; and in a cusp, where v is the vertex at one end of a covered gap of this
  // circle.
  static bool starts_at_corner(const BorderPoint &corner, uint32_t v, uint32_t w);
  int starts_at_cusp(const BorderPoint &cusp, uint32_t v, uint32_t w) const;
  // Of two points on the crease of v and w: whether the second follows the first within half a turn.
  int turn(uint32_t v, uint32_t w, const BorderPoint &first, const BorderPoint &second) const;
  // Whether the saddles of two balls' circle reach its axis.
  bool has_cusps(uint32_t a, uint32_t b) const;

  // The way from a vertex to a point, or to another vertex, in lattice steps. False where no width knows it to 2^-36 of
  // itself.
  bool find_way(uint32_t v, const BorderPoint &point, Vec3 &way) const;
  bool find_way_to_vertex(uint32_t v, uint32_t w, Vec3 &way) const;

  // How many questions were answered by doubles, by floats of some width, and by none.
  struct Answers {
    uint64_t by_doubles = 0, by_floats = 0, by_none = 0;
  };
  const Answers &answers() const { return answers_; }

  // Memory for vertices that are asked for again, as long as nobody else uses it.
  void keep_vertices(Span<uint64_t> memory) const {
    if constexpr (!small_code) kept_ = KeptVertices(memory);
  }

  const BallSet &balls() const { return balls_; }
  const Boundary &boundary() const { return boundary_; }

  // The first answer of question(points) that is not 0, in all widths from doubles on. Points are seen from the centre
  // of a ball, or of the first ball of a vertex (actual_decisions.hpp).
  template <class Question>
  int decide_about(uint32_t ball, Question question) const;
  // A sign, which is the same in every width that knows it: code that has to be small asks floats alone. And figures.
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
