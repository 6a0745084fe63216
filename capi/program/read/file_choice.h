/* The user's choice among the contents of a file: model, location, kind of chain names, assembly. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Stands for all models together. */
#define EVERY_MODEL UINT64_MAX

enum { LOCATION_FIRST = 0, LOCATION_BY_OCCUPANCY = 1 }; /* else a letter */

struct file_choice {
  uint64_t model;       /* counted from 1, or EVERY_MODEL */
  char location;        /* for atoms with several locations: LOCATION_FIRST, LOCATION_BY_OCCUPANCY, or a letter */
  bool label_chains;    /* chains by label_asym_id rather than auth_asym_id */
  const char *assembly; /* its name; NULL: the atoms as they are in the file */
};

#define FILE_CHOICE_FIRST \
  { 1, LOCATION_FIRST, false, NULL }
