/* Lines of a text file, one at a time: any length, ended by LF, CRLF, CR or the end of the file. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "read/failure.h"
#include "read/progress.h"

#define LINE_READER_BLOCK 32768

struct line_reader {
  char *text;         /* the current line without its end, NUL-terminated, in the block; valid until the next call. From
                         any place in it 16 bytes may be read. */
  size_t length;      /* its length */
  const char *ending; /* what ended it: "\n", "\r\n", "\r", or "" at the end of the file */
  bool marked;        /* a byte-order mark was dropped from it */
  uint64_t number;    /* its number, counted from 1; 0 before the first line */
  FILE *file;         /* closed by line_reader_close unless it is standard input */
  char *block;        /* what was read of the file and not yet passed */
  size_t capacity;    /* of the block, not counting what is behind it */
  size_t next;        /* first byte of the block that was not looked at */
  size_t filled;      /* bytes in the block */
  uint64_t bytes;     /* all that were read */
  bool borrowed;      /* the block is all there is, and the caller's */
  struct progress progress;
};

/* Whether the name of an input stands for standard input: "-". */
bool input_is_standard(const char *path);

/* An input as a person calls it: by its name, or "standard input". */
const char *input_name(const char *path);

/* The same without folders. */
const char *input_base_name(const char *path);

/* A file to be read, or standard input, which is not to be closed; NULL with the system's reason if that cannot be
 * done. */
FILE *input_open(const char *path, struct failure *failure);

/* The same as a reader of lines. */
bool line_reader_open(struct line_reader *reader, const char *path, struct failure *failure);

/* The same of lines in memory that another reader has had, each with '\n' behind it; so many bytes behind all of them
 * are written. */
enum { LINE_READER_ROOM = 64 };
void line_reader_open_text(struct line_reader *reader, char *text, size_t length);

/* Put what is left of standard input into a file without a name and read that from now on, so that rewind(stdin) begins
 * anew, even if it was a pipe. */
bool line_reader_keep_standard_input(struct failure *failure);

enum line_status { LINE_READ, LINE_END, LINE_FAILED };

/* Step to the next line. LINE_END: there is none. LINE_FAILED: a read error, short memory, or bytes that no text file
 * has (NUL and other control characters). A byte-order mark at the start of the file is dropped. */
enum line_status line_reader_next(struct line_reader *reader, struct failure *failure);

/* Step over lines that are in the block as a whole, end with LF and do not begin with `mark`, no end of a line itself:
 * *bytes of them with their ends, valid until the next call. How many; 0: the next line is another one, or was not
 * read yet. */
uint64_t line_reader_pass(struct line_reader *reader, char mark, const char **text, size_t *bytes);

/* The line that shows the progress is taken away. */
void line_reader_close(struct line_reader *reader);
