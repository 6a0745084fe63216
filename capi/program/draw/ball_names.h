/* The names of balls in the file of a picture: classes for style sheets, and texts that appear beside the pointer. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/molecule.h"

/* For each ball "el-C res-CYS chain-A" and "CYS A 16 SG", as far as the file has these names; or NULL. */
struct ball_names {
  char *text; /* all of them */
  const char **class_of;
  const char **title_of;
};

#define BALL_NAMES_NONE \
  { NULL, NULL, NULL }

/* Make the classes, if `classes`, and the titles, if `titles`. Free the names on true and on false. False: memory is
 * short. */
bool ball_names_make(const struct molecule *molecule, bool classes, bool titles, struct ball_names *names,
                     struct failure *failure);

void ball_names_free(struct ball_names *names);
