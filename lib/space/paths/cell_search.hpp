// A way from cell to cell of free space, by A*: a cell is entered at one point, that of the least way found to it, and
// left at the portals to its neighbours. Ways inside a cell count as straight.
#pragma once

#include "cells/free_space.hpp"
#include "core/patience.hpp"

namespace hsp {

class CellSearch {
 public:
  void carve(Workspace &workspace, const FreeSpaceLimits &limits);
  // After the cells are built, with portals. False if that is stopped.
  bool prepare(const FreeSpace &space, Patience &patience);

  // Finds a way between points of two cells of one region. Status::check if there is none, which cannot happen.
  Status find(const FreeSpace &space, uint32_t from_cell, const exact::Vector &from, uint32_t to_cell,
              const exact::Vector &to, Patience &patience);
  // The cells of the way from the first to the last one; no_id behind that.
  uint32_t next(uint32_t cell) const { return visits_[cell].next; }
  // Where a cell is entered.
  const exact::Vector &entry(uint32_t cell) const { return visits_[cell].entry; }

 private:
  struct Visit {
    exact::Vector entry;
    double way;       // up to there
    double estimate;  // of the whole way
    uint32_t from;
    uint32_t next;  // while searching: the index in the heap, not_seen or done
  };
  // A run on the lattice; far beyond all points where it has no end.
  struct Box {
    exact::Vector low, high;
  };

  bool comes_first(uint32_t a, uint32_t b) const;
  exact::Vector portal(const FreeSpace &space, uint32_t contact, const exact::Vector &from) const;

  Span<Visit> visits_;         // [cells]
  Span<uint32_t> heap_;        // [cells]
  Span<uint32_t> first_link_;  // [cells + 1]
  Span<uint32_t> links_;       // [2 adjacencies] contacts of each cell
  Span<Box> boxes_;            // [runs]
};

}  // namespace hsp
