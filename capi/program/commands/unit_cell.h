/* The box of the file and what is in it: atoms that fit its frame, and their copies by symmetry. */
#pragma once

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "write/record.h"

/* If the box of the file is asked for, see that it lies as the atoms do, and fill it: behind the atoms come copies
 * by the operators of the file, one operator after the other, each copy moved as a whole by vectors of the box, so that
 * the mean of its centres lies in it. An image is left out if the digits of the file do not tell it from an atom of its
 * element that is there, whatever its occupancy is: that of an atom on a rotation axis, a mirror or a centre, or one
 * that the file has already. No copies are made without operators, or if the user does not want them. */
bool unit_cell_fill(const struct request *request, struct molecule *molecule, struct failure *failure);

/* The symmetry that there is, and what was made of it. */
enum { UNIT_CELL_TEXT_BYTES = 300 };
const char *unit_cell_text(char value[UNIT_CELL_TEXT_BYTES], const struct symmetry *symmetry);

/* The same as a record; nothing where there is no symmetry. */
void unit_cell_record(struct record *record, const struct symmetry *symmetry);
