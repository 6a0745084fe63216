// The answers of a summary once all bricks are in it.
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
  double area, volume;  // in the caller's unit; of what it encloses
  bool is_void;
};

class WholeSet {
 public:
  explicit WholeSet(const SummaryBlock &summary);

  // The first brick that is not in it; no_id if all are.
  uint32_t first_missing() const;
  // Whether what is there makes a union: each component has one outer shell. It does unless bricks lacked balls that
  // meet their own, or the sets are not parts of one. All bricks are in it.
  bool is_sound() const;
  // Of what is complete.
  WholeTotals totals() const;
  // How many there are that are kept, and one of them.
  uint32_t shells() const { return summary_.header().pieces; }
  WholeShell shell(uint32_t k) const;

 private:
  bool is_outer(const ShellPiece &piece, uint32_t k) const {
    return summary_.component(piece.component).top_piece == k;
  }

  const SummaryBlock &summary_;
  SummaryTotals sums_;  // with what is kept
  AreaQuantum quantum_;
  exact::Lattice lattice_;
};

}  // namespace hsp
