/* Paint over a PDF file of the library: an incremental update, which changes no byte of the file. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/text_buffer.h"

/* Append to `out` the bytes that are to follow a compressed file of `size` bytes, whose last `count` bytes are `tail`.
 * They paint the operators `over` over its one page, of page[0] by page[1] px. False if memory is short. */
bool pdf_update_make(const char *over, const double page[2], const char *tail, size_t count, uint64_t size,
                     struct text_buffer *out);
