#include "read/byte_reader.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "read/line_reader.h"

bool byte_reader_open(struct byte_reader *reader, const char *path, struct failure *failure) {
  reader->file = input_open(path, failure);
  return reader->file != NULL;
}

bool byte_reader_at_end(const struct byte_reader *reader) {
  const int byte = getc(reader->file);
  if (byte != EOF) ungetc(byte, reader->file);
  return byte == EOF && !ferror(reader->file);
}

bool byte_reader_take(struct byte_reader *reader, void *out, size_t count, struct failure *failure) {
  errno = 0;
  if (fread(out, 1, count, reader->file) == count) return true;
  const bool broken = ferror(reader->file);
  return failure_in_input(failure, 0, "%s",
                          !broken      ? "cut off: the file ends here"
                          : errno != 0 ? strerror(errno)
                                       : "cannot be read");
}

bool byte_reader_skip(struct byte_reader *reader, uint64_t count, struct failure *failure) {
  unsigned char ignored[8192];
  while (count > 0) {
    const size_t piece = count < sizeof ignored ? (size_t)count : sizeof ignored;
    if (!byte_reader_take(reader, ignored, piece, failure)) return false;
    count -= piece;
  }
  return true;
}

void byte_reader_close(struct byte_reader *reader) {
  if (reader->file != NULL && reader->file != stdin) fclose(reader->file);
  reader->file = NULL;
}

int32_t bits_to_i32(uint32_t bits) {
  int32_t value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

float bits_to_float(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

double bits_to_double(uint64_t bits) {
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

double float_as_written(float value) {
  char text[32];
  double read = (double)value;
  for (int digits = 6; digits <= 9; ++digits) {
    snprintf(text, sizeof text, "%.*g", digits, (double)value);
    read = strtod(text, NULL);
    if ((float)read == value) break;
  }
  return read;
}
