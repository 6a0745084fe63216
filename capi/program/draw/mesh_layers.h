/* In which order triangles that are seen are painted. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/seen_triangle.h"

/* Sort them, the farthest first, and set their layers: none of a layer lies over another one of it, and what lies over
 * another one, in the middle of where both are, is of a later layer. So all that has one paint in one layer is one
 * area. Of triangles that lie over each other in a ring the farthest comes first. Overlaps of less than `slack` units
 * are none. False for want of memory. */
bool mesh_layers_find(struct seen_triangle *triangle, uint32_t count, double slack);

/* Tell which are seen, of triangles with layers: at how many of the points that are so many units apart they do not lie
 * under whole ones of later layers. Of those without any less is seen than lies between such points. False for want of
 * memory. */
bool mesh_layers_find_seen(struct seen_triangle *triangle, uint32_t count, int32_t apart);
