/* A reader of text files, one line at a time. Lines have any length, and end with LF, CRLF, CR or the end of the
 * file. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "read/failure.h"
#include "read/progress.h"

#define LINE_READER_BLOCK 32768

struct line_reader {
  char *text;         /* the current line without its end, NUL-terminated, in the block; valid until the next call. 16
                         bytes may be read from any place in it. */
  size_t length;      /* its length */
  const char *ending; /* what ended it: "\n", "\r\n", "\r", or "" at the end of the file */
  bool marked;        /* a byte-order mark was dropped from it */
  uint64_t number;    /* its number, counted from 1; 0 before the first line */
  FILE *file;         /* closed by line_reader_close unless it is standard input */
  char *block;        /* bytes of the file that were read and not yet passed */
  size_t capacity;    /* of the block, without the spare bytes behind it */
  size_t next;        /* first byte of the block that was not looked at */
  size_t filled;      /* bytes in the block */
  uint64_t bytes;     /* how many bytes were read in all */
  bool borrowed;      /* the block is the whole text, and the caller's */
  struct progress progress;
};

/* Whether the name of an input stands for standard input: "-". */
bool input_is_standard(const char *path);

/* The name of an input for messages: its own, or "standard input". */
const char *input_name(const char *path);

/* The same without folders. */
const char *input_base_name(const char *path);

/* Open a file for reading, or standard input, which must not be closed; NULL, with the system's reason, if that
 * fails. */
FILE *input_open(const char *path, struct failure *failure);

/* Open a file as a reader of lines. */
bool line_reader_open(struct line_reader *reader, const char *path, struct failure *failure);

/* Read lines in memory that another reader has passed, each with '\n' behind it. LINE_READER_ROOM bytes behind the text
 * are overwritten. */
enum { LINE_READER_ROOM = 64 };
void line_reader_open_text(struct line_reader *reader, char *text, size_t length);

/* Copy the rest of standard input to a file without a name and read that from now on, so that rewind(stdin) works even
 * if it was a pipe. */
bool line_reader_keep_standard_input(struct failure *failure);

enum line_status { LINE_READ, LINE_END, LINE_FAILED };

/* Step to the next line. LINE_END: there is none. LINE_FAILED: a read error, short memory, or bytes that do not occur
 * in text files (NUL and other control characters). A byte-order mark at the start of the file is dropped, and Ctrl-Z
 * at its end, behind which only ends of lines may follow. */
enum line_status line_reader_next(struct line_reader *reader, struct failure *failure);

/* Step over lines that are completely in the block, end with LF and do not begin with `mark`, which is no line end.
 * *text and *bytes become these lines with their ends, valid until the next call. Returns how many lines; 0: the next
 * line is of another kind, or not read yet. */
uint64_t line_reader_pass(struct line_reader *reader, char mark, const char **text, size_t *bytes);

/* Also takes the line of progress away. */
void line_reader_close(struct line_reader *reader);
