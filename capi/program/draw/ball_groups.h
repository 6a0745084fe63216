/* Which balls of a picture belong together, so that contours set them apart from others. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/drawing.h"
#include "read/failure.h"
#include "read/molecule.h"

/* The group of every ball, to be freed on true: chains, and each ligand, ion or water for itself; residues where
 * colours stand for those. */
bool ball_groups_make(const struct drawing *drawing, const struct molecule *molecule, uint32_t **group,
                      struct failure *failure);
