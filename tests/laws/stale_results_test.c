/* Results can be read as long as the model or boundary that they were made from holds the same. Once the model has
 * other balls, or the model or boundary is overwritten, reading returns HSP_E_STATE. When the same balls are set again
 * the results can be read again. */
#include <string.h>

#include "law.h"

static int reads(const function *f, int i, int base) {
  const argument *const a = &f->arguments[i];
  return a->kind == KIND_handle && depends_on(a->noun, base) && reads_contents(f, i);
}

/* Overwrites the model or boundary behind the results of a function that does not take this handle itself. */
static void base_overwritten(const function *f, uint32_t capacity, int base) {
  int i;
  call c;
  call_prepare(&c, f, capacity);
  for (i = 0; i < f->count; ++i) {
    if (c.v[i].p == given.handle[base] && f->arguments[i].kind == KIND_handle) return;
  }
  memset(given.handle[base], 0, sizeof(uintptr_t));
  law_refused(&c, "overwritten behind the results:", base == NOUN_model ? "model" : "boundary", HSP_E_STATE, "");
  call_spoils(given.handle[base]);
}

static void stale_results(const function *f, uint32_t capacity) {
  static const int bases[] = {NOUN_model, NOUN_boundary};
  int k;
  if (!has_status(f, HSP_E_STATE)) return;
  for (k = 0; k < 2; ++k) {
    int i, any = 0;
    call c;
    for (i = 0; i < f->count; ++i) any |= reads(f, i, bases[k]);
    if (!any) continue;
    base_overwritten(f, capacity, bases[k]);
    if (bases[k] != NOUN_model) continue;
    call_prepare(&c, f, capacity);
    fixture_set_other_balls();
    law_refused(&c, "other balls behind the results", "", HSP_E_STATE, "");
    fixture_set_model();
    call_prepare(&c, f, capacity);
    CHECK_EQUAL(hsp_model_set(given.handle[NOUN_model], given.balls, NULL, NULL, NULL, NULL),
                given.balls > 0 ? HSP_E_ARGUMENT : HSP_OK);
    if (given.balls > 0) law_refused(&c, "no balls behind the results, as they were refused", "", HSP_E_STATE, "");
    fixture_set_model();
    call_prepare(&c, f, capacity);
    law_succeeds(&c, "the same balls again behind the results", "");
  }
}

int main(void) {
  return check_law(stale_results);
}
