#include "write/output_file.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "write/new_file.h"
#include "write/same_file.h"

/* Remove the new file, and give the failure its reason. */
static bool give_up(struct output_file *file, struct failure *failure) {
  const int reason = file->reason != 0 ? file->reason : errno;
  const bool standard = file->stream == stdout;
  const char *what = standard ? "standard output: " : file->no_room ? "no new file can be made in its folder: " : "";
  const bool taken = file->taken;
  failure->file = standard ? NULL : file->path;
  output_file_abandon(file);
  if (taken) return failure_in_input(failure, 0, "another output of this run would write the same file");
  return failure_in_input(failure, 0, "%s%s", what, reason != 0 ? strerror(reason) : "cannot be written");
}

bool output_file_open(struct output_file *file, const char *path, struct failure *failure) {
  memset(file, 0, sizeof *file);
  file->path = path;
  if (output_is_standard(path)) {
    file->stream = stdout;
    return true;
  }
  errno = 0;
  struct stat standard;
  struct stat old;
  if (stat(path, &old) == 0 && fstat(STDOUT_FILENO, &standard) == 0 && same_file(&old, &standard)) {
    failure->file = path;
    return failure_in_input(failure, 0, "this is where standard output goes already");
  }
  errno = 0;
  return new_file_open(file) || give_up(file, failure);
}

bool output_file_write(struct output_file *file, const char *bytes, size_t count) {
  if (file->reason != 0) return false;
  errno = 0;
  if (count == 0 || fwrite(bytes, 1, count, file->stream) == count) return true;
  file->reason = errno != 0 ? errno : EIO;
  return false;
}

bool output_file_finish(struct output_file *file, struct failure *failure) {
  errno = 0;
  if (file->reason == 0 && fflush(file->stream) != 0) file->reason = errno != 0 ? errno : EIO;
  if (file->reason != 0) return give_up(file, failure);
  if (file->stream == stdout) return true;
  FILE *stream = file->stream;
  file->stream = NULL;
  if (fclose(stream) == 0) return true;
  file->reason = errno != 0 ? errno : EIO;
  return give_up(file, failure);
}

void output_file_abandon(struct output_file *file) {
  if (file->stream != NULL && file->stream != stdout) fclose(file->stream);
  new_file_drop(file);
  memset(file, 0, sizeof *file);
}

bool output_file_write_text(const char *path, const struct text_buffer *text, struct failure *failure) {
  struct output_file file;
  if (text->out_of_memory) return failure_of_memory(failure);
  if (!output_file_open(&file, path, failure)) return false;
  output_file_write(&file, text->text, text->length);
  return output_file_finish(&file, failure);
}
