// The results of a summary that has all bricks.
#pragma once

#include "bricks/summary_block.hpp"
#include "core/span.hpp"
#include "exact/lattice.hpp"

namespace hsp {

struct WholeTotals {
  uint64_t balls, exposed, contained, vertices, arcs, circles, faces, loops, shells, components, voids, tied_vertices;
  int64_t euler;
  double area, volume, void_volume;  // in the caller's unit
};

struct WholeShell {
  uint64_t component;  // the lowest id of its balls
  uint64_t faces;
  int64_t euler;
  double area, volume;  // the area, and the volume that it encloses, in the caller's unit
  bool is_void;
};

class WholeSet {
 public:
  explicit WholeSet(const SummaryBlock &summary);

  // The first brick that is not in the summary; no_id if all are.
  uint32_t first_missing() const;
  // Whether the shells make a union: each component has one outer shell. They do unless some brick lacked balls that
  // meet its own, or the bricks are not parts of one set. Only for a summary with all bricks.
  bool is_sound() const;
  // The sums over complete shells and components.
  WholeTotals totals() const;
  // The shells that were kept.
  uint32_t shells() const { return summary_.header().pieces; }
  WholeShell shell(uint32_t k) const;

 private:
  bool is_outer(const ShellPiece &piece, uint32_t k) const {
    return summary_.component(piece.component).top_piece == k;
  }

  const SummaryBlock &summary_;
  SummaryTotals sums_;  // with the shells and components that are kept
  AreaQuantum quantum_;
  exact::Lattice lattice_;
};

}  // namespace hsp
