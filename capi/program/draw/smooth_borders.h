/* Smooth borders between areas of a surface; an area is all vertices with the same number. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "draw/mesh_split.h"
#include "write/mesh_file.h"

enum { NO_AREA = 0xFF };

/* Smooth the borders between the areas of a closed mesh, whose vertices have the numbers 0 .. areas - 1. A vertex gets
 * the number with most of the surface around it; the weight of the surface falls with the distance, up to `reach`, in a
 * mean of means. Borders are where two numbers have the same weight. So dents and islands of half of that size vanish,
 * a border in a plane of symmetry stays, and vertices with NO_AREA get the number of those around them, if these have
 * one. of_vertex changes. *edges become the edges that borders cross, sorted; free them on true and on false. False:
 * memory is short. */
bool smooth_borders_find(const struct triangle_mesh *mesh, uint32_t areas, double reach, uint8_t *of_vertex,
                         struct split_edge **edges, size_t *count);
