// The cubes of Section 3 in an open-addressing table with double hashing: cube coordinates -> cube number. Its size
// depends on the number of cubes that hold balls alone, not on the extent of the set.
//
// The number of slots is a power of two at least twice the number of cubes, the second hash is odd: every probe
// sequence visits all slots and ends at an empty one. With load at most 1/2 and independent hashes a search that fails
// looks at 1/(1 - load) <= 2 slots on average and one that succeeds at no more than 1.39 (Knuth, TAOCP 3, section 6.4,
// eq. for double hashing); the longest probe met while building is recorded and reported.
#pragma once

#include "core/small_code.hpp"
#include "core/span.hpp"
#include "core/status.hpp"

namespace hsp {

struct CubeCoordinates {
  int64_t x, y, z;
  friend constexpr bool operator==(const CubeCoordinates &, const CubeCoordinates &) = default;
};

// The hash is a linear form in the coordinates, so that the form of a neighbour differs by a constant; then a finalizer
// mixes its high bits down.
constexpr uint64_t linear_hash(const CubeCoordinates &cube) {
  return static_cast<uint64_t>(cube.x) * UINT64_C(0x9E3779B97F4A7C15) +
         static_cast<uint64_t>(cube.y) * UINT64_C(0xC2B2AE3D27D4EB4F) +
         static_cast<uint64_t>(cube.z) * UINT64_C(0x165667B19E3779F9);
}

// The sequence of slots where a cube may be.
struct CubeProbe {
  CubeProbe(uint64_t linear, uint32_t slots) : mask(slots - 1) {
    uint64_t h = (linear ^ (linear >> 32)) * UINT64_C(0xD6E8FEB86659FD93);
    h ^= h >> 32;
    slot = static_cast<uint32_t>(h) & mask;
    stride = static_cast<uint32_t>(h >> 32) | 1U;
  }
  void next() { slot = (slot + stride) & mask; }
  uint32_t mask, slot, stride;
};

class CubeTable {
 public:
  // Slots for at most `cubes` cubes.
  static constexpr uint64_t slots_for(uint32_t cubes) {
    uint64_t slots = 4;
    while (slots < 2 * static_cast<uint64_t>(cubes)) slots *= 2;
    return slots;
  }

  CubeTable() = default;
  CubeTable(Span<uint32_t> slots, Span<CubeCoordinates> cubes) : slots_(slots), cubes_(cubes) {}

  // Removes all cubes; from now on there are as many slots as `cubes` cubes need.
  void clear(uint32_t cubes) {
    count_ = 0;
    clear_slots(cubes);
  }

  uint32_t find(const CubeCoordinates &cube) const { return find(cube, linear_hash(cube)); }
  // The same for callers that know the linear form.
  uint32_t find(const CubeCoordinates &cube, uint64_t linear) const {
    for (CubeProbe probe(linear, used_slots_);; probe.next()) {
      const uint32_t number = slots_[probe.slot];
      if (number == no_id || cubes_[number] == cube) return number;
    }
  }
  // Gives the next number to a cube that is not there yet.
  void append(const CubeCoordinates &cube) {
    push(cube);
    insert(count_ - 1);
  }
  // The same for many, after clear(): first all are pushed, and from then on have numbers and coordinates; then all are
  // inserted, and can be found among as many slots as they need. Scratch memory: a bit for each of these.
  void push(const CubeCoordinates &cube) {
    if (count_ == 0) low_ = high_ = cube;
    widen(cube.x, low_.x, high_.x);
    widen(cube.y, low_.y, high_.y);
    widen(cube.z, low_.z, high_.z);
    cubes_[count_++] = cube;
  }
  void insert_all(Span<uint32_t> scratch) {
    clear_slots(count_);
    if (!small_code && used_slots_ > most_near_slots) {
      insert_far(scratch);
      return;
    }
    for (uint32_t number = 0; number < count_; ++number) {
      if (!small_code && number + fetched_ahead < count_) fetch(number + fetched_ahead);
      insert(number);
    }
  }

  uint32_t count() const { return count_; }
  uint32_t slots() const { return used_slots_; }

  // The least interval that holds the value, too.
  static void widen(int64_t value, int64_t &low, int64_t &high) {
    low = value < low ? value : low;
    high = value > high ? value : high;
  }
  uint32_t longest_probe() const { return longest_probe_; }
  const CubeCoordinates &coordinates(uint32_t number) const { return cubes_[number]; }
  // The corners of the box around all cubes, if there are any.
  const CubeCoordinates &low() const { return low_; }
  const CubeCoordinates &high() const { return high_; }

 private:
  // Slots of a large table are far from each other: they are on their way while other cubes are inserted.
  static constexpr uint32_t fetched_ahead = 32;
  // More than these do not stay in a near memory, but a bit for each does.
  static constexpr uint32_t most_near_slots = 1U << 16;

  void clear_slots(uint32_t cubes) {
    longest_probe_ = 0;
    used_slots_ = static_cast<uint32_t>(slots_for(cubes));
    for (uint32_t k = 0; k < used_slots_; ++k) slots_[k] = no_id;
  }
  void fetch(uint32_t number) const {
    __builtin_prefetch(&slots_[CubeProbe(linear_hash(cubes_[number]), used_slots_).slot], 1);
  }
  void insert(uint32_t number) {
    uint32_t length = 1;
    CubeProbe probe(linear_hash(cubes_[number]), used_slots_);
    for (; slots_[probe.slot] != no_id; probe.next()) ++length;
    slots_[probe.slot] = number;
    if (length > longest_probe_) longest_probe_ = length;
  }

  // All cubes into an empty table, each into the same slot as by insert(). Bits tell which slots are taken, so that
  // slots are never read, and are on their way while later cubes look for theirs.
  void insert_far(Span<uint32_t> taken) {
    for (uint32_t &word : taken.part(0, used_slots_ / 32)) word = 0;
    uint32_t found[fetched_ahead];  // slots that are not written yet
    for (uint32_t number = 0; number < count_; ++number) {
      uint32_t length = 1;
      CubeProbe probe(linear_hash(cubes_[number]), used_slots_);
      for (; (taken[probe.slot / 32] >> probe.slot % 32 & 1U) != 0; probe.next()) ++length;
      taken[probe.slot / 32] |= 1U << probe.slot % 32;
      if (length > longest_probe_) longest_probe_ = length;
      __builtin_prefetch(&slots_[probe.slot], 1);
      uint32_t &slot = found[number % fetched_ahead];
      if (number >= fetched_ahead) slots_[slot] = number - fetched_ahead;
      slot = probe.slot;
    }
    // There are more cubes than that, as there are so many slots.
    for (uint32_t number = count_ - fetched_ahead; number < count_; ++number) {
      slots_[found[number % fetched_ahead]] = number;
    }
  }

  Span<uint32_t> slots_;  // cube numbers, no_id = empty
  Span<CubeCoordinates> cubes_;
  uint32_t used_slots_ = 0;
  uint32_t count_ = 0;
  uint32_t longest_probe_ = 0;
  CubeCoordinates low_{}, high_{};
};

}  // namespace hsp
