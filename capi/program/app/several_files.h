/* One command on several files, by several threads: what each of them gives, one after the other. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "app/notes.h"
#include "commands/request.h"
#include "read/failure.h"
#include "read/text_buffer.h"

/* Do what is asked for with the file of a request, by so many threads. */
typedef bool file_function(const struct request *request, uint32_t threads, struct notes *notes,
                           struct text_buffer *out, struct failure *failure);

/* Run it on all files of the command line, of which `first` is the request for the first one, and print what they give
 * in their order: tables with an empty line between them, JSON as one object a line, and of --csv one table with the
 * file's name as its first column. A command line at fault stops all before anything is read: false. A file at fault,
 * or one whose table has other columns than the first one, stops only itself: its failure is printed, and of the last
 * one the failure has the exit status. */
bool several_files_run(const struct request *first, int count, char **arguments, file_function *run,
                       struct failure *failure);
