// Spans: lengths, parts, and that a reader's span sees what the writer's writes.
#pragma once

#include "cases.hpp"
#include "core/span.hpp"

namespace cases {

static_assert(std::is_convertible_v<hsp::Span<int>, hsp::Span<const int>>);
static_assert(!std::is_convertible_v<hsp::Span<const int>, hsp::Span<int>>);

struct Part {
  uint32_t first, last;
};
constexpr Part parts[] = {{0, 0}, {0, 6}, {2, 5}, {6, 6}, {5, 6}};

inline uint32_t parts_are_where_they_belong() {
  return first_failing(parts, [](const Part &c) {
    int numbers[6] = {10, 11, 12, 13, 14, 15};
    const hsp::Span<int> all(numbers, 6);
    const hsp::Span<int> part = all.part(c.first, c.last);
    const hsp::Span<const int> read = part;
    if (part.size() != c.last - c.first || part.empty() != (c.first == c.last)) return false;
    if (read.data() != numbers + c.first || read.end() - read.begin() != static_cast<std::ptrdiff_t>(part.size())) {
      return false;
    }
    uint32_t k = c.first;
    for (const int number : read) {
      if (number != 10 + static_cast<int>(k++)) return false;
    }
    for (k = 0; k < part.size(); ++k) part[k] = -1;
    for (k = 0; k < 6; ++k) {
      if ((numbers[k] == -1) != (k >= c.first && k < c.last)) return false;
    }
    return hsp::Span<int>().empty() && hsp::Span<int>().data() == nullptr;
  });
}

inline constexpr Check core_span[] = {{"parts_are_where_they_belong", parts_are_where_they_belong}};

}  // namespace cases
