/* Names that occur again and again in a file, numbered in the order of their first occurrences. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "read/fields.h"

struct table_name {
  char text[24]; /* a longer name is cut off */
};

/* Zeros at first. */
struct name_table {
  struct table_name *names; /* [count], in the order of their numbers, from 1 on */
  size_t count, room;
  uint32_t *slots; /* a hash table with open addressing: numbers of names, 0: empty */
  size_t capacity; /* a power of two, or 0 */
  uint32_t last;   /* the number found last */
};

/* The number of a name, from 1 on; it is added if it is new. 0: memory is short. */
uint32_t name_table_number(struct name_table *table, struct field name);

void name_table_free(struct name_table *table);
