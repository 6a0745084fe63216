/* A reader of binary files, one piece of bytes after the other. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "read/failure.h"

struct byte_reader {
  FILE *file; /* closed by byte_reader_close unless it is standard input */
};

/* Open a file, or standard input; false with the system's reason if that cannot be done. */
bool byte_reader_open(struct byte_reader *reader, const char *path, struct failure *failure);

/* Whether there are no more bytes. */
bool byte_reader_at_end(const struct byte_reader *reader);

/* Read so many bytes. False: the file ends before, or cannot be read. */
bool byte_reader_take(struct byte_reader *reader, void *out, size_t count, struct failure *failure);

/* The same without keeping them. */
bool byte_reader_skip(struct byte_reader *reader, uint64_t count, struct failure *failure);

void byte_reader_close(struct byte_reader *reader);

/* Numbers from their bytes, with the lowest or the highest byte first. */
static inline uint32_t bytes_to_u32(const unsigned char *at, bool highest_first) {
  return highest_first ? (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3]
                       : (uint32_t)at[3] << 24 | (uint32_t)at[2] << 16 | (uint32_t)at[1] << 8 | at[0];
}
static inline uint64_t bytes_to_u64(const unsigned char *at, bool highest_first) {
  const uint64_t first = bytes_to_u32(at, highest_first), second = bytes_to_u32(at + 4, highest_first);
  return highest_first ? first << 32 | second : second << 32 | first;
}

/* The signed number with these bits. */
int32_t bits_to_i32(uint32_t bits);
float bits_to_float(uint32_t bits);
double bits_to_double(uint64_t bits);

/* The double nearest to the shortest decimal number that rounds to this float: 0.1, not the 17 digits of the float. */
double float_as_written(float value);
