/* Blocks of memory that tell whether somebody wrote beside them: each lies between two strips of a known pattern and is
 * itself filled before use. */
#pragma once

#include <stddef.h>

typedef struct guarded_memory {
  unsigned char *whole; /* what malloc gave */
  unsigned char *block; /* what is handed out */
  size_t bytes;         /* length of block */
  size_t front;         /* length of the strip before it */
} guarded_memory;

/* The bytes that fill a block; GUARDED_RANDOM differs from byte to byte. */
enum { GUARDED_PATTERN = 0xA5, GUARDED_RANDOM = 256 };

/* A block of exactly `bytes` bytes whose address is `misalignment` (0..63) more than a multiple of 64. fill is a byte
 * or GUARDED_RANDOM. Ends the program if there is no memory. */
guarded_memory guarded_take(size_t bytes, size_t misalignment, int fill);

/* Whether both strips are as they were. */
int guarded_clean(const guarded_memory *memory);

/* Whether the block itself still holds nothing but `byte`. */
int guarded_untouched(const guarded_memory *memory, unsigned char byte);

void guarded_give_back(guarded_memory *memory);
