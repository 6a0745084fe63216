/* Sets of few balls and of none, with room for no records and for some: whatever the status is, it is documented, and
 * nothing outside of the arguments is touched. */
#include "law.h"

static void any_room(const function *f, uint32_t capacity) {
  const int first = place_of(f, "first");
  uint32_t from, k;
  for (k = 0; k < 3; ++k) {
    const uint32_t rooms[] = {0, 1, capacity + 7};
    for (from = 0; from < 2; ++from) {
      call c;
      call_prepare(&c, f, rooms[k]);
      if (first >= 0 && f->arguments[first].kind == KIND_value) c.v[first].u = from;
      law_run(&c, "few balls", "");
    }
  }
}

static void few_balls(const function *f, uint32_t capacity) {
  static const uint32_t sets[] = {0, 1, 2, 3, 5, 7, 8};
  size_t k;
  (void)capacity;
  if (f != registry) return; /* once, for the first function: any_room is tried on all functions here */
  for (k = 0; k < sizeof sets / sizeof sets[0]; ++k) {
    call_with_balls(sets[k]);
    try_law(any_room);
  }
  call_with_balls(FIXTURE_BALLS);
}

int main(void) {
  return check_law(few_balls);
}
