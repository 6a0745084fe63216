/* The names of a picture's balls in its file: classes that style sheets can name, and texts beside the pointer. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/molecule.h"

/* For each ball "el-C res-CYS chain-A" and "CYS A 16 SG", as far as the file says; or NULL. */
struct ball_names {
  char *text; /* all of them */
  const char **class_of;
  const char **title_of;
};

#define BALL_NAMES_NONE \
  { NULL, NULL, NULL }

/* Makes those asked for of `classes` and `titles`, to be freed whatever is returned. False: memory is short. */
bool ball_names_make(const struct molecule *molecule, bool classes, bool titles, struct ball_names *names,
                     struct failure *failure);

void ball_names_free(struct ball_names *names);
