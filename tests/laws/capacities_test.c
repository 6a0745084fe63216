/* Room for one record less than is needed is refused with HSP_E_CAPACITY, for all arrays together and for each alone.
 * The number that suffices is reported, with and without the refusal, and a refused call writes nothing else. */
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

/* The outputs that may be written on HSP_E_CAPACITY. Functions that list pairs or rows also report where the list of
 * each ball begins, and two functions report a second number. */
static const char *also_written(const function *f) {
  return strstr(f->name, "query_pairs") != NULL || strstr(f->name, "_rows") != NULL ? "|needed|first|"
                                                                                    : "|needed|words_needed|";
}

static void check_needed(const call *c, uint32_t needed) {
  CHECK_EQUAL(call_needed(c), needed);
}

/* Tries one record less with array i alone: the others are NULL, but for those that may not be. */
static void one_less_alone(const function *f, uint32_t needed, int i) {
  int k, others = 0;
  call c;
  call_prepare(&c, f, needed - 1);
  for (k = 0; k < f->count; ++k) {
    if (k == i || !f->arguments[k].held || f->arguments[k].null == NULL_empty) continue;
    call_put_null(&c, k);
    ++others;
  }
  if (others == 0) return;
  law_refused(&c, "one less, alone:", f->arguments[i].name, HSP_E_CAPACITY, also_written(f));
  check_needed(&c, needed);
}

static void capacities(const function *f, uint32_t needed) {
  int i;
  call c;
  if (place_of_kind(f, KIND_needed) < 0) return;
  call_prepare(&c, f, needed);
  law_succeeds(&c, "as much as is needed", "");
  check_needed(&c, needed);
  if (needed == 0) return;
  call_prepare(&c, f, needed - 1);
  law_refused(&c, "one less than is needed", "", HSP_E_CAPACITY, also_written(f));
  check_needed(&c, needed);
  for (i = 0; i < f->count; ++i) {
    if (f->arguments[i].held) one_less_alone(f, needed, i);
  }
}

int main(void) {
  return check_law(capacities);
}
