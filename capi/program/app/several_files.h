/* One command on several files: what each of them gives, one after the other. */
#ifndef HARDSPHERE_TOOL_SEVERAL_FILES_H
#define HARDSPHERE_TOOL_SEVERAL_FILES_H

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"
#include "read/text_buffer.h"

/* What was printed so far. */
struct several_files {
  bool any;
  struct text_buffer header; /* of the table of --csv, which all share */
};

#define SEVERAL_FILES_NONE \
  { false, TEXT_BUFFER_EMPTY }

/* Print what a file gave: tables with an empty line between them, JSON as one object a line, and of --csv one table
 * with the file's name as its first column. False: it cannot be printed, or its table has other columns than the first
 * one. */
bool several_files_print(struct several_files *several, const struct request *request, const struct text_buffer *record,
                         struct failure *failure);

void several_files_free(struct several_files *several);

#endif
