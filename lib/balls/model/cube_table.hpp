// The cubes of Section 3 by their coordinates: cube coordinates -> cube number. The size of the table depends on the
// number of cubes that hold balls alone, not on the extent of the set.
#pragma once

#include "core/ahead.hpp"
#include "model/cube_slots.hpp"

namespace hsp {

class CubeTable {
 public:
  // Slots for at most `cubes` cubes.
  static constexpr uint64_t slots_for(uint32_t cubes) { return CubeSlots::slots_for(cubes); }

  CubeTable() = default;
  CubeTable(Span<uint32_t> slots, Span<CubeCoordinates> cubes) : slots_(slots), cubes_(cubes) {}

  // Removes all cubes; from now on there are as many slots as `cubes` cubes need.
  void clear(uint32_t cubes) {
    count_ = 0;
    slots_.clear(cubes);
  }

  uint32_t find(const CubeCoordinates &cube) const { return find(cube, linear_hash(cube)); }
  // The same for callers that know the linear form.
  uint32_t find(const CubeCoordinates &cube, uint64_t linear) const { return slots_.find(cube, linear, cube_of()); }
  // Gives the next number to a cube that is not there yet.
  void append(const CubeCoordinates &cube) {
    push(cube);
    slots_.insert(count_ - 1, cube_of());
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
    slots_.clear(count_);
    if (!small_code && slots_.size() > most_near_slots) {
      insert_far(scratch);
      return;
    }
    CubeSlots slots = slots_;  // in registers: slots are numbers like its members
    const uint32_t count = count_, size = slots.size();
    const CubeOf cube = cube_of();
    for (uint32_t number = 0; number < count; ++number) {
      if (!small_code && number + ahead::slots < count) {
        slots.prefetch(CubeProbe(linear_hash(cube(number + ahead::slots)), size).slot);
      }
      if (!slots.insert_in_table(number, cube)) [[unlikely]]
        return slots_.make_tree(count_, cube_of());
    }
    slots_ = slots;
  }

  uint32_t count() const { return count_; }
  uint32_t slots() const { return slots_.size(); }

  // The least interval that holds the value, too.
  static void widen(int64_t value, int64_t &low, int64_t &high) {
    low = value < low ? value : low;
    high = value > high ? value : high;
  }
  uint32_t longest_search() const { return slots_.longest_search(); }
  const CubeCoordinates &coordinates(uint32_t number) const { return cubes_[number]; }
  // The corners of the box around all cubes, if there are any.
  const CubeCoordinates &low() const { return low_; }
  const CubeCoordinates &high() const { return high_; }

 private:
  // More than these do not stay in a near memory, but a bit for each does.
  static constexpr uint32_t most_near_slots = 1U << 16;

  struct CubeOf {
    Span<CubeCoordinates> cubes;
    const CubeCoordinates &operator()(uint32_t number) const { return cubes[number]; }
  };
  CubeOf cube_of() const { return {cubes_}; }
  CubeProbe probe_of(uint32_t number) const { return {linear_hash(cubes_[number]), slots_.size()}; }

  // All cubes into an empty table, each into the same slot as by insert(). Bits tell which slots are taken, so that
  // slots are never read, and are on their way while later cubes look for theirs.
  void insert_far(Span<uint32_t> taken) {
    for (uint32_t &word : taken.part(0, slots_.size() / 32)) word = 0;
    uint32_t found[ahead::slots];  // slots that are not written yet
    for (uint32_t number = 0; number < count_; ++number) {
      uint32_t length = 1;
      CubeProbe probe = probe_of(number);
      for (; (taken[probe.slot / 32] >> probe.slot % 32 & 1U) != 0; probe.next()) {
        if (++length > CubeSlots::most_probes) {
          slots_.make_tree(count_, cube_of());
          return;
        }
      }
      taken[probe.slot / 32] |= 1U << probe.slot % 32;
      slots_.note(length);
      slots_.prefetch(probe.slot);
      uint32_t &slot = found[number % ahead::slots];
      if (number >= ahead::slots) slots_.put(slot, number - ahead::slots);
      slot = probe.slot;
    }
    // There are more cubes than that, as there are so many slots.
    for (uint32_t number = count_ - ahead::slots; number < count_; ++number) {
      slots_.put(found[number % ahead::slots], number);
    }
  }

  CubeSlots slots_;
  Span<CubeCoordinates> cubes_;
  uint32_t count_ = 0;
  CubeCoordinates low_{}, high_{};
};

}  // namespace hsp
