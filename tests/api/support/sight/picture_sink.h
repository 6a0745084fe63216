/* A sink for pictures that keeps what it is given, and one that refuses when it has enough. */
#pragma once

#include <hardsphere.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct picture_sink {
  char *bytes; /* NUL-terminated after picture_sink_start */
  size_t count;
  size_t room;
  size_t accepts;   /* refuses what would lead beyond this number */
  uint32_t calls;   /* refused one included */
  uint32_t refused; /* calls refused: never more than 1 */
  uint32_t odd;     /* calls with more than 1024 bytes, with no place for them, or after a refusal */
} picture_sink;

void picture_sink_start(picture_sink *sink, size_t accepts);
void picture_sink_release(picture_sink *sink);

/* The hsp_sink itself; context is the picture_sink. Returns 77 when it refuses. */
int32_t picture_sink_take(void *context, const char *bytes, size_t count);

/* A copy of the text without the values of data-ball, in memory of malloc; *length becomes its length. */
char *picture_without_ids(const char *bytes, size_t count, size_t *length);

#ifdef __cplusplus
}
#endif
