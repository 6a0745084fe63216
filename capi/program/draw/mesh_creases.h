/* Creases: edges at which the spheres of two patches meet at an angle. Of its two patches one is chosen whose line
 * extends over the other one. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define NO_PATCH UINT32_MAX

/* An edge of a crease. Its first patch, which has the lower number, is on the side to which (y, -x) points, if (x, y)
 * is the direction of the edge on the page. */
struct crease {
  uint32_t vertex[2], patch[2];
  double at[2][2];
  int painted;       /* 0 or 1: the patch whose area is painted later, over the other */
  size_t edge;       /* for the caller */
  bool known;        /* `over` is chosen, and stays */
  int over;          /* 0 or 1: the patch to which the line belongs */
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

/* Choose for each edge the patch whose line extends over the other one, by half of the line's width. If a crease
 * continues as a contour, it is the patch of the contour, whose line extends over the things behind it: another choice
 * would give a step. If a crease has contours at both ends, each part has the patch of the nearer contour. Without
 * contours it is the patch with more visible points. Towards its ends the line is moved aside, so that its edge there
 * is that of the area painted later.
 *   nearer  for each vertex the patch of a contour there, or NO_PATCH
 *   points  for each patch the number of its visible points
 *   width   of these lines, and of the lines around areas
 * False: memory is short. */
bool creases_choose(struct creases *creases, const uint32_t *nearer, const uint64_t *points, const double width[2]);

void creases_free(struct creases *creases);
