// A directory of the non-empty cubes in a static perfect hash table of two levels (Fredman, Komlos, Szemeredi: "Storing
// a sparse table with O(1) worst case access time", J. ACM 31 (1984) 538), which Theorem 3.2 rests on in its dynamic
// form: every search looks at one bucket and one slot.
//
// The hash functions are x -> (a x mod 2^64) / 2^(64 - k) with a random odd a. Two keys collide with a probability of
// at most 2 / 2^k (Dietzfelbinger, Hagerup, Katajainen, Penttonen: "A reliable randomized algorithm for the closest
// pair problem", J. Algorithms 25 (1997) 19). So n keys in 2^k >= n buckets make at most 2 n pairs (x, y), x != y, of
// one bucket on average, and no more than 4 n in every other trial; b keys in at least 2 b (b - 1) slots collide in
// less than every other trial.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "random_numbers.hpp"
#include "section_3/cubes.hpp"
#include "section_3/grouped_balls.hpp"

namespace bench {

class PerfectHashing {
 public:
  void build(const Cubes &, const std::vector<Cube> &cube, std::vector<uint32_t> &numbers) {
    support::Random random(1984);
    trials_ = 0;
    std::vector<uint64_t> key_of_ball;
    for (const Cube &c : cube) key_of_ball.push_back(packed(c));
    do split(key_of_ball, random);
    while (pairs_in_buckets() > 4 * keys_.size());
    slots_.clear();
    for (size_t b = 0; b + 1 < first_key_.size(); ++b) place_keys(b, random);
    const std::vector<uint32_t> place = sort_cubes(keys_);
    for (uint32_t &number : slots_) number = number == none ? none : place[number];
    numbers.clear();
    for (const uint64_t key : key_of_ball) numbers.push_back(slots_[slot_of(key)]);
  }

  uint32_t count() const { return static_cast<uint32_t>(keys_.size()); }

  template <class Visit>
  void visit_row(uint32_t x_low, uint32_t x_high, uint32_t y, uint32_t z, Visit visit) const {
    const auto find = [&](uint64_t key) {
      const uint32_t number = slots_[slot_of(key)];
      return number != none && keys_[number] == key ? number : none;
    };
    visit_row_of(keys_, x_low, x_high, y, z, find, visit);
  }

  size_t bytes() const { return bytes_of(buckets_) + bytes_of(slots_) + bytes_of(keys_); }

  // How many hash functions were tried, of both levels, for each that was needed.
  double trials_per_function() const { return trials_ / static_cast<double>(functions_); }

 private:
  static constexpr uint32_t none = UINT32_MAX;

  struct Hash {
    uint64_t multiplier;
    uint32_t shift;  // 64 - k, at most 63
    uint64_t operator()(uint64_t key) const { return (multiplier * key) >> shift; }
  };
  struct Bucket {
    Hash hash;
    uint32_t first_slot;
  };

  // At least so many values.
  Hash random_hash(uint64_t values, support::Random &random) {
    ++trials_;
    const uint32_t bits = values <= 2 ? 1 : static_cast<uint32_t>(std::bit_width(values - 1));
    return {random.next() | 1U, 64 - bits};
  }
  static uint64_t values_of(const Hash &hash) { return uint64_t{1} << (64 - hash.shift); }

  uint64_t slot_of(uint64_t key) const {
    const Bucket &bucket = buckets_[top_(key)];
    return bucket.first_slot + bucket.hash(key);
  }

  // First level: keys of balls into buckets, each key of a bucket once.
  void split(const std::vector<uint64_t> &key_of_ball, support::Random &random) {
    top_ = random_hash(key_of_ball.size(), random);
    const size_t buckets = values_of(top_);
    std::vector<uint32_t> first_ball(buckets + 1, 0);
    for (const uint64_t key : key_of_ball) ++first_ball[top_(key) + 1];
    for (size_t b = 0; b < buckets; ++b) first_ball[b + 1] += first_ball[b];
    std::vector<uint32_t> next(first_ball.begin(), first_ball.end() - 1);
    std::vector<uint64_t> grouped(key_of_ball.size());
    for (const uint64_t key : key_of_ball) grouped[next[top_(key)]++] = key;
    keys_.clear();
    first_key_.assign(1, 0);
    for (size_t b = 0; b < buckets; ++b) {
      for (size_t i = first_ball[b]; i < first_ball[b + 1]; ++i) {
        size_t k = first_key_.back();
        while (k < keys_.size() && keys_[k] != grouped[i]) ++k;
        if (k == keys_.size()) keys_.push_back(grouped[i]);
      }
      first_key_.push_back(count());
    }
    buckets_.assign(buckets, Bucket{});
    functions_ = 1;
  }

  uint64_t pairs_in_buckets() const {
    uint64_t pairs = 0;
    for (size_t b = 0; b + 1 < first_key_.size(); ++b) {
      const uint64_t size = first_key_[b + 1] - first_key_[b];
      if (size > 1) pairs += size * (size - 1);
    }
    return pairs;
  }

  // Second level: a hash function without collisions for the keys of a bucket. Empty buckets share two empty slots.
  void place_keys(size_t b, support::Random &random) {
    const uint32_t begin = first_key_[b];
    const uint32_t end = first_key_[b + 1];
    if (slots_.empty()) slots_.assign(2, none);
    buckets_[b] = {{1, 63}, 0};
    if (begin == end) return;
    ++functions_;
    const uint32_t first_slot = static_cast<uint32_t>(slots_.size());
    const uint64_t size = end - begin;
    for (bool collides = true; collides;) {
      const Hash hash = random_hash(2 * size * (size - 1), random);
      buckets_[b] = {hash, first_slot};
      slots_.resize(first_slot);
      slots_.resize(first_slot + values_of(hash), none);
      collides = false;
      for (uint32_t k = begin; k < end && !collides; ++k) {
        uint32_t &slot = slots_[first_slot + hash(keys_[k])];
        collides = slot != none;
        slot = k;
      }
    }
  }

  Hash top_{1, 63};
  std::vector<Bucket> buckets_;
  std::vector<uint32_t> slots_;      // numbers of cubes, or none
  std::vector<uint64_t> keys_;       // of each cube
  std::vector<uint32_t> first_key_;  // [buckets + 1], while building
  double trials_ = 0;
  size_t functions_ = 1;
};

}  // namespace bench
