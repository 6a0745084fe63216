/* Lines of a text file, one at a time: any length, ended by LF, CRLF, CR or the end of the file. */
#ifndef HARDSPHERE_TOOL_LINE_READER_H
#define HARDSPHERE_TOOL_LINE_READER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "failure.h"

#define LINE_READER_CHUNK 65536

struct line_reader {
  char *text;         /* the current line without its end, NUL-terminated; valid until the next call */
  size_t length;      /* its length */
  const char *ending; /* what ended it: "\n", "\r\n", "\r", or "" at the end of the file */
  bool marked;        /* a byte-order mark was dropped from it */
  uint64_t number;    /* its number, counted from 1; 0 before the first line */
  FILE *file;
  size_t capacity; /* of text */
  size_t next;     /* first byte of the chunk that was not looked at */
  size_t filled;   /* bytes in the chunk */
  unsigned char chunk[LINE_READER_CHUNK];
};

/* Open a file; false with the system's reason if that cannot be done. */
bool line_reader_open(struct line_reader *reader, const char *path, struct failure *failure);

enum line_status { LINE_READ, LINE_END, LINE_FAILED };

/* Step to the next line. LINE_END: there is none. LINE_FAILED: a read error, short memory, or bytes that no text file
 * has (NUL and other control characters). A byte-order mark at the start of the file is dropped. */
enum line_status line_reader_next(struct line_reader *reader, struct failure *failure);

void line_reader_close(struct line_reader *reader);

#endif
