#include "function_facts.h"

#include <string.h>

#include "fixture.h"

int place_of(const function *f, const char *name) {
  int i;
  for (i = 0; i < f->count; ++i) {
    if (strcmp(f->arguments[i].name, name) == 0) return i;
  }
  return -1;
}

int place_of_kind(const function *f, int kind) {
  int i;
  for (i = 0; i < f->count; ++i) {
    if (f->arguments[i].kind == kind) return i;
  }
  return -1;
}

int has_status(const function *f, int32_t status) {
  return (f->statuses & BIT(status)) != 0;
}

int is_output(const argument *a) {
  switch (a->kind) {
    case KIND_array_out:
    case KIND_struct_out:
    case KIND_value_out:
    case KIND_needed:
    case KIND_handle_out:
    case KIND_sized:
    case KIND_memory:
      return 1;
    default:
      return 0;
  }
}

int is_number(const argument *a) {
  return a->kind == KIND_value || a->kind == KIND_capacity;
}

int is_pointer(const argument *a) {
  return !is_number(a) && (a->of == 0 || (a->kind != KIND_needed && a->kind != KIND_value_out));
}

int is_sized(const argument *a) {
  return a->kind == KIND_sized || a->kind == KIND_sized_in || a->kind == KIND_outputs;
}

size_t row_of(const argument *a) {
  return a->row == 0 ? 1 : a->row;
}

int names_reason(const function *f, const argument *a) {
  return strcmp(a->name, "first_bad") == 0 || (strcmp(f->noun, "picture") == 0 && strcmp(a->name, "bytes") == 0);
}

/* ---- the few functions of which names and kinds do not say enough ---- */

static void begin(void) {
  uint32_t stages;
  hsp_boundary_begin(given.handle[NOUN_boundary], given.handle[NOUN_model], 1, &stages);
}

static void begin_and_work(void) {
  uint32_t stages = 0, i;
  hsp_boundary_begin(given.handle[NOUN_boundary], given.handle[NOUN_model], 1, &stages);
  for (i = 0; i < stages; ++i) hsp_boundary_work(given.handle[NOUN_boundary], i, 0);
}

static const struct recipe {
  const char *name;
  void (*before)(void);
  const char *argument, *only_with; /* the first may be NULL only if the other is, and is read */
} recipes[] = {
    {"hsp_boundary_work", begin, NULL, NULL},
    {"hsp_boundary_end", begin_and_work, NULL, NULL},
    {"hsp_boundary_gradient_end", NULL, "shares", "energy"},
};

static const struct recipe *recipe_of(const function *f) {
  size_t i;
  for (i = 0; i < sizeof recipes / sizeof recipes[0]; ++i) {
    if (strcmp(recipes[i].name, f->name) == 0) return &recipes[i];
  }
  return NULL;
}

int needs_calls_before(const function *f) {
  const struct recipe *const r = recipe_of(f);
  return r != NULL && r->before != NULL;
}

void make_calls_before(const function *f) {
  recipe_of(f)->before();
}

int adds_to_arrays(const function *f) {
  const struct recipe *const r = recipe_of(f);
  return r != NULL && r->argument != NULL;
}

int null_only_with(const function *f, int i) {
  const struct recipe *const r = recipe_of(f);
  if (r == NULL || r->argument == NULL || strcmp(r->argument, f->arguments[i].name) != 0) return -1;
  return place_of(f, r->only_with);
}
