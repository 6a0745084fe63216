#include "read/alternate_locations.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "read/growing_array.h"
#include "read/words.h"

struct seen_location {
  char name[8]; /* of the atom; empty for the residue as a whole */
  struct residue_place place;
  char residue[RESIDUE_NAME_BYTES]; /* name of the residue in the first record with this name and place */
  char letter[8];                   /* the letter of that first record, or word */
};

enum { KEY_BYTES = offsetof(struct seen_location, residue) };

struct location_slot {
  uint32_t hash;
  uint32_t place; /* in `seen`, plus 1; 0: empty */
};

/* Atoms without letters that are neighbours in the file and belong to one residue. */
struct residue_visit {
  struct residue_place place;
  char residue[RESIDUE_NAME_BYTES]; /* its name */
  uint32_t first;                   /* the first of the atoms that wait, in the molecule */
  uint32_t count;                   /* how many wait; 0: none waits any more */
  uint32_t next;                    /* the next visit of the same residue, counted from 1; 0: none */
  uint32_t last;                    /* in the first visit of a residue: its last visit, counted from 1 */
  uint32_t waiting; /* in the first visit of a residue: the first visit with names that wait, or the last one */
};

/* Labels have zeros behind their texts. */
struct residue_place residue_place_of(const struct residue_label *residue, struct field segment) {
  struct residue_place place;
  memcpy(place.chain, residue->chain, sizeof place.chain);
  memcpy(place.number, residue->number, sizeof place.number);
  memcpy(place.insertion, residue->insertion, sizeof place.insertion);
  memset(place.segment, 0, sizeof place.segment);
  memcpy(place.segment, segment.text, segment.length < 4 ? segment.length : 4);
  return place;
}

static struct seen_location location_of(const char *name, const struct residue_place *place, const char *residue,
                                        struct field letter) {
  struct seen_location location = {.place = *place};
  label_copy(location.letter, sizeof location.letter, letter);
  memcpy(location.name, name, sizeof location.name);
  memcpy(location.residue, residue, sizeof location.residue);
  return location;
}

static bool same_key(const struct seen_location *a, const struct seen_location *b) {
  return memcmp(a, b, KEY_BYTES) == 0;
}

static bool same_letter(const struct seen_location *a, const struct seen_location *b) {
  return memcmp(a->letter, b->letter, sizeof a->letter) == 0;
}

/* Make room for one more, in the list and in the table, half of which stays empty. */
static bool reserve(struct alternate_locations *locations) {
  if (locations->count == UINT32_MAX ||
      !array_make_room(&locations->seen, locations->count, &locations->room, sizeof *locations->seen)) {
    return false;
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
  const uint32_t hash = word_hash(location, KEY_BYTES);
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

static bool goes_on(const struct residue_visit *visit, const struct residue_place *place, const char *residue) {
  return memcmp(&visit->place, place, sizeof *place) == 0 &&
         memcmp(visit->residue, residue, sizeof visit->residue) == 0;
}

/* Note an atom without a letter. False: memory is short. */
static bool note_waiting(struct alternate_locations *locations, uint32_t atom, const struct residue_place *place,
                         const char *residue) {
  struct residue_visit *visit = locations->visits > 0 ? &locations->visit[locations->visits - 1] : NULL;
  /* One that is in the table may have been shown. */
  if (visit == NULL || locations->numbered == locations->visits || !goes_on(visit, place, residue)) {
    if (locations->visits == UINT32_MAX ||
        !array_make_room(&locations->visit, locations->visits, &locations->visit_room, sizeof *visit)) {
      return false;
    }
    visit = &locations->visit[locations->visits++];
    *visit = (struct residue_visit){.place = *place, .first = atom};
    memcpy(visit->residue, residue, sizeof visit->residue);
  }
  ++visit->count;
  return true;
}

/* The slot of the table of residues that has the place, or would have it. */
static uint32_t *residue_at(const struct alternate_locations *locations, const struct residue_place *place) {
  size_t at = word_hash(place, sizeof *place) & (locations->residues - 1);
  while (locations->residue[at] != 0 &&
         memcmp(&locations->visit[locations->residue[at] - 1].place, place, sizeof *place) != 0) {
    at = (at + 1) & (locations->residues - 1);
  }
  return &locations->residue[at];
}

/* Put the visits that are new into the table of residues. */
static bool number_visits(struct alternate_locations *locations) {
  if (2 * (size_t)locations->visits >= locations->residues) {
    size_t capacity = locations->residues == 0 ? 256 : locations->residues;
    while (capacity <= 2 * (size_t)locations->visits) capacity *= 2;
    uint32_t *const grown = calloc(capacity, sizeof *grown), *const old = locations->residue;
    const size_t before = locations->residues;
    if (grown == NULL) return false;
    locations->residue = grown;
    locations->residues = capacity;
    for (size_t k = 0; k < before; ++k) {
      if (old[k] != 0) *residue_at(locations, &locations->visit[old[k] - 1].place) = old[k];
    }
    free(old);
  }
  for (; locations->numbered < locations->visits; ++locations->numbered) {
    const uint32_t own = locations->numbered + 1;
    uint32_t *const first = residue_at(locations, &locations->visit[own - 1].place);
    if (*first == 0) {
      *first = own;
      locations->visit[own - 1].last = locations->visit[own - 1].waiting = own;
    } else {
      struct residue_visit *const head = &locations->visit[*first - 1];
      locations->visit[head->last - 1].next = own;
      head->last = own;
    }
  }
  return true;
}

/* Show the atoms that wait of a residue; label: of all atoms. */
static bool show_waiting(struct alternate_locations *locations, const struct atom_label *label,
                         const struct residue_place *place) {
  if (locations->visits == 0) return true;
  if (!number_visits(locations)) return false;
  const uint32_t first = *residue_at(locations, place);
  if (first == 0) return true;
  uint32_t *const waiting = &locations->visit[first - 1].waiting;
  const struct field letterless = {"", 0};
  for (;;) {
    struct residue_visit *const visit = &locations->visit[*waiting - 1];
    for (uint32_t k = 0; k < visit->count; ++k) {
      const struct seen_location atom = location_of(label[visit->first + k].name, place, visit->residue, letterless);
      if (first_of(locations, &atom) == NULL) return false;
    }
    visit->count = 0;
    if (visit->next == 0) return true;
    *waiting = visit->next;
  }
}

bool alternate_locations_keep(struct alternate_locations *locations, const struct molecule *molecule,
                              const struct atom_label *label, struct field segment, struct field letter, bool *keep) {
  static const char nobody[sizeof label->name] = "";
  const struct residue_place place = residue_place_of(label->residue, segment);
  *keep = true;
  if (letter.length == 0) return note_waiting(locations, molecule->atoms, &place, label->residue->name);
  if (!show_waiting(locations, molecule->label, &place)) return false;
  const struct seen_location atom = location_of(label->name, &place, label->residue->name, letter);
  const struct seen_location *first_atom = first_of(locations, &atom);
  if (first_atom == NULL) return false;
  *keep = same_letter(first_atom, &atom);
  const struct seen_location residue = location_of(nobody, &place, label->residue->name, letter);
  const struct seen_location *first_residue = first_of(locations, &residue);
  if (first_residue == NULL) return false;
  if (memcmp(first_residue->residue, residue.residue, sizeof residue.residue) != 0) {
    *keep = *keep && same_letter(first_residue, &residue);
  }
  return true;
}

void alternate_locations_go_on(struct alternate_locations *locations) {
  ++locations->visit[locations->visits - 1].count;
}

void alternate_locations_free(struct alternate_locations *locations) {
  free(locations->seen);
  free(locations->slots);
  free(locations->visit);
  free(locations->residue);
  *locations = (struct alternate_locations)ALTERNATE_LOCATIONS_NONE;
}
