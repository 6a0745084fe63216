#include "alternate_locations.h"

#include <stdlib.h>
#include <string.h>

/* Columns of an atom record, counted from 0, end excluded. */
enum {
  NAME_BEGIN = 12,
  NAME_END = 16,
  LETTER = 16,
  RESIDUE_BEGIN = 17,
  RESIDUE_END = 20,
  PLACE_BEGIN = 21, /* chain, residue number, insertion code */
  PLACE_END = 27,
  SEGMENT_BEGIN = 72,
  SEGMENT_END = 76
};

struct seen_location {
  char key[4 + 6 + 4]; /* atom name (blank for the residue as a whole), place, segment */
  char letter;         /* of its first record; '\0' marks an empty slot */
  char residue[3];     /* name of the residue in that record */
};

static void copy_columns(char *out, const char *record, size_t length, size_t begin, size_t end) {
  for (size_t at = begin; at < end; ++at) *out++ = at < length ? record[at] : ' ';
}

static struct seen_location location_of(const char *record, size_t length, bool of_atom) {
  struct seen_location location;
  memset(location.key, ' ', 4);
  if (of_atom) copy_columns(location.key, record, length, NAME_BEGIN, NAME_END);
  copy_columns(location.key + 4, record, length, PLACE_BEGIN, PLACE_END);
  copy_columns(location.key + 10, record, length, SEGMENT_BEGIN, SEGMENT_END);
  copy_columns(location.residue, record, length, RESIDUE_BEGIN, RESIDUE_END);
  copy_columns(&location.letter, record, length, LETTER, LETTER + 1);
  return location;
}

/* The slot that holds the key, or the empty one where it belongs. The table is never full. */
static struct seen_location *find_slot(const struct alternate_locations *seen, const struct seen_location *wanted) {
  uint64_t hash = UINT64_C(14695981039346656037); /* FNV-1a */
  for (size_t i = 0; i < sizeof wanted->key; ++i) {
    hash = (hash ^ (unsigned char)wanted->key[i]) * UINT64_C(1099511628211);
  }
  size_t slot = (size_t)(hash ^ (hash >> 32)) & (seen->capacity - 1);
  while (seen->slots[slot].letter != '\0' && memcmp(seen->slots[slot].key, wanted->key, sizeof wanted->key) != 0) {
    slot = (slot + 1) & (seen->capacity - 1);
  }
  return &seen->slots[slot];
}

static bool grow(struct alternate_locations *seen) {
  struct alternate_locations larger = {NULL, seen->capacity == 0 ? 1024 : 2 * seen->capacity, seen->used};
  larger.slots = calloc(larger.capacity, sizeof *larger.slots);
  if (larger.slots == NULL) return false;
  for (size_t i = 0; i < seen->capacity; ++i) {
    if (seen->slots[i].letter != '\0') *find_slot(&larger, &seen->slots[i]) = seen->slots[i];
  }
  free(seen->slots);
  *seen = larger;
  return true;
}

/* The first record with this key: the given one, if there was none. */
static const struct seen_location *first_of(struct alternate_locations *seen, const struct seen_location *location) {
  struct seen_location *slot = find_slot(seen, location);
  if (slot->letter == '\0') {
    *slot = *location;
    ++seen->used;
  }
  return slot;
}

bool alternate_locations_keep(struct alternate_locations *seen, const char *record, size_t length, bool *keep) {
  *keep = true;
  if (2 * (seen->used + 2) > seen->capacity && !grow(seen)) return false;
  const struct seen_location atom = location_of(record, length, true);
  const struct seen_location *first_atom = first_of(seen, &atom);
  if (atom.letter == ' ') return true;
  *keep = first_atom->letter == atom.letter;
  const struct seen_location residue = location_of(record, length, false);
  const struct seen_location *first_residue = first_of(seen, &residue);
  if (memcmp(first_residue->residue, residue.residue, sizeof residue.residue) != 0) {
    *keep = *keep && first_residue->letter == residue.letter;
  }
  return true;
}

void alternate_locations_free(struct alternate_locations *seen) {
  free(seen->slots);
  seen->slots = NULL;
  seen->capacity = 0;
  seen->used = 0;
}
