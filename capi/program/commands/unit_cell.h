/* The box of the file and its content: atoms that fit its frame, and their copies by symmetry. */
#pragma once

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "write/record.h"

/* If the box of the file is wanted, check that it has the same frame as the atoms, and fill it. Behind the atoms come
 * copies by the operators of the file, one operator after the other. Each copy is moved as a whole by vectors of the
 * box, so that the mean of its centres lies in it. An image is left out if within the digits of the file it coincides
 * with an atom of its element already there, whatever its occupancy: so are images of an atom on a rotation axis, a
 * mirror or a centre, and images that the file has already. No copies are made without operators, or if the user does
 * not want them. */
bool unit_cell_fill(const struct request *request, struct molecule *molecule, struct failure *failure);

/* A text on the symmetry, and on the copies made by it. */
enum { UNIT_CELL_TEXT_BYTES = 300 };
const char *unit_cell_text(char value[UNIT_CELL_TEXT_BYTES], const struct symmetry *symmetry);

/* The same as a record; nothing if there is no symmetry. */
void unit_cell_record(struct record *record, const struct symmetry *symmetry);
