#include "draw/picture_file.h"

#include <stdlib.h>
#include <string.h>

#include "read/geometry.h"
#include "read/stopping.h"
#include "write/output_file.h"
#include "write/pdf_update.h"

/* How often progress is shown. */
enum { BYTES_A_STEP = 1000000 };

/* How files end after all that is drawn; of .pdf, where its table is. */
static const char *const ends[] = {"</svg>\n", "showpage\n%%Trailer\nrestore end\n%%EOF\n", NULL};
enum { MOST_BYTES_OF_END = 64 };

struct sink {
  struct output_file *file;
  char kept[MOST_BYTES_OF_END]; /* the last `keep` bytes are written at last */
  size_t keep, held;
  uint64_t written;
  const struct progress *progress;
};

/* Write all but the last bytes of those held back and those given; the last ones are held back. */
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

/* The text over the picture comes before the end of the file, and in .pdf behind it. */
static bool end(struct sink *sink, const struct picture *picture, uint64_t *bytes, struct failure *failure) {
  if (picture->options.format == HSP_FORMAT_PDF && picture->over != NULL) {
    struct text_buffer update = TEXT_BUFFER_EMPTY;
    bool made = pdf_update_make(picture->over, picture->page, sink->kept, sink->held, *bytes, &update);
    if (made && output_file_write(sink->file, sink->kept, sink->held)) {
      output_file_write(sink->file, update.text, update.length);
    }
    *bytes += update.length;
    text_buffer_free(&update);
    return made || failure_of_memory(failure);
  }
  const size_t count = picture->over != NULL ? strlen(picture->over) : 0;
  *bytes += count;
  if (count == 0 || output_file_write(sink->file, picture->over, count)) {
    output_file_write(sink->file, sink->kept, sink->held);
  }
  return true;
}

static int32_t take(void *context, const char *bytes, size_t count) {
  struct sink *sink = context;
  if (stopping_asked() || !put(sink, bytes, count)) return 1;
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
  if (picture->over != NULL) {
    const char *const after = ends[picture->options.format];
    sink.keep = after != NULL ? strlen(after) : MOST_BYTES_OF_END;
  }
  hsp_picture_options options = picture->options;
  /* Without memory the file is correct, but larger; text over it, however, needs the table of the smaller kind. */
  void *memory = options.format == HSP_FORMAT_PDF ? malloc(HSP_PICTURE_MEMORY) : NULL;
  if (options.format == HSP_FORMAT_PDF && picture->over != NULL && memory == NULL) {
    output_file_abandon(&file);
    return failure_of_memory(failure);
  }
  options.memory = memory;
  options.memory_bytes = memory != NULL ? HSP_PICTURE_MEMORY : 0;
  const int32_t status = write_picture(picture, &options, &sink, bytes);
  free(memory);
  if (status == HSP_OK && !end(&sink, picture, bytes, failure)) {
    output_file_abandon(&file);
    return false;
  }
  if (status == HSP_OK || status == HSP_E_SINK) return output_file_finish(&file, failure);
  output_file_abandon(&file);
  return failure_in_library(failure, status);
}
