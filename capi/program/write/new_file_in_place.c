#include <unistd.h>

#include "write/new_file.h"

bool new_file_open(struct output_file *file) {
  file->stream = fopen(file->path, "wb");
  file->in_place = file->stream != NULL;
  return file->in_place;
}

void new_file_drop(struct output_file *file) {
  if (file->in_place) unlink(file->path);
}

bool output_files_keep(struct failure *failure) {
  (void)failure;
  return true;
}

void output_files_drop(void) {}
