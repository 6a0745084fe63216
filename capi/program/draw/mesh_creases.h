/* Creases, where the spheres of two patches meet at an angle, and which of these goes on over the other there. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define NO_PATCH UINT32_MAX

/* An edge of a crease, with the patch with the lower number beside it on the side to which (y, -x) points, if (x, y) is
 * the way along it on the page. */
struct crease {
  uint32_t vertex[2], patch[2];
  double at[2][2];
  int painted;       /* 0 or 1: of which patch the area is painted later, over the other */
  size_t edge;       /* anything of the caller's */
  bool known;        /* `over` is chosen, and stays */
  int over;          /* 0 or 1: of which patch the line is */
  double line[2][2]; /* its ends */
};

struct creases {
  struct crease *crease; /* [count] */
  size_t count, room;
  bool out_of_memory; /* stays set */
};

#define CREASES_NONE \
  { NULL, 0, 0, false }

void creases_add(struct creases *creases, const struct crease *crease);

/* Choose for each edge the patch whose line goes on over the other one by half of its width. Where a crease goes over
 * into a contour that is the patch of the contour, which goes on over what is behind it: else there would be a step;
 * of a crease with a contour at either end each part has that of the nearer one. Of others it is that of which more
 * points are seen. Towards its ends the line is moved aside, so that there its edge is that of the later area.
 *   nearer  of each vertex the patch of a contour there, or NO_PATCH
 *   points  of each patch, that are seen
 *   width   of lines, and of those around areas
 * False for want of memory. */
bool creases_choose(struct creases *creases, const uint32_t *nearer, const uint64_t *points, const double width[2]);

void creases_free(struct creases *creases);
