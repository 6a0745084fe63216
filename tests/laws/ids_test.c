/* Ids that do not exist are refused with HSP_E_ID, or the function returns HSP_NONE. Arguments that are ids are known
 * by their names, which are listed below, as are those of all other numbers: a new name has to be added to either. */
#include <stdio.h>
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

static const char ids_by_name[] =
    "|ball|edge|face|cell|region|patch|shell|h|q|first|atomic_number|shells|maximum|other|gate|pocket|avoided|owner|";
static const char others_by_name[] = "|set|tangency|flags|count|brick|bricks|patches|cheapest|";

static int is_in(const char *names, const char *name) {
  char between[64];
  snprintf(between, sizeof between, "|%s|", name);
  return strstr(names, between) != NULL;
}

static int is_uint(const argument *a) {
  return strcmp(a->base, "uint32_t") == 0 && (a->kind == KIND_value || a->kind == KIND_array_in);
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
    const char *const name = f->arguments[i].name;
    if (!is_uint(&f->arguments[i])) continue;
    check_scene("%s: whether %s is an id", f->name, name);
    CHECK(is_in(ids_by_name, name) != is_in(others_by_name, name));
    for (k = 0; k < sizeof bad / sizeof bad[0] && is_in(ids_by_name, name); ++k) {
      call c;
      if (bad[k] == balls && strcmp(name, "ball") != 0) continue;
      call_prepare(&c, f, capacity);
      if (f->arguments[i].kind == KIND_value) {
        c.v[i].u = bad[k];
      } else {
        memcpy(fence_data(i), &bad[k], sizeof bad[k]);
      }
      law_refused(&c, "no such", name, HSP_E_ID, "");
    }
  }
}

int main(void) {
  return check_law(ids);
}
