// Components of a union in a periodic box, and in how many directions each goes on for ever.
//
// Sets of balls that are joined, where each ball remembers how many boxes away from its parent's its own copy lies. A
// pair of balls that are in one set already closes a way through the box: it leads to a copy of where it began, and the
// multiples of the box's vectors between the two make up a lattice. Its rank is the number of directions.
#pragma once

#include "core/workspace.hpp"
#include "periodic/periodic_box.hpp"

namespace hsp {

// A lattice of shifts in echelon form: pivots are positive, and above each are smaller numbers that are not negative.
// So equal lattices have equal rows.
struct WindingLattice {
  uint32_t rank = 0;
  int32_t row[3][3] = {};

  // Adds a generator. False if numbers become too large, and then the lattice is of no use.
  bool add(const int64_t (&generator)[3]);
  bool holds_all_shifts() const { return rank == 3 && row[0][0] == 1 && row[1][1] == 1 && row[2][2] == 1; }
  // How many copies of the component are apart from each other among those in the space that the rows span: the index
  // of the lattice among all shifts there. For rank 3 so many copies go through each other. 0 if too many for 64 bits.
  uint64_t copies() const;
};

class Windings {
 public:
  void carve(Workspace &workspace, uint32_t balls);

  void reset(uint32_t balls);
  // The same with sets of balls that have met in their places: number k of them is ball[k], and of its set root[k] is
  // the number of one.
  void reset(Span<const uint32_t> root, Span<const uint32_t> ball);
  // Ball i, in its place, meets ball j `shift` boxes away from its own.
  bool join(uint32_t i, uint32_t j, const BoxShift &shift);
  // While they are joined: the lowest ball of a ball's set, and the lattice of a set by that.
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
  // In multiples of the vectors that shifts were given in.
  const WindingLattice &lattice(uint32_t component) const { return lattice_[first_[component]]; }

 private:
  struct Offset {
    int64_t k[3];
  };

  uint32_t find(uint32_t ball, Offset &offset);

  uint32_t n_ = 0;
  Span<uint32_t> parent_;  // the smallest number is the root
  Span<Offset> offset_;    // the ball's copy is so far from its parent's
  Span<WindingLattice> lattice_;
  Span<uint32_t> component_, first_;
};

}  // namespace hsp
