/* The report on a file: what was read, what was left out, and how the rest became balls. */
#pragma once

#include "commands/request.h"
#include "read/molecule.h"
#include "read/text_buffer.h"
#include "write/record.h"

/* The heading says what was read and how: file, balls, what was left out, radii, probe. Every table begins with it. */
void report_heading(struct text_buffer *out, const struct request *request, const struct molecule *molecule);

/* The last key of every command's JSON: , "input": {...} */
void input_report_json(struct text_buffer *out, const struct request *request, const struct molecule *molecule);

/* The results that `print` puts into a record, with what was read before or behind them: a table, an object of JSON, or
 * of CSV a line and its titles, which of a trajectory the first frame alone has. */
void report(const struct request *request, const struct molecule *molecule,
            void print(struct record *record, const void *of), const void *of, struct text_buffer *out);

/* The table as comma-separated values; in a frame of a trajectory each row behind what the frame is, with titles in the
 * first frame alone. The table has no lead of its own. */
void report_list(const struct molecule *molecule, const struct table *table, struct text_buffer *out);

/* How many molecules of water are among the balls; 0 if there is nothing else. */
uint64_t input_report_waters(const struct molecule *molecule);
