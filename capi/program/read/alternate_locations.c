#include "read/alternate_locations.h"

#include <stdlib.h>
#include <string.h>

enum { KEY_WORDS = 5, SEGMENT_BYTES = 4 };

struct seen_location {
  uint64_t key[KEY_WORDS]; /* atom name (empty for the residue as a whole), chain, number, insertion code, segment */
  char residue[8];         /* name of the residue in the first record with this key */
  char letter;             /* of that record */
};

struct location_slot {
  uint32_t hash;
  uint32_t place; /* in `seen`, plus 1; 0: empty */
};

static char *put(char *out, const char *text, size_t room) {
  for (size_t i = 0; i < room && text[i] != '\0'; ++i) out[i] = text[i];
  return out + room;
}

static struct seen_location location_of(const struct atom_label *label, struct field segment, char letter,
                                        bool of_atom) {
  struct seen_location location;
  char key[sizeof location.key] = "";
  const struct residue_label *residue = &label->residue;
  char *end = put(key, of_atom ? label->name : "", sizeof label->name);
  end = put(end, residue->chain, sizeof residue->chain);
  end = put(end, residue->number, sizeof residue->number);
  end = put(end, residue->insertion, sizeof residue->insertion);
  memcpy(end, segment.text, segment.length < SEGMENT_BYTES ? segment.length : SEGMENT_BYTES);
  memcpy(location.key, key, sizeof key);
  memset(location.residue, 0, sizeof location.residue);
  put(location.residue, residue->name, sizeof location.residue);
  location.letter = letter;
  return location;
}

static uint32_t hash_of(const struct seen_location *location) {
  uint64_t hash = 0;
  for (size_t i = 0; i < KEY_WORDS; ++i) {
    hash = (hash ^ location->key[i]) * UINT64_C(0x9E3779B97F4A7C15);
    hash ^= hash >> 32;
  }
  return (uint32_t)hash;
}

static bool same_key(const struct seen_location *a, const struct seen_location *b) {
  return memcmp(a->key, b->key, sizeof a->key) == 0;
}

/* Room for one more, in the list and in the table, half of which stays empty. */
static bool reserve(struct alternate_locations *locations) {
  if (locations->count == locations->room) {
    const size_t room = locations->room == 0 ? 512 : 2 * (size_t)locations->room;
    if (room > UINT32_MAX || room > SIZE_MAX / sizeof *locations->seen) return false;
    struct seen_location *seen = realloc(locations->seen, room * sizeof *seen);
    if (seen == NULL) return false;
    locations->seen = seen;
    locations->room = (uint32_t)room;
  }
  if (2 * ((size_t)locations->count + 1) <= locations->capacity) return true;
  const size_t capacity = locations->capacity == 0 ? 1024 : 2 * locations->capacity;
  struct location_slot *slots = calloc(capacity, sizeof *slots);
  if (slots == NULL) return false;
  for (size_t i = 0; i < locations->capacity; ++i) {
    if (locations->slots[i].place == 0) continue;
    size_t to = locations->slots[i].hash & (capacity - 1);
    while (slots[to].place != 0) to = (to + 1) & (capacity - 1);
    slots[to] = locations->slots[i];
  }
  free(locations->slots);
  locations->slots = slots;
  locations->capacity = capacity;
  return true;
}

/* The first record with this key: the given one, if there was none. NULL: memory is short. */
static const struct seen_location *first_of(struct alternate_locations *locations,
                                            const struct seen_location *location) {
  if (!reserve(locations)) return NULL;
  const uint32_t hash = hash_of(location);
  size_t at = hash & (locations->capacity - 1);
  for (; locations->slots[at].place != 0; at = (at + 1) & (locations->capacity - 1)) {
    const struct location_slot slot = locations->slots[at];
    if (slot.hash == hash && same_key(&locations->seen[slot.place - 1], location)) {
      return &locations->seen[slot.place - 1];
    }
  }
  locations->seen[locations->count++] = *location;
  locations->slots[at] = (struct location_slot){hash, locations->count};
  return &locations->seen[locations->count - 1];
}

bool alternate_locations_keep(struct alternate_locations *locations, const struct atom_label *label,
                              struct field segment, char letter, bool *keep) {
  *keep = true;
  const struct seen_location atom = location_of(label, segment, letter, true);
  const struct seen_location *first_atom = first_of(locations, &atom);
  if (first_atom == NULL) return false;
  if (letter == ' ') return true;
  *keep = first_atom->letter == letter;
  const struct seen_location residue = location_of(label, segment, letter, false);
  const struct seen_location *first_residue = first_of(locations, &residue);
  if (first_residue == NULL) return false;
  if (memcmp(first_residue->residue, residue.residue, sizeof residue.residue) != 0) {
    *keep = *keep && first_residue->letter == letter;
  }
  return true;
}

void alternate_locations_free(struct alternate_locations *locations) {
  free(locations->seen);
  free(locations->slots);
  *locations = (struct alternate_locations)ALTERNATE_LOCATIONS_NONE;
}
