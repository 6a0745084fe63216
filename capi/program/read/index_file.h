/* Groups of atoms by name, as GROMACS's index files (.ndx) have them. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/fields.h"

#define INDEX_NAME_BYTES 64

struct index_group {
  char name[INDEX_NAME_BYTES]; /* what does not fit is cut off */
  uint32_t *place;             /* [count], of its atoms among those read, from 0 on, ascending; some may come twice */
  size_t count;
  size_t capacity;
};

struct index_file {
  struct index_group *group; /* [count] in the order of the file */
  size_t count;
  size_t capacity;
};

#define INDEX_FILE_NONE \
  { NULL, 0, 0 }

/* Read a file: "[ name ]" on a line of its own, and behind it the numbers of atoms, counted from 1 in the order of the
 * molecule's file. Comments begin with ';'. Free it on true and on false. */
bool index_file_read(struct index_file *file, const char *path, struct failure *failure);

/* The group of that name, the first one if there are several, or else the group of that number, counted from 0; NULL:
 * there is none. */
const struct index_group *index_file_find(const struct index_file *file, struct field name);

bool index_group_has(const struct index_group *group, uint32_t place);

/* Whether a file of so many atoms has all that the groups name. */
bool index_file_suits(const struct index_file *file, const char *path, uint32_t atoms, struct failure *failure);

void index_file_free(struct index_file *file);
