/* The one way in which files are written: beside the old files, which are replaced at the end of the run. So each file
 * is either complete or as it was. A run that fails before its end replaces none. If at the end a file cannot be
 * replaced, those that were begun before it are replaced already and stay so; it and the others are as they were. */
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
  struct new_file *made; /* the new file beside the old one; NULL if bytes go to their place at once */
  bool in_place;         /* bytes go to their place at once, and are removed if anything fails (new_file.h) */
  int reason;            /* errno of the first call that failed, 0 if none did */
  bool no_room;          /* the failed call was to make a new file in the folder */
  bool taken;            /* another output of the run has this place */
};

/* Begin to write. The path decides where the bytes go:
 *   1. standard output: there;
 *   2. a device, a pipe or the like: there;
 *   3. a file, or no file yet: a new file in the same folder. A symbolic link is followed, so that it stays a link.
 * False, with the path named, if that is impossible, or if another file of this run is to take the same place; then
 * there is nothing to finish. */
bool output_file_open(struct output_file *file, const char *path, struct failure *failure);

/* Write bytes. False once anything could not be written; output_file_finish will say why. */
bool output_file_write(struct output_file *file, const char *bytes, size_t count);

/* End the file: it is complete and waits until the run keeps its files. False, with the path named, if not all was
 * written; the new file is removed then. */
bool output_file_finish(struct output_file *file, struct failure *failure);

/* Remove the new file instead of ending it. Signals that end the program do the same. */
void output_file_abandon(struct output_file *file);

/* End a run that did all else, standard output included. Its files, which are all finished, replace old ones in the
 * order in which they were begun, and get their permissions. False, with the path named, if one cannot be replaced:
 * those before it are new then, and it and those after it are as they were, once output_files_drop is called. */
bool output_files_keep(struct failure *failure);

/* End a run that failed: new files are removed, except those that were kept. The path that a failure names becomes
 * invalid, too. */
void output_files_drop(void);

/* Write a file of this text: open, write and finish. False also if memory was short for the text. */
bool output_file_write_text(const char *path, const struct text_buffer *text, struct failure *failure);
