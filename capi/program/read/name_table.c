#include "read/name_table.h"

#include <stdlib.h>
#include <string.h>

#include "read/growing_array.h"
#include "read/molecule.h"

/* The order of names is that of their lengths first: numbers that grow are added at the end. */
static int compare(const char *a, const char *b) {
  const size_t one = strlen(a), other = strlen(b);
  return one != other ? (one > other) - (one < other) : strcmp(a, b);
}

uint32_t name_table_number(struct name_table *table, struct field name) {
  char wanted[TABLE_NAME_BYTES];
  const struct numbered_name *const last = table->count > 0 ? &table->names[table->last] : NULL;
  if (last != NULL && name.length < sizeof wanted && memcmp(last->name, name.text, name.length) == 0 &&
      last->name[name.length] == '\0') {
    return last->number;
  }
  label_copy(wanted, sizeof wanted, name);
  size_t low = 0, high = table->count;
  if (high > 0 && compare(table->names[high - 1].name, wanted) < 0) low = high;
  while (low < high) {
    const size_t middle = low + (high - low) / 2;
    if (compare(table->names[middle].name, wanted) < 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  table->last = low;
  if (low < table->count && strcmp(table->names[low].name, wanted) == 0) return table->names[low].number;
  struct numbered_name *const grown = array_with_room(table->names, sizeof *grown, table->count, &table->room);
  if (grown == NULL || table->count >= UINT32_MAX) {
    table->last = 0;
    return 0;
  }
  table->names = grown;
  memmove(grown + low + 1, grown + low, (table->count - low) * sizeof *grown);
  memcpy(grown[low].name, wanted, sizeof wanted);
  grown[low].number = (uint32_t)++table->count;
  return grown[low].number;
}

void name_table_free(struct name_table *table) {
  free(table->names);
  memset(table, 0, sizeof *table);
}
