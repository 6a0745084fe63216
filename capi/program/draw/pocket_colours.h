/* The colours of pockets: the same in pictures of a surface and in charts. */
#pragma once

#include <stdint.h>

enum { POCKET_COLOURS = 6 };

/* The colours of the first pockets in the list, in their order; and the colour of all others. */
extern const uint32_t pocket_colours[POCKET_COLOURS], other_pockets_colour;
