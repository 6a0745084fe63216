/* Atomic masses of elements. */
#pragma once

#include "read/radii.h"

/* In g/mol: the standard atomic weight of IUPAC; 0 of elements that have none. */
double element_mass(struct element_symbol symbol);
