/* The section HANDLES AFTER A FAILURE of hardsphere.h: a set or computation that is refused, for whatever reason,
 * leaves its handle without results. A refused reading function leaves the results. */
#include <math.h>
#include <string.h>

#include "law.h"

/* A function that reads results of this kind of handle and needs no other results. Each kind shall have one; NULL if
 * none is found. */
static const function *reader_of(int noun) {
  size_t k;
  for (k = 0; k < registry_size; ++k) {
    const function *const f = &registry[k];
    if (noun == NOUN_model && strcmp(f->name, "hsp_query_ray") == 0) return f;
    if (noun == NOUN_body && strcmp(f->name, "hsp_body_hits") == 0) return f;
    if (noun == NOUN_paths && strcmp(f->name, "hsp_paths_get_points") == 0) return f;
    if (f->count == 2 && f->arguments[0].noun == noun && f->arguments[0].is_const && has_status(f, HSP_E_STATE) &&
        f->arguments[1].kind == KIND_struct_out)
      return f;
  }
  return NULL;
}

static void check_reading(const function *reader, const char *what, const char *after, int32_t status) {
  call c;
  call_prepare_next(&c, reader, PLENTY);
  check_scene("%s after %s: %s", reader->name, after, what);
  call_run(&c);
  CHECK_EQUAL(c.result, status);
}

/* Gives argument i a value that is refused; 0 if it has no such value. */
static int spoil(call *c, int i) {
  static const uint32_t no_size = 0;
  const argument *const a = &c->f->arguments[i];
  if (is_sized(a)) {
    memcpy(c->v[i].p, &no_size, sizeof no_size);
  } else if (a->kind == KIND_value && strcmp(a->base, "double") == 0 && has_status(c->f, HSP_E_NOT_FINITE)) {
    c->v[i].d = NAN;
  } else if (is_pointer(a) && a->null == NULL_never) {
    call_put_null(c, i);
  } else {
    return 0;
  }
  return 1;
}

static void after_failure(const function *f, uint32_t capacity) {
  const function *reader;
  int i, is_const, computes;
  if (f->count == 0 || f->arguments[0].kind != KIND_handle) return;
  reader = reader_of(f->arguments[0].noun);
  is_const = f->arguments[0].is_const;
  computes = replaces_contents(f);
  check_scene("%s: results that can be read", f->name);
  CHECK(reader != NULL);
  if (reader == NULL || (!is_const && !computes)) return;
  for (i = 1; i < f->count; ++i) {
    call c;
    call_prepare(&c, f, capacity);
    if (!spoil(&c, i)) continue;
    law_run(&c, "after which results are read, a bad", f->arguments[i].name);
    CHECK(c.result != HSP_OK);
    check_reading(reader, f->arguments[i].name, f->name, computes ? HSP_E_STATE : HSP_OK);
  }
}

int main(void) {
  return check_law(after_failure);
}
