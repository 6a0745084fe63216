#include "write/output_file.h"

bool output_file_write_text(const char *path, const struct text_buffer *text, struct failure *failure) {
  struct output_file file;
  if (text->out_of_memory) return failure_of_memory(failure);
  if (!output_file_open(&file, path, failure)) return false;
  output_file_write(&file, text->text, text->length);
  return output_file_finish(&file, failure);
}
