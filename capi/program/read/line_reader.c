#define _POSIX_C_SOURCE 200112L /* dup2, fileno */

#include "read/line_reader.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "read/stopping.h"
#include "read/words.h"

bool input_is_standard(const char *path) {
  return strcmp(path, "-") == 0;
}

const char *input_name(const char *path) {
  return input_is_standard(path) ? "standard input" : path;
}

const char *input_base_name(const char *path) {
  const char *name = input_name(path);
  const char *slash = strrchr(name, '/');
  return slash == NULL ? name : slash + 1;
}

FILE *input_open(const char *path, struct failure *failure) {
  if (input_is_standard(path)) return stdin;
  errno = 0;
  FILE *file = fopen(path, "rb");
  if (file == NULL) failure_in_input(failure, 0, "%s", errno != 0 ? strerror(errno) : "cannot be opened");
  return file;
}

static void begin(struct line_reader *reader) {
  reader->text = NULL;
  reader->length = 0;
  reader->ending = "";
  reader->marked = false;
  reader->number = 0;
  reader->block = NULL;
  reader->capacity = 0;
  reader->next = 0;
  reader->filled = 0;
  reader->bytes = 0;
  reader->borrowed = false;
  reader->progress = (struct progress){false};
  reader->file = NULL;
}

bool line_reader_open(struct line_reader *reader, const char *path, struct failure *failure) {
  begin(reader);
  reader->file = input_open(path, failure);
  return reader->file != NULL;
}

void line_reader_open_text(struct line_reader *reader, char *text, size_t length) {
  begin(reader);
  reader->borrowed = true;
  reader->block = text;
  reader->capacity = reader->filled = length;
  memset(text + length, '\n', LINE_READER_ROOM);
}

#ifdef __wasi__
/* There are no files without names, and no second names for a descriptor. */
bool line_reader_keep_standard_input(struct failure *failure) {
  failure->file = input_name("-");
  return failure_in_input(failure, 0, "cannot be kept to be read again");
}
#else
/* Copy the rest of standard input into a file. False with errno. */
static bool copy_standard_input(FILE *copy) {
  char bytes[4096];
  for (;;) {
    const size_t got = fread(bytes, 1, sizeof bytes, stdin);
    if (got == 0) return !ferror(stdin) && fflush(copy) == 0;
    if (fwrite(bytes, 1, got, copy) != got) return false;
  }
}

bool line_reader_keep_standard_input(struct failure *failure) {
  errno = 0;
  FILE *copy = tmpfile();
  const bool kept = copy != NULL && copy_standard_input(copy) && dup2(fileno(copy), STDIN_FILENO) == STDIN_FILENO;
  if (!kept) {
    failure->file = input_name("-");
    failure_in_input(failure, 0, "%s", errno != 0 ? strerror(errno) : "cannot be kept to be read again");
  }
  if (copy != NULL) fclose(copy);
  rewind(stdin);
  return kept;
}
#endif

/* A person who watches sees large files grow. */
static void show_progress(struct line_reader *reader, size_t got) {
  const uint64_t before = reader->bytes;
  reader->bytes += got;
  if (reader->bytes / PROGRESS_LEAST_BYTES == before / PROGRESS_LEAST_BYTES) return;
  reader->progress = progress_begin(reader->bytes, PROGRESS_LEAST_BYTES);
  progress_show_bytes(&reader->progress, "reading", reader->bytes);
}

/* The bytes after the block: a line's end, which every search finds, and room for words. */
enum { BEHIND_BLOCK = LINE_READER_ROOM };

/* More bytes behind those from `next` on, which move to the front of the block; it grows if they fill it. LINE_END: the
 * file has ended. */
static enum line_status refill(struct line_reader *reader, struct failure *failure) {
  const size_t kept = reader->filled - reader->next;
  if (kept > 0 && reader->next > 0) memmove(reader->block, reader->block + reader->next, kept);
  reader->next = 0;
  reader->filled = kept;
  if (kept == reader->capacity) {
    const size_t capacity = kept == 0 ? LINE_READER_BLOCK : 2 * kept;
    char *block = kept > SIZE_MAX / 4 ? NULL : realloc(reader->block, capacity + BEHIND_BLOCK);
    if (block == NULL) {
      failure_of_memory(failure);
      return LINE_FAILED;
    }
    reader->block = block;
    reader->capacity = capacity;
  }
  if (stopping_asked()) {
    failure_in_input(failure, 0, "stopped");
    return LINE_FAILED;
  }
  errno = 0;
  const size_t got = fread(reader->block + kept, 1, reader->capacity - kept, reader->file);
  reader->filled += got;
  memset(reader->block + reader->filled, '\n', BEHIND_BLOCK);
  show_progress(reader, got);
  if (got > 0) return LINE_READ;
  if (ferror(reader->file)) {
    failure_in_input(failure, 0, "%s", errno != 0 ? strerror(errno) : "cannot be read");
    return LINE_FAILED;
  }
  return LINE_END;
}

/* The first byte that ends or breaks a line, any control character but a tab; there is one. */
static char *end_of_line(char *at) {
  for (;; at += 16) {
    const uint32_t found = control_in_16(at);
    if (found != 0) return at + lowest_bit(found);
  }
}

/* The number of bytes up to the end of the line that begins at `next`, all of them in the block. */
static enum line_status find_end(struct line_reader *reader, size_t *length, struct failure *failure) {
  for (*length = 0;;) {
    char *const begin = reader->block + reader->next;
    *length = (size_t)(end_of_line(begin + *length) - begin);
    if (*length < reader->filled - reader->next) return LINE_READ;
    *length = reader->filled - reader->next;
    const enum line_status status = refill(reader, failure);
    if (status != LINE_READ) return status;
  }
}

/* The next line of a text that another reader has checked: every line ends with '\n'. */
static enum line_status next_of_text(struct line_reader *reader) {
  uint32_t found;
  if (reader->next == reader->filled) return LINE_END;
  char *const begin = reader->block + reader->next, *end = begin;
  while ((found = equal_in_16(end, '\n')) == 0) end += 16;
  end += lowest_bit(found);
  *end = '\0';
  ++reader->number;
  reader->text = begin;
  reader->length = (size_t)(end - begin);
  reader->next += reader->length + 1;
  return LINE_READ;
}

uint64_t line_reader_pass(struct line_reader *reader, char mark, const char **text, size_t *bytes) {
  const size_t most = reader->filled - reader->next;
  uint64_t lines = 0;
  *text = reader->block;
  *bytes = 0;
  if (most == 0) return 0;
  const char *const begin = *text += reader->next;
  if (*begin == mark) return 0;
  for (size_t at = 0; at < most; at += 16) {
    const char *const here = begin + at;
    const uint32_t breaks = control_in_16(here);
    if (breaks == 0) continue;
    uint32_t ends = equal_in_16(here, '\n');
    /* Before what stops: a line that begins with the mark, another end, what is no text. */
    const uint32_t stops = (ends & equal_in_16(here + 1, mark)) << 1 | (breaks ^ ends);
    if (stops != 0) ends &= (stops & (0 - stops)) - 1;
    for (; ends != 0; ends &= ends - 1) {
      if (at + lowest_bit(ends) >= most) break;
      *bytes = at + lowest_bit(ends) + 1;
      ++lines;
    }
    if (stops != 0) break;
  }
  reader->next += *bytes;
  reader->number += lines;
  return lines;
}

/* The mark with which old programs end a text, Ctrl-Z. */
enum { END_OF_TEXT = 0x1A };

/* Look behind a mark. LINE_END: nothing follows but ends of lines. */
static enum line_status look_behind_mark(struct line_reader *reader, size_t mark, struct failure *failure) {
  for (size_t at = mark + 1;;) {
    for (; reader->next + at < reader->filled; ++at) {
      const char byte = reader->block[reader->next + at];
      if (byte != '\n' && byte != '\r') return LINE_READ;
    }
    const enum line_status status = refill(reader, failure);
    if (status != LINE_READ) return status;
  }
}

enum line_status line_reader_next(struct line_reader *reader, struct failure *failure) {
  size_t length = 0;
  reader->text = NULL;
  reader->length = 0;
  reader->ending = "";
  reader->marked = false;
  if (reader->borrowed) return next_of_text(reader);
  if (reader->next == reader->filled) {
    const enum line_status status = refill(reader, failure);
    if (status != LINE_READ) return status;
  }
  ++reader->number;
  enum line_status status = find_end(reader, &length, failure);
  if (status == LINE_READ && reader->block[reader->next + length] == END_OF_TEXT) {
    status = look_behind_mark(reader, length, failure);
    if (status == LINE_END) reader->filled = reader->next + length;
    if (status == LINE_END && length == 0) {
      --reader->number;
      return LINE_END;
    }
  }
  if (status == LINE_FAILED) return LINE_FAILED;
  size_t ending = 0;
  if (status == LINE_READ) {
    const char byte = reader->block[reader->next + length];
    if (byte != '\n' && byte != '\r') {
      failure_in_input(failure, reader->number, "binary data (byte 0x%02X); expected text", (unsigned)byte);
      return LINE_FAILED;
    }
    ending = 1;
    reader->ending = byte == '\n' ? "\n" : "\r";
    if (byte == '\r') {
      if (reader->next + length + 1 == reader->filled && refill(reader, failure) == LINE_FAILED) return LINE_FAILED;
      if (reader->next + length + 1 < reader->filled && reader->block[reader->next + length + 1] == '\n') {
        ending = 2;
        reader->ending = "\r\n";
      }
    }
  }
  reader->text = reader->block + reader->next;
  reader->length = length;
  reader->text[length] = '\0';
  reader->next += length + ending;
  if (reader->number == 1 && length >= 3 && memcmp(reader->text, "\xEF\xBB\xBF", 3) == 0) {
    reader->text += 3;
    reader->length -= 3;
    reader->marked = true;
  }
  return LINE_READ;
}

void line_reader_close(struct line_reader *reader) {
  progress_end(&reader->progress);
  if (!reader->borrowed) free(reader->block);
  reader->block = reader->text = NULL;
  if (reader->file != NULL && reader->file != stdin) fclose(reader->file);
  reader->file = NULL;
}
