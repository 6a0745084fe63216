/* Arrays that grow as items are added. The caller has the address, the room in items, and the number of items. */
#pragma once

#include <stddef.h>

/* The array with twice the room, at first 64 items of `size` bytes. NULL: memory is short, and the array is
 * unchanged. */
void *array_grown(void *array, size_t size, size_t *room);

/* The array with room for one more than `count` items; it has room for `count` already. NULL as above. */
static inline void *array_with_room(void *array, size_t size, size_t count, size_t *room) {
  return count < *room ? array : array_grown(array, size, room);
}
