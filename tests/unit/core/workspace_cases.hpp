// Carving: what is measured suffices for blocks at any address, arrays are aligned and apart, and sizes that do not fit
// are reported.
#pragma once

#include "cases.hpp"
#include "core/workspace.hpp"

namespace cases {

struct Layout {
  uint32_t bytes, doubles, words;  // lengths of three arrays
};
constexpr Layout layouts[] = {{3, 17, 5}, {0, 0, 0}, {64, 8, 16}, {1, 0, 1}, {65, 1, 33}, {0, 9, 0}, {200, 0, 1}};

inline uint32_t measured_memory_suffices() {
  return first_failing(layouts, [](const Layout &c) {
    const auto carve = [&](hsp::Workspace &workspace, hsp::Span<unsigned char> &a, hsp::Span<double> &b,
                           hsp::Span<uint32_t> &w) {
      a = workspace.take<unsigned char>(c.bytes);
      b = workspace.take<double>(c.doubles);
      w = workspace.take<uint32_t>(c.words);
    };
    hsp::Span<unsigned char> a;
    hsp::Span<double> b;
    hsp::Span<uint32_t> w;
    hsp::Workspace measure;
    carve(measure, a, b, w);
    if (a.data() != nullptr || b.data() != nullptr || w.data() != nullptr) return false;
    const size_t bytes = measure.bytes();
    unsigned char memory[800];
    if (bytes + 64 > sizeof memory) return false;
    for (size_t offset = 0; offset < 64; ++offset) {
      hsp::Workspace workspace(memory + offset, bytes);
      carve(workspace, a, b, w);
      const uintptr_t at[4] = {reinterpret_cast<uintptr_t>(a.data()), reinterpret_cast<uintptr_t>(b.data()),
                               reinterpret_cast<uintptr_t>(w.data()),
                               reinterpret_cast<uintptr_t>(memory + offset + bytes)};
      const uintptr_t end[3] = {at[0] + c.bytes, at[1] + c.doubles * sizeof(double),
                                at[2] + c.words * sizeof(uint32_t)};
      if (a.size() != c.bytes || b.size() != c.doubles || w.size() != c.words) return false;
      if (at[0] < reinterpret_cast<uintptr_t>(memory + offset)) return false;
      for (uint32_t k = 0; k < 3; ++k) {
        if (at[k] % hsp::Workspace::alignment != 0 || end[k] > at[k + 1]) return false;
      }
    }
    hsp::unpoison(memory, sizeof memory);  // others use this part of the stack again
    return true;
  });
}

// A block that is too short gives nothing instead of memory behind its end.
inline uint32_t short_blocks_give_nothing() {
  alignas(64) unsigned char memory[256];
  hsp::Workspace workspace(memory, sizeof memory);
  const bool conditions[] = {workspace.take<double>(16).size() == 16, workspace.take<double>(17).empty()};
  hsp::unpoison(memory, sizeof memory);
  return first_false(conditions);
}

// Arrays hold what lay in the block; objects that are made begin with their values.
inline uint32_t values_are_of_what_is_made() {
  struct Pair {
    uint32_t first = 5, second = 7;
  };
  alignas(64) unsigned char memory[256];
  for (unsigned char &byte : memory) byte = 0xA5;
  hsp::Workspace workspace(memory, sizeof memory);
  const hsp::Span<Pair> taken = workspace.take<Pair>(3);
  const hsp::Span<Pair> made = workspace.make<Pair>(3);
  const bool conditions[] = {taken.size() == 3 && memory[0] == 0xA5 && memory[23] == 0xA5, made[0].first == 5,
                             made[2].second == 7, workspace.make<Pair>(30).empty()};
  hsp::unpoison(memory, sizeof memory);
  return first_false(conditions);
}

inline uint32_t sizes_that_do_not_fit() {
  hsp::Workspace measure;
  measure.take<double>(UINT64_MAX / 4);
  measure.take<double>(UINT64_MAX / 4);
  // The padding after the first array reaches half of the address space; the others would go once around it.
  // Compilers know no array as large as that. 337 leaves next to nothing, whether a size has 32 bits or 64.
  struct Large {
    char bytes[SIZE_MAX / 2 / 337];
  };
  hsp::Workspace around;
  around.take<Large>(337);
  around.take<Large>(337);
  around.take<char>(64);
  // More items than a span has.
  hsp::Workspace most, more;
  most.take<char>(UINT32_MAX);
  more.take<char>(UINT64_C(1) << 32);
  const bool conditions[] = {measure.bytes() == 0, around.bytes() == 0, sizeof(size_t) == 4 || most.bytes() != 0,
                             more.bytes() == 0};
  return first_false(conditions);
}

inline constexpr Check core_workspace[] = {{"measured_memory_suffices", measured_memory_suffices},
                                           {"short_blocks_give_nothing", short_blocks_give_nothing},
                                           {"values_are_of_what_is_made", values_are_of_what_is_made},
                                           {"sizes_that_do_not_fit", sizes_that_do_not_fit}};

}  // namespace cases
