/* Lines along edges of triangles, without the parts that nearer triangles hide. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "draw/mesh_squares.h"

/* An edge of triangles, with the depths of its ends. */
struct seen_line {
  int32_t at[2][2];
  double depth[2];
  uint32_t vertex[2]; /* its ends */
  uint32_t beside[2]; /* the numbers of its triangles, which do not hide it */
};

/* A part of a line, from 0 to 1. */
struct span {
  double from, to;
};

struct hidden_lines {
  const struct seen_triangle *triangle;
  double plane; /* the depth of a cut, at which triangles that are not whole end */
  struct mesh_squares squares;
  struct span *span; /* [spans] */
  size_t spans, room;
};

/* Prepare for `count` triangles; they stay the caller's, and must stay where they are. Free *lines on true and on
 * false. False: memory is short. */
bool hidden_lines_begin(const struct seen_triangle *triangle, uint32_t count, double plane, struct hidden_lines *lines);

/* Find the parts of a line that no triangle hides, in their order: they are the spans of *lines until the next call. A
 * triangle that a line only touches does not hide it. False: memory is short. */
bool hidden_lines_find_seen(struct hidden_lines *lines, const struct seen_line *line);
/* The depth of the nearest triangle over a point of the page; infinitely far if there is none. */
double hidden_lines_front(const struct hidden_lines *lines, const double at[2]);

void hidden_lines_free(struct hidden_lines *lines);
