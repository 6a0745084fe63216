#define _XOPEN_SOURCE 700 /* fstat, S_ISBLK */

#include "write/same_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Links that are followed one after the other. */
enum { MOST_LINKS = 40 };

bool output_is_standard(const char *path) {
  return strcmp(path, "-") == 0 || strcmp(path, "/dev/stdout") == 0;
}

char *path_beside(const char *path, const char *name) {
  const char *slash = strrchr(path, '/');
  const size_t folder = name[0] == '/' || slash == NULL ? 0 : (size_t)(slash - path) + 1;
  char *joined = malloc(folder + strlen(name) + 1);
  if (joined == NULL) return NULL;
  memcpy(joined, path, folder);
  memcpy(joined + folder, name, strlen(name) + 1);
  return joined;
}

#if defined(_WIN32)

/* Files have no numbers there: two paths are one file if they are the same from the root, in letters of either case. */
bool same_file(const struct stat *a, const struct stat *b) {
  (void)a;
  (void)b;
  return false;
}

char *path_without_links(const char *path) {
  return path_beside("", path);
}

static bool paths_are_one(const char *a, const char *b) {
  char *const end_of_a = _fullpath(NULL, a, 0), *const end_of_b = _fullpath(NULL, b, 0);
  const bool one = end_of_a != NULL && end_of_b != NULL && _stricmp(end_of_a, end_of_b) == 0;
  free(end_of_a);
  free(end_of_b);
  return one;
}

bool output_is_input(const char *out, const char *in) {
  return !output_is_standard(out) && strcmp(in, "-") != 0 && paths_are_one(out, in);
}

#else

bool same_file(const struct stat *a, const struct stat *b) {
  return (S_ISREG(a->st_mode) || S_ISBLK(a->st_mode)) && a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

char *path_without_links(const char *path) {
  char *at = path_beside("", path);
  for (int links = 0; at != NULL; ++links) {
    struct stat found;
    char text[4096];
    if (lstat(at, &found) != 0 || !S_ISLNK(found.st_mode)) return at;
    const ssize_t length = readlink(at, text, sizeof text);
    if (length < 0 || length == (ssize_t)sizeof text || links == MOST_LINKS) {
      if (length >= 0) errno = ELOOP;
      free(at);
      return NULL;
    }
    text[length] = '\0';
    char *next = path_beside(at, text);
    free(at);
    at = next;
  }
  return NULL;
}

/* The folder of a file that is yet to be made. */
static bool stat_folder(const char *path, const char *name, struct stat *folder) {
  char text[4096] = ".";
  const size_t length = (size_t)(name - path);
  if (length >= sizeof text) return false;
  if (length > 0) memcpy(text, path, length), text[length] = '\0';
  return stat(text, folder) == 0;
}

static const char *name_in_folder(const char *path) {
  const char *const slash = strrchr(path, '/');
  return slash == NULL ? path : slash + 1;
}

/* For paths that are no links. */
static bool names_are_one(const char *a, const char *b) {
  struct stat of_a, of_b;
  const char *const name = name_in_folder(a), *const other = name_in_folder(b);
  return strcmp(name, other) == 0 && stat_folder(a, name, &of_a) && stat_folder(b, other, &of_b) &&
         of_a.st_dev == of_b.st_dev && of_a.st_ino == of_b.st_ino;
}

static bool paths_are_one(const char *a, const char *b) {
  struct stat of_a, of_b;
  if (stat(a, &of_a) == 0 && stat(b, &of_b) == 0) return same_file(&of_a, &of_b);
  char *const end_of_a = path_without_links(a), *const end_of_b = path_without_links(b);
  const bool one = end_of_a != NULL && end_of_b != NULL && names_are_one(end_of_a, end_of_b);
  free(end_of_a);
  free(end_of_b);
  return one;
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

#endif

bool outputs_are_one(const char *a, const char *b) {
  if (output_is_standard(a) || output_is_standard(b)) return output_is_standard(a) && output_is_standard(b);
  return strcmp(a, b) == 0 || paths_are_one(a, b);
}
