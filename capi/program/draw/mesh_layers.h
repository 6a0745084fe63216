/* The order in which visible triangles are painted. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "draw/seen_triangle.h"

/* Sort the triangles, the farthest first, and set their layers. No triangle lies over another one of its layer, and one
 * that lies over another one is in a later layer; the middle of their common part decides which is nearer. So all
 * triangles of one layer with the same paint form one area. If triangles lie over each other in a ring, the farthest
 * comes first. Overlaps of less than `slack` units are ignored. False: memory is short. */
bool mesh_layers_find(struct seen_triangle *triangle, uint32_t count, double slack);

/* Find which triangles are seen; they have layers. Points of the page are tested that are `apart` units apart: for each
 * triangle those of its points are counted that no whole triangle of a later layer covers. If a triangle has none, the
 * visible part of it is smaller than the gaps between points. False: memory is short. */
bool mesh_layers_find_seen(struct seen_triangle *triangle, uint32_t count, int32_t apart);
