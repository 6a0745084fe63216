// The chords of one ball with later caps, by pairs of these, while their ends are found. Two tables of one interface:
//   set_end(j, k, side, clipper)  of the chord of caps j < k, which is new or not
//   next_open(end)                an end that is not known of a chord of which the other one is; false if there is none
//   link()                        when all are known: the first chord; each has the next one, ascending by caps
#pragma once

#include "core/span.hpp"
#include "core/status.hpp"

namespace hsp {

struct FoundChord {
  uint32_t cap[2];      // ascending
  uint32_t clipper[2];  // balls that clip it at the side of p- and of p+; no_id where it ends in a vertex
  uint32_t vertex;      // of the boundary, one that it ends in, or no_id if that is not known; if it has a free end
  uint32_t next;        // the next chord, or no_id

  uint32_t free_ends() const { return (clipper[0] == no_id ? 1U : 0U) + (clipper[1] == no_id ? 1U : 0U); }
};

// The end of a chord.
struct ChordEnd {
  uint32_t j, k, side;
};

// For few caps. Whether a chord is new, and which end of it is known, cannot be predicted, so there are no branches on
// it: bits tell.
class MaskedChords {
 public:
  static constexpr uint32_t most_caps = 64;

  // Of caps from `first` on.
  MaskedChords(Span<FoundChord> chords, uint32_t first, uint32_t caps) : chords_(chords), first_(first) {
    for (uint32_t row = 0; row < caps; ++row) known_[row][0] = known_[row][1] = 0;
  }

  FoundChord &set_end(uint32_t j, uint32_t k, uint32_t side, uint32_t clipper) {
    const uint32_t row = j - first_;
    const uint32_t column = k - first_;
    uint64_t(&known)[2] = known_[row];
    const uint32_t is_old = static_cast<uint32_t>((known[0] | known[1]) >> column & 1);
    const uint32_t at = (slot_[row][column] & (0U - is_old)) | (count_ & (is_old - 1));
    slot_[row][column] = static_cast<uint8_t>(at);
    count_ += 1 - is_old;
    known[side] |= UINT64_C(1) << column;
    rows_ |= UINT64_C(1) << row;
    FoundChord &chord = chords_[at];
    chord.cap[0] = j;
    chord.cap[1] = k;
    chord.clipper[side] = clipper;
    return chord;
  }

  // The one that has waited longest, so that a processor can look for its other end while others are being found.
  bool next_open(ChordEnd &end) {
    for (; seen_ < count_; ++seen_) {
      const auto [j, k] = chords_[seen_].cap;
      const uint64_t(&known)[2] = known_[j - first_];
      const uint32_t column = k - first_;
      if (((known[0] ^ known[1]) >> column & 1) == 0) continue;
      end = {j, k, static_cast<uint32_t>(known[0] >> column & 1)};
      return true;
    }
    return false;
  }

  uint32_t link() {
    uint32_t first = no_id;
    uint32_t *link = &first;
    uint64_t rows = rows_;
    uint64_t left = 0;
    for (uint32_t n = 0; n < count_; ++n) {
      const uint32_t row = lowest_bit(rows);
      left = left == 0 ? known_[row][0] : left;
      const uint32_t at = slot_[row][lowest_bit(left)];
      left &= left - 1;
      rows = left == 0 ? rows & (rows - 1) : rows;
      *link = at;
      link = &chords_[at].next;
    }
    *link = no_id;
    return first;
  }

 private:
  static uint32_t lowest_bit(uint64_t bits) { return static_cast<uint32_t>(__builtin_ctzll(bits)); }

  Span<FoundChord> chords_;
  uint32_t first_, count_ = 0;
  uint32_t seen_ = 0;                   // chords of which both ends are known, from the first on
  uint64_t rows_ = 0;                   // that have chords
  uint64_t known_[most_caps][2];        // by first cap: a bit for each second one
  uint8_t slot_[most_caps][most_caps];  // of those with a bit; there are fewer than three for each cap
};

// For any number: lists by first caps, ascending in the second ones.
class ListedChords {
 public:
  // `heads` is for as many as there are caps.
  ListedChords(Span<FoundChord> chords, Span<uint32_t> heads, uint32_t first, uint32_t caps)
      : chords_(chords), heads_(heads), first_(first), caps_(caps) {
    for (uint32_t row = 0; row < caps; ++row) heads_[row] = no_id;
  }

  FoundChord &set_end(uint32_t j, uint32_t k, uint32_t side, uint32_t clipper) {
    uint32_t *link = &heads_[j - first_];
    while (*link != no_id && chords_[*link].cap[1] < k) link = &chords_[*link].next;
    if (*link == no_id || chords_[*link].cap[1] != k) {
      chords_[count_] = {{j, k}, {unknown, unknown}, no_id, *link};
      *link = count_++;
    }
    FoundChord &chord = chords_[*link];
    chord.clipper[side] = clipper;
    return chord;
  }

  // An end that this returns is known before the next call.
  bool next_open(ChordEnd &end) {
    for (; seen_ < count_; ++seen_) {
      const FoundChord &chord = chords_[seen_];
      for (uint32_t side = 0; side < 2; ++side) {
        if (chord.clipper[side] != unknown) continue;
        end = {chord.cap[0], chord.cap[1], side};
        return true;
      }
    }
    return false;
  }

  uint32_t link() {
    uint32_t first = no_id;
    uint32_t *link = &first;
    for (uint32_t row = 0; row < caps_; ++row) {
      *link = heads_[row];
      while (*link != no_id) link = &chords_[*link].next;
    }
    return first;
  }

 private:
  // No ball.
  static constexpr uint32_t unknown = no_id - 1;

  Span<FoundChord> chords_;
  Span<uint32_t> heads_;
  uint32_t first_, caps_, count_ = 0;
  uint32_t seen_ = 0;  // chords of which both ends are known, from the first on
};

}  // namespace hsp
