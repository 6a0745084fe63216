/* malloc and its relatives, replaced by functions that count their calls while armed. To be included by one source of a
 * program. For glibc only, and not for sanitizer builds, which bring their own malloc. */
#pragma once

#include <stdlib.h>

extern void *__libc_malloc(size_t bytes);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *memory, size_t bytes);
extern void __libc_free(void *memory);

static volatile int armed;
static volatile int caught;

/* The trap is itself tested, so it counts instead of ending the program. */
static void spring(void) {
  if (armed) ++caught;
}

void *malloc(size_t bytes) {
  spring();
  return __libc_malloc(bytes);
}
void *calloc(size_t count, size_t size) {
  spring();
  return __libc_calloc(count, size);
}
void *realloc(void *memory, size_t bytes) {
  spring();
  return __libc_realloc(memory, bytes);
}
void free(void *memory) {
  spring();
  __libc_free(memory);
}
