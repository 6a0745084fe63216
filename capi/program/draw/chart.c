#include "draw/chart.h"

#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "draw/look.h"

enum { MOST_STEPS = 10, NUMBER_BYTES = 32 };

void chart_begin(struct text_buffer *out, int width, int height, const char *title) {
  chart_begin_before(out, width, height, title, false);
}

void chart_begin_before(struct text_buffer *out, int width, int height, const char *title, bool dark) {
  text_buffer_add(out,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
                  "font-family=\"Helvetica,Arial,sans-serif\" font-size=\"%d\" fill=\"#%06" PRIx32
                  "\" role=\"img\">\n<title>",
                  width, height, width, height, CHART_LETTER, dark ? DARK_PAGE_TEXT : UINT32_C(0x333333));
  text_buffer_add_xml(out, title);
  text_buffer_add(out, "</title>\n<rect width=\"%d\" height=\"%d\" fill=\"#%06" PRIx32 "\"/>\n", width, height,
                  dark ? DARK_PAGE : UINT32_C(0xffffff));
}

static void add_text(struct text_buffer *out, double x, double y, const char *anchor, const char *text,
                     const char *sign) {
  text_buffer_add(out, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor);
  text_buffer_add_xml(out, text);
  text_buffer_add(out, "%s%s</text>\n", sign[0] == '\0' ? "" : ", ", sign);
}

void chart_text(struct text_buffer *out, double x, double y, const char *anchor, const char *text) {
  add_text(out, x, y, anchor, text, "");
}

void chart_tick_below(struct text_buffer *out, double x, double bottom, const char *text) {
  text_buffer_add(out, "<path stroke=\"" CHART_GREY "\" d=\"M%.1f %.1fv%d\"/>\n", x, bottom, CHART_TICK);
  chart_text(out, x, bottom + CHART_TICK + CHART_LETTER + 1, "middle", text);
}

void chart_tick_left(struct text_buffer *out, double left, double y, const char *text) {
  text_buffer_add(out, "<path stroke=\"" CHART_GREY "\" d=\"M%.1f %.1fh-%d\"/>\n", left, y, CHART_TICK);
  chart_text(out, left - CHART_TICK - 3, y + CHART_HALF_LETTER, "end", text);
}

void chart_name_across(struct text_buffer *out, const struct chart_frame *frame, const char *name, const char *sign) {
  add_text(out, frame->left + frame->width / 2, frame->top + frame->height + CHART_NAME_BELOW, "middle", name, sign);
}

void chart_name_up(struct text_buffer *out, const struct chart_frame *frame, const char *name, const char *sign) {
  text_buffer_add(out, "<g transform=\"translate(%d %.6g) rotate(-90)\">", CHART_LETTER + 8,
                  frame->top + frame->height / 2);
  add_text(out, 0.0, 0.0, "middle", name, sign);
  text_buffer_add(out, "</g>\n");
}

struct chart_scale chart_scale_of(double low, double high) {
  struct chart_scale scale = {low, high, 1.0};
  const double least = fmax((high - low) / MOST_STEPS, 1e-9 * fmax(fabs(low), fabs(high)));
  while (scale.step > least) scale.step /= 10.0;
  for (int k = 0; scale.step < least; ++k) scale.step *= k % 3 == 1 ? 2.5 : 2.0; /* 1, 2, 5, 10, .. */
  scale.low = floor(low / scale.step) * scale.step;
  scale.high = ceil(high / scale.step) * scale.step;
  return scale;
}

double chart_x(const struct chart_frame *frame, const struct chart_scale *across, double number) {
  return frame->left + (number - across->low) / (across->high - across->low) * frame->width;
}

double chart_y(const struct chart_frame *frame, const struct chart_scale *up, double number) {
  return frame->top + (up->high - number) / (up->high - up->low) * frame->height;
}

static void add_ticks(struct text_buffer *out, const struct chart_frame *frame, const struct chart_scale *scale,
                      bool below) {
  const long steps = lround((scale->high - scale->low) / scale->step);
  const double largest = fmax(fabs(scale->low), fabs(scale->high));
  const bool plain = largest < 1e6 && scale->step > 0.99e-4;
  int decimals = 0, digits = 6; /* the same of all; and as many as tell ticks apart */
  for (double unit = 1.0; plain && unit > 1.01 * scale->step; unit /= 10.0) ++decimals;
  for (double unit = 1e-5 * largest; unit > scale->step; unit /= 10.0) ++digits;
  for (long k = 0; k <= steps; ++k) {
    const double sum = scale->low + scale->step * (double)k;
    const double number = fabs(sum) < scale->step / 2.0 ? 0.0 : sum;
    char text[NUMBER_BYTES];
    snprintf(text, sizeof text, plain ? "%.*f" : "%.*g", plain ? decimals : digits, number);
    if (below) {
      chart_tick_below(out, chart_x(frame, scale, number), frame->top + frame->height, text);
    } else {
      chart_tick_left(out, frame->left, chart_y(frame, scale, number), text);
    }
  }
}

void chart_axes(struct text_buffer *out, const struct chart_frame *frame, const struct chart_scale *across,
                const struct chart_scale *up) {
  text_buffer_add(out, "<path fill=\"none\" stroke=\"" CHART_GREY "\" d=\"M%.6g %.6gh%.6gv%.6gh-%.6gz\"/>\n",
                  frame->left, frame->top, frame->width, frame->height, frame->width);
  add_ticks(out, frame, across, true);
  add_ticks(out, frame, up, false);
}

void chart_axis_below(struct text_buffer *out, const struct chart_frame *frame, const struct chart_scale *across) {
  text_buffer_add(out, "<path stroke=\"" CHART_GREY "\" d=\"M%.6g %.6gh%.6g\"/>\n", frame->left,
                  frame->top + frame->height, frame->width);
  add_ticks(out, frame, across, true);
}

/* Also without red or green, by how light they are: CIEDE2000 at least 16 as Machado et al. (2009) simulate that. */
static const char *const colours[] = {"#3a539f", "#b44f05", "#1a8d7d", "#732e51", "#d39022", "#40a6d4"};
enum { COLOURS = sizeof colours / sizeof colours[0], DASH = 4 };

const char *chart_colour(uint32_t number) {
  return colours[number % COLOURS];
}

int chart_dash(uint32_t number) {
  return DASH * (int)(number / COLOURS);
}

void chart_path_begin(struct text_buffer *out, const char *colour, double width) {
  text_buffer_add(out, "<path fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\" stroke-linejoin=\"round\"", colour,
                  width);
}

void chart_dashed(struct text_buffer *out, double x0, double y0, double x1, double y1) {
  text_buffer_add(out, "<path stroke=\"" CHART_GREY "\" stroke-dasharray=\"4 3\" d=\"M%.2f %.2fL%.2f %.2f\"/>\n", x0,
                  y0, x1, y1);
}
