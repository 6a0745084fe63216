// A cache of positions: vertices and other points of the actual set, as they were computed in some width. Most
// questions are about the same few points. The memory is lent by the caller; the oldest positions make room for new
// ones. No answer depends on how many are kept.
#pragma once

#include "core/span.hpp"
#include "core/status.hpp"
#include "numbers/number_vector.hpp"

namespace hsp {

class KeptVertices {
 public:
  KeptVertices() = default;
  explicit KeptVertices(Span<uint64_t> memory) {
    const uint32_t places = memory.size() / words_for_place;
    if (places == 0) return;
    places_ = memory.part(0, 2 * places);
    words_ = memory.part(2 * places, memory.size());
    for (uint64_t &word : places_) word = no_id;
  }

  // Writes the position to x; false if it is not kept.
  template <class Number>
  bool find(uint32_t vertex, uint32_t bits, NumberVector<Number> &x) const {
    if (places_.empty()) return false;
    const uint64_t *const place = place_of(vertex, bits);
    if (place[0] != name(vertex, bits) || end_ - place[1] > words_.size()) return false;
    const uint64_t *from = words_.data() + place[1] % words_.size();
    Number *const numbers[] = {&x.x, &x.y, &x.z};
    for (Number *const number : numbers) {
      number->load(from);
      from += Number::words_of(bits);
    }
    return true;
  }
  template <class Number>
  void keep(uint32_t vertex, uint32_t bits, const NumberVector<Number> &x) {
    const uint32_t size = 3 * Number::words_of(bits);
    if (size > words_.size()) return;
    // The words of a position are consecutive.
    if (end_ % words_.size() + size > words_.size()) end_ += words_.size() - end_ % words_.size();
    uint64_t *const place = place_of(vertex, bits);
    place[0] = name(vertex, bits);
    place[1] = end_;
    uint64_t *to = words_.data() + end_ % words_.size();
    const Number *const numbers[] = {&x.x, &x.y, &x.z};
    for (const Number *const number : numbers) {
      number->store(to);
      to += Number::words_of(bits);
    }
    end_ += size;
  }

 private:
  // There is one place for so many words of memory; a place takes two of them.
  static constexpr uint32_t words_for_place = 16;

  static uint64_t name(uint32_t vertex, uint32_t bits) { return uint64_t{vertex} << 32 | bits; }
  // A place holds the name of a position, and the number of its first word; words are counted on without starting anew.
  uint64_t *place_of(uint32_t vertex, uint32_t bits) const {
    return places_.data() + uint64_t{(vertex * 7 + bits / 64) % (places_.size() / 2)} * 2;
  }

  Span<uint64_t> places_, words_;
  uint64_t end_ = 0;
};

}  // namespace hsp
