// Components of a union in a periodic box, and in how many directions each goes on for ever.
//
// Balls are joined to disjoint sets. Each ball has the shift of its copy relative to that of its parent. A pair of
// balls that are in one set already closes a way through the box, which leads to a copy of its beginning. The shifts
// between beginning and end, the windings, generate a lattice. Its rank is the number of directions.
#pragma once

#include "core/workspace.hpp"
#include "periodic/periodic_box.hpp"

namespace hsp {

// A lattice of shifts in echelon form: pivots are positive, and the numbers above a pivot are smaller and not negative.
// So equal lattices have equal rows.
struct WindingLattice {
  uint32_t rank = 0;
  int32_t row[3][3] = {};

  // Adds a generator. False if numbers become too large: then the lattice must not be used.
  bool add(const int64_t (&generator)[3]);
  bool holds_all_shifts() const { return rank == 3 && row[0][0] == 1 && row[1][1] == 1 && row[2][2] == 1; }
  // How many copies of the component in the space spanned by the rows are not connected: the index of the lattice among
  // all shifts in that space. For rank 3 so many copies go through each other. 0 if the number needs more than 64 bits.
  uint64_t copies() const;
};

class Windings {
 public:
  void carve(Workspace &workspace, uint32_t balls);

  // Begins with each ball in a set of its own.
  void reset(uint32_t balls);
  // Begins with sets of balls that meet at their places. Index k stands for ball[k]; root[k] is the index of one ball
  // of its set.
  void reset(Span<const uint32_t> root, Span<const uint32_t> ball);
  // Joins ball i, at its place, and ball j, `shift` away from its place. False if numbers become too large.
  bool join(uint32_t i, uint32_t j, const BoxShift &shift);
  // During joins: the lowest ball of a ball's set; and the lattice of a set, by its lowest ball.
  uint32_t set_of(uint32_t ball) {
    Offset ignored;
    return find(ball, ignored);
  }
  const WindingLattice &lattice_of_set(uint32_t lowest) const { return lattice_[lowest]; }
  // Numbers the sets in the order of their first balls. Returns how many.
  uint32_t number();

  uint32_t size() const { return n_; }
  uint32_t component(uint32_t ball) const { return component_[ball]; }
  uint32_t first_ball(uint32_t component) const { return first_[component]; }
  // The lattice of a component, in multiples of the vectors in which shifts were given.
  const WindingLattice &lattice(uint32_t component) const { return lattice_[first_[component]]; }

 private:
  struct Offset {
    int64_t k[3];
  };

  uint32_t find(uint32_t ball, Offset &offset);

  uint32_t n_ = 0;
  Span<uint32_t> parent_;  // the root has the smallest number of its set
  Span<Offset> offset_;    // the shift of the ball's copy relative to its parent's
  Span<WindingLattice> lattice_;
  Span<uint32_t> component_, first_;
};

}  // namespace hsp
