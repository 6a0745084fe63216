#include "law.h"

#include <stdio.h>

#include "fenced_memory.h"

void law_run(call *c, const char *what, const char *whose) {
  const char *found;
  check_scene("%s: %s %s", c->f->name, what, whose);
  call_run(c);
  found = call_finds(c);
  check_true(found == NULL, found == NULL ? "" : found, __FILE__, __LINE__);
}

void law_refused(call *c, const char *what, const char *whose, int32_t status, const char *but) {
  char may_write[128] = "";
  const char *written;
  int i;
  law_run(c, what, whose);
  CHECK_EQUAL(call_is_refused(c, status) ? status : c->result, status);
  for (i = 0; i < c->f->count && status != HSP_E_HANDLE; ++i) {
    if (names_reason(c->f, &c->f->arguments[i])) {
      snprintf(may_write, sizeof may_write, "|%s|%s", c->f->arguments[i].name, but);
    }
  }
  written = call_wrote(c, may_write[0] != '\0' ? may_write : but);
  check_true(written == NULL, written == NULL ? "" : written, __FILE__, __LINE__);
}

void law_succeeds(call *c, const char *what, const char *whose) {
  law_run(c, what, whose);
  if (c->f->result == RESULT_status) {
    CHECK_EQUAL(c->result, HSP_OK);
  } else if (c->f->result == RESULT_id) {
    CHECK((uint32_t)c->result != HSP_NONE);
  }
}

/* From a call with plenty of room: the number that it needed, or that it asks for. */
static uint32_t capacity_that_suffices(const function *f) {
  call c;
  call_prepare(&c, f, PLENTY);
  check_scene("%s: base arguments", f->name);
  call_run(&c);
  return c.result == HSP_OK || c.result == HSP_E_CAPACITY ? call_needed(&c) : 0;
}

void try_law(law try_it) {
  size_t k;
  for (k = 0; k < registry_size; ++k) try_it(&registry[k], capacity_that_suffices(&registry[k]));
}

int check_law(law try_it) {
  const char *why;
  if (!fences_exist(&why)) {
    printf("skipped: %s\n", why);
    return 77;
  }
  try_law(try_it);
  return check_report();
}
