/* Outlines of areas of the page, from the edges of their triangles: edges between neighbours with the same paint cancel
 * out, and the others are the outlines. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/text_buffer.h"

struct painted_edge {
  uint32_t layer;
  uint32_t paint; /* for the caller; within a layer areas are painted in the order of their paints */
  int32_t from[2], to[2];
  bool inner; /* no outline, but the border between two neighbouring tones */
};

struct painted_edges {
  struct painted_edge *edge; /* [count] */
  size_t count, room;
  int32_t (*joint)[2]; /* [joints], sorted */
  size_t joints;
  bool out_of_memory; /* stays set */
};

#define PAINTED_EDGES_NONE \
  { NULL, 0, 0, NULL, 0, false }

/* Edges of no length are left out. */
void painted_edges_add(struct painted_edges *edges, const struct painted_edge *edge);

/* Sort edges by layers and paints, and remove pairs of opposite edges. */
void painted_edges_cancel(struct painted_edges *edges);

/* Leave out specks among lines with paints from `first` on: lines that are connected, or whose ends are within `apart`
 * of one another, and that have less than `ink` in all. The ink of an edge is its length times the number of its paint
 * counted from `first`. False: memory is short. */
bool painted_edges_drop_specks(struct painted_edges *edges, uint32_t first, double ink, double apart);

/* Find joints: the points where more than two edges with paints first .. end - 1 meet. No curve passes a joint. False:
 * memory is short. */
bool painted_edges_find_joints(struct painted_edges *edges, uint32_t first, uint32_t end);

/* The end of the edges that have the same layer and paint as edge `first`. */
size_t painted_edges_end(const struct painted_edges *edges, size_t first);

/* Write the edges first .. end - 1 as data of an SVG path, in halves of units. It has the fewest points that stay
 * within a unit of outlines, within less of lines, and within five and a half units of inner edges. With `curved` it is
 * a curve where it turns gently. closed: the edges form loops; else they are lines, which may end. False: memory is
 * short. */
bool painted_edges_write(const struct painted_edges *edges, size_t first, size_t end, bool closed, bool curved,
                         struct text_buffer *out);

void painted_edges_free(struct painted_edges *edges);
