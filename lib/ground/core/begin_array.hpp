// Arrays in memory that held other arrays.
#pragma once

#include <new>

#include "core/span.hpp"

namespace hsp {

// Ends the lifetime of the old array and begins that of as many T as there is room for.
template <class T, class Other>
Span<T> begin_array(Span<Other> memory) {
  static_assert(alignof(T) <= alignof(Other));
  unsigned char *const bytes = reinterpret_cast<unsigned char *>(memory.data());
  const uint32_t count = static_cast<uint32_t>(uint64_t{memory.size()} * sizeof(Other) / sizeof(T));
  T *first = nullptr;
  for (uint32_t k = count; k-- > 0;) first = ::new (static_cast<void *>(bytes + k * sizeof(T))) T;
  return {first, count};
}

}  // namespace hsp
