/* No function of the interface allocates or frees: malloc and its relatives are replaced by functions that count their
 * calls while a function runs. For glibc only, and not for sanitizer builds, which bring their own malloc. */
#include "law.h"
#include "malloc_trap.h"

static void check_trap(void) {
  void *volatile memory;
  armed = 1;
  memory = malloc(10);
  memory = realloc(memory, 20);
  free(memory);
  memory = calloc(1, 1);
  free(memory);
  armed = 0;
  CHECK_EQUAL(caught, 5);
}

static const function *trapped;
static int64_t armed_call(const value *v) {
  int64_t result;
  caught = 0;
  armed = 1;
  result = trapped->call(v);
  armed = 0;
  return result;
}

static void no_allocation(const function *f, uint32_t capacity) {
  function with_trap = *f;
  call c;
  trapped = f;
  with_trap.call = armed_call;
  call_prepare(&c, &with_trap, capacity);
  law_succeeds(&c, "with the heap trapped", "");
  CHECK_EQUAL(caught, 0);
}

int main(void) {
  check_trap();
  return check_law(no_allocation);
}
