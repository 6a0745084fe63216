/* The data in the title of a frame in a text file beside the name of the molecule. */
#pragma once

#include "read/molecule.h"

/* Read time and step from a title such as "Protein in water t= 20.00000 step= 10000" of GROMACS, "i = 5, time = 2.5" of
 * CP2K or "time=2.5" of extended XYZ. A title is free text: all else is ignored. */
void frame_title_read(const char *title, struct frame_stamp *stamp);
