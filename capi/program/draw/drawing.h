/* Checks of the options of `draw`, and choices that follow from them. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "commands/drawing_request.h"
#include "read/failure.h"

/* Check that the options may be combined, and set the format by the file's name. */
bool drawing_check(struct drawing *drawing, struct failure *failure);

/* Whether only visible parts are drawn, from a map; if not, pieces of a view are painted one over the other. */
bool drawing_is_of_map(const struct drawing *drawing);

/* Whether small balls and sticks are drawn in place of balls of full size. */
bool drawing_is_of_sticks(const struct drawing *drawing);

/* Whether contours are drawn; they need a map, too. */
bool drawing_has_ink(const struct drawing *drawing);

/* Whether colours stand for numbers. */
bool drawing_is_of_values(const struct drawing *drawing);

/* Whether there is any text over the picture. */
bool drawing_is_annotated(const struct drawing *drawing);

/* The style and the occlusion for a number of balls, defaults included. */
uint32_t drawing_style(const struct drawing *drawing, uint32_t balls);
double drawing_occlusion(const struct drawing *drawing, uint32_t balls);

/* The width of the picture in its unit if the user gives neither width nor height. */
double drawing_default_width(const struct drawing *drawing);

/* The names of formats, styles and palettes for people. */
const char *drawing_format_name(uint32_t format);
const char *drawing_style_name(uint32_t style);
const char *drawing_palette_name(uint32_t palette);
