/* A struct that begins with struct_size is accepted in the size of each of its versions, and in a larger size if the
 * rest is zeros. Nothing is read or written beyond its size, and as much of it as there is gets the same contents. All
 * other sizes are refused with HSP_E_VERSION. So is a struct that is read and has a byte that is not zero in the part
 * that this library does not know. */
#include <stdlib.h>
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

enum { LARGEST = 1024, BEYOND = 12, ROOM = LARGEST + 64 };

/* Structs that have grown: their earlier size, and behind it the first field that was added. */
static const struct {
  const char *base;
  uint32_t size;
} earlier[] = {
    {"hsp_model_options", 24},   /* largest_radius */
    {"hsp_picture_options", 72}, /* scale */
};

static int is_good(const argument *a, uint32_t size) {
  size_t k;
  for (k = 0; k < sizeof earlier / sizeof earlier[0]; ++k) {
    if (strcmp(earlier[k].base, a->base) == 0 && earlier[k].size == size) return 1;
  }
  return size == a->size || (size > a->size && size <= LARGEST && size % 4 == 0);
}

/* A call with the struct of base arguments, zeros behind, in so many bytes. */
static unsigned char *prepare(call *c, const function *f, uint32_t capacity, int i, uint32_t size, size_t room) {
  const argument *const a = &f->arguments[i];
  unsigned char whole[ROOM] = {0}, *data;
  call_prepare(c, f, capacity);
  call_put(c, i, room);
  c->v[i].p = data = fence_take(i, room, (8 - room % 8) % 8);                     /* aligned */
  if (i + 1 < f->count && strcmp(f->arguments[i + 1].name, "struct_size") == 0) { /* its size is an argument */
    c->v[i + 1].u = size;
    return data;
  }
  fill_base(a, whole, 1);
  memcpy(whole, &size, sizeof size);
  memcpy(data, whole, room);
  return data;
}

static void good_size(const function *f, uint32_t capacity, int i, uint32_t size) {
  const argument *const a = &f->arguments[i];
  unsigned char known[ROOM] = {0};
  call c;
  unsigned char *data = prepare(&c, f, capacity, i, (uint32_t)a->size, a->size);
  law_succeeds(&c, "the struct of this header for", a->name);
  memcpy(known, data, a->size);
  memcpy(known, &size, sizeof size);
  data = prepare(&c, f, capacity, i, size, size);
  law_succeeds(&c, "a struct of another version for", a->name);
  if (a->kind == KIND_sized) CHECK_BYTES(data, known, size);
}

/* Tries a struct in which the byte `at`, in the part that this library does not know, is not 0. */
static void unknown_part(const function *f, uint32_t capacity, int i, uint32_t size, size_t at) {
  const argument *const a = &f->arguments[i];
  size_t k;
  call c;
  unsigned char *const data = prepare(&c, f, capacity, i, size, size);
  data[at] = 1;
  if (a->kind != KIND_sized) { /* it asks for something */
    law_refused(&c, "an unknown part that is not 0 of", a->name, HSP_E_VERSION, "");
    return;
  }
  law_succeeds(&c, "an unknown part that is not 0 of", a->name);
  for (k = a->size; k < size; ++k) CHECK(data[k] == 0 || data[k] == fence_copy(i)[k]);
}

static void one_size(const function *f, uint32_t capacity, int i, uint32_t size) {
  const argument *const a = &f->arguments[i];
  call c;
  if (!is_good(a, size)) {
    prepare(&c, f, capacity, i, size, ROOM);
    law_refused(&c, "a bad struct_size for", a->name, HSP_E_VERSION, "");
    return;
  }
  good_size(f, capacity, i, size);
  if (size > a->size) unknown_part(f, capacity, i, size, a->size);
  if (size > a->size) unknown_part(f, capacity, i, size, size - 1);
}

static void struct_sizes(const function *f, uint32_t capacity) {
  int i;
  for (i = 0; i < f->count; ++i) {
    const uint32_t size = (uint32_t)f->arguments[i].size;
    uint32_t k;
    if (!is_sized(&f->arguments[i])) continue;
    /* Functions with handles, which are made anew for each call, try multiples of 4 alone, to save time. */
    for (k = 0; k <= size + BEYOND; k += place_of_kind(f, KIND_handle) < 0 ? 1 : 4) one_size(f, capacity, i, k);
    for (k = LARGEST - 5; k <= LARGEST + 8; ++k) one_size(f, capacity, i, k);
    one_size(f, capacity, i, 0xFFFFFFFF);
  }
}

int main(void) {
  return check_law(struct_sizes);
}
