// Poisons bytes that no code may touch, for the address sanitizer, and overwrites arrays whose content is over. Only
// tests and fuzz harnesses (HSP_CHECK_INDEX) do this: the poison stays after the handle that carved the memory, and a
// caller may use the memory for something else.
#pragma once

#include <cstddef>
#include <cstring>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define HSP_ADDRESS_SANITIZER 1
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define HSP_ADDRESS_SANITIZER 1
#endif

#if HSP_CHECK_INDEX && HSP_ADDRESS_SANITIZER
extern "C" void __asan_poison_memory_region(const volatile void *memory, size_t bytes);
extern "C" void __asan_unpoison_memory_region(const volatile void *memory, size_t bytes);

namespace hsp {
inline constexpr bool poisons = true;
inline void poison(const void *memory, size_t bytes) {
  __asan_poison_memory_region(memory, bytes);
}
inline void unpoison(const void *memory, size_t bytes) {
  __asan_unpoison_memory_region(memory, bytes);
}
}  // namespace hsp
#else
namespace hsp {
inline constexpr bool poisons = false;
inline void poison(const void *, size_t) {}
inline void unpoison(const void *, size_t) {}
}  // namespace hsp
#endif

namespace hsp {

// Says that the content of an array is over, and that its memory may be used for something else. Where bytes are
// poisoned, the array is overwritten, so that tests see whether any code still relies on it.
template <class Array>
void forget(const Array &array) {
  if (poisons && array.size() > 0) std::memset(array.data(), 0xA5, array.size() * sizeof(array[0]));
}

}  // namespace hsp
