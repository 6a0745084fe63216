/* The choice among the molecules that a file states: a model, a location, a chain's name, an assembly. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* For all models as one. */
#define EVERY_MODEL UINT64_MAX

enum { LOCATION_FIRST = 0, LOCATION_BY_OCCUPANCY = 1 }; /* else a letter */

struct file_choice {
  uint64_t model;       /* counted from 1, or EVERY_MODEL */
  char location;        /* of atoms with several: LOCATION_FIRST, LOCATION_BY_OCCUPANCY or the letter that they have */
  bool label_chains;    /* chains by label_asym_id rather than auth_asym_id */
  const char *assembly; /* its name; NULL: the atoms as they are in the file */
};

#define FILE_CHOICE_FIRST \
  { 1, LOCATION_FIRST, false, NULL }
