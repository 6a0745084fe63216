/* Outputs filled with a pattern, to see that a failing call leaves them alone. */
#pragma once

#include <string.h>

#include "check.h"

/* With the address sanitizer some bytes of a handle's memory stay poisoned (core/poison.hpp), even when the memory is
 * used for something else. */
#if defined(__SANITIZE_ADDRESS__)
#define HAS_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define HAS_ADDRESS_SANITIZER
#endif
#endif
#ifdef HAS_ADDRESS_SANITIZER
extern void __asan_unpoison_memory_region(const volatile void *memory, size_t bytes);
#define unpoison __asan_unpoison_memory_region
#else
#define unpoison(memory, bytes) ((void)0)
#endif

static inline void fill_with_pattern(void *memory, size_t bytes) {
  unpoison(memory, bytes);
  memset(memory, 0xA5, bytes);
}

#define FILL(object) fill_with_pattern(&(object), sizeof(object))
#define CHECK_UNTOUCHED(object)                                \
  do {                                                         \
    unsigned char untouched_pattern[sizeof(object)];           \
    memset(untouched_pattern, 0xA5, sizeof(object));           \
    CHECK_BYTES(&(object), untouched_pattern, sizeof(object)); \
  } while (0)
