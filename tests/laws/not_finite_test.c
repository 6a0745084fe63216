/* NaN and infinity are refused with HSP_E_NOT_FINITE, also in arrays and in fields of structs. first_bad names the
 * ball or pose. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

static const struct {
  const char *what;
  double value;
} bad[] = {{"NaN in", NAN}, {"infinity in", INFINITY}, {"minus infinity in", -INFINITY}};
enum { BAD = sizeof bad / sizeof bad[0] };

/* Whether the array has an entry for each ball or pose; other arrays have a fixed length. */
static int is_list(const argument *a) {
  return a->kind == KIND_array_in && (a->extent[0] < '0' || a->extent[0] > '9');
}

static void check_first_bad(const function *f, uint32_t expected) {
  const int place = place_of(f, "first_bad");
  uint32_t named;
  if (place < 0) return;
  memcpy(&named, fence_data(place), sizeof named);
  CHECK_EQUAL(named, expected);
}

/* Tries each number of a point, a box or a matrix; of arrays over balls the numbers of ball 1, as ball 0 may lie
 * outside of the range that a function reads. */
static void numbers(const function *f, uint32_t capacity, int i) {
  const argument *const a = &f->arguments[i];
  const int of_balls = a->kind == KIND_array_in && strcmp(a->extent, "n") == 0;
  size_t at = of_balls ? row_of(a) : 0, end = of_balls ? 2 * at : at + 1;
  int k;
  call c;
  call_prepare(&c, f, capacity);
  if (a->kind == KIND_array_in && !of_balls) end = fence_size(i) / a->size;
  for (; at < end; ++at) {
    for (k = 0; k < BAD; ++k) {
      call_prepare(&c, f, capacity);
      if (a->kind == KIND_value) {
        c.v[i].d = bad[k].value;
      } else {
        memcpy(fence_data(i) + at * a->size, &bad[k].value, sizeof bad[k].value);
      }
      law_refused(&c, bad[k].what, a->name, HSP_E_NOT_FINITE, "|needed|");
      check_first_bad(f, is_list(a) ? (uint32_t)(at / row_of(a)) : HSP_NONE);
    }
  }
}

static void fields(const function *f, uint32_t capacity, int i) {
  const argument *const a = &f->arguments[i];
  size_t d;
  for (d = 0; d < registry_fields_size; ++d) {
    const field *const part = &registry_fields[d];
    int k;
    if (strcmp(part->of, a->base) != 0 || strcmp(part->base, "double") != 0) continue;
    if (place_of(f, part->name) > i) continue; /* this field is also tried as an argument of its own */
    for (k = 0; k < BAD; ++k) {
      call c;
      char whose[64];
      call_prepare(&c, f, capacity);
      memcpy(fence_data(i) + part->offset, &bad[k].value, sizeof bad[k].value);
      snprintf(whose, sizeof whose, "%s->%s", a->name, part->name);
      law_refused(&c, bad[k].what, whose, HSP_E_NOT_FINITE, "|needed|");
      check_first_bad(f, is_list(a) ? 0 : HSP_NONE);
    }
  }
}

static void not_finite(const function *f, uint32_t capacity) {
  int i;
  if (!has_status(f, HSP_E_NOT_FINITE)) return;
  for (i = 0; i < f->count; ++i) {
    const argument *const a = &f->arguments[i];
    const int is_number = strcmp(a->base, "double") == 0;
    if (is_number && (a->kind == KIND_value || a->kind == KIND_array_in)) numbers(f, capacity, i);
    if (a->kind == KIND_sized_in || a->kind == KIND_struct_in || (!is_number && a->kind == KIND_array_in))
      fields(f, capacity, i);
  }
}

int main(void) {
  return check_law(not_finite);
}
