#include "picture_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "geometry.h"

/* How often progress is shown. */
enum { BYTES_A_STEP = 1000000 };

struct sink {
  FILE *file;
  uint64_t written;
  int reason; /* errno when writing failed */
  const struct progress *progress;
};

static int32_t take(void *context, const char *bytes, size_t count) {
  struct sink *sink = context;
  if (count > 0 && fwrite(bytes, 1, count, sink->file) != count) {
    sink->reason = errno;
    return 1;
  }
  const uint64_t step = sink->written / BYTES_A_STEP;
  sink->written += count;
  if (sink->written / BYTES_A_STEP != step) progress_show_bytes(sink->progress, "writing", sink->written);
  return 0;
}

bool picture_file_write(hsp_view *view, const struct picture *picture, const char *path,
                        const struct progress *progress, uint64_t *bytes, struct failure *failure) {
  const char *file_before = failure->file;
  errno = 0;
  struct sink sink = {fopen(path, "wb"), 0, 0, progress};
  if (sink.file == NULL) {
    failure->file = path;
    return failure_in_input(failure, 0, "%s", errno != 0 ? strerror(errno) : "cannot be opened");
  }
  errno = 0;
  const int32_t status = hsp_picture_write(view, picture->colour, &picture->options, picture->title,
                                           picture->description, take, &sink, bytes);
  bool written = status == HSP_OK;
  if (written && fflush(sink.file) != 0) {
    sink.reason = errno;
    written = false;
  }
  if (fclose(sink.file) != 0 && written) {
    sink.reason = errno;
    written = false;
  }
  if (written) return true;
  remove(path);
  if (status != HSP_OK && status != HSP_E_SINK) {
    failure->file = file_before;
    return failure_in_library(failure, status);
  }
  failure->file = path;
  return failure_in_input(failure, 0, "%s", sink.reason != 0 ? strerror(sink.reason) : "cannot be written");
}
