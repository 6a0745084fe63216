/* The periodic box that a file of a molecule has. */
#ifndef HARDSPHERE_TOOL_FILE_BOX_H
#define HARDSPHERE_TOOL_FILE_BOX_H

#include <stdbool.h>

#include "line_reader.h"

/* A box that a file has; given is false at first. */
struct box_record {
  bool given;
  double vector[9]; /* a, b, c: a along x, b in the plane of x and y, unless the file has it otherwise */
};

/* From the lengths of the vectors and the angles between them, b and c, c and a, a and b, in degrees, as
 * crystallographers have them. Right angles are exact. Nothing is given if there is no such box. */
void box_from_angles(const double length[3], const double angle[3], struct box_record *box);

/* Nine numbers a_x a_y a_z b_x .. c_z. Nothing is given if one of the lengths along the axes is not
 * above 0. */
void box_from_vectors(const double vector[9], struct box_record *box);

/* Of a PDB file's CRYST1 record, if the line is one: nothing else changes the box. 1 1 1 90 90 90 stands for none. */
void box_from_cryst1(const struct line_reader *reader, struct box_record *box);

/* Of the title of extended XYZ, Lattice="a_x a_y a_z b_x .. c_z"; else nothing is given. */
void box_from_title(const char *title, struct box_record *box);

#endif
