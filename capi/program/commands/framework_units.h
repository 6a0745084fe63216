/* Areas and volumes of pores in a crystal as papers on frameworks quote them: by volume and by mass. */
#pragma once

#include "read/geometry.h"
#include "read/molecule.h"
#include "write/record.h"

struct framework {
  double mass;   /* of all that is in the box, in g/mol; NAN where an element has none */
  double volume; /* of the box, in the unit of the file */
};

struct framework framework_of(const struct molecule *molecule, const double box[9]);

/* In g/cm^3. */
double framework_density(const struct framework *framework);

/* Of the space that a probe gets to, or where it fits and does not get to. */
struct pore_sizes {
  double area, volume;
};

/* Total, by cm^3 and by gram; in a row for persons the main ones alone. */
void framework_record(struct record *record, const struct framework *framework, struct pore_sizes reached,
                      struct pore_sizes blocked);

/* Of what is in a box: the density, and area and free volume, reached or not. area: NaN where it is not that of all. */
void framework_record_union(struct record *record, const double box[9], double area, double free_volume);
