#include "function_facts.h"

#include <string.h>

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

int is_choice(const argument *a) {
  static const char *const choices[] = {"tangency", "flags", "set", "dimension"};
  size_t k;
  for (k = 0; k < sizeof choices / sizeof choices[0]; ++k) {
    if (a->kind == KIND_value && strcmp(choices[k], a->name) == 0) return 1;
  }
  return 0;
}

int is_sized(const argument *a) {
  return a->kind == KIND_sized || a->kind == KIND_sized_in || a->kind == KIND_outputs;
}

int is_memory_of_call(const function *f, int i) {
  return f->arguments[i].kind == KIND_memory && is_pointer(&f->arguments[i + 1]);
}

size_t row_of(const argument *a) {
  return a->row == 0 ? 1 : a->row;
}

int names_reason(const function *f, const argument *a) {
  return strcmp(a->name, "first_bad") == 0 || (strcmp(f->noun, "bricks") == 0 && strcmp(a->name, "brick") == 0) ||
         (strcmp(f->noun, "picture") == 0 && strcmp(a->name, "bytes") == 0);
}
