#include "read/location_choice.h"

#include <stdlib.h>
#include <string.h>

#include "read/growing_array.h"
#include "read/number.h"

struct located_atom {
  struct residue_place place;
  char name[8];
  char residue[RESIDUE_NAME_BYTES];
  char location[8];
  double occupancy;
  uint32_t atom;
};

bool location_choice_add(struct location_choice *choice, const struct molecule *molecule,
                         const struct residue_place *place, const char *name, const char *residue,
                         struct field location, struct field occupancy, struct failure *failure) {
  struct located_atom added = {.place = *place, .atom = molecule->atoms - 1};
  memcpy(added.name, name, sizeof added.name);
  memcpy(added.residue, residue, sizeof added.residue);
  label_copy(added.location, sizeof added.location, location);
  if (number_parse(occupancy.text, occupancy.length, &added.occupancy) != NUMBER_OK) added.occupancy = 1.0;
  return array_append(&choice->located, &choice->count, &choice->room, &added, sizeof added) ||
         failure_of_memory(failure);
}

static int order_of_atoms(const struct located_atom *a, const struct located_atom *b) {
  return (a->atom > b->atom) - (a->atom < b->atom);
}

static int order_by_location(const void *left, const void *right) {
  const struct located_atom *a = left, *b = right;
  int order = memcmp(&a->place, &b->place, sizeof a->place);
  if (order == 0) order = memcmp(a->location, b->location, sizeof a->location);
  return order != 0 ? order : order_of_atoms(a, b);
}

static int order_by_name(const void *left, const void *right) {
  const struct located_atom *a = left, *b = right;
  int order = memcmp(&a->place, &b->place, sizeof a->place);
  if (order == 0) order = memcmp(a->name, b->name, sizeof a->name);
  return order != 0 ? order : order_of_atoms(a, b);
}

/* The end of the records of one atom that begin at `begin`, in the order of names. */
static size_t end_of_atom(const struct located_atom *located, size_t begin, size_t end) {
  size_t at = begin;
  while (at < end && memcmp(&located[at].place, &located[begin].place, sizeof located->place) == 0 &&
         memcmp(located[at].name, located[begin].name, sizeof located->name) == 0) {
    ++at;
  }
  return at;
}

/* Forget the atoms that are at no location. Those that remain are in the order of names. */
static void forget_others(struct location_choice *choice) {
  struct located_atom *const located = choice->located;
  size_t kept = 0;
  qsort(located, choice->count, sizeof *located, order_by_name);
  for (size_t begin = 0, end; begin < choice->count; begin = end) {
    bool any = false;
    end = end_of_atom(located, begin, choice->count);
    for (size_t k = begin; k < end; ++k) any = any || located[k].location[0] != '\0';
    if (!any) continue;
    memmove(located + kept, located + begin, (end - begin) * sizeof *located);
    kept += end - begin;
  }
  choice->count = kept;
}

static bool is_letter_of(const struct located_atom *atom, char letter) {
  return atom->location[0] == letter && atom->location[1] == '\0';
}

/* The location that counts in a residue, as its first atom there. Atoms are in the order of locations. */
static struct located_atom chosen_of(const struct located_atom *atoms, size_t count, char wanted) {
  const struct located_atom *best = NULL;
  double best_mean = 0.0;
  for (size_t begin = 0, end; begin < count; begin = end) {
    double sum = 0.0;
    for (end = begin; end < count && memcmp(atoms[end].location, atoms[begin].location, 8) == 0; ++end) {
      sum += atoms[end].occupancy;
    }
    const double mean = wanted == LOCATION_BY_OCCUPANCY ? sum / (double)(end - begin) : 0.0;
    if (wanted != LOCATION_BY_OCCUPANCY && is_letter_of(&atoms[begin], wanted)) return atoms[begin];
    if (best == NULL || mean > best_mean || (mean == best_mean && atoms[begin].atom < best->atom)) {
      best = &atoms[begin];
      best_mean = mean;
    }
  }
  return *best;
}

/* Choose among the records of one atom, which are in the order of the file. */
static void choose_records(const struct located_atom *records, size_t count, const struct located_atom *chosen,
                           bool by_occupancy, uint8_t *keep) {
  size_t own = 0;
  bool there = false;
  for (size_t k = 0; k < count; ++k) {
    if (memcmp(records[k].location, chosen->location, sizeof chosen->location) == 0) there = true;
    if (by_occupancy && records[k].occupancy > records[own].occupancy) own = k;
  }
  const char *const location = there ? chosen->location : records[own].location;
  for (size_t k = 0; k < count; ++k) {
    keep[records[k].atom] = memcmp(records[k].location, location, sizeof chosen->location) == 0 &&
                            memcmp(records[k].residue, chosen->residue, sizeof chosen->residue) == 0;
  }
}

bool location_choice_finish(struct location_choice *choice, struct molecule *molecule, struct failure *failure) {
  struct located_atom *const located = choice->located;
  const char wanted = molecule->choice.location;
  if (choice->count > 0) forget_others(choice);
  if (choice->count == 0) return true;
  uint8_t *const keep = malloc((size_t)molecule->atoms + 1);
  if (keep == NULL) return failure_of_memory(failure);
  memset(keep, 1, molecule->atoms);
  qsort(located, choice->count, sizeof *located, order_by_location);
  for (size_t begin = 0, end; begin < choice->count; begin = end) {
    end = begin;
    while (end < choice->count && memcmp(&located[end].place, &located[begin].place, sizeof located->place) == 0) ++end;
    const struct located_atom chosen = chosen_of(located + begin, end - begin, wanted);
    if (is_letter_of(&chosen, wanted)) molecule->location_found = true;
    qsort(located + begin, end - begin, sizeof *located, order_by_name);
    for (size_t from = begin, to; from < end; from = to) {
      to = end_of_atom(located, from, end);
      choose_records(located + from, to - from, &chosen, wanted == LOCATION_BY_OCCUPANCY, keep);
    }
  }
  const uint32_t before = molecule->atoms;
  molecule_keep_atoms(molecule, keep);
  molecule->left_out.alternate_locations += before - molecule->atoms;
  choice->count = 0;
  free(keep);
  return true;
}

void location_choice_free(struct location_choice *choice) {
  free(choice->located);
  memset(choice, 0, sizeof *choice);
}
