#include "draw/pocket_colours.h"

const uint32_t pocket_colours[POCKET_COLOURS] = {0x3F6FBA, 0xDB7238, 0x4F9E83, 0x7F3F6E, 0xDDB02A, 0x3BB7D6};
const uint32_t other_pockets_colour = 0x73787E;
