/* Memory that ends directly before pages that may not be touched (fences), and begins behind guard bytes that are
 * compared after a call. */
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Whether there are such pages here; if not, `why` says so. */
int fences_exist(const char **why);

enum { FENCES = 24, FENCE_BYTES = 1 << 20, FENCE_PATTERN = 0xA5 };

/* A block of so many bytes, filled with a pattern, in place 0 .. FENCES - 1; it replaces the block that was there.
 * Between its end and the fence lie `slack` bytes, which are compared too. */
void *fence_take(int place, size_t bytes, size_t slack);

/* Keeps a copy of the block in this place. */
void fence_remember(int place);
const unsigned char *fence_copy(int place);
unsigned char *fence_data(int place);
size_t fence_size(int place);

/* fence_holds: whether the bytes around the block are as they were. fence_unchanged: whether the block itself, from a
 * byte on, is as it was when it was remembered. */
int fence_holds(int place);
int fence_unchanged(int place, size_t from);

/* Calls a function; 0 if it touches a fence. */
int fence_watch(void (*call)(void *context), void *context);

#ifdef __cplusplus
}
#endif
