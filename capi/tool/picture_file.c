#include "picture_file.h"

#include <stdlib.h>
#include <string.h>

#include "geometry.h"
#include "output_file.h"

/* How often progress is shown. */
enum { BYTES_A_STEP = 1000000 };

/* How files end after all that is drawn. */
static const char *const ends[] = {"</svg>\n", "showpage\n%%Trailer\nrestore end\n%%EOF\n"};
enum { MOST_BYTES_OF_END = 64 };

struct sink {
  struct output_file *file;
  char kept[MOST_BYTES_OF_END]; /* the last `keep` bytes are written at last */
  size_t keep, held;
  uint64_t written;
  const struct progress *progress;
};

/* Of what is held back and what comes, all but the last bytes go to the file. */
static bool put(struct sink *sink, const char *bytes, size_t count) {
  const size_t all = sink->held + count;
  const size_t out = all > sink->keep ? all - sink->keep : 0;
  const size_t old = out < sink->held ? out : sink->held;
  if (!output_file_write(sink->file, sink->kept, old)) return false;
  memmove(sink->kept, sink->kept + old, sink->held - old);
  sink->held -= old;
  if (!output_file_write(sink->file, bytes, out - old)) return false;
  memcpy(sink->kept + sink->held, bytes + (out - old), count - (out - old));
  sink->held += count - (out - old);
  return true;
}

/* What is written over the picture comes before the end of the file. */
static void end(struct sink *sink, const char *over, uint64_t *bytes) {
  const size_t count = over != NULL ? strlen(over) : 0;
  *bytes += count;
  if (count == 0 || output_file_write(sink->file, over, count)) {
    output_file_write(sink->file, sink->kept, sink->held);
  }
}

static int32_t take(void *context, const char *bytes, size_t count) {
  struct sink *sink = context;
  if (!put(sink, bytes, count)) return 1;
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
  struct sink sink = {.file = &file, .progress = progress};
  if (picture->over != NULL) sink.keep = strlen(ends[picture->options.format]);
  hsp_picture_options options = picture->options;
  /* Without memory the file is correct, and larger. */
  void *memory = options.format == HSP_FORMAT_PDF ? malloc(HSP_PICTURE_MEMORY) : NULL;
  options.memory = HSP_ADDRESS(memory);
  options.memory_bytes = memory != NULL ? HSP_PICTURE_MEMORY : 0;
  const int32_t status = write_picture(picture, &options, &sink, bytes);
  free(memory);
  if (status == HSP_OK) end(&sink, picture->over, bytes);
  if (status == HSP_OK || status == HSP_E_SINK) return output_file_finish(&file, failure);
  output_file_abandon(&file);
  return failure_in_library(failure, status);
}
