/* What a ball is called in JSON and CSV: its index, and the names that its file's format has. */
#ifndef HARDSPHERE_TOOL_BALL_LABEL_H
#define HARDSPHERE_TOOL_BALL_LABEL_H

#include <stdint.h>

#include "read/molecule.h"
#include "read/text_buffer.h"

/* The keys from "ball" to "radius", without braces. */
void ball_label_json(const struct molecule *molecule, uint32_t ball, struct text_buffer *out);

/* The first columns of a row that is about a ball, and their titles with a suffix behind each. */
void ball_label_csv_titles(const struct file_format *format, const char *suffix, struct text_buffer *out);
void ball_label_csv(const struct molecule *molecule, uint32_t ball, struct text_buffer *out);

#endif
