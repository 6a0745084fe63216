/* A range of records that ends beyond them, also beyond 2^32, is refused with HSP_E_ID. */
#include <string.h>

#include "law.h"

static void ranges(const function *f, uint32_t capacity) {
  static const uint32_t bad[][2] = {{1, 0xFFFFFFFF}, {0xFFFFFFFF, 1}, {0x80000000, 0x80000000}, {0, 0xFFFFFFFF}};
  const int first = place_of(f, "first");
  size_t k;
  if (first < 0 || f->arguments[first].kind != KIND_value) return;
  if (first + 1 == f->count || strcmp(f->arguments[first + 1].name, "count") != 0) return;
  for (k = 0; k < sizeof bad / sizeof bad[0]; ++k) {
    call c;
    call_prepare(&c, f, capacity);
    c.v[first].u = bad[k][0];
    c.v[first + 1].u = bad[k][1];
    law_refused(&c, "a range beyond the end", "", HSP_E_ID, "");
  }
}

int main(void) {
  return check_law(ranges);
}
