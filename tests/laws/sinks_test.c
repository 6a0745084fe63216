/* A sink that refuses bytes ends a picture with HSP_E_SINK, is not called again, and the bytes that it has taken are
 * counted. */
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

typedef struct refusing {
  uint32_t calls, accepts; /* so many calls */
  uint64_t taken;
} refusing;

static int32_t take_some(void *context, const char *bytes, size_t count) {
  refusing *const r = context;
  (void)bytes;
  if (r->calls++ >= r->accepts) return 1;
  r->taken += count;
  return 0;
}

static void sinks(const function *f, uint32_t capacity) {
  const int sink = place_of_kind(f, KIND_callback), bytes = place_of(f, "bytes");
  uint32_t calls = 1, accepts;
  if (sink < 0) return;
  for (accepts = 0; accepts < calls; ++accepts) {
    refusing r = {0, 0, 0};
    uint64_t said;
    call c;
    if (accepts == 0) { /* first find the number of calls */
      r.accepts = UINT32_MAX;
      call_prepare(&c, f, capacity);
      c.v[sink].f = take_some;
      c.v[sink + 1].p = &r;
      law_succeeds(&c, "a sink that takes everything", "");
      calls = r.calls;
      r.calls = 0;
      r.taken = 0;
    }
    r.accepts = accepts;
    call_prepare(&c, f, capacity);
    c.v[sink].f = take_some;
    c.v[sink + 1].p = &r;
    law_refused(&c, "a sink that refuses bytes", "", HSP_E_SINK, "");
    CHECK_EQUAL(r.calls, accepts + 1);
    memcpy(&said, fence_data(bytes), sizeof said);
    CHECK_EQUAL(said, r.taken);
  }
}

int main(void) {
  return check_law(sinks);
}
