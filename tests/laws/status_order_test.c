/* If more than one status fits, a function returns the one that hardsphere.h puts first (section STATUS): handles,
 * then versions, arguments, states, values, capacities. Every two faults of different ranks are tried together. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "fenced_memory.h"
#include "law.h"

enum rank { HANDLE, VERSION, ARGUMENT, STATE, VALUE, ROOM };

typedef struct fault {
  int rank, place, where; /* where: in which field of a struct, -1: none */
  int32_t status;
  const char *what;
} fault;

enum { MOST_FAULTS = 128 };

typedef struct faults {
  fault of[MOST_FAULTS];
  int count;
} faults;

static void add(faults *all, int rank, int place, int where, int32_t status, const char *what) {
  const fault one = {rank, place, where, status, what};
  CHECK(all->count < MOST_FAULTS); /* else a fault would go untried */
  if (all->count < MOST_FAULTS) all->of[all->count++] = one;
}

static int is_handle(const argument *a) {
  return a->kind == KIND_handle;
}

/* The faults that can be made in the arguments of f. That each fault alone is refused is tried by the other laws. */
static faults faults_of(const function *f, uint32_t needed) {
  const int first = place_of(f, "first");
  faults all;
  int i;
  all.count = 0;
  for (i = 0; i < f->count; ++i) {
    const argument *const a = &f->arguments[i];
    if (is_handle(a)) {
      add(&all, HANDLE, i, -1, HSP_E_HANDLE, "zeros for");
      if (a->null == NULL_never) add(&all, HANDLE, i, -1, HSP_E_ARGUMENT, "NULL for");
      if (reads_contents(f, i) && has_status(f, HSP_E_STATE)) add(&all, STATE, i, -1, HSP_E_STATE, "no results in");
      continue;
    }
    if (is_sized(a)) add(&all, VERSION, i, -1, HSP_E_VERSION, "a bad struct_size of");
    if (is_pointer(a) && a->null == NULL_never && !(a->held && needed == 0))
      add(&all, ARGUMENT, i, -1, HSP_E_ARGUMENT, "NULL for");
    /* With one entry less than is needed there is still something to hold. */
    if (is_pointer(a) && a->null == NULL_empty && (!a->held || needed > 1))
      add(&all, ARGUMENT, i, -1, HSP_E_ARGUMENT, "NULL for");
    if (is_choice(a)) add(&all, ARGUMENT, i, -1, HSP_E_ARGUMENT, "an unknown");
    if (a->kind == KIND_value && strcmp(a->base, "double") == 0 && has_status(f, HSP_E_NOT_FINITE))
      add(&all, VALUE, i, -1, HSP_E_NOT_FINITE, "NaN in");
    if (a->kind == KIND_array_in && strcmp(a->base, "double") == 0 && has_status(f, HSP_E_NOT_FINITE))
      add(&all, VALUE, i, -1, HSP_E_NOT_FINITE, "NaN in");
    if (i == first && a->kind == KIND_value && has_status(f, HSP_E_ID))
      add(&all, VALUE, i, -1, HSP_E_ID, "a range beyond the end from");
    if (a->kind == KIND_capacity && needed > 0 && place_of_kind(f, KIND_needed) >= 0)
      add(&all, ROOM, i, -1, HSP_E_CAPACITY, "one less than is needed of");
  }
  return all;
}

/* Makes the fault in a prepared call; 0 if this is no longer possible. */
static int make(call *c, const fault *one, uint32_t needed) {
  static uint64_t zeros[64];
  static const uint32_t no_size = 1;
  static const double nan = NAN;
  const argument *const a = &c->f->arguments[one->place];
  const int i = one->place;
  switch (one->rank) {
    case HANDLE:
      c->v[i].p = one->status == HSP_E_ARGUMENT ? NULL : (void *)zeros;
      return 1;
    case VERSION:
      if (i + 1 < c->f->count && strcmp(c->f->arguments[i + 1].name, "struct_size") == 0) {
        c->v[i + 1].u = no_size;
        return 1;
      }
      if (!c->fenced[i]) return 0;
      memcpy(fence_data(i), &no_size, sizeof no_size);
      return 1;
    case ARGUMENT:
      if (is_choice(a)) {
        c->v[i].u = 1u << 30;
      } else {
        call_put_null(c, i);
      }
      return 1;
    case STATE:
      c->v[i].p = a->noun == NOUN_model || a->noun == NOUN_body ? given.refused[a->noun] : given.fresh[a->noun];
      return 1;
    case VALUE:
      if (one->status == HSP_E_ID) {
        c->v[i].u = 100000;
      } else if (a->kind == KIND_value) {
        c->v[i].d = NAN;
      } else {
        if (!c->fenced[i] || fence_size(i) < sizeof nan) return 0;
        memcpy(fence_data(i), &nan, sizeof nan);
      }
      return 1;
    default:
      c->v[i].u = needed - 1;
      return 1;
  }
}

/* Whether two faults can be seen together: not if both are in one argument or one struct. */
static int are_apart(const function *f, const fault *one, const fault *other) {
  return one->rank != other->rank && one->place != other->place && f->arguments[other->place].of != one->place &&
         f->arguments[one->place].of != other->place;
}

static void status_order(const function *f, uint32_t needed) {
  const faults all = faults_of(f, needed);
  int i, k;
  if (f->result != RESULT_status) return;
  for (i = 0; i < all.count; ++i) {
    for (k = 0; k < all.count; ++k) {
      const fault *const one = &all.of[i], *const other = &all.of[k];
      char scene[160];
      call c;
      if (one->rank >= other->rank || !are_apart(f, one, other)) continue;
      call_prepare(&c, f, needed);
      /* Pointers last, as what they led to is written first. */
      if (!make(&c, other, needed) || !make(&c, one, needed)) continue;
      snprintf(scene, sizeof scene, "%s %s and %s", one->what, f->arguments[one->place].name, other->what);
      check_scene("%s: %s %s", f->name, scene, f->arguments[other->place].name);
      call_run(&c);
      CHECK_EQUAL(c.result, one->status);
    }
  }
}

int main(void) {
  return check_law(status_order);
}
