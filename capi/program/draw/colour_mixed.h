/* A mixture of two colours. */
#pragma once

#include <stdint.h>

/* 0xRRGGBB: each channel goes from that of `a` to that of `b` by a share from 0 to 1, and is rounded. */
uint32_t colour_mixed(uint32_t a, uint32_t b, double share_of_b);
