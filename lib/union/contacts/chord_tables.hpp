// The chords of one ball with two later caps each, while their ends are found. Two tables with one interface:
//   set_end(j, k, side)   notes that this end of the chord of caps j < k is known; returns whether the chord is new
//   count()               how many chords there are; they are numbered in the order in which they came
//   known_ends(n)         how many ends of chord n are known, 1 or 2
//   next_open(end)        gives the unknown end of a chord whose other end is known, each once; false if there is none
#pragma once

#include <cstring>

#include "core/span.hpp"
#include "core/status.hpp"

namespace hsp {

struct FoundChord {
  uint32_t cap[2];    // ascending
  uint8_t free_ends;  // how many of its ends are vertices of the boundary
  uint8_t known;      // for ListedChords: a bit for each end that is known
  uint32_t next;      // for ListedChords: the next chord with the same first cap, or no_id
};

// An end of the chord of caps j < k: p- if `side` is 0, p+ if it is 1.
struct ChordEnd {
  uint32_t j, k, side;
};

// For few caps, with bits. A processor cannot predict whether a chord is new and which end is known, so there is no
// branch on that.
class MaskedChords {
 public:
  static constexpr bool for_many = false;
  static constexpr uint32_t most_caps = 64;

  // caps: how many caps there are from `first` on. There must be room for one chord more than there will be.
  MaskedChords(Span<FoundChord> chords, uint32_t first, uint32_t caps) : chords_(chords.data()), first_(first) {
    for (uint64_t(&known)[most_caps] : known_) std::memset(known, 0, caps * sizeof known[0]);
  }

  bool set_end(uint32_t j, uint32_t k, uint32_t side) {
    const uint32_t row = j - first_;
    const uint64_t bit = UINT64_C(1) << (k - first_);
    const bool is_new = ((known_[0][row] | known_[1][row]) & bit) == 0;
    known_[side][row] |= bit;
    FoundChord &chord = chords_[count_];
    chord.cap[0] = j;
    chord.cap[1] = k;
    chord.free_ends = 0;
    count_ += is_new ? 1U : 0U;
    return is_new;
  }

  uint32_t count() const { return count_; }
  uint32_t known_ends(uint32_t n) const { return is_known(n, 0) + is_known(n, 1); }

  // The chord that has waited longest: so a processor can work on several chords at a time.
  bool next_open(ChordEnd &end) {
    for (; seen_ < count_; ++seen_) {
      const uint32_t is_side = is_known(seen_, 0);
      if (is_side == is_known(seen_, 1)) continue;
      const auto [j, k] = chords_[seen_++].cap;
      end = {j, k, is_side};
      return true;
    }
    return false;
  }

 private:
  uint32_t is_known(uint32_t n, uint32_t side) const {
    const auto [j, k] = chords_[n].cap;
    return static_cast<uint32_t>(known_[side][j - first_] >> (k - first_) & 1);
  }

  FoundChord *chords_;
  uint32_t first_, count_ = 0;
  uint32_t seen_ = 0;             // the first chord that next_open() has not passed yet
  uint64_t known_[2][most_caps];  // by side and first cap: a bit for each second cap
};

// For any number of caps: lists by the first cap, ascending in the second cap.
class ListedChords {
 public:
  static constexpr bool for_many = true;
  // heads [caps]
  ListedChords(Span<FoundChord> chords, Span<uint32_t> heads, uint32_t first, uint32_t caps)
      : chords_(chords), heads_(heads), first_(first) {
    for (uint32_t row = 0; row < caps; ++row) heads_[row] = no_id;
  }

  bool set_end(uint32_t j, uint32_t k, uint32_t side) {
    uint32_t *link = &heads_[j - first_];
    while (*link != no_id && chords_[*link].cap[1] < k) link = &chords_[*link].next;
    const bool is_new = *link == no_id || chords_[*link].cap[1] != k;
    if (is_new) {
      chords_[count_] = {{j, k}, 0, 0, *link};
      *link = count_++;
    }
    uint8_t &known = chords_[*link].known;
    known = static_cast<uint8_t>(known | 1U << side);
    return is_new;
  }

  uint32_t count() const { return count_; }
  uint32_t known_ends(uint32_t n) const { return chords_[n].known == 3 ? 2 : 1; }

  bool next_open(ChordEnd &end) {
    for (; seen_ < count_; ++seen_) {
      const FoundChord &chord = chords_[seen_];
      if (chord.known == 3) continue;
      ++seen_;
      end = {chord.cap[0], chord.cap[1], chord.known == 1 ? 1U : 0U};
      return true;
    }
    return false;
  }

 private:
  Span<FoundChord> chords_;
  Span<uint32_t> heads_;
  uint32_t first_, count_ = 0;
  uint32_t seen_ = 0;  // the first chord that next_open() has not passed yet
};

}  // namespace hsp
