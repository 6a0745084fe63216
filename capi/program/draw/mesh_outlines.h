/* Areas of the page by the edges of what they are made of: edges between neighbours of one paint cancel out, and
 * what is left are outlines. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/text_buffer.h"

struct painted_edge {
  uint32_t layer;
  uint32_t paint; /* anything of the caller's: areas of a layer are painted in their order */
  int32_t from[2], to[2];
  bool inner; /* no outline, but where one tone goes over into the next */
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

/* Sort by layers and paints, and let edges cancel those that run back. */
void painted_edges_cancel(struct painted_edges *edges);

/* Leave out lines of paints from `first` on that hang together, or end within `apart` of one another, and have less ink
 * than that in all: of an edge its length times its paint over the first. False for want of memory. */
bool painted_edges_drop_specks(struct painted_edges *edges, uint32_t first, double ink, double apart);

/* Find joints: where more than two edges meet, of those left of paints first .. end - 1. No curve goes by a joint.
 * False for want of memory. */
bool painted_edges_find_joints(struct painted_edges *edges, uint32_t first, uint32_t end);

/* The end of the edges that have layer and paint of the first one. */
size_t painted_edges_end(const struct painted_edges *edges, size_t first);

/* The edges first .. end - 1 as data of an SVG path, in halves of units, with the fewest points that keep within a unit
 * of outlines, less of lines and five and a half of others, curved if so asked where they turn gently. Each loop is
 * closed; or they are lines, which may end. False for want of memory. */
bool painted_edges_write(const struct painted_edges *edges, size_t first, size_t end, bool closed, bool curved,
                         struct text_buffer *out);

void painted_edges_free(struct painted_edges *edges);
