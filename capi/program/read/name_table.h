/* Names that come again in a file, and a number for each in the order in which they come first. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "read/fields.h"

struct table_name {
  char text[24]; /* what is longer is cut off */
};

/* Zeros at first. */
struct name_table {
  struct table_name *names; /* [count], in the order of their numbers, from 1 on */
  size_t count, room;
  uint32_t *slots; /* a hash table with open addressing: numbers, 0 where there is none */
  size_t capacity; /* a power of two, or 0 */
  uint32_t last;   /* that was found */
};

/* The number of a name, from 1 on; it is added if it is new. 0: memory is short. */
uint32_t name_table_number(struct name_table *table, struct field name);

void name_table_free(struct name_table *table);
