/* The one way in which files are written: beside the old file, which is replaced at the end, whole or not at all. Where
 * there are no signals and owners of files, output_file_in_place.c writes in the file's place. */
#ifndef HARDSPHERE_TOOL_OUTPUT_FILE_H
#define HARDSPHERE_TOOL_OUTPUT_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "read/failure.h"
#include "read/text_buffer.h"
#include "write/same_file.h"

struct output_file {
  const char *path; /* as the user wrote it */
  FILE *stream;
  char *target;    /* the file that is replaced at the end; NULL where bytes go to their place at once */
  char *temporary; /* what stands beside it until then */
  int reason;      /* errno of the first thing that failed, 0 if nothing did */
  bool no_room;    /* that was to make a new file in the folder */
};

/* Begin to write. The thing that path stands for decides where the bytes go:
 *   1. standard output: there;
 *   2. a device, a pipe or the like: there;
 *   3. a file, or no file yet: a new file in the same folder. A symbolic link is followed, so that it stays a link.
 * False, with the path named, if that cannot be; then there is nothing to finish. */
bool output_file_open(struct output_file *file, const char *path, struct failure *failure);

/* False once anything could not be written; output_file_finish will say why. */
bool output_file_write(struct output_file *file, const char *bytes, size_t count);

/* The end: the new file takes the place of the old one, with its permissions. False, with the path named, if not all
 * was written; the old file is as it was then, and the new one gone. */
bool output_file_finish(struct output_file *file, struct failure *failure);

/* Instead of the end: the new file is taken away. Signals that end the program do the same. */
void output_file_abandon(struct output_file *file);

/* A file of this text and nothing else: all of the above. False for a text that memory was short for, too. */
bool output_file_write_text(const char *path, const struct text_buffer *text, struct failure *failure);

#endif
