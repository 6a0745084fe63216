/* Darker colours for balls that lie deep among others: less of an even light from all sides reaches them. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* Darken colour [atoms], 0xRRGGBB, by the exposure of each ball of the geometry's model; *strength is from 0, not at
 * all, to 1. The exposure is the free part of the ball's area for large probes, the mean for several of them. It is
 * smoothed twice over the ball's neighbourhood, then twice over the balls bonded to it, as no line separates these. It
 * is relative to the exposure of the most exposed balls, and in small sets not below a limit.
 *
 * All lengths are relative to the larger balls, and so any unit of length is possible. If carbon has 1.7 angstrom, the
 * probes are 2.8 and 7, which takes 0.3 ms a ball. The weight of 7 fades out between 500 and 1000 balls; 2.8 alone
 * takes 0.04 ms. From 5000 to 15000 balls 1.4 takes its place, with 0.015 ms. The limit fades out between 30 and 90
 * balls.
 *
 * With `limited`, sets that are far more crowded than molecules are left as they are: they would take much longer. The
 * result does not depend on the order of the balls. *strength becomes 0 if the colours are left as they are. */
bool occlusion_darken(const struct molecule *molecule, const struct geometry *geometry, double probe, double *strength,
                      bool limited, uint32_t *colour, struct failure *failure);
