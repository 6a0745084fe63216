/* Memory that ends where memory ends that may not be touched, and begins behind bytes that are compared. */
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Whether there are such pages here; if not, `why` says so. */
int fences_exist(const char **why);

enum { FENCES = 24, FENCE_BYTES = 1 << 20, FENCE_PATTERN = 0xA5 };

/* So many bytes of a pattern in place 0 .. FENCES - 1, instead of what was there before. Between their end and the
 * fence lie `slack` bytes, which are compared too. */
void *fence_take(int place, size_t bytes, size_t slack);

/* Keeps a copy of what is there now, and where it lies. */
void fence_remember(int place);
const unsigned char *fence_copy(int place);
unsigned char *fence_data(int place);
size_t fence_size(int place);

/* Whether what lies around it is as it was, and whether it is itself, from a byte on, as it was when remembered. */
int fence_holds(int place);
int fence_unchanged(int place, size_t from);

/* Calls a function; 0 if it touches what it may not. */
int fence_watch(void (*call)(void *context), void *context);

#ifdef __cplusplus
}
#endif
