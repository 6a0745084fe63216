/* How deep each ball lies among the others, to draw it darker: an even light from all sides reaches less of it. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* Darken colour [atoms], 0xRRGGBB, by how deep the balls of geometry's model lie; strength in [0, 1], 0: not at all.
 *   exposure   the free part of the ball's area as large probes see it, in the mean of the probes, smoothed over its
 *              neighbourhood twice, then twice over the balls that it is bonded to, as no line parts these; relative to
 *              that of the most exposed balls; in small sets not below a limit
 * All lengths are relative to the larger balls, so that any unit of length does. Probes are 2.8 and 7 angstrom where
 * carbon has 1.7, which takes 0.3 ms a ball. 7 loses its weight between 500 and 1000 balls: 2.8 alone takes 0.04 ms;
 * from 5000 to 15000 balls 1.4 takes its place, with 0.015 ms. The limit fades out between 30 and 90 balls. With
 * `limited`, sets that are far more crowded than molecules, which would take much longer, are left as they are. The
 * result does not depend on the order of the balls. *strength becomes 0 if the colours are left as they are. */
bool occlusion_darken(const struct molecule *molecule, const struct geometry *geometry, double probe, double *strength,
                      bool limited, uint32_t *colour, struct failure *failure);
