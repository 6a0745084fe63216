/* Outputs filled with a pattern, to see that a failing call leaves them alone. */
#pragma once

#include <string.h>

#include "check.h"

/* Defined with the address sanitizer alone. It keeps some bytes of a handle's memory out of reach, see
 * lib/core/poison.hpp, also when the memory is used for something else. */
extern void __asan_unpoison_memory_region(const volatile void *memory, size_t bytes) __attribute__((weak));

static inline void fill_with_pattern(void *memory, size_t bytes) {
  if (__asan_unpoison_memory_region != NULL) __asan_unpoison_memory_region(memory, bytes);
  memset(memory, 0xA5, bytes);
}

#define FILL(object) fill_with_pattern(&(object), sizeof(object))
#define CHECK_UNTOUCHED(object)                                \
  do {                                                         \
    unsigned char untouched_pattern[sizeof(object)];           \
    memset(untouched_pattern, 0xA5, sizeof(object));           \
    CHECK_BYTES(&(object), untouched_pattern, sizeof(object)); \
  } while (0)
