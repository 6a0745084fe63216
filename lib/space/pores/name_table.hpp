// A hash table from the names of points to their numbers: open addressing over the caller's memory.
#pragma once

#include "core/workspace.hpp"
#include "pores/pores.hpp"

namespace hsp {

class NameTable {
 public:
  void carve(Workspace &workspace, uint32_t capacity) {
    entries_ = workspace.take<uint32_t>(slots(capacity));
    capacity_ = capacity;
  }
  void clear() {
    for (uint32_t &entry : entries_) entry = no_id;
    count_ = 0;
  }
  // The number under which a name was added; no_id if it was not. records[number].point has that name.
  template <class Records>
  uint32_t find(const PointName &name, const Records &records) const {
    return entries_[slot_of(name, records)];
  }
  // Adds a name that is new. Does nothing when the table is full.
  template <class Records>
  void add(const PointName &name, uint32_t number, const Records &records) {
    if (count_ == capacity_) return;
    entries_[slot_of(name, records)] = number;
    ++count_;
  }

 private:
  // A power of two, at least twice the capacity: some slots stay free.
  static uint64_t slots(uint32_t capacity) {
    uint64_t slots = 4;
    while (slots < uint64_t{2} * capacity) slots *= 2;
    return slots;
  }
  template <class Records>
  uint32_t slot_of(const PointName &name, const Records &records) const {
    uint64_t hash = 0;
    for (uint32_t k = 0; k < 4; ++k) {
      const uint64_t part = name.ball[k] | static_cast<uint64_t>(name.shift[k].bits) << 32;
      hash = (hash ^ part) * UINT64_C(0x9E3779B97F4A7C15) ^ hash >> 29;
    }
    const uint32_t mask = entries_.size() - 1;
    for (uint32_t slot = static_cast<uint32_t>(hash >> 32) & mask;; slot = (slot + 1) & mask) {
      const uint32_t number = entries_[slot];
      if (number == no_id || records[number].point == name) return slot;
    }
  }

  Span<uint32_t> entries_;  // no_id: free
  uint32_t capacity_ = 0, count_ = 0;
};

}  // namespace hsp
