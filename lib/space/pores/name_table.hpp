// Numbers by names of up to four ids: open addressing over the caller's memory.
#pragma once

#include "core/workspace.hpp"

namespace hsp {

class NameTable {
 public:
  void carve(Workspace &workspace, uint32_t capacity) {
    entries_ = workspace.take<Entry>(slots(capacity));
    capacity_ = capacity;
  }
  void clear() {
    for (Entry &entry : entries_) entry.number = no_id;
    count_ = 0;
  }
  // The number of a name; no_id if there is none.
  uint32_t find(const uint32_t *name) const { return entries_[place_of(name)].number; }
  // Of a name that is new. Without room it does nothing.
  void add(const uint32_t *name, uint32_t number) {
    if (count_ == capacity_) return;
    Entry &entry = entries_[place_of(name)];
    entry = {{name[0], name[1], name[2], name[3]}, number};
    ++count_;
  }

 private:
  struct Entry {
    uint32_t name[4];
    uint32_t number;  // no_id: free
  };
  // A power of two, and never full.
  static uint64_t slots(uint32_t capacity) {
    uint64_t slots = 4;
    while (slots < uint64_t{2} * capacity) slots *= 2;
    return slots;
  }
  uint32_t place_of(const uint32_t *name) const {
    uint64_t hash = 0;
    for (uint32_t k = 0; k < 4; ++k) hash = (hash ^ name[k]) * UINT64_C(0x9E3779B97F4A7C15) ^ hash >> 29;
    const uint32_t mask = entries_.size() - 1;
    for (uint32_t place = static_cast<uint32_t>(hash >> 32) & mask;; place = (place + 1) & mask) {
      const Entry &entry = entries_[place];
      if (entry.number == no_id) return place;
      bool same = true;
      for (uint32_t k = 0; k < 4; ++k) same = same && entry.name[k] == name[k];
      if (same) return place;
    }
  }

  Span<Entry> entries_;
  uint32_t capacity_ = 0, count_ = 0;
};

}  // namespace hsp
