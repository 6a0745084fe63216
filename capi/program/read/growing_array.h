/* Arrays that grow as items are added: an address, how many items it has room for, and how many there are. */
#pragma once

#include <stddef.h>

/* The array with twice the room, at first 64 items of `size` bytes. NULL: memory is short, and it stays as it was. */
void *array_grown(void *array, size_t size, size_t *room);

/* The array with room for one more than `count` items, at most one of which it has no room for; NULL as above. */
static inline void *array_with_room(void *array, size_t size, size_t count, size_t *room) {
  return count < *room ? array : array_grown(array, size, room);
}
