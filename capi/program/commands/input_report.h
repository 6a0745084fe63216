/* What became of a file: what was read, what was left out, and how the rest became balls. */
#ifndef HARDSPHERE_TOOL_INPUT_REPORT_H
#define HARDSPHERE_TOOL_INPUT_REPORT_H

#include "commands/request.h"
#include "read/molecule.h"
#include "read/text_buffer.h"
#include "write/table.h"

/* What was read and how: file, balls, what was left out, radii, probe. Every table begins with it. */
void report_heading(struct text_buffer *out, const struct request *request, const struct molecule *molecule);

/* The last key of every command's JSON: , "input": {...} */
void input_report_json(struct text_buffer *out, const struct request *request, const struct molecule *molecule);

/* Results that are but numbers, in a table or as JSON, each with what was read. */
void input_report_results(struct text_buffer *out, const struct request *request, const struct molecule *molecule,
                          const struct result *results, size_t count);

/* How many molecules of water are among the balls; 0 if there is nothing else. */
uint64_t input_report_waters(const struct molecule *molecule);

#endif
