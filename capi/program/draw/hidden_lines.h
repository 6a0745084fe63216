/* Lines along edges of triangles, without what nearer triangles hide of them. */
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
  double plane; /* the depth where those that are not whole end */
  struct mesh_squares squares;
  struct span *span; /* [spans] */
  size_t spans, room;
};

/* Take `count` triangles, which stay the caller's and where they are. To be freed on true and on false, which is for
 * want of memory. */
bool hidden_lines_begin(const struct seen_triangle *triangle, uint32_t count, double plane, struct hidden_lines *lines);

/* The parts of a line before which no triangle lies, in their order, as spans of *lines, which stay until the next
 * call. A triangle that a line only touches does not hide it. False for want of memory. */
bool hidden_lines_find_seen(struct hidden_lines *lines, const struct seen_line *line);
/* The depth of the nearest triangle over a point of the page; that of nothing is infinitely far. */
double hidden_lines_front(const struct hidden_lines *lines, const double at[2]);

void hidden_lines_free(struct hidden_lines *lines);
