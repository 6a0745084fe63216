// A directory of the non-empty cubes in an open-addressing table with double hashing, as the paper's program and the
// library have it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "section_3/cubes.hpp"
#include "section_3/grouped_balls.hpp"

namespace bench {

class DoubleHashing {
 public:
  void build(const Cubes &, const std::vector<Cube> &cube, std::vector<uint32_t> &numbers) {
    uint32_t slots = 4;
    while (slots < 2 * cube.size()) slots *= 2;
    mask_ = slots - 1;
    slots_.assign(slots, {0, none});
    keys_.clear();
    numbers.clear();
    for (const Cube &c : cube) numbers.push_back(find_or_insert(packed(c)));
    const std::vector<uint32_t> place = sort_cubes(keys_);
    for (uint32_t &number : numbers) number = place[number];
    for (Slot &slot : slots_) {
      if (slot.number != none) slot.number = place[slot.number];
    }
  }

  uint32_t count() const { return static_cast<uint32_t>(keys_.size()); }

  template <class Visit>
  void visit_row(uint32_t x_low, uint32_t x_high, uint32_t y, uint32_t z, Visit visit) const {
    visit_row_of(
        keys_, x_low, x_high, y, z, [&](uint64_t key) { return find(key); }, visit);
  }

  size_t bytes() const { return bytes_of(slots_) + bytes_of(keys_); }

 private:
  static constexpr uint32_t none = UINT32_MAX;

  // The key stands beside the number: a search touches one line of the cache.
  struct Slot {
    uint64_t key;
    uint32_t number;  // of the cube, or none
  };

  // The slots where a cube may be. The stride is odd and the number of slots a power of two: all slots are visited.
  struct Probe {
    Probe(uint64_t key, uint32_t mask_of_slots) : mask(mask_of_slots) {
      uint64_t hash = (key ^ (key >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);  // the mixer of SplitMix64
      hash = (hash ^ (hash >> 27)) * UINT64_C(0x94D049BB133111EB);
      hash ^= hash >> 31;
      slot = static_cast<uint32_t>(hash) & mask;
      stride = static_cast<uint32_t>(hash >> 32) | 1U;
    }
    void next() { slot = (slot + stride) & mask; }
    uint32_t mask, slot, stride;
  };

  uint32_t find(uint64_t key) const {
    for (Probe probe(key, mask_);; probe.next()) {
      const Slot &slot = slots_[probe.slot];
      if (slot.number == none || slot.key == key) return slot.number;
    }
  }
  uint32_t find_or_insert(uint64_t key) {
    for (Probe probe(key, mask_);; probe.next()) {
      const Slot &slot = slots_[probe.slot];
      if (slot.number != none && slot.key == key) return slot.number;
      if (slot.number != none) continue;
      slots_[probe.slot] = {key, count()};
      keys_.push_back(key);
      return count() - 1;
    }
  }

  std::vector<Slot> slots_;
  std::vector<uint64_t> keys_;  // of each cube
  uint32_t mask_ = 0;
};

}  // namespace bench
