/* The molecules of a file of many, one after the other, each as its text: only one is in memory at a time. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/fields.h"
#include "read/file_format.h"
#include "read/line_reader.h"
#include "read/text_buffer.h"

/* The text of one molecule: first the lines that are common to all, if there are any, then its own. */
struct molecule_text {
  struct text_buffer text;
  uint64_t number; /* counted from 1 */
  uint64_t common; /* how many lines are common to all: the first ones of the file */
  uint64_t before; /* lines of the file before its own */
};

struct molecule_texts {
  const struct file_format *format;
  struct line_reader reader;
  struct molecule_lines lines;
  struct text_buffer common;
  uint64_t common_lines;
  struct text_buffer behind; /* lines read that are the next molecule's */
  uint64_t behind_lines;
  bool held; /* the reader's line is the first of the next molecule */
  bool ended;
  struct failure broken; /* why reading ended behind a complete molecule */
  uint64_t given;
};

/* Open a file of a format with FILE_MOLECULES. False: it cannot be opened. Close it on true and on false. */
bool molecule_texts_open(struct molecule_texts *texts, const char *path, const struct file_format *format,
                         struct failure *failure);

/* Step to the next molecule. Lines behind the last one that form no molecule are ignored, unless the file has nothing
 * else. LINE_END: there is none. LINE_FAILED: the file cannot be read further, and the molecule begun is not whole. */
enum line_status molecule_texts_next(struct molecule_texts *texts, struct molecule_text *text, struct failure *failure);

void molecule_texts_close(struct molecule_texts *texts);

/* The number in the file of a line of the text; 0 stays 0: no line. */
static inline uint64_t molecule_text_line(const struct molecule_text *text, uint64_t line) {
  return line <= text->common ? line : line + text->before - text->common;
}

/* Step over a line of a text, which ends with '\n'. Returns the line without blanks around it. */
struct field molecule_text_next_line(const char **text, size_t *length);
