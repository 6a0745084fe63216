#include "call.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fenced_memory.h"

/* ---- base arguments --------------------------------------------------------------------------------------------- */

static uint32_t wanted_balls = FIXTURE_BALLS;
static int all_dirty = 1, dirty[NOUNS];

void call_with_balls(uint32_t balls) {
  wanted_balls = balls;
  all_dirty = 1;
}

void call_spoils(const void *handle) {
  int noun;
  for (noun = NOUN_none + 1; noun < NOUNS; ++noun) {
    if (handle == given.handle[noun]) dirty[noun] = 1;
    if (handle == given.fresh[noun]) all_dirty = 1;
  }
  if (handle == given.spare_model || handle == given.moving_body) all_dirty = 1;
}

static void clean(void) {
  int noun;
  if (all_dirty) fixture_make(wanted_balls);
  for (noun = NOUN_none + 1; noun < NOUNS; ++noun) {
    if (dirty[noun] && !all_dirty) fixture_make_again(noun);
    dirty[noun] = 0;
  }
  all_dirty = 0;
}

static int32_t take_all(void *context, const char *bytes, size_t count) {
  (void)context;
  (void)bytes;
  (void)count;
  return 0;
}

static size_t entries(const call *c, const argument *a, uint32_t capacity) {
  char *end;
  const size_t number = strtoul(a->extent, &end, 10);
  int place;
  if (a->held) return capacity;
  if (end != a->extent && *end == '\0') return number;
  place = place_of(c->f, a->extent);
  if (place >= 0 && strcmp(c->f->arguments[place].base, "size_t") == 0) return c->v[place].z;
  if (place >= 0) return c->v[place].u;
  if (strcmp(a->extent, "n") == 0) return given.balls;
  if (strcmp(a->extent, "n + 1") == 0) return given.balls + 1;
  printf("%s: how long is %s [%s]?\n", c->f->name, a->name, a->extent);
  exit(2);
}

void *call_put(call *c, int i, size_t bytes) {
  c->fenced[i] = 1;
  return c->v[i].p = fence_take(i, bytes, 0);
}

void call_put_null(call *c, int i) {
  c->fenced[i] = 0;
  if (c->f->arguments[i].kind == KIND_callback) {
    c->v[i].f = NULL;
  } else {
    c->v[i].p = NULL;
  }
}

static void *base_handle(const argument *a, int i) {
  if (a->noun == NOUN_body && strcmp(a->name, "posed") == 0) return given.moving_body;
  if (a->noun == NOUN_model && !a->is_const && i > 0) return given.spare_model;
  return given.handle[a->noun];
}

static const size_t memory_of_call = HSP_AREAS_BYTES(FIXTURE_BALLS);

static void give(call *c, int i, uint32_t capacity) {
  const argument *const a = &c->f->arguments[i];
  size_t count;
  c->fenced[i] = 0;
  switch (a->kind) {
    case KIND_value:
      c->v[i] = base_number(c->f, i);
      return;
    case KIND_capacity:
      c->v[i].u = capacity;
      return;
    case KIND_handle:
      c->v[i].p = base_handle(a, i);
      return;
    case KIND_context:
      c->v[i].p = NULL;
      return;
    case KIND_callback:
      c->v[i].f = take_all;
      return;
    case KIND_string:
      count = strlen(base_text(a)) + 1;
      memcpy(call_put(c, i, count), base_text(a), count);
      return;
    case KIND_handle_out:
      call_put(c, i, sizeof(void *));
      return;
    case KIND_memory: /* not one byte more than the handle takes */
      call_put(c, i, is_memory_of_call(c->f, i) ? memory_of_call : c->v[i + 1].z);
      return;
    case KIND_array_in:
    case KIND_array_out:
      count = entries(c, a, capacity) * row_of(a);
      call_put(c, i, count * a->size);
      if (a->kind == KIND_array_in) fill_base(a, c->v[i].p, count);
      return;
    default:
      call_put(c, i, a->size);
      if (a->kind == KIND_struct_in || is_sized(a)) fill_base(a, c->v[i].p, 1);
      if (i > 0 && is_memory_of_call(c->f, i - 1)) memcpy(c->v[i].p, &memory_of_call, sizeof memory_of_call);
  }
}

static void numbers_of(call *c, const function *f, uint32_t capacity) {
  int i;
  c->f = f;
  for (i = 0; i < f->count; ++i) {
    if (is_number(&f->arguments[i])) give(c, i, capacity);
  }
}

void call_numbers(call *c, const function *f, uint32_t capacity) {
  clean(); /* before anybody takes its addresses */
  numbers_of(c, f, capacity);
}

void call_pointers(call *c, uint32_t capacity) {
  int i;
  for (i = 0; i < c->f->count; ++i) {
    if (!is_number(&c->f->arguments[i])) give(c, i, capacity);
  }
}

void call_prepare(call *c, const function *f, uint32_t capacity) {
  call_numbers(c, f, capacity);
  call_pointers(c, capacity);
}

void call_prepare_next(call *c, const function *f, uint32_t capacity) {
  numbers_of(c, f, capacity);
  call_pointers(c, capacity);
}

/* ---- a call ------------------------------------------------------------------------------------------------------ */

/* The address of a field in its request or outputs; NULL if the struct is missing or too short for the field. */
static unsigned char *field_at(const call *c, int i) {
  const argument *const a = &c->f->arguments[i];
  const size_t bytes = is_pointer(a) ? sizeof(void *) : a->size;
  if (a->of == 0 || !c->fenced[a->of] || a->offset + bytes > fence_size(a->of)) return NULL;
  return fence_data(a->of) + a->offset;
}

static void put_fields(const call *c) {
  int i;
  for (i = 0; i < c->f->count; ++i) {
    const argument *const a = &c->f->arguments[i];
    unsigned char *const at = field_at(c, i);
    if (at == NULL) continue;
    if (is_number(a) || is_pointer(a)) {
      memcpy(at, &c->v[i], is_number(a) ? a->size : sizeof(void *));
    } else {
      memcpy(at, c->v[i].p, a->size);
    }
  }
}

/* Numbers that a function writes into an outputs struct itself are moved to memory of their own; then nothing else in
 * the struct may have changed. */
static void take_fields(const call *c) {
  int i;
  for (i = 0; i < c->f->count; ++i) {
    const argument *const a = &c->f->arguments[i];
    unsigned char *const at = field_at(c, i);
    if (at == NULL || is_number(a) || is_pointer(a)) continue;
    memcpy(c->v[i].p, at, a->size);
    memcpy(at, fence_copy(a->of) + a->offset, a->size);
  }
}

static void run(void *context) {
  call *const c = context;
  c->result = c->f->call(c->v);
}

void call_run(call *c) {
  int i;
  put_fields(c);
  for (i = 0; i < c->f->count; ++i) {
    if (c->fenced[i]) fence_remember(i);
    if (c->f->arguments[i].kind == KIND_handle && !c->f->arguments[i].is_const) call_spoils(c->v[i].p);
  }
  c->outside = !fence_watch(run, c);
  if (c->outside) all_dirty = 1;
  take_fields(c);
}

const char *call_finds(const call *c) {
  int i;
  if (c->outside) return "memory outside of the arguments is touched";
  for (i = 0; i < c->f->count; ++i) {
    if (!c->fenced[i]) continue;
    if (!fence_holds(i)) return "memory beside an array is written";
    if (!is_output(&c->f->arguments[i]) && !fence_unchanged(i, 0)) return "an input is written";
  }
  if (c->f->result != RESULT_status) return NULL;
  if (c->result > 0 || c->result < -31 || !has_status(c->f, (int32_t)c->result)) return "the status is not documented";
  return NULL;
}

int call_is_refused(const call *c, int32_t status) {
  if (c->f->result == RESULT_id) return (uint32_t)c->result == HSP_NONE;
  return c->result == status;
}

const char *call_wrote(const call *c, const char *but) {
  int i;
  for (i = 0; i < c->f->count; ++i) {
    const argument *const a = &c->f->arguments[i];
    char name[64];
    if (is_memory_of_call(c->f, i)) continue; /* nothing of it is an answer */
    snprintf(name, sizeof name, "|%s|", a->name);
    if (c->fenced[i] && is_output(a) && strstr(but, name) == NULL && !fence_unchanged(i, 0)) return a->name;
  }
  return NULL;
}

uint32_t call_needed(const call *c) {
  const int place = place_of_kind(c->f, KIND_needed);
  uint32_t needed = 0;
  if (place >= 0 && c->fenced[place]) memcpy(&needed, fence_data(place), sizeof needed);
  return needed;
}
