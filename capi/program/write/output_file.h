/* The one way in which files are written: beside the old files, which are replaced at the end of the run. Each is whole
 * or as it was. A run that fails before its end replaces none; if at the end a file cannot be replaced, those that were
 * begun before it are replaced already and stay so, and it and the others are as they were. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "read/failure.h"
#include "read/text_buffer.h"
#include "write/same_file.h"

struct output_file {
  const char *path; /* as the user wrote it */
  FILE *stream;
  struct new_file *made; /* what stands beside the old one; NULL where bytes go to their place at once */
  bool in_place;         /* they do, and are taken away there if anything fails (new_file.h) */
  int reason;            /* errno of the first thing that failed, 0 if nothing did */
  bool no_room;          /* that was to make a new file in the folder */
  bool taken;            /* another output of the run has this place */
};

/* Begin to write. The thing that path stands for decides where the bytes go:
 *   1. standard output: there;
 *   2. a device, a pipe or the like: there;
 *   3. a file, or no file yet: a new file in the same folder. A symbolic link is followed, so that it stays a link.
 * False, with the path named, if that cannot be, or if a file of this run waits for the same place; then there is
 * nothing to finish. */
bool output_file_open(struct output_file *file, const char *path, struct failure *failure);

/* False once anything could not be written; output_file_finish will say why. */
bool output_file_write(struct output_file *file, const char *bytes, size_t count);

/* The end: the new file is whole and waits until the run keeps its files. False, with the path named, if not all was
 * written; the new file is gone then. */
bool output_file_finish(struct output_file *file, struct failure *failure);

/* Instead of the end: the new file is taken away. Signals that end the program do the same. */
void output_file_abandon(struct output_file *file);

/* The end of a run that did all else, standard output included: its files, which are all finished, take the places of
 * old ones in the order in which they were begun, with their permissions. False, with the path named, if one cannot; it
 * and those after it are as they were then, once they are dropped, and those before it are new. */
bool output_files_keep(struct failure *failure);

/* The end of a run that failed: new files are taken away, but those that were kept. The path that a
 * failure names is gone, too. */
void output_files_drop(void);

/* A file of this text and nothing else: all of the above. False for a text that memory was short for, too. */
bool output_file_write_text(const char *path, const struct text_buffer *text, struct failure *failure);
