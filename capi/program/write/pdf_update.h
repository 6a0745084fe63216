/* The paint over a PDF file of the library: an incremental update, which changes nothing in the file. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/text_buffer.h"

/* Append to `out` what follows a compressed file of `size` bytes, the last `count` of which are `tail`: operators that
 * are painted over its one page, of page[0] by page[1] px. False if memory is short. */
bool pdf_update_make(const char *over, const double page[2], const char *tail, size_t count, uint64_t size,
                     struct text_buffer *out);
