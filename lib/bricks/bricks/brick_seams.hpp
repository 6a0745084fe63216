// The seams at which a brick joins others: found in its boundary, and named so that both bricks find the same names.
//
// Two bricks see the same arcs between balls of the one and balls of the other. Two such arcs are linked at a vertex
// whose third ball belongs to one of both bricks: then both are on one piece of each brick. So arcs make up curves. A
// curve is closed, or ends where a third brick begins; it is named by its lowest vertex. In the same way both bricks
// see the same pairs of balls that meet, one of each brick. Linked pairs make up a seam of components, named by its
// lowest ball.
//
// Example: two bricks that cut a torus of balls have two curves, both closed, and two seams of components, of which the
// second joins what the first has joined.
#pragma once

#include "boundary/boundary.hpp"
#include "bricks/summary_records.hpp"
#include "core/patience.hpp"
#include "model/cube_grid.hpp"

namespace hsp {

// A computed model of a brick: its own balls, and all of others that meet one of them.
struct BrickModel {
  const CubeGrid &grid;
  const Boundary &boundary;
  uint32_t brick = 0;
  const uint64_t *id = nullptr;  // [n] ascending, in the caller's order
  Span<const uint32_t> owner;    // [n] the brick that owns a ball, in the grid's order

  const BallSet &balls() const { return grid.balls(); }
  bool owns(uint32_t ball) const { return owner[ball] == brick; }
  uint64_t id_of(uint32_t ball) const { return id[balls().caller[ball]]; }
  // A seam between this brick and another one, with the bricks' numbers and nothing else.
  template <class Record>
  Record seam_to(uint32_t other) const {
    Record seam;
    seam.a = brick < other ? brick : other;
    seam.b = brick < other ? other : brick;
    return seam;
  }
};

// The seams found, in memory that may be too small: seams without room are counted.
template <class Record>
class SeamList {
 public:
  SeamList(uint8_t *memory, uint64_t bytes) : memory_(memory), room_(bytes / little_bytes<Record>) {}

  void push(const Record &seam) {
    if (count_ < room_) store_record(seam, memory_ + uint64_t{little_bytes<Record>} * count_);
    ++count_;
  }
  uint32_t count() const { return count_; }

 private:
  uint8_t *memory_;
  uint64_t room_;
  uint32_t count_ = 0;
};

// The number of words for so many bits, one for each half-edge.
inline uint64_t words_of_bits(uint64_t count) {
  return count / 32 + 1;
}

// Finds the seams of shells. False if patience ends. passed: scratch memory, a bit for each half-edge; piece: [faces]
// the labels of pieces.
bool find_shell_seams(const BrickModel &model, Patience &patience, Span<uint32_t> passed, Span<const uint32_t> piece,
                      SeamList<ShellSeam> &seams);

// Finds the seams of components. False if patience ends. component: [components of the boundary] the labels, no_id for
// components without an owned ball; the other arrays are scratch memory, [n].
bool find_component_seams(const BrickModel &model, Patience &patience, Span<const uint32_t> component,
                          Span<uint32_t> joined, Span<uint32_t> first_contact, Span<uint32_t> neighbours,
                          SeamList<ComponentSeam> &seams);

}  // namespace hsp
