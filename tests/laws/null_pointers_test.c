/* NULL is refused with HSP_E_ARGUMENT, or has no effect on the status where the header allows it. */
#include <string.h>

#include "law.h"

static void with_nothing_to_hold(const function *f, int i, uint32_t capacity) {
  const argument *const a = &f->arguments[i];
  const int place = a->held ? -1 : place_of(f, a->extent);
  call c;
  call_prepare(&c, f, a->held ? 0 : capacity);
  if (place >= 0) c.v[place].u = 0;
  call_put_null(&c, i);
  law_run(&c, "NULL and nothing to hold for", a->name);
  CHECK_EQUAL(c.result, a->held && capacity > 0 ? HSP_E_CAPACITY : HSP_OK);
}

static void null_pointers(const function *f, uint32_t capacity) {
  int i;
  for (i = 0; i < f->count; ++i) {
    const argument *const a = &f->arguments[i];
    call c;
    if (!is_pointer(a)) continue;
    call_prepare(&c, f, a->held && capacity == 0 ? 1 : capacity);
    call_put_null(&c, i);
    if (a->null == NULL_always) {
      law_run(&c, "NULL for", a->name);
      CHECK_EQUAL(c.result, HSP_OK);
    } else {
      law_refused(&c, "NULL for", a->name, HSP_E_ARGUMENT, "");
    }
    if (a->null == NULL_empty) with_nothing_to_hold(f, i, capacity);
  }
}

int main(void) {
  return check_law(null_pointers);
}
