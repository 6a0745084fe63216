#include "picture_file.h"

#include <stdlib.h>

#include "geometry.h"
#include "output_file.h"

/* How often progress is shown. */
enum { BYTES_A_STEP = 1000000 };

struct sink {
  struct output_file *file;
  uint64_t written;
  const struct progress *progress;
};

static int32_t take(void *context, const char *bytes, size_t count) {
  struct sink *sink = context;
  if (!output_file_write(sink->file, bytes, count)) return 1;
  const uint64_t step = sink->written / BYTES_A_STEP;
  sink->written += count;
  if (sink->written / BYTES_A_STEP != step) progress_show_bytes(sink->progress, "writing", sink->written);
  return 0;
}

static int32_t write_picture(const struct picture *picture, const hsp_picture_options *options, struct sink *sink,
                             uint64_t *bytes) {
  if (picture->sticks != NULL) {
    return hsp_picture_write_sticks(picture->sticks, picture->colour, options, picture->title, picture->description,
                                    take, sink, bytes);
  }
  if (picture->view == NULL) {
    return hsp_picture_write_map(picture->map, picture->colour, options, picture->title, picture->description, take,
                                 sink, bytes);
  }
  return hsp_picture_write(picture->view, picture->colour, options, picture->title, picture->description, take, sink,
                           bytes);
}

bool picture_file_write(const struct picture *picture, const char *path, const struct progress *progress,
                        uint64_t *bytes, struct failure *failure) {
  struct output_file file;
  if (!output_file_open(&file, path, failure)) return false;
  struct sink sink = {&file, 0, progress};
  hsp_picture_options options = picture->options;
  /* Without memory the file is correct, and larger. */
  void *memory = options.format == HSP_FORMAT_PDF ? malloc(HSP_PICTURE_MEMORY) : NULL;
  options.memory = HSP_ADDRESS(memory);
  options.memory_bytes = memory != NULL ? HSP_PICTURE_MEMORY : 0;
  const int32_t status = write_picture(picture, &options, &sink, bytes);
  free(memory);
  if (status == HSP_OK || status == HSP_E_SINK) return output_file_finish(&file, failure);
  output_file_abandon(&file);
  return failure_in_library(failure, status);
}
