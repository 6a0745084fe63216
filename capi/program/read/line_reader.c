#define _POSIX_C_SOURCE 200112L /* dup2, fileno */

#include "read/line_reader.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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

bool line_reader_open(struct line_reader *reader, const char *path, struct failure *failure) {
  reader->text = NULL;
  reader->length = 0;
  reader->ending = "";
  reader->marked = false;
  reader->number = 0;
  reader->capacity = 0;
  reader->next = 0;
  reader->filled = 0;
  reader->bytes = 0;
  reader->progress = (struct progress){false};
  reader->file = input_open(path, failure);
  return reader->file != NULL;
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
static void show_progress(struct line_reader *reader) {
  const uint64_t before = reader->bytes;
  reader->bytes += reader->filled;
  if (reader->bytes / PROGRESS_LEAST_BYTES == before / PROGRESS_LEAST_BYTES) return;
  reader->progress = progress_begin(reader->bytes, PROGRESS_LEAST_BYTES);
  progress_show_bytes(&reader->progress, "reading", reader->bytes);
}

/* Fill the chunk anew if it is used up. LINE_END: the file has ended. */
static enum line_status refill(struct line_reader *reader, struct failure *failure) {
  if (reader->next < reader->filled) return LINE_READ;
  errno = 0;
  reader->next = 0;
  reader->filled = fread(reader->chunk, 1, sizeof reader->chunk, reader->file);
  show_progress(reader);
  if (reader->filled > 0) return LINE_READ;
  if (ferror(reader->file)) {
    failure_in_input(failure, 0, "%s", errno != 0 ? strerror(errno) : "cannot be read");
    return LINE_FAILED;
  }
  return LINE_END;
}

static bool append(struct line_reader *reader, const unsigned char *bytes, size_t count) {
  if (reader->capacity - reader->length <= count) {
    if (count > SIZE_MAX / 4 - reader->length) return false;
    const size_t capacity = 2 * (reader->length + count) + 128;
    char *text = realloc(reader->text, capacity);
    if (text == NULL) return false;
    reader->text = text;
    reader->capacity = capacity;
  }
  if (count > 0) memcpy(reader->text + reader->length, bytes, count);
  reader->length += count;
  reader->text[reader->length] = '\0';
  return true;
}

static bool ends_or_breaks_line(unsigned char byte) {
  return (byte < 0x20 && byte != '\t') || byte == 0x7F;
}

static void drop_byte_order_mark(struct line_reader *reader) {
  static const char mark[] = "\xEF\xBB\xBF";
  if (reader->length >= 3 && memcmp(reader->text, mark, 3) == 0) {
    memmove(reader->text, reader->text + 3, reader->length - 3 + 1);
    reader->length -= 3;
    reader->marked = true;
  }
}

enum line_status line_reader_next(struct line_reader *reader, struct failure *failure) {
  reader->length = 0;
  reader->ending = "";
  reader->marked = false;
  enum line_status status = refill(reader, failure);
  if (status != LINE_READ) return status;
  ++reader->number;
  while (status == LINE_READ) {
    size_t end = reader->next;
    while (end < reader->filled && !ends_or_breaks_line(reader->chunk[end])) ++end;
    if (!append(reader, reader->chunk + reader->next, end - reader->next)) {
      failure_of_memory(failure);
      return LINE_FAILED;
    }
    reader->next = end;
    if (end < reader->filled) break;
    status = refill(reader, failure);
    if (status == LINE_FAILED) return LINE_FAILED;
  }
  if (status == LINE_READ) {
    const unsigned char byte = reader->chunk[reader->next++];
    if (byte != '\n' && byte != '\r') {
      failure_in_input(failure, reader->number, "binary data (byte 0x%02X); expected text", (unsigned)byte);
      return LINE_FAILED;
    }
    reader->ending = byte == '\n' ? "\n" : "\r";
    if (byte == '\r') {
      status = refill(reader, failure);
      if (status == LINE_FAILED) return LINE_FAILED;
      if (status == LINE_READ && reader->chunk[reader->next] == '\n') {
        ++reader->next;
        reader->ending = "\r\n";
      }
    }
  }
  if (reader->number == 1) drop_byte_order_mark(reader);
  return LINE_READ;
}

void line_reader_close(struct line_reader *reader) {
  progress_end(&reader->progress);
  free(reader->text);
  reader->text = NULL;
  if (reader->file != NULL && reader->file != stdin) fclose(reader->file);
  reader->file = NULL;
}
