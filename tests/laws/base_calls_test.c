/* Every function succeeds with base arguments (support/call.h), with as much room as is needed and with more. Output
 * arrays are written up to their last entry, and nothing behind it. */
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

/* Whether an array need not be written to its end: scratch memory. */
static int may_stay(const function *f, int i) {
  return strcmp(f->arguments[i].name, "scratch") == 0;
}

/* Whether every number of an output array is another one than before. Numbers are compared by words of four bytes, as a
 * byte of a double may well stay; of smaller numbers only all that make the last entry. */
static int is_written_whole(int i, const argument *a) {
  const size_t word = 4, size = fence_size(i);
  size_t at;
  if (a->size % word != 0) return !fence_unchanged(i, size - a->size);
  for (at = 0; at < size; at += word) {
    if (memcmp(fence_data(i) + at, fence_copy(i) + at, word) == 0) return 0;
  }
  return 1;
}

static void check_written_whole(const call *c) {
  int i;
  for (i = 0; i < c->f->count; ++i) {
    const argument *const a = &c->f->arguments[i];
    if (a->kind != KIND_array_out || fence_size(i) == 0 || may_stay(c->f, i)) continue;
    check_true(is_written_whole(i, a), a->name, __FILE__, __LINE__);
  }
}

static void check_nothing_behind(const call *c, uint32_t needed, uint32_t capacity) {
  int i;
  for (i = 0; i < c->f->count; ++i) {
    if (!c->f->arguments[i].held) continue;
    check_true(fence_unchanged(i, fence_size(i) / capacity * needed), c->f->arguments[i].name, __FILE__, __LINE__);
  }
}

static void base_calls(const function *f, uint32_t capacity) {
  const uint32_t spare = 64;
  const int place = place_of_kind(f, KIND_capacity);
  call c;
  call_prepare(&c, f, capacity);
  law_succeeds(&c, "base arguments", "");
  check_written_whole(&c);
  if (place < 0 || strcmp(f->arguments[place].name, "capacity") != 0) return;
  call_prepare(&c, f, capacity + spare);
  law_succeeds(&c, "more room than is needed", "");
  check_nothing_behind(&c, capacity, capacity + spare);
}

int main(void) {
  return check_law(base_calls);
}
