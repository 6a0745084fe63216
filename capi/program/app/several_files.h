/* One command for several files, by several threads; the results come in the order of the files. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "app/notes.h"
#include "commands/request.h"
#include "read/failure.h"
#include "read/text_buffer.h"

/* Do what a request asks for with its file, by that many threads. */
typedef bool file_function(const struct request *request, uint32_t threads, struct notes *notes,
                           struct text_buffer *out, struct failure *failure);

/* Run it on all files of the command line (`first` is the request for the first one) and print the results in their
 * order: tables with an empty line between them, JSON as one object a line, and for --csv one table with the file's
 * name as its first column. A faulty command line stops all before anything is read: false. A faulty file, or one whose
 * table has other columns than that of the first file, stops only itself: its failure is printed, and the exit status
 * is that of the last such failure. */
bool several_files_run(const struct request *first, int count, char **arguments, file_function *run,
                       struct failure *failure);
