#include "draw/pocket_colours.h"

const uint32_t pocket_colours[POCKET_COLOURS] = {0x2F6DB5, 0xE0862B, 0x3E9B62, 0x8F5FB0, 0xB9A62A, 0x35A3B3};
const uint32_t other_pockets_colour = 0x8C9196;
