/* Charts as .svg: a frame, axes with ticks, lines, a legend. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "read/text_buffer.h"

/* Pixels. Letters are legible where a chart is printed as wide as a column of a page. */
enum { CHART_LETTER = 16, CHART_TICK = 4 };

/* Half the height of capitals and figures: so far below the middle of what a text stands beside is its line. */
#define CHART_HALF_LETTER 5.5

/* Lines of the frame and of ticks. */
#define CHART_GREY "#9a9a9a"

/* The beginning of the file; its end is "</svg>\n". */
void chart_begin(struct text_buffer *out, int width, int height, const char *title);

/* The same before a dark page, if so asked; lines and ticks have their grey on both. */
void chart_begin_before(struct text_buffer *out, int width, int height, const char *title, bool dark);

/* anchor: "start", "middle" or "end". */
void chart_text(struct text_buffer *out, double x, double y, const char *anchor, const char *text);

/* A tick and its label below a frame at x, or to the left of it at y. */
void chart_tick_below(struct text_buffer *out, double x, double bottom, const char *text);
void chart_tick_left(struct text_buffer *out, double left, double y, const char *text);

struct chart_frame {
  double left, top, width, height;
};

/* How far below a frame the name of the axis there has its line. */
enum { CHART_NAME_BELOW = CHART_TICK + 2 * CHART_LETTER + 8 };

/* The name of an axis, and the sign of its unit, in UTF-8; of an empty one nothing. */
void chart_name_across(struct text_buffer *out, const struct chart_frame *frame, const char *name, const char *sign);
void chart_name_up(struct text_buffer *out, const struct chart_frame *frame, const char *name, const char *sign);

/* The numbers along a side of a frame: ticks at multiples of 1, 2 or 5 times a power of ten, at most a dozen, at two of
 * which it begins and ends, around all from low to high, which is more than low. */
struct chart_scale {
  double low, high, step;
};
struct chart_scale chart_scale_of(double low, double high);

/* The frame, with ticks along its lower and its left side; or its lower side alone, where lines would be taken for
 * others. */
void chart_axes(struct text_buffer *out, const struct chart_frame *frame, const struct chart_scale *across,
                const struct chart_scale *up);
void chart_axis_below(struct text_buffer *out, const struct chart_frame *frame, const struct chart_scale *across);

/* Where a number is along a side. */
double chart_x(const struct chart_frame *frame, const struct chart_scale *across, double number);
double chart_y(const struct chart_frame *frame, const struct chart_scale *up, double number);

/* A line without its points, and one of dashes, whole. */
void chart_path_begin(struct text_buffer *out, const char *colour, double width);
void chart_dashed(struct text_buffer *out, double x0, double y0, double x1, double y1);

/* Distinct colours, which begin anew after the last one. */
const char *chart_colour(uint32_t number);

/* In pixels, the dashes of a line that has the colour of another one, longer each time; 0: it has none. */
int chart_dash(uint32_t number);
