/* Presets of `draw`: several of its options by one name. An option that the user gives by itself wins. */
#pragma once

#include <stdint.h>

struct drawing;

/* Of --look slide and --dark, lines of balls before it, and what is written on it. */
#define DARK_PAGE UINT32_C(0x14171e)
#define DARK_PAGE_LINES UINT32_C(0x3a414f)
#define DARK_PAGE_TEXT UINT32_C(0xece9e2)

/* Sets the options that the user has left open, by the look that was asked for, if there is one. */
void look_apply(struct drawing *drawing);
