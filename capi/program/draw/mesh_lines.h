/* The lines of a picture of triangles: contours, and borders of patches and pockets. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/mesh_page.h"
#include "draw/seen_triangle.h"

/* The paints of lines. Those of borders and contours are numbered by width, in BORDER_LEVELS or CONTOUR_LEVELS steps up
 * to the widest; those of rims by the pocket. */
enum { BORDER_LEVELS = 4, CONTOUR_LEVELS = 8, FIRST_BORDER = 0, FIRST_RIM = 8, FIRST_CONTOUR = 16, FIRST_OUTLINE = 32 };

/* The widths of lines of areas, and of creases. Those of creases are wider: no edge of a line may lie on that of
 * another line. */
#define AREA_LINE 6.0
#define CREASE_LINE 9.0

/* Add the visible lines to picture->lines. There is a contour where a visible side meets one that turns away; elsewhere
 * there is a border where patches meet, or the rim of a pocket. Lines lie over all areas, and end where a nearer
 * triangle hides them.
 *   contours  the smaller the gap between a contour and the things behind it, the thinner the line; its ends are
 *             points; of two contours near to each other only the one before the larger gap is drawn
 *   borders   as thin as a line on the surface would look from the side
 *   rims      cover the overlaps of areas with two colours; as dark as contours where two pockets meet
 *   creases   the lines where spheres meet at an angle go to picture->creases
 * seen [count]: all triangles that are shown, hidden or not. On a dark page outlines have their own paints. False:
 * memory is short. */
bool mesh_lines_find(struct mesh_picture *picture, const struct seen_triangle *seen, uint32_t count);

double mesh_line_width(const struct mesh_picture *picture, uint32_t paint);
