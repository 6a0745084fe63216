/* Facts about a function of the registry by the kinds of its arguments, and by names that always mean the same. */
#pragma once

#include "registry.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whether an argument is an output that tells the reason of a failure: the header lets a function write it when it
 * fails, unless a handle is refused. */
int names_reason(const function *f, const argument *a);

/* The place of an argument, -1 if there is none. */
int place_of(const function *f, const char *name);
int place_of_kind(const function *f, int kind);

int has_status(const function *f, int32_t status);
int is_output(const argument *a);
/* Whether it is a single number: an argument, or a field of a struct that is read. */
int is_number(const argument *a);
int is_pointer(const argument *a);
/* Whether it is a number of which only few values have a meaning: flags, or one of some constants. */
int is_choice(const argument *a);
/* A struct that says its size. */
int is_sized(const argument *a);

/* Whether it is memory for one call, with a pointer to its size as the next argument; other memory is for a handle. */
int is_memory_of_call(const function *f, int i);

/* How many numbers or structs make an entry of an array. */
size_t row_of(const argument *a);

#ifdef __cplusplus
}
#endif
