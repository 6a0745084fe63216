/* Numbers beyond their range: too large limits, too many balls and points too far away are refused with HSP_E_RANGE, a
 * negative radius with HSP_E_NEGATIVE. */
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

static const uint32_t too_many[] = {HSP_MAX_BALLS + 1, 0xFFFFFFFF};
enum { TOO_MANY = sizeof too_many / sizeof too_many[0] };

static void limits_too_large(const function *f, uint32_t capacity, int i) {
  size_t d, k;
  for (d = 0; d < registry_fields_size; ++d) {
    const field *const part = &registry_fields[d];
    call c;
    if (strcmp(part->of, f->arguments[i].base) != 0 || part->offset == 0) continue;
    for (k = 0; k < TOO_MANY; ++k) {
      call_prepare(&c, f, capacity);
      memcpy(fence_data(i) + part->offset, &too_many[k], sizeof too_many[k]);
      law_refused(&c, "too large:", part->name, HSP_E_RANGE, "");
    }
  }
}

/* Tries a wrong value as each number of the first row of an array, or as the argument itself. */
static void number(const function *f, uint32_t capacity, int i, double wrong, const char *what, int32_t status) {
  const argument *const a = &f->arguments[i];
  size_t at = 0, end = 1;
  if (!has_status(f, status)) return;
  if (a->kind == KIND_array_in) end = strcmp(a->extent, "3") == 0 ? 3 : row_of(a);
  for (; at < end; ++at) {
    call c;
    call_prepare(&c, f, capacity);
    if (a->kind == KIND_value) {
      c.v[i].d = wrong;
    } else {
      memcpy(fence_data(i) + at * a->size, &wrong, sizeof wrong);
    }
    law_refused(&c, what, a->name, status, "");
  }
}

/* Tries more balls than HSP_MAX_BALLS, and more than the model has room for. */
static void too_many_balls(const function *f, uint32_t capacity, int i) {
  size_t k;
  for (k = 0; k < TOO_MANY; ++k) {
    call c;
    call_prepare(&c, f, capacity);
    c.v[i].u = too_many[k];
    law_refused(&c, "too many", f->arguments[i].name,
                strncmp(f->name, "hsp_model_set", 13) == 0 ? HSP_E_CAPACITY : HSP_E_RANGE, "");
  }
}

static void magnitudes(const function *f, uint32_t capacity) {
  static const char *const far_away[] = {"xyz", "from", "to", "origin"};
  static const double far[] = {1e30, -1e30, 1e300, -1.7e308};
  int i;
  size_t k, which;
  for (i = 0; i < f->count; ++i) {
    const argument *const a = &f->arguments[i];
    if (a->kind == KIND_sized_in && strstr(a->base, "_limits") != NULL && has_status(f, HSP_E_RANGE))
      limits_too_large(f, capacity, i);
    if (a->kind == KIND_value && (strcmp(a->name, "n") == 0 || strcmp(a->name, "balls") == 0))
      too_many_balls(f, capacity, i);
    if (strcmp(a->base, "double") != 0 || (a->kind != KIND_value && a->kind != KIND_array_in)) continue;
    if (strcmp(a->name, "radius") == 0) {
      number(f, capacity, i, -1, "negative:", HSP_E_NEGATIVE);
      number(f, capacity, i, -1e-300, "negative:", HSP_E_NEGATIVE);
      /* a stick so thick is in conflict with its balls before */
      if (!has_status(f, HSP_E_CONFLICT)) number(f, capacity, i, 1e300, "too large:", HSP_E_RANGE);
    }
    for (k = 0; k < sizeof far_away / sizeof far_away[0]; ++k) {
      for (which = 0; which < 4 && strcmp(a->name, far_away[k]) == 0; ++which)
        number(f, capacity, i, far[which], "too far away:", HSP_E_RANGE);
    }
  }
}

int main(void) {
  return check_law(magnitudes);
}
