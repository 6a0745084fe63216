/* Calls of functions of the registry with base arguments: a valid value for each argument, chosen by its kind and name.
 * Arrays lie in fenced memory (fenced_memory.h), so that reading or writing one number too many is noticed. */
#pragma once

#include "fixture.h"
#include "function_facts.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { MOST_ARGUMENTS = 24, PLENTY = 400 };

typedef struct call {
  const function *f;
  value v[MOST_ARGUMENTS];
  int fenced[MOST_ARGUMENTS]; /* whether v[i].p lies in fenced memory, in place i */
  int64_t result;
  int outside; /* whether memory outside of the arguments was touched */
} call;

/* call_with_balls makes all handles of the fixture anew, over its first `balls` balls. call_spoils marks a handle that
 * the next call_prepare has to make anew. */
void call_with_balls(uint32_t balls);
void call_spoils(const void *handle);

/* Base arguments, with room for `capacity` records: call_numbers sets the numbers, then call_pointers the arrays, as
 * long as the numbers say. call_prepare does both. */
void call_numbers(call *c, const function *f, uint32_t capacity);
void call_pointers(call *c, uint32_t capacity);
void call_prepare(call *c, const function *f, uint32_t capacity);
/* The same with the handles as the call before has left them. */
void call_prepare_next(call *c, const function *f, uint32_t capacity);

/* call_put gives an argument other memory, of so many bytes; call_put_null gives it NULL. */
void *call_put(call *c, int i, size_t bytes);
void call_put_null(call *c, int i);

/* The contents of base arguments: base_number is the value of argument i, fill_base fills an array of `count` numbers
 * or structs, or one struct. */
value base_number(const function *f, int i);
void fill_base(const argument *a, void *out, size_t count);
const char *base_text(const argument *a);

/* Makes the call. `outside` and call_finds tell whether it kept the rules that hold for every call. */
void call_run(call *c);

/* NULL, or what is wrong whatever the arguments are: an undocumented status, an input that was written, memory outside
 * of the arguments that was touched. */
const char *call_finds(const call *c);

/* Whether it was refused with that status; functions without a status say HSP_NONE. */
int call_is_refused(const call *c, int32_t status);

/* NULL, or the name of an output that was written although its name is not in `but`: "|name|name|". */
const char *call_wrote(const call *c, const char *but);

/* The value of `needed` afterwards; 0 if the function has none. */
uint32_t call_needed(const call *c);

#ifdef __cplusplus
}
#endif
