/* Ids that do not exist are refused with HSP_E_ID, or the function returns HSP_NONE. Arguments that are ids are known
 * by their names, which are listed below. */
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

static int is_id(const argument *a) {
  static const char *const ids[] = {"ball",   "vertex",  "edge", "face",   "cell",   "region", "patch",
                                    "shell",  "h",       "q",    "first",  "stage",  "worker", "atomic_number",
                                    "shells", "maximum", "gate", "pocket", "avoided"};
  size_t k;
  if (strcmp(a->base, "uint32_t") != 0 || (a->kind != KIND_value && a->kind != KIND_array_in)) return 0;
  for (k = 0; k < sizeof ids / sizeof ids[0]; ++k) {
    if (strcmp(ids[k], a->name) == 0) return 1;
  }
  return 0;
}

static void ids(const function *f, uint32_t capacity) {
  /* In a map of sticks the ids of the halves of sticks follow those of the balls. */
  const uint32_t halves = strcmp(f->noun, "sticks") == 0 && given.balls > FIXTURE_STICK_END ? 2 : 0;
  const uint32_t balls = given.balls + halves;
  const uint32_t bad[] = {0xFFFFFFFF, 0x7FFFFFFF, 0x80000000, 100000, balls};
  int i;
  size_t k;
  if (f->result != RESULT_id && !(f->result == RESULT_status && has_status(f, HSP_E_ID))) return;
  for (i = 0; i < f->count; ++i) {
    for (k = 0; k < sizeof bad / sizeof bad[0] && is_id(&f->arguments[i]); ++k) {
      call c;
      if (bad[k] == balls && strcmp(f->arguments[i].name, "ball") != 0) continue;
      call_prepare(&c, f, capacity);
      if (f->arguments[i].kind == KIND_value) {
        c.v[i].u = bad[k];
      } else {
        memcpy(fence_data(i), &bad[k], sizeof bad[k]);
      }
      law_refused(&c, "no such", f->arguments[i].name, HSP_E_ID, "");
    }
  }
}

int main(void) {
  return check_law(ids);
}
