#include "guarded_memory.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "random_numbers.h"

enum { STRIP = 128, ALIGNMENT = 64, STRIP_BYTE = 0x5C };

guarded_memory guarded_take(size_t bytes, size_t misalignment, int fill) {
  guarded_memory memory;
  size_t i;
  if (misalignment >= ALIGNMENT) {
    fprintf(stderr, "a test block cannot be %zu bytes off\n", misalignment);
    exit(2);
  }
  memory.whole = malloc(bytes + 2 * STRIP + 2 * ALIGNMENT);
  if (memory.whole == NULL) {
    fprintf(stderr, "out of memory for a test block of %zu bytes\n", bytes);
    exit(2);
  }
  memory.front = STRIP + (ALIGNMENT - (uintptr_t)(memory.whole + STRIP) % ALIGNMENT) % ALIGNMENT + misalignment;
  memory.block = memory.whole + memory.front;
  memory.bytes = bytes;
  memset(memory.whole, STRIP_BYTE, memory.front);
  memset(memory.block + bytes, STRIP_BYTE, STRIP);
  if (fill == GUARDED_RANDOM) {
    uint64_t state = 18;
    for (i = 0; i < bytes; ++i) memory.block[i] = (unsigned char)random_next(&state);
  } else {
    memset(memory.block, fill, bytes);
  }
  return memory;
}

static int all_are(const unsigned char *from, size_t bytes, unsigned char byte) {
  size_t i;
  for (i = 0; i < bytes; ++i) {
    if (from[i] != byte) return 0;
  }
  return 1;
}

int guarded_clean(const guarded_memory *memory) {
  return all_are(memory->whole, memory->front, STRIP_BYTE) && all_are(memory->block + memory->bytes, STRIP, STRIP_BYTE);
}

int guarded_untouched(const guarded_memory *memory, unsigned char byte) {
  return all_are(memory->block, memory->bytes, byte);
}

void guarded_give_back(guarded_memory *memory) {
  free(memory->whole);
  memory->whole = NULL;
  memory->block = NULL;
}
