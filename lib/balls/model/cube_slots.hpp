// Finds numbers by their cubes, in an open-addressing hash table with double hashing (Section 3). The cubes themselves
// are kept elsewhere: cube_of(number) is the cube of a number that was inserted.
//
// The number of slots is a power of two at least twice the number of cubes, and the second hash, the stride, is odd: so
// every probe sequence visits all slots. With load at most 1/2 and independent hashes, a search that fails looks at no
// more than 1/(1 - load) <= 2 slots on average, and one that succeeds at 1.39 (Knuth, TAOCP 3, section 6.4).
//
// The hash has no key, so that cubes can be chosen whose probe sequences are the same. If a probe sequence would be
// longer than most_probes, which hardly ever happens with independent hashes, the slots become the links of a digital
// search tree (Knuth, TAOCP 3, section 6.3, algorithm D): each node has a cube, and all cubes below a node share with
// its cube one bit for each node above it. A search looks at one slot and at 193 nodes at most, as three coordinates
// have 192 bits.
//
// As an example eight slots, and a cube whose hash is slot 5 and stride 3. It may be in slots
//   5 0 3 6 1 4 7 2                modulo 8; as the stride is odd, each slot comes once
// If slots 5 and 0 have other cubes, it goes into slot 3. A search for it looks at 5, 0 and 3. A search for a cube with
// the same hash that is not there goes on to 6, and ends if that slot is empty.
#pragma once

#include "core/ahead.hpp"
#include "core/small_code.hpp"
#include "core/span.hpp"
#include "core/status.hpp"

namespace hsp {

struct CubeCoordinates {
  int64_t x, y, z;
  friend constexpr bool operator==(const CubeCoordinates &, const CubeCoordinates &) = default;
};

// The order of the grid: by z, then y, then x.
constexpr bool comes_before(const CubeCoordinates &a, const CubeCoordinates &b) {
  if (a.z != b.z) return a.z < b.z;
  if (a.y != b.y) return a.y < b.y;
  return a.x < b.x;
}

// The hash begins with this linear form in the coordinates, so that the forms of neighbouring cubes differ by
// constants. CubeProbe then mixes its high bits into the low ones.
constexpr uint64_t linear_hash(const CubeCoordinates &cube) {
  return static_cast<uint64_t>(cube.x) * UINT64_C(0x9E3779B97F4A7C15) +
         static_cast<uint64_t>(cube.y) * UINT64_C(0xC2B2AE3D27D4EB4F) +
         static_cast<uint64_t>(cube.z) * UINT64_C(0x165667B19E3779F9);
}

// The probe sequence: the slots where a cube may be, in the order in which they are tried.
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

// The way of a cube down the tree: the bits of its three coordinates in turn, from the lowest on. The ways of different
// cubes part at some node.
class CubePath {
 public:
  static constexpr uint32_t most_bits = 192;

  explicit CubePath(const CubeCoordinates &cube)
      : x_(static_cast<uint64_t>(cube.x)), y_(static_cast<uint64_t>(cube.y)), z_(static_cast<uint64_t>(cube.z)) {}
  // The link on the way of the cube out of this node, one of the node's two.
  uint32_t link_of(uint32_t node) {
    const uint32_t link = 2 * node + static_cast<uint32_t>(x_ & 1U);
    const uint64_t rest = x_ >> 1;
    x_ = y_;
    y_ = z_;
    z_ = rest;
    return link;
  }

 private:
  uint64_t x_, y_, z_;
};

class CubeSlots {
 public:
  // Small code makes no trees: if cubes are chosen to collide, its probe sequences are as long as there are such cubes.
  static constexpr uint32_t most_probes = small_code ? no_id : 64;
  // How many slots numbers below `numbers` need.
  static constexpr uint64_t slots_for(uint32_t numbers) {
    uint64_t slots = 4;
    while (slots < 2 * static_cast<uint64_t>(numbers)) slots *= 2;
    return slots;
  }

  CubeSlots() = default;
  explicit CubeSlots(Span<uint32_t> slots) : slots_(slots) {}

  // Removes all; from now on there are as many slots as numbers below `numbers` need.
  void clear(uint32_t numbers) {
    used_ = static_cast<uint32_t>(slots_for(numbers));
    longest_probe_ = longest_way_ = 0;
    fill(no_id);
  }

  // The number of a cube; no_id if it is not there. linear: linear_hash(cube). If there is a tree, no slot is empty,
  // and the number in the first slot that is looked at is the right one only by chance.
  template <class CubeOf>
  uint32_t find(const CubeCoordinates &cube, uint64_t linear, const CubeOf &cube_of) const {
    CubeProbe probe(linear, used_);
    for (uint32_t looks = 1;; ++looks, probe.next()) {
      const uint32_t number = slots_[probe.slot];
      if (number == no_id || cube_of(number) == cube) return number;
      if (looks >= longest_probe_) [[unlikely]]
        return is_tree() ? find_in_tree(cube.x, cube.y, cube.z, cube_of) : no_id;
    }
  }

  // Inserts a number whose cube is not there yet. Numbers are inserted in ascending order from 0 on; a number may be
  // left out if its cube is there already.
  template <class CubeOf>
  void insert(uint32_t number, const CubeOf &cube_of) {
    if (is_tree() || !insert_in_table(number, cube_of)) [[unlikely]]
      insert_in_tree(number, cube_of);
  }
  // Removes all numbers, and inserts those below `count`, whose cubes are different, into as many slots as they need.
  // scratch: a bit for each of these slots.
  template <class CubeOf>
  void insert_all(uint32_t count, const CubeOf &cube_of, Span<uint32_t> scratch) {
    clear(count);
    if (!small_code && used_ > most_near_slots) return insert_far(count, cube_of, scratch);
    CubeSlots slots = *this;  // in registers: to the compiler, a store to a slot might change a member
    for (uint32_t number = 0; number < count; ++number) {
      if (!small_code && number + ahead::slots < count) {
        slots.prefetch(CubeProbe(linear_hash(cube_of(number + ahead::slots)), slots.used_).slot);
      }
      if (!slots.insert_in_table(number, cube_of)) [[unlikely]]
        return make_tree(count, cube_of);
    }
    *this = slots;
  }
  uint32_t size() const { return used_; }
  bool is_tree() const { return !small_code && longest_way_ != 0; }
  // The most slots and nodes that are looked at to find a cube that is there.
  uint32_t longest_search() const { return is_tree() ? longest_way_ : longest_probe_; }

 private:
  // More slots than these do not stay in the nearest cache, but a bit for each does.
  static constexpr uint32_t most_near_slots = 1U << 16;
  static constexpr uint32_t root = 0;  // no link leads to the root, so this number stands for an empty link

  void fill(uint32_t value) {
    const uint32_t used = used_;  // in a register: to the compiler, a store to a slot might change the member
    for (uint32_t k = 0; k < used; ++k) slots_[k] = value;
  }
  void prefetch(uint32_t slot) const { __builtin_prefetch(&slots_[slot], 1); }
  void note(uint32_t length) {
    if (length > longest_probe_) longest_probe_ = length;
  }
  // Inserts into the table. If the probe sequence is too long, changes nothing and returns false.
  template <class CubeOf>
  bool insert_in_table(uint32_t number, const CubeOf &cube_of) {
    CubeProbe probe(linear_hash(cube_of(number)), used_);
    uint32_t length = 1;
    for (; slots_[probe.slot] != no_id; probe.next()) {
      if (++length > most_probes) [[unlikely]]
        return false;
    }
    slots_[probe.slot] = number;
    note(length);
    return true;
  }
  // Replaces the table by a tree of the numbers below `numbers`.
  template <class CubeOf>
  void make_tree(uint32_t numbers, const CubeOf &cube_of) {
    fill(root);
    longest_probe_ = 1;
    longest_way_ = 2;  // the first slot and the root
    for (uint32_t number = 1; number < numbers; ++number) plant(number, cube_of);
  }
  // Inserts all into an empty table, each into the same slot as by insert(). Bits say which slots are taken, so that
  // slots are never read; they are written some cubes later, when the processor has fetched them.
  template <class CubeOf>
  void insert_far(uint32_t count, const CubeOf &cube_of, Span<uint32_t> taken) {
    for (uint32_t &word : taken.part(0, used_ / 32)) word = 0;
    uint32_t found[ahead::slots];  // slots that are not written yet
    for (uint32_t number = 0; number < count; ++number) {
      uint32_t length = 1;
      CubeProbe probe(linear_hash(cube_of(number)), used_);
      for (; (taken[probe.slot / 32] >> probe.slot % 32 & 1U) != 0; probe.next()) {
        if (++length > most_probes) return make_tree(count, cube_of);
      }
      taken[probe.slot / 32] |= 1U << probe.slot % 32;
      note(length);
      prefetch(probe.slot);
      uint32_t &slot = found[number % ahead::slots];
      if (number >= ahead::slots) slots_[slot] = number - ahead::slots;
      slot = probe.slot;
    }
    // There are more cubes than ahead::slots, as there are more than most_near_slots slots.
    for (uint32_t number = count - ahead::slots; number < count; ++number)
      slots_[found[number % ahead::slots]] = number;
  }
  // This rare path gets the coordinates one by one, so that the common path keeps its cube in registers.
  template <class CubeOf>
  [[gnu::noinline, gnu::cold]] uint32_t find_in_tree(int64_t x, int64_t y, int64_t z, CubeOf cube_of) const {
    const CubeCoordinates cube{x, y, z};
    uint32_t node = root;
    for (CubePath path(cube); !(cube_of(node) == cube);) {
      node = slots_[path.link_of(node)];
      if (node == root) return no_id;
    }
    return node;
  }
  template <class CubeOf>
  [[gnu::noinline, gnu::cold]] void insert_in_tree(uint32_t number, CubeOf cube_of) {
    if (!is_tree()) make_tree(number, cube_of);
    plant(number, cube_of);
  }
  // Does nothing if the cube is there.
  template <class CubeOf>
  void plant(uint32_t number, const CubeOf &cube_of) {
    const CubeCoordinates cube = cube_of(number);
    uint32_t node = root, looks = 3;
    for (CubePath path(cube); !(cube_of(node) == cube); ++looks) {
      uint32_t &link = slots_[path.link_of(node)];
      if (link == root) {
        link = number;
        if (looks > longest_way_) longest_way_ = looks;
        return;
      }
      node = link;
    }
  }

  Span<uint32_t> slots_;        // numbers, no_id if empty; of a tree: the two links of each number
  uint32_t used_ = 0;           // how many of slots_ are used
  uint32_t longest_probe_ = 0;  // 1 for a tree
  uint32_t longest_way_ = 0;    // of a tree; 0 for a table
};

}  // namespace hsp
