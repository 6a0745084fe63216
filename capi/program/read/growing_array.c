#include "read/growing_array.h"

#include <stdint.h>
#include <stdlib.h>

void *array_grown(void *array, size_t size, size_t *room) {
  if (*room > SIZE_MAX / 2 / size) return NULL;
  const size_t more = *room == 0 ? 64 : 2 * *room;
  void *const grown = realloc(array, more * size);
  if (grown != NULL) *room = more;
  return grown;
}
