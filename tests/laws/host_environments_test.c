/* Every function writes the same bytes and returns the same value in every floating-point environment of its caller
 * (tests/support/host). */
#include <stdlib.h>
#include <string.h>

#include "fenced_memory.h"
#include "host_calls.h"
#include "host_environment.h"
#include "law.h"

/* Whether argument i is an output with an answer, and not memory or the address of a handle. */
static int is_answer(const call *c, int i) {
  const argument *const a = &c->f->arguments[i];
  return c->fenced[i] && is_output(a) && a->kind != KIND_memory && a->kind != KIND_handle_out;
}

static void host_environments(const function *f, uint32_t capacity) {
  static unsigned char plain[FENCES][FENCE_BYTES];
  int64_t result;
  int which, i;
  call c;
  call_prepare(&c, f, capacity);
  law_succeeds(&c, "in the environment of this program", "");
  result = c.result;
  for (i = 0; i < f->count; ++i) {
    if (is_answer(&c, i)) memcpy(plain[i], fence_data(i), fence_size(i));
  }
  for (which = HOST_default + 1; which < HOST_ENVIRONMENTS; ++which) {
    if (!host_environment_exists(which)) continue;
    call_prepare(&c, f, capacity);
    host_calls_choose(which);
    law_succeeds(&c, "in the environment", host_environment_name(which));
    host_calls_choose(HOST_default);
    CHECK_EQUAL(c.result, result);
    for (i = 0; i < f->count; ++i) {
      if (is_answer(&c, i)) CHECK_BYTES(fence_data(i), plain[i], fence_size(i));
    }
  }
}

int main(void) {
  return check_law(host_environments);
}
