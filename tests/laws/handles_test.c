/* Anything but a live handle of the right kind is refused with HSP_E_HANDLE, and nothing is written, not even an output
 * that tells the reason. Tried are a handle that was overwritten or moved, an address inside a handle, memory that
 * holds no handle, and a handle of each other kind. */
#include <stdlib.h>
#include <string.h>

#include "handle_kind.h"
#include "law.h"
#include "untouched.h"

static void refused(call *c, int i, void *stranger, const char *what) {
  c->v[i].p = stranger;
  law_refused(c, what, c->f->arguments[i].name, HSP_E_HANDLE, "");
}

static void overwritten(const function *f, int i, uint32_t capacity) {
  call c;
  call_prepare(&c, f, capacity);
  memset(c.v[i].p, 0x5A, sizeof(uintptr_t));
  call_spoils(c.v[i].p);
  refused(&c, i, c.v[i].p, "overwritten:");
}

/* A copy at another address, as realloc makes it. */
static void moved(const function *f, int i, uint32_t capacity) {
  const int noun = f->arguments[i].noun;
  unsigned char *copy;
  ptrdiff_t at;
  call c;
  call_prepare(&c, f, capacity);
  if (c.v[i].p != given.handle[noun]) return;
  at = (unsigned char *)c.v[i].p - (unsigned char *)given.memory[noun];
  copy = test_zeros(given.bytes[noun], 1);
  unpoison(given.memory[noun], given.bytes[noun]);
  memcpy(copy, given.memory[noun], given.bytes[noun]);
  refused(&c, i, copy + at, "moved:");
  free(copy);
}

static void handles(const function *f, uint32_t capacity) {
  static uint64_t zeros[1024];
  int i, other;
  for (i = 0; i < f->count; ++i) {
    call c;
    if (f->arguments[i].kind != KIND_handle) continue;
    overwritten(f, i, capacity);
    moved(f, i, capacity);
    call_prepare(&c, f, capacity);
    refused(&c, i, (unsigned char *)c.v[i].p + 3, "three bytes into");
    call_prepare(&c, f, capacity);
    refused(&c, i, zeros, "zeros for");
    for (other = NOUN_none + 1; other < NOUNS; ++other) {
      if (other == f->arguments[i].noun || given.handle[other] == NULL) continue;
      call_prepare(&c, f, capacity);
      refused(&c, i, given.handle[other], "a handle of another kind for");
    }
  }
}

int main(void) {
  return check_law(handles);
}
