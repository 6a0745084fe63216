#include "read/weights.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "read/fields.h"
#include "read/line_reader.h"

static bool read_lines(struct line_reader *reader, const char *what, uint32_t count, double *weights,
                       struct failure *failure) {
  uint32_t read = 0;
  for (;;) {
    const enum line_status status = line_reader_next(reader, failure);
    if (status == LINE_FAILED) return false;
    if (status == LINE_END) break;
    const char *comment = memchr(reader->text, '#', reader->length);
    const size_t length = comment == NULL ? reader->length : (size_t)(comment - reader->text);
    struct field column;
    const size_t columns = fields_split(reader->text, length, &column, 1);
    if (columns == 0) continue;
    if (columns > 1) {
      return failure_in_input(failure, reader->number, "expected one %s on a line, found %zu columns", what, columns);
    }
    double weight;
    if (!field_number_in_line(column, what, &weight, reader->number, failure)) return false;
    if (read == count) {
      return failure_in_input(failure, reader->number, "more %ss than balls: there are %" PRIu32 " balls", what, count);
    }
    weights[read++] = weight;
  }
  if (read == count) return true;
  return failure_in_input(failure, 0, "%" PRIu32 " %ss for %" PRIu32 " balls", read, what, count);
}

bool weights_read(const char *path, const char *what, uint32_t count, double **weights, struct failure *failure) {
  const char *file_before = failure->file;
  failure->file = input_name(path);
  struct line_reader *reader = malloc(sizeof *reader);
  *weights = malloc(((size_t)count + 1) * sizeof **weights);
  bool done = reader != NULL && *weights != NULL;
  if (!done) {
    failure_of_memory(failure);
  } else {
    done = line_reader_open(reader, path, failure);
    if (done) {
      done = read_lines(reader, what, count, *weights, failure);
      line_reader_close(reader);
    }
  }
  free(reader);
  if (done) {
    failure->file = file_before;
  } else {
    free(*weights);
    *weights = NULL;
  }
  return done;
}
