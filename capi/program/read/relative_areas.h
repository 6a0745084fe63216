/* The area with which a residue's area is compared: the largest that it can have. */
#pragma once

/* The source of the values, for people. */
extern const char relative_areas_source[];

/* The largest solvent-accessible area of a residue of this name in a chain, in angstrom^2; NaN if there is no value. */
double largest_residue_area(const char *name);
