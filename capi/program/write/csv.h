/* Tables for other programs: comma-separated values, quoted as RFC 4180 says; lines end with LF. */
#ifndef HARDSPHERE_TOOL_CSV_H
#define HARDSPHERE_TOOL_CSV_H

#include "read/molecule.h"
#include "read/text_buffer.h"

/* A field of text, in quotes if it holds a comma, a quote or a line break. */
void csv_text(struct text_buffer *out, const char *text);

/* A number as exact_text has it; nothing unless it is finite. */
void csv_number(struct text_buffer *out, double value);

/* Several of them, a comma before each. */
void csv_numbers(struct text_buffer *out, const double *numbers, int count);

/* The first columns of a table of frames, and of one of its rows; a comma is behind them. */
void csv_frame_titles(struct text_buffer *out);
void csv_frame(struct text_buffer *out, const struct molecule *molecule);

#endif
