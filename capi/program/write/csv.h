/* Tables for other programs: comma-separated values, quoted as RFC 4180 says; lines end with LF. */
#pragma once

#include "read/text_buffer.h"

/* A field of text, in quotes if it holds a comma, a quote or a line break. */
void csv_text(struct text_buffer *out, const char *text);

/* A number as number_text_exact writes it; nothing if it is not finite. */
void csv_number(struct text_buffer *out, double value);
