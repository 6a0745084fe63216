/* Areas of a surface, each the vertices with one number, with borders that are smooth. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "draw/mesh_split.h"
#include "write/mesh_file.h"

enum { NO_AREA = 0xFF };

/* Smooth the borders between `areas` numbers of vertices, from 0 on, of a closed mesh: a vertex gets the number that
 * has most of the surface around it, the nearer the more, as far as reach, in a mean of means; and borders go where two
 * have as much. So dents and islands of half of that are gone, a border in a plane of symmetry stays, and vertices with
 * NO_AREA get the number of those around, if these have one. of_vertex changes; *edges become those that borders cross,
 * sorted, to be freed on true and on false. False for want of memory. */
bool smooth_borders_find(const struct triangle_mesh *mesh, uint32_t areas, double reach, uint8_t *of_vertex,
                         struct split_edge **edges, size_t *count);
