// For kernels: tables of all pairs j < k of up to eight things, in order, so that one word has a bit for each pair.
#pragma once

#include "lanes/words.hpp"

namespace hsp {

struct PairsOfFew {
  static constexpr uint32_t most = 8, size = 32;
  // For each number of things: the things of pair p.
  alignas(64) uint8_t j[most + 1][size];
  uint8_t k[most + 1][size];
  // For each number of things: the bits of the pairs whose first thing, or second thing, is thing t.
  alignas(32) uint32_t first[most + 1][most];
  alignas(32) uint32_t second[most + 1][most];
  // For each four of the 28 pairs of eight things, and for each of the 16 sets of these four: a symmetric matrix of
  // 8 x 8 bits, a byte for each row, with the bits of the pairs in the set. The pairs of fewer things are the last of
  // the 28, in the same order: those of the last things.
  static constexpr uint32_t fours = 7;
  uint64_t matrix[fours][16];
};
// One table for the kernels of all targets.
extern const PairsOfFew pairs_of_few;

namespace {

constexpr uint32_t count_of_pairs(uint32_t things) {
  return things * (things - 1) / 2;
}

// The matrix of the pairs whose bits are set in `pairs`, pairs of `things` things, which are the last of the eight.
inline uint64_t matrix_of(uint32_t things, uint32_t pairs) {
  uint64_t all = 0;
  pairs <<= 4 * PairsOfFew::fours - count_of_pairs(things);
#pragma GCC unroll 7
  for (uint32_t four = 0; four < PairsOfFew::fours; ++four) {
    all |= pairs_of_few.matrix[four][pairs >> 4 * four & 15U];
  }
  return all;
}

// The bits of the things that are the first thing of a pair in as_first or the second thing of a pair in as_second.
inline LaneBits things_in(uint32_t things, uint32_t as_first, uint32_t as_second) {
  LaneBits in_none = 0;
  for (uint32_t t = 0; t < PairsOfFew::most; t += Integers::lanes) {
    const Integers pairs = (Integers::load(pairs_of_few.first[things] + t) & Integers::all(as_first)) |
                           (Integers::load(pairs_of_few.second[things] + t) & Integers::all(as_second));
    in_none |= equal(pairs, Integers::all(0)) << t;
  }
  return ~in_none & ((1U << things) - 1U);
}

// The number of connected components of a graph of `things` things with this symmetric matrix (Warshall 1962).
inline uint32_t connected_sets(uint64_t matrix, uint32_t things) {
  constexpr uint64_t lowest_of_each = UINT64_C(0x0101010101010101);
#pragma GCC unroll 8
  for (uint32_t t = 0; t < 8; ++t) {
    const uint64_t rows = (matrix >> t & lowest_of_each) * 255;
    matrix |= rows & (matrix >> 8 * t & 255) * lowest_of_each;
  }
  // A component is counted at its first thing, which is connected with none before it.
  constexpr uint64_t before = UINT64_C(0x7F3F1F0F07030100), rest = UINT64_C(0x7F7F7F7F7F7F7F7F);
  const uint64_t earlier = matrix & before;
  const uint64_t has_earlier = (((earlier & rest) + rest) | earlier) >> 7 & lowest_of_each;
  return things - static_cast<uint32_t>(has_earlier * lowest_of_each >> 56);
}

}  // namespace
}  // namespace hsp
