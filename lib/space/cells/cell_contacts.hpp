// The pairs of adjacent cells of free space, each once. For paths each pair has a portal, too: a lattice point near one
// that both cells have in common. It is outside all balls but for rounding.
#pragma once

#include "cells/cube_frame.hpp"
#include "core/fixed_vector.hpp"
#include "core/workspace.hpp"
#include "exact/power.hpp"

namespace hsp {

struct AdjacentCells {
  uint32_t cell[2];
};

class CellContacts {
 public:
  // Takes memory for pairs, and for as many portals if they are wanted.
  void carve(Workspace &workspace, uint32_t pairs, bool with_portals) {
    pairs_ = FixedVector<AdjacentCells>(workspace.take<AdjacentCells>(pairs));
    portals_ = workspace.take<exact::Vector>(with_portals ? pairs : 0);
  }

  void clear() { pairs_.clear(); }
  bool has_portals() const { return !portals_.empty(); }
  // Adds two runs, without a portal: that depends on the point from which a path comes.
  void push(const AdjacentCells &pair) { pairs_.push(pair); }
  // Adds two cells with a portal: a position in a cube that both have in common.
  void push(const AdjacentCells &pair, const CubeFrame &frame, const Vec3 &at) {
    if (pairs_.required() < portals_.size()) portals_[static_cast<uint32_t>(pairs_.required())] = frame.rounded(at);
    pairs_.push(pair);
  }

  // Sets the portal of pair k to this position if it is farther from the centre of a ball.
  void widen(uint32_t k, const CubeFrame &frame, const Vec3 &at, const exact::Vector &centre) {
    const exact::Vector other = frame.rounded(at);
    if ((squared_distance(other, centre) - squared_distance(portals_[k], centre)).sign() > 0) portals_[k] = other;
  }

  uint64_t required() const { return pairs_.required(); }
  bool overflowed() const { return pairs_.overflowed(); }
  uint32_t size() const { return pairs_.size(); }
  const AdjacentCells &operator[](uint32_t k) const { return pairs_[k]; }
  // For tests, which damage it.
  AdjacentCells &operator[](uint32_t k) { return pairs_[k]; }
  void shrink(uint32_t count) { pairs_.shrink(count); }
  Span<const AdjacentCells> items() const { return pairs_.items(); }
  Span<AdjacentCells> items() { return pairs_.items(); }
  const exact::Vector &portal(uint32_t k) const { return portals_[k]; }

 private:
  static exact::WideInteger<exact::FastLimb, 128> squared_distance(const exact::Vector &a, const exact::Vector &b) {
    return exact::squared_length(a - b);
  }

  FixedVector<AdjacentCells> pairs_;
  Span<exact::Vector> portals_;
};

}  // namespace hsp
