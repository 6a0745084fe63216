/* Charts as .svg: a frame, axes with ticks, lines, a legend. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/text_buffer.h"

/* Pixels. Letters are still legible if a chart is printed as wide as a column of a page. */
enum { CHART_LETTER = 16, CHART_TICK = 4 };

/* Half the height of capitals and figures: the line of a text is so far below the middle of the thing beside it. */
#define CHART_HALF_LETTER 5.5

/* The colour of the frame and of ticks. */
#define CHART_GREY "#9a9a9a"

/* The beginning of the file; its end is "</svg>\n". */
void chart_begin(struct text_buffer *out, int width, int height, const char *title);

/* The same, on a dark page if `dark`. Lines and ticks have the same grey on both kinds. */
void chart_begin_before(struct text_buffer *out, int width, int height, const char *title, bool dark);

/* anchor: "start", "middle" or "end". */
void chart_text(struct text_buffer *out, double x, double y, const char *anchor, const char *text);

/* A tick and its label below a frame at x, or to the left of it at y. */
void chart_tick_below(struct text_buffer *out, double x, double bottom, const char *text);
void chart_tick_left(struct text_buffer *out, double left, double y, const char *text);

struct chart_frame {
  double left, top, width, height;
};

/* The distance from the lower side of a frame down to the line of the axis name. */
enum { CHART_NAME_BELOW = CHART_TICK + 2 * CHART_LETTER + 8 };

/* The name of an axis, and the sign of its unit, in UTF-8, unless it is empty. */
void chart_name_across(struct text_buffer *out, const struct chart_frame *frame, const char *name, const char *sign);
void chart_name_up(struct text_buffer *out, const struct chart_frame *frame, const char *name, const char *sign);

/* The numbers along a side of a frame: at most a dozen ticks at multiples of 1, 2 or 5 times a power of ten. The side
 * begins and ends at a tick, and holds all numbers from low to high (high > low). */
struct chart_scale {
  double low, high, step;
};
struct chart_scale chart_scale_of(double low, double high);

/* The frame, with ticks along its lower and its left side; or only its lower side, if the frame's lines could be
 * mistaken for others. */
void chart_axes(struct text_buffer *out, const struct chart_frame *frame, const struct chart_scale *across,
                const struct chart_scale *up);
void chart_axis_below(struct text_buffer *out, const struct chart_frame *frame, const struct chart_scale *across);

/* The place of a number along a side. */
double chart_x(const struct chart_frame *frame, const struct chart_scale *across, double number);
double chart_y(const struct chart_frame *frame, const struct chart_scale *up, double number);

/* The beginning of a line, to which the caller adds points; and a whole dashed line. */
void chart_path_begin(struct text_buffer *out, const char *colour, double width);
void chart_dashed(struct text_buffer *out, double x0, double y0, double x1, double y1);

/* Distinct colours; behind the last one they are repeated. */
const char *chart_colour(uint32_t number);

/* The length in pixels of the dashes of line `number`: the longer, the more lines before it have its colour; 0: the
 * line is solid. */
int chart_dash(uint32_t number);
