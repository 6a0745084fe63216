#include "core/sorting.hpp"

namespace hsp {

void sort_ascending(Span<uint32_t> numbers) {
  sort_in_place(numbers, [](uint32_t a, uint32_t b) { return a < b; });
}

}  // namespace hsp
