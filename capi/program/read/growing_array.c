#include "read/growing_array.h"

#include <stdint.h>
#include <stdlib.h>

bool array_grow(void *array, size_t *room, size_t size) {
  void *items;
  if (*room > SIZE_MAX / 2 / size) return false;
  const size_t more = *room == 0 ? 64 : 2 * *room;
  memcpy(&items, array, sizeof items); /* whatever it points to */
  void *const grown = realloc(items, more * size);
  if (grown == NULL) return false;
  memcpy(array, &grown, sizeof grown);
  *room = more;
  return true;
}
