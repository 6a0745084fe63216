/* Charts of pores, and the sizes that they share, in px. */
#pragma once

#include "draw/chart.h"
#include "read/failure.h"
#include "read/molecule.h"

struct pores_found;

enum { LEFT = 88, TOP = 20, WIDTH = 640, RIGHT = 40, LEGEND_ROW = 24, MARGIN_BELOW = 20 };
enum { BELOW = CHART_NAME_BELOW + LEGEND_ROW + 8 }; /* the line of the first row of a legend */

/* The length of swatches: enough for rings, dashes and dots. */
enum { SWATCH = 28, BEHIND_SWATCH = 6 };

/* Write charts as .svg: the radius along each tunnel; and the tree of the listed classes, each a line from the radius
 * of its birth to that of its death. Those of the first pockets have the pockets' colours. */
bool pores_write_profile(const struct pores_found *found, const struct molecule *molecule, const char *path,
                         struct failure *failure);
bool pores_write_tree(const struct pores_found *found, const struct molecule *molecule, const char *path,
                      struct failure *failure);
