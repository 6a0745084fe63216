/* A handle without results is refused with HSP_E_STATE where results are read. */
#include <string.h>

#include "law.h"

static void no_results(const function *f, uint32_t capacity) {
  int i;
  if (!has_status(f, HSP_E_STATE)) return;
  for (i = 0; i < f->count; ++i) {
    const argument *const a = &f->arguments[i];
    call c;
    if (a->kind != KIND_handle || a->noun == NOUN_model || a->noun == NOUN_body) continue;
    if (i == 0 && strstr(f->name, "_compute") != NULL) continue; /* what is computed needs none before */
    call_prepare(&c, f, capacity);
    c.v[i].p = given.fresh[a->noun];
    law_refused(&c, "no results in", a->name, HSP_E_STATE, "");
  }
}

int main(void) {
  return check_law(no_results);
}
