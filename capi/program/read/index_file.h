/* Named groups of atoms, from index files of GROMACS (.ndx). */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/fields.h"

#define INDEX_NAME_BYTES 64

struct index_group {
  char name[INDEX_NAME_BYTES]; /* a longer name is cut off */
  uint32_t *place;             /* [count], its atoms, counted from 0 in the file's order; ascending, perhaps repeated */
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

/* Read a file. A group is "[ name ]" on a line of its own, then the numbers of atoms, counted from 1 in the order of
 * the molecule's file, also those that are left out. Comments begin with ';'. Free it on true and on false. */
bool index_file_read(struct index_file *file, const char *path, struct failure *failure);

/* The first group of that name; if there is none, the group of that number, counted from 0; NULL: neither exists. */
const struct index_group *index_file_find(const struct index_file *file, struct field name);

bool index_group_has(const struct index_group *group, uint32_t place);

/* Whether a file of so many atoms has all atoms of the groups. */
bool index_file_suits(const struct index_file *file, const char *path, uint32_t atoms, struct failure *failure);

void index_file_free(struct index_file *file);
