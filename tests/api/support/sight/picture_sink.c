#include "picture_sink.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *grown(void *memory, size_t bytes) {
  void *more = realloc(memory, bytes);
  if (more == NULL) {
    fprintf(stderr, "out of memory in a test\n");
    exit(2);
  }
  return more;
}

void picture_sink_start(picture_sink *sink, size_t accepts) {
  memset(sink, 0, sizeof *sink);
  sink->accepts = accepts;
  sink->room = 4096;
  sink->bytes = grown(NULL, sink->room);
  sink->bytes[0] = '\0';
}

void picture_sink_release(picture_sink *sink) {
  free(sink->bytes);
  memset(sink, 0, sizeof *sink);
}

int32_t picture_sink_take(void *context, const char *bytes, size_t count) {
  picture_sink *sink = context;
  ++sink->calls;
  if (sink->refused > 0 || count > 1024 || (bytes == NULL && count > 0)) ++sink->odd;
  if (count > sink->accepts - sink->count) {
    ++sink->refused;
    return 77;
  }
  if (sink->count + count + 1 > sink->room) {
    sink->room = 2 * (sink->count + count + 1);
    sink->bytes = grown(sink->bytes, sink->room);
  }
  if (count > 0) memcpy(sink->bytes + sink->count, bytes, count);
  sink->count += count;
  sink->bytes[sink->count] = '\0';
  return 0;
}

char *picture_without_ids(const char *bytes, size_t count, size_t *length) {
  static const char name[] = "data-ball=\"";
  const size_t long_as = sizeof name - 1;
  char *copy = grown(NULL, count + 1);
  size_t from = 0, to = 0;
  while (from < count) {
    if (count - from >= long_as && memcmp(bytes + from, name, long_as) == 0) {
      memcpy(copy + to, name, long_as);
      from += long_as;
      to += long_as;
      while (from < count && bytes[from] >= '0' && bytes[from] <= '9') ++from;
    } else {
      copy[to++] = bytes[from++];
    }
  }
  copy[to] = '\0';
  *length = to;
  return copy;
}
