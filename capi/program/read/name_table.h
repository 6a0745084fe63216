/* Names that come again in a file, and a number for each in the order in which they come first. */
#ifndef HARDSPHERE_TOOL_NAME_TABLE_H
#define HARDSPHERE_TOOL_NAME_TABLE_H

#include <stddef.h>
#include <stdint.h>

#include "read/fields.h"

enum { TABLE_NAME_BYTES = 24 }; /* what is longer is cut off */

/* Sorted; zeros at first. */
struct name_table {
  struct numbered_name {
    char name[TABLE_NAME_BYTES];
    uint32_t number;
  } * names;
  size_t count, room;
  size_t last; /* that was found */
};

/* The number of a name, from 1 on; it is added if it is new. 0: memory is short. */
uint32_t name_table_number(struct name_table *table, struct field name);

void name_table_free(struct name_table *table);

#endif
