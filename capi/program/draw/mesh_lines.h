/* The lines of a picture of triangles: contours, and borders of patches and pockets. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/mesh_page.h"
#include "draw/seen_triangle.h"

/* Their paints, by how wide they are: so many parts of BORDER_LEVELS or CONTOUR_LEVELS of the widest; of rims by the
 * pocket. */
enum { BORDER_LEVELS = 4, CONTOUR_LEVELS = 8, FIRST_BORDER = 0, FIRST_RIM = 8, FIRST_CONTOUR = 16, FIRST_OUTLINE = 32 };

/* The widths of lines of areas, and of creases: more, as no edge may lie on the edge of another line. */
#define AREA_LINE 6.0
#define CREASE_LINE 9.0

/* Add those that are seen to picture->lines: where a side that is seen meets one that turns away there is a contour,
 * and elsewhere a border where patches meet, or the rim of a pocket. They lie over all areas, and end where a nearer
 * triangle hides them. The less lies between a contour and what is behind it, the thinner it is, and it ends in a
 * point; of two close by each other that before the larger gap stands for both. A border is as thin as a line on the
 * surface looks from the side; rims cover where areas of two colours overlap, and are as dark as contours where two
 * pockets meet. seen [count]: all triangles that are shown, hidden or not. picture->creases become the lines where
 * spheres meet at an angle. Before a dark page outlines have paints of their own. False for want of memory. */
bool mesh_lines_find(struct mesh_picture *picture, const struct seen_triangle *seen, uint32_t count);

double mesh_line_width(const struct mesh_picture *picture, uint32_t paint);
