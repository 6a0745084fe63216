/* Which colour each ball of a picture gets, before light and occlusion. */
#ifndef HARDSPHERE_TOOL_BALL_COLOURS_H
#define HARDSPHERE_TOOL_BALL_COLOURS_H

#include <stdbool.h>
#include <stdint.h>

#include "drawing.h"
#include "failure.h"
#include "molecule.h"

/* The colour of every ball, 0xRRGGBB, to be freed on true, and the palette that they are from: the user's; else a tint
 * for each chain of large molecules with several, and muted colours by element of all others. Under tints, ligands and
 * ions have colours by element, stronger ones, so that they are found at a glance. False: memory is short. */
bool ball_colours_make(const struct drawing *drawing, const struct molecule *molecule, uint32_t **colour,
                       uint32_t *palette, struct failure *failure);

#endif
