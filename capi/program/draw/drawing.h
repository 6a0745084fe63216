/* Which options of `draw` go together, and what follows from them. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "commands/drawing_request.h"
#include "read/failure.h"

/* Which options go together, and what format the file's name asks for. */
bool drawing_check(struct drawing *drawing, struct failure *failure);

/* Whether what is visible is drawn, from a map, and no pieces of a view one over the other. */
bool drawing_is_of_map(const struct drawing *drawing);

/* Whether balls and sticks are drawn, and no balls of full size. */
bool drawing_is_of_sticks(const struct drawing *drawing);

/* Whether contours are drawn, for which a map is needed, too. */
bool drawing_has_ink(const struct drawing *drawing);

/* Whether colours stand for numbers. */
bool drawing_is_of_values(const struct drawing *drawing);

/* Whether anything is written over it. */
bool drawing_is_annotated(const struct drawing *drawing);

/* The style and the occlusion for a number of balls, defaults included. */
uint32_t drawing_style(const struct drawing *drawing, uint32_t balls);
double drawing_occlusion(const struct drawing *drawing, uint32_t balls);

/* How wide the picture is where the user gives no side, in its unit. */
double drawing_default_width(const struct drawing *drawing);

/* The names of formats, styles and palettes for people. */
const char *drawing_format_name(uint32_t format);
const char *drawing_style_name(uint32_t style);
const char *drawing_palette_name(uint32_t palette);
