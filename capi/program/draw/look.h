/* Presets of `draw`: several of its options by one name. An option that the user gives by itself wins. */
#pragma once

#include <stdint.h>

struct drawing;

/* The page of --look slide and --dark, and the colours of balls' lines and of texts on it. */
#define DARK_PAGE UINT32_C(0x14171e)
#define DARK_PAGE_LINES UINT32_C(0x3a414f)
#define DARK_PAGE_TEXT UINT32_C(0xece9e2)

/* Set the options that the user has not given by the look that the user asks for, if any. */
void look_apply(struct drawing *drawing);
