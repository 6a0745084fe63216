#define _XOPEN_SOURCE 700 /* fstat, S_ISBLK */

#include "write/same_file.h"

#include <string.h>
#include <unistd.h>

bool output_is_standard(const char *path) {
  return strcmp(path, "-") == 0 || strcmp(path, "/dev/stdout") == 0;
}

bool same_file(const struct stat *a, const struct stat *b) {
  return (S_ISREG(a->st_mode) || S_ISBLK(a->st_mode)) && a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

bool output_is_input(const char *out, const char *in) {
  struct stat written;
  struct stat read;
  const bool from_standard = strcmp(in, "-") == 0;
  const int found_out = output_is_standard(out) ? fstat(STDOUT_FILENO, &written) : stat(out, &written);
  const int found_in = from_standard ? fstat(STDIN_FILENO, &read) : stat(in, &read);
  if (found_in != 0) return !from_standard && strcmp(out, in) == 0;
  return found_out == 0 && same_file(&written, &read);
}
