/* Values that mean nothing are refused: flags and choices with HSP_E_ARGUMENT, reserved fields that are not 0 with
 * HSP_E_VERSION or, of structs that never grow, HSP_E_ARGUMENT. */
#include <stdio.h>
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

static void reserved_fields(const function *f, uint32_t capacity, int i) {
  const argument *const a = &f->arguments[i];
  size_t d;
  for (d = 0; d < registry_fields_size; ++d) {
    const field *const part = &registry_fields[d];
    call c;
    char whose[64];
    if (strcmp(part->of, a->base) != 0 || strncmp(part->name, "reserved", 8) != 0) continue;
    call_prepare(&c, f, capacity);
    fence_data(i)[part->offset] = 1;
    snprintf(whose, sizeof whose, "%s->%s", a->name, part->name);
    law_refused(&c, "not 0:", whose, is_sized(a) ? HSP_E_VERSION : HSP_E_ARGUMENT, "");
  }
}

static void unknown_values(const function *f, uint32_t capacity) {
  int i;
  for (i = 0; i < f->count; ++i) {
    const argument *const a = &f->arguments[i];
    call c;
    if (is_choice(a)) {
      call_prepare(&c, f, capacity);
      c.v[i].u = 1u << 30;
      law_refused(&c, "unknown", a->name, HSP_E_ARGUMENT, "");
    }
    if ((is_sized(a) && a->kind != KIND_sized) || a->kind == KIND_array_in || a->kind == KIND_struct_in)
      reserved_fields(f, capacity, i);
  }
}

int main(void) {
  return check_law(unknown_values);
}
