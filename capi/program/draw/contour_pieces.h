/* The seen parts of contours, edge by edge, with widths that go over into one another. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The end of a piece where something nearer hides the edge, or it goes through the plane of a cut. */
#define NO_CONTOUR_VERTEX UINT32_MAX

/* Of an edge of triangles, in the direction of the contour. */
struct contour_piece {
  double at[2][2];    /* on the page */
  uint32_t vertex[2]; /* at its ends, or NO_CONTOUR_VERTEX */
  double level;       /* of its width; 0: none */
  bool outline;       /* nothing is behind it */
  double most[2];     /* the level that its ends may have */
  uint32_t paint;     /* anything of the caller's */
  bool goes_on;       /* no piece, but where an outline goes on hidden: its first vertex */
};

struct contour_pieces {
  struct contour_piece *piece; /* [count] */
  size_t count, room;
  bool out_of_memory; /* stays set */
};

#define CONTOUR_PIECES_NONE \
  { NULL, 0, 0, false }

void contour_pieces_add(struct contour_pieces *pieces, const struct contour_piece *piece);

/* Levels along contours.
 *   dip    so long may be a part with lower levels than those before and after it, to which it is raised
 *   thin   the level of what closes a gap of no more than `gap`
 *   slope  by how much a level may change in a unit of length, from 0 on where a contour ends alone; of outlines four
 *          times that
 *   ink    contours that end alone get level 0 if they have a smaller sum of levels times lengths, up to where they are
 *          hidden, meet others or become outlines */
struct contour_limits {
  double dip, thin, gap, slope, ink;
};

/* Set levels, and `most`. vertices: more than the numbers of all of them. False for want of memory. */
bool contour_pieces_level(struct contour_pieces *pieces, uint32_t vertices, const struct contour_limits *limits);

double contour_piece_length(const struct contour_piece *piece);

/* The level at a share of the way. */
double contour_piece_level(const struct contour_piece *piece, double slope, double share);

void contour_pieces_free(struct contour_pieces *pieces);
