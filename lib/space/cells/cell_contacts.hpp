// Which cells of free space are adjacent, each two of them once. A search for paths also gets a portal for each: a
// point of the lattice near one that both cells have, outside all balls but for its rounding.
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
  // Memory for as many portals as pairs, or for none if they are not asked for.
  void carve(Workspace &workspace, uint32_t pairs, bool with_portals) {
    pairs_ = FixedVector<AdjacentCells>(workspace.take<AdjacentCells>(pairs));
    portals_ = workspace.take<exact::Vector>(with_portals ? pairs : 0);
  }

  void clear() { pairs_.clear(); }
  bool has_portals() const { return !portals_.empty(); }
  // Two runs: their portal depends on where one comes from.
  void push(const AdjacentCells &pair) { pairs_.push(pair); }
  // Two cells that have a position in a cube in common.
  void push(const AdjacentCells &pair, const CubeFrame &frame, const Vec3 &at) {
    if (pairs_.required() < portals_.size()) portals_[static_cast<uint32_t>(pairs_.required())] = frame.rounded(at);
    pairs_.push(pair);
  }

  // The portal of pair k becomes this position if that is farther from the centre of a ball.
  void widen(uint32_t k, const CubeFrame &frame, const Vec3 &at, const exact::Vector &centre) {
    const exact::Vector other = frame.rounded(at);
    if ((squared_distance(other, centre) - squared_distance(portals_[k], centre)).sign() > 0) portals_[k] = other;
  }

  uint64_t required() const { return pairs_.required(); }
  bool overflowed() const { return pairs_.overflowed(); }
  uint32_t size() const { return pairs_.size(); }
  const AdjacentCells &operator[](uint32_t k) const { return pairs_[k]; }
  // To be broken by tests.
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
