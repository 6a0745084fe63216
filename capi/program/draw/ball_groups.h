/* Groups of balls in a picture that contours separate from each other. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/drawing.h"
#include "read/failure.h"
#include "read/molecule.h"

/* Find the group of every ball: its chain, or its own ligand, ion or water; its residue if colours stand for residues.
 * Free *group on true. */
bool ball_groups_make(const struct drawing *drawing, const struct molecule *molecule, uint32_t **group,
                      struct failure *failure);
