/* The report on a file: which atoms were read, which were left out, and how the rest became balls. */
#pragma once

#include "commands/request.h"
#include "read/molecule.h"
#include "read/text_buffer.h"
#include "write/record.h"

/* The heading of every table: file, balls, atoms left out, radii, probe. */
void report_heading(struct text_buffer *out, const struct request *request, const struct molecule *molecule);

/* The files of a table with a row for each. */
struct files_among {
  const char *first; /* its name */
  bool one_unit;     /* the lengths of all are in that of the request's format */
  bool own_radii;    /* some bring their own */
};

/* The heading of a table with a row for each of several files or molecules: the data that all share, as the request has
 * it. */
void rows_heading(struct text_buffer *out, const struct request *request, const struct files_among *files);

/* The last key of every command's JSON: , "input": {...} */
void input_report_json(struct text_buffer *out, const struct request *request, const struct molecule *molecule);

/* Write the results that `print` puts into a record, and the report on the file before or behind them: as a table, an
 * object of JSON, or a line of CSV or of a table. A line has titles before it, in a trajectory only that of the first
 * frame. */
void report(const struct request *request, const struct molecule *molecule,
            void print(struct record *record, const void *of), const void *of, struct text_buffer *out);

/* Write the table as comma-separated values. In a trajectory each row begins with the columns of its frame, and only
 * the first frame has titles. The table has no lead of its own. */
void report_list(const struct molecule *molecule, const struct table *table, struct text_buffer *out);

/* How many molecules of water are among the balls; 0 if there is nothing else. */
uint64_t input_report_waters(const struct molecule *molecule);
