/* Atomic masses of elements. */
#pragma once

#include "read/radii.h"

/* The standard atomic weight of IUPAC in g/mol; 0 for elements that have none. */
double element_mass(struct element_symbol symbol);
