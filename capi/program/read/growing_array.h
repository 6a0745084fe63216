/* Arrays that grow as items are added. The caller has the pointer to the items, whose address is passed as `array`,
 * their number, and the room for them, 0 at first. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* Make room for twice as many items of `size` bytes, at first for 64. False: memory is short, and nothing has
 * changed. */
bool array_grow(void *array, size_t *room, size_t size);

/* Make room for one more than `count` items; there is room for `count` already. False as above. */
static inline bool array_make_room(void *array, size_t count, size_t *room, size_t size) {
  return count < *room || array_grow(array, room, size);
}

/* Append a copy of an item. False as above. */
static inline bool array_append(void *array, size_t *count, size_t *room, const void *item, size_t size) {
  char *items;
  if (!array_make_room(array, *count, room, size)) return false;
  memcpy(&items, array, sizeof items);
  memcpy(items + (*count)++ * size, item, size);
  return true;
}
