/* A struct that begins with struct_size: sizes that no version of it has are refused with HSP_E_VERSION, as is a part
 * behind what is known that is not zeros, of a struct that is read. Larger ones of zeros serve. Nothing is written
 * beyond struct_size. */
#include <stdio.h>
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

enum { LARGEST = 1024, TAIL = 8 };

/* A call with the struct of base arguments in so many bytes, zeros behind. */
static unsigned char *prepare(call *c, const function *f, uint32_t capacity, int i, uint32_t struct_size, size_t room) {
  const argument *const a = &f->arguments[i];
  const int by_argument = i + 1 < f->count && strcmp(f->arguments[i + 1].name, "struct_size") == 0;
  unsigned char *data;
  call_prepare(c, f, capacity);
  data = call_put(c, i, room);
  if (by_argument) { /* it says nothing itself */
    c->v[i + 1].u = struct_size;
    return data;
  }
  memset(data, 0, room);
  fill_base(a, data, 1);
  memcpy(data, &struct_size, sizeof struct_size);
  return data;
}

static void bad_sizes(const function *f, uint32_t capacity, int i) {
  const argument *const a = &f->arguments[i];
  const uint32_t size = (uint32_t)a->size, sizes[] = {0, 3, size - 1, size + 2, LARGEST + 4, 0xFFFFFFFF};
  size_t k;
  for (k = 0; k < sizeof sizes / sizeof sizes[0]; ++k) {
    call c;
    char what[64];
    prepare(&c, f, capacity, i, sizes[k], LARGEST + 8);
    snprintf(what, sizeof what, "struct_size %u of %u for", (unsigned)sizes[k], (unsigned)size);
    law_refused(&c, what, a->name, HSP_E_VERSION, "");
  }
}

static void larger_structs(const function *f, uint32_t capacity, int i) {
  const argument *const a = &f->arguments[i];
  call c;
  prepare(&c, f, capacity, i, (uint32_t)a->size + TAIL, a->size + TAIL);
  law_succeeds(&c, "a larger struct for", a->name);
  prepare(&c, f, capacity, i, LARGEST, LARGEST);
  law_succeeds(&c, "the largest struct for", a->name);
  prepare(&c, f, capacity, i, (uint32_t)a->size + TAIL, LARGEST);
  law_succeeds(&c, "more memory than struct_size for", a->name);
  CHECK(fence_unchanged(i, a->size + TAIL));
}

/* What this library does not know is not 0. */
static void unknown_part(const function *f, uint32_t capacity, int i) {
  const argument *const a = &f->arguments[i];
  unsigned char *data;
  size_t k;
  call c;
  data = prepare(&c, f, capacity, i, (uint32_t)a->size + TAIL, a->size + TAIL);
  data[a->size + 1] = 1;
  if (a->kind == KIND_sized_in) {
    law_refused(&c, "an unknown part that is not 0 of", a->name, HSP_E_VERSION, "");
    return;
  }
  law_succeeds(&c, "an unknown part that is not 0 of", a->name);
  for (k = a->size; k < a->size + TAIL; ++k) CHECK(data[k] == 0 || data[k] == fence_copy(i)[k]);
}

static void struct_sizes(const function *f, uint32_t capacity) {
  int i;
  for (i = 0; i < f->count; ++i) {
    if (f->arguments[i].kind != KIND_sized && f->arguments[i].kind != KIND_sized_in) continue;
    bad_sizes(f, capacity, i);
    larger_structs(f, capacity, i);
    unknown_part(f, capacity, i);
  }
}

int main(void) {
  return check_law(struct_sizes);
}
