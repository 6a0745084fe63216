// Concave patches with creases: their borders chained to loops, the loops gathered to pieces, these measured and put.
#pragma once

#include "surface/concave_patches.hpp"
#include "surface/creases.hpp"
#include "surface/patch_loops.hpp"

namespace hsp {

// The words of so many T.
template <class T>
constexpr uint32_t words_of(uint32_t count) {
  return static_cast<uint32_t>((sizeof(T) + 7) / 8) * count;
}

class CreasedPatches {
 public:
  struct Inputs {
    const ActualBalls &actual;
    const ChosenFaces &chosen;
    const ProbeGrid &grid;
    const CuspedCircles &cusped;
    Creases &creases;  // whose list of near vertices is used
  };

  // Memory for the borders of one patch: so many words for each arc.
  static constexpr uint32_t words_of_arc = words_of<BorderArc>(1) + words_of<ArcFigures>(1);
  void use(Span<uint64_t> memory) { memory_ = memory; }

  // Status::degenerate if borders do not close, or no width tells what they bound. Cut patches may have no room.
  // Status::stopped if more is not allowed.
  Status fill(const Inputs &in, CutPatches &cut, Patience &patience);

  // The border of the patch of the vertex whose near ones are listed, in no order; none if no crease is there.
  Span<BorderArc> find_border(const Inputs &in, const NearVertices &near, uint32_t v);

 private:
  void add_sides(const Inputs &in, uint32_t v);
  void add_creases(const Inputs &in, const NearVertices &near, uint32_t v);
  void push(const Inputs &in, uint32_t across, uint32_t start, uint32_t end);
  // Behind what borders and figures use, from patch to patch, as long as there is room.
  void keep_vertices(const Inputs &in, uint32_t first);
  Status store_patch(const Inputs &in, uint32_t v, CutPatches &cut);
  void measure_piece(const PatchLoops &loops, uint32_t piece, double &steradians, Vec3 &vector_area,
                     CreaseSums &sums) const;

  Span<uint64_t> memory_;
  uint32_t first_kept_ = 0;
  FixedVector<BorderArc> arcs_;  // of the patch at hand
  Span<ArcFigures> figures_;     // of these
};

}  // namespace hsp
