/* Areas and volumes of pores in a crystal, per volume and per mass of it, as papers on frameworks state them. */
#pragma once

#include "read/geometry.h"
#include "read/molecule.h"
#include "write/record.h"

struct framework {
  double mass;   /* of all atoms in the box, in g/mol; NAN if an element's mass is not known */
  double volume; /* of the box, in the unit of the file */
};

struct framework framework_of(const struct molecule *molecule, const double box[9]);

/* The density in g/cm^3. */
double framework_density(const struct framework *framework);

/* The sizes of the space that a probe reaches, or of the space in which it fits, but which it does not reach. */
struct pore_sizes {
  double area, volume;
};

/* Write areas and volumes: in total, per cm^3 and per gram; in a row for persons only the main ones. */
void framework_record(struct record *record, const struct framework *framework, struct pore_sizes reached,
                      struct pore_sizes blocked);

/* Write the density of the content of a box, and its area and free volume, whether reached or not. area: NaN if it is
 * not the area of all atoms. */
void framework_record_union(struct record *record, const double box[9], double area, double free_volume);
