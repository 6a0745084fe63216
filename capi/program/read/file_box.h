/* The periodic box that a file of a molecule has. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/line_reader.h"

/* A box that a file has; zeros at first. */
struct box_record {
  bool given;
  bool denied;       /* what the file has is none: lengths of 0, or 1 1 1 as a placeholder */
  const char *fault; /* why it is none, where there is more to say, not owned; or NULL */
  double vector[9];  /* a, b, c, in the frame of the atoms */
};

/* From the lengths of the vectors and the angles between them, b and c, c and a, a and b, in degrees, as
 * crystallographers have them: a along x, b in the plane of x and y. Right angles are exact. Denied if there is no such
 * box. */
void box_from_angles(const double length[3], const double angle[3], struct box_record *box);

/* Nine numbers a_x a_y a_z b_x .. c_z. Denied if they span no volume. */
void box_from_vectors(const double vector[9], struct box_record *box);

/* Of a PDB file's CRYST1 record, if the line is one: nothing else changes the box. */
void box_from_cryst1(const struct line_reader *reader, struct box_record *box);

/* Of the title of extended XYZ, Lattice="a_x a_y a_z b_x .. c_z" in quotes or brackets of any kind, or three lengths;
 * else nothing is given. Denied by pbc unless it repeats in all directions. */
void box_from_title(const char *title, struct box_record *box);

/* The point at these fractions of the vectors. */
void box_point(const struct box_record *box, const double fraction[3], double out[3]);

/* The fractions of the vectors that a point is at. */
void box_fractions(const struct box_record *box, const double point[3], double out[3]);

/* The distance of the two faces that vector k leads across. */
double box_distance(const struct box_record *box, int k);

/* Three unit vectors at right angles: along a, along what b has beside it, and their cross product. */
void box_axes(const struct box_record *box, double axis[9]);
