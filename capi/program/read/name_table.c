#include "read/name_table.h"

#include <stdlib.h>
#include <string.h>

#include "read/growing_array.h"
#include "read/molecule.h"
#include "read/words.h"

/* The slot that has the name, or would have it. */
static uint32_t *slot_of(const struct name_table *table, const struct table_name *name) {
  size_t at = word_hash(name, sizeof *name) & (table->capacity - 1);
  while (table->slots[at] != 0 && memcmp(&table->names[table->slots[at] - 1], name, sizeof *name) != 0) {
    at = (at + 1) & (table->capacity - 1);
  }
  return &table->slots[at];
}

/* Room for one more name; half of the slots stay empty. */
static bool reserve(struct name_table *table) {
  if (table->count >= UINT32_MAX || !array_make_room(&table->names, table->count, &table->room, sizeof *table->names)) {
    return false;
  }
  if (2 * (table->count + 1) <= table->capacity) return true;
  const size_t capacity = table->capacity == 0 ? 128 : 2 * table->capacity;
  uint32_t *const slots = calloc(capacity, sizeof *slots);
  if (slots == NULL) return false;
  free(table->slots);
  table->slots = slots;
  table->capacity = capacity;
  for (size_t k = 0; k < table->count; ++k) *slot_of(table, &table->names[k]) = (uint32_t)k + 1;
  return true;
}

uint32_t name_table_number(struct name_table *table, struct field name) {
  struct table_name wanted = {""};
  const char *const last = table->last > 0 ? table->names[table->last - 1].text : NULL;
  if (last != NULL && name.length < sizeof wanted.text && memcmp(last, name.text, name.length) == 0 &&
      last[name.length] == '\0') {
    return table->last;
  }
  label_copy(wanted.text, sizeof wanted.text, name);
  if (!reserve(table)) return 0;
  uint32_t *const slot = slot_of(table, &wanted);
  if (*slot == 0) {
    table->names[table->count] = wanted;
    *slot = (uint32_t)++table->count;
  }
  return table->last = *slot;
}

void name_table_free(struct name_table *table) {
  free(table->names);
  free(table->slots);
  memset(table, 0, sizeof *table);
}
