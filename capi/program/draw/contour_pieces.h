/* The visible parts of contours, edge by edge, with widths that change gradually. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* In place of a vertex, at the end of a piece where something nearer hides the edge, or where the edge crosses the
 * plane of a cut. */
#define NO_CONTOUR_VERTEX UINT32_MAX

/* A visible part of an edge of triangles, in the direction of the contour. */
struct contour_piece {
  double at[2][2];    /* on the page */
  uint32_t vertex[2]; /* at its ends, or NO_CONTOUR_VERTEX */
  double level;       /* from which its width follows; 0: no line */
  bool outline;       /* nothing is behind it */
  double most[2];     /* the largest level at each end */
  uint32_t paint;     /* for the caller */
  bool goes_on;       /* no piece: an outline goes on hidden from its first vertex */
};

struct contour_pieces {
  struct contour_piece *piece; /* [count] */
  size_t count, room;
  bool out_of_memory; /* stays set */
};

#define CONTOUR_PIECES_NONE \
  { NULL, 0, 0, false }

void contour_pieces_add(struct contour_pieces *pieces, const struct contour_piece *piece);

/* Limits of levels along contours.
 *   dip    a part of at most this length with lower levels than before and after it is raised to those
 *   thin   the level of a piece that closes a gap of at most `gap`
 *   slope  the largest change of a level per unit of length, beginning with 0 where a contour ends alone; for outlines
 *          four times that
 *   ink    a contour that ends alone gets level 0 if the sum of its levels times lengths is smaller than this, up to
 *          where it is hidden, meets others or becomes an outline */
struct contour_limits {
  double dip, thin, gap, slope, ink;
};

/* Set the levels of all pieces, and `most`. vertices: larger than every vertex number. False: memory is short. */
bool contour_pieces_level(struct contour_pieces *pieces, uint32_t vertices, const struct contour_limits *limits);

double contour_piece_length(const struct contour_piece *piece);

/* The level at a share of the way along a piece. */
double contour_piece_level(const struct contour_piece *piece, double slope, double share);

void contour_pieces_free(struct contour_pieces *pieces);
