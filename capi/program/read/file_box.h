/* The periodic box that a file of a molecule has. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "read/line_reader.h"

/* The box of a file; zeros at first. */
struct box_record {
  bool given;
  bool denied;       /* the record stands for no box: lengths of 0, or 1 1 1 as a placeholder */
  const char *fault; /* more about why it is no box, not owned; or NULL */
  double vector[9];  /* a, b, c, in the frame of the atoms */
};

/* Make a box from the lengths of its vectors and the angles between b and c, c and a, a and b, in degrees, by the
 * convention of crystallography: a along x, b in the plane of x and y. Right angles are exact. Denied if there is no
 * such box. */
void box_from_angles(const double length[3], const double angle[3], struct box_record *box);

/* Make a box from nine numbers a_x a_y a_z b_x .. c_z. Denied if they span no volume. */
void box_from_vectors(const double vector[9], struct box_record *box);

/* Read the box from a CRYST1 record of a PDB file. Other lines leave the box as it is. */
void box_from_cryst1(const struct line_reader *reader, struct box_record *box);

/* Read the box from the title of an extended XYZ file: Lattice="a_x a_y a_z b_x .. c_z" in quotes or brackets of any
 * kind, or three lengths; without it no box is given. Denied if pbc says that it does not repeat in all directions. */
void box_from_title(const char *title, struct box_record *box);

/* The point at these fractions of the vectors. */
void box_point(const struct box_record *box, const double fraction[3], double out[3]);

/* The coordinates of a point as fractions of the vectors. */
void box_fractions(const struct box_record *box, const double point[3], double out[3]);

/* The distance of the two faces of the box that vector k connects. */
double box_distance(const struct box_record *box, int k);

/* Three unit vectors at right angles: along a, along the part of b across a, and their cross product. */
void box_axes(const struct box_record *box, double axis[9]);
