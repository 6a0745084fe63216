// A way from cell to cell of free space, by A*. A cell is entered at one point, that of the shortest way found to it,
// and left at the portals to its neighbours. Ways inside a cell count as straight.
#pragma once

#include "cells/free_space.hpp"
#include "core/patience.hpp"

namespace hsp {

class CellSearch {
 public:
  void carve(Workspace &workspace, const FreeSpaceLimits &limits);
  // To be called when the cells are built, with portals. False if patience ends.
  bool prepare(const FreeSpace &space, Patience &patience);

  // Finds a way between points of two cells of one region. Status::check if there is none, which cannot happen.
  Status find(const FreeSpace &space, uint32_t from_cell, const exact::Vector &from, uint32_t to_cell,
              const exact::Vector &to, Patience &patience);
  // The next cell of the way; no_id behind the last one.
  uint32_t next(uint32_t cell) const { return visits_[cell].next; }
  // The point at which the way enters a cell.
  const exact::Vector &entry(uint32_t cell) const { return visits_[cell].entry; }

 private:
  struct Visit {
    exact::Vector entry;
    double way;       // length of the way to the entry
    double estimate;  // of the length of the whole way
    uint32_t from;
    uint32_t next;  // during the search: the index in the heap, not_seen or done
  };
  // A run on the lattice; a side without end is far beyond all points.
  struct Box {
    exact::Vector low, high;
  };

  bool comes_first(uint32_t a, uint32_t b) const;
  exact::Vector portal(const FreeSpace &space, uint32_t contact, const exact::Vector &from) const;

  Span<Visit> visits_;    // [cells]
  Span<uint32_t> heap_;   // [cells]
  Span<uint32_t> links_;  // [2 adjacencies] contacts of each cell, in the places of its neighbours
  Span<Box> boxes_;       // [runs]
};

}  // namespace hsp
