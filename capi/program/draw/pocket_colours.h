/* The colours of pockets: the same in pictures of a surface and in charts. */
#pragma once

#include <stdint.h>

enum { POCKET_COLOURS = 6 };

/* Of the pockets that are listed, the first one's first; and that of all other pockets. */
extern const uint32_t pocket_colours[POCKET_COLOURS], other_pockets_colour;
