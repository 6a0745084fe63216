/* A handle without results is refused with HSP_E_STATE where results are read. So is a model or a body whose last set
 * has failed, by every function that takes one but hsp_model_get_info. */
#include "law.h"

static void no_results(const function *f, uint32_t capacity) {
  int i;
  for (i = 0; i < f->count; ++i) {
    const argument *const a = &f->arguments[i];
    const int of_set = a->kind == KIND_handle && (a->noun == NOUN_model || a->noun == NOUN_body);
    call c;
    if (!reads_contents(f, i)) continue;
    check_scene("%s: what its comment says of %s without results", f->name, a->name);
    if (of_set) CHECK(f->result == RESULT_status && has_status(f, HSP_E_STATE));
    if (!has_status(f, HSP_E_STATE)) continue;
    call_prepare(&c, f, capacity);
    c.v[i].p = of_set ? given.refused[a->noun] : given.fresh[a->noun];
    law_refused(&c, "no results in", a->name, HSP_E_STATE, "");
  }
}

int main(void) {
  return check_law(no_results);
}
