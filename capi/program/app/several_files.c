#include "app/several_files.h"

#include <string.h>

#include "write/csv.h"

/* The length of a table's first row, its line end included. A line end in quotes is part of a field. */
static size_t row_length(const char *text, size_t length) {
  bool quoted = false;
  for (size_t at = 0; at < length; ++at) {
    if (text[at] == '"') quoted = !quoted;
    if (text[at] == '\n' && !quoted) return at + 1;
  }
  return length;
}

/* The rows of a table with the file's name before each; its header only if it is the first one. */
static bool add_table(struct several_files *several, const struct request *request, const struct text_buffer *record,
                      struct text_buffer *out, struct failure *failure) {
  size_t at = row_length(record->text, record->length);
  if (!several->any) {
    text_buffer_append(&several->header, record->text, at);
    text_buffer_add(out, "file,");
    text_buffer_append(out, record->text, at);
  } else if (at != several->header.length || memcmp(record->text, several->header.text, at) != 0) {
    failure->file = request->file;
    return failure_in_input(failure, 0, "its table has other columns than that of the first file");
  }
  while (at < record->length) {
    const size_t length = row_length(record->text + at, record->length - at);
    csv_text(out, request->file);
    text_buffer_add(out, ",");
    text_buffer_append(out, record->text + at, length);
    at += length;
  }
  return !several->header.out_of_memory || failure_of_memory(failure);
}

bool several_files_print(struct several_files *several, const struct request *request, const struct text_buffer *record,
                         struct failure *failure) {
  if (record->out_of_memory) return failure_of_memory(failure);
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  bool done = true;
  if (request->csv) {
    done = add_table(several, request, record, &out, failure);
  } else {
    if (several->any && !request->json) text_buffer_add(&out, "\n");
    text_buffer_append(&out, record->text, record->length);
  }
  if (done) {
    several->any = true;
    done = text_buffer_print(&out, failure);
  }
  text_buffer_free(&out);
  return done;
}

void several_files_free(struct several_files *several) {
  text_buffer_free(&several->header);
}
