// Concave patches with creases, cut by decisions about the actual set: their borders are chained to loops, the loops
// gathered to pieces, and the pieces measured and stored.
#pragma once

#include "surface/concave_patches.hpp"
#include "surface/creases.hpp"
#include "surface/patch_loops.hpp"

namespace hsp {

// The words of 8 bytes for `count` objects of type T.
template <class T>
constexpr uint32_t words_of(uint32_t count) {
  return static_cast<uint32_t>((sizeof(T) + 7) / 8) * count;
}

class CreasedPatches {
 public:
  struct Inputs {
    const ActualBalls &actual;
    const ProbeGrid &grid;
    const CuspedCircles &cusped;
    const Creases &creases;
  };

  // Memory for the borders of one patch: so many words for each arc.
  static constexpr uint32_t words_of_arc = words_of<BorderArc>(1) + words_of<ArcFigures>(1);
  void use(Span<uint64_t> memory) { memory_ = memory; }

  // Fills `cut`, which may overflow. Status::degenerate if borders do not close, or no width tells what they bound.
  // Status::stopped if `patience` stops it.
  Status fill(const Inputs &in, CutPatches &cut, Patience &patience);

  // The arcs around the patch of v, in no order; none if the patch has no crease.
  Span<BorderArc> find_border(const Inputs &in, uint32_t v);

 private:
  void add_sides(const Inputs &in, uint32_t v);
  void push(const Inputs &in, uint32_t across, uint32_t start, uint32_t end);
  // Keeps positions of vertices from patch to patch in the memory from word `first` on, behind borders and figures.
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
