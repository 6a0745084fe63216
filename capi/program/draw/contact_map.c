#include "draw/contact_map.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/chart.h"
#include "draw/text_width.h"
#include "read/text_buffer.h"
#include "write/output_file.h"

/* Pixels. Within the frame a row is a unit, so that squares have small coordinates. */
enum { LEFT = 88, TOP = 40, SIDE = 640, RIGHT = 40, SHADES = 6, SHADE_WIDTH = 56, MOST_TICKS = 16 };
enum { SCALE_BELOW = CHART_NAME_BELOW + 24, SCALE_HEIGHT = 16, BOTTOM = SCALE_BELOW + SCALE_HEIGHT + 40 };
enum { LABEL_BYTES = 64 };

/* Even steps of lightness, away from the page: from a contrast of 1.65 on before a light one, of 2.4 before a dark one.
 */
static const char *const shades[2][SHADES] = {{"#bbcbde", "#9ab1ce", "#7898bd", "#587fab", "#386699", "#174e87"},
                                              {"#365784", "#4771a4", "#5f8cc1", "#7ea7d9", "#a0c3ec", "#c5e0fc"}};

/* How wide a row is: whole pixels, so that no edge of a square lies between two, unless there are more rows than
 * pixels. */
static double unit_of(const struct contact_map *map) {
  const double unit = (double)SIDE / map->rows;
  return unit < 1.0 ? unit : floor(unit + 0.5);
}

static double side_of(const struct contact_map *map) {
  return map->rows == 0 ? SIDE : unit_of(map) * map->rows;
}

/* Powers of ten, as far as doubles go. */
static double power_of_ten_below(double value) {
  double power = 1.0;
  while (power > value && power > 1e-300) power /= 10.0;
  while (10.0 * power <= value && power < 1e300) power *= 10.0;
  return power;
}

/* The nearest of 1, 1.5, 2, 3, 4, 5, 6, 8, 10 times a power of ten: no two numbers of ratio 1.5 become one. */
static double rounded(double value) {
  static const double steps[] = {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
  const double power = power_of_ten_below(value);
  size_t k = 0;
  while (k + 1 < sizeof steps / sizeof steps[0] && value / power > (steps[k] + steps[k + 1]) / 2.0) ++k;
  return steps[k] * power;
}

/* Find the area at which each shade ends: parts of the largest area that grow quadratically, as areas of contacts
 * differ by powers of ten. They are round numbers; the last one is not below the largest area. */
static void find_shade_ends(double largest, double end[SHADES]) {
  for (int shade = 0; shade < SHADES; ++shade) {
    const double part = (shade + 1) / (double)SHADES;
    end[shade] = rounded(part * part * largest);
  }
  const double unit = power_of_ten_below(largest) / 10.0;
  end[SHADES - 1] = ceil(largest / unit) * unit;
}

static const struct residue_label *label_of(const struct contact_map *map, uint32_t row) {
  return map->molecule->label[map->groups->group[row].first].residue;
}

/* The least of 1, 2, 5, 10, ... with at most MOST_TICKS ticks. */
static uint32_t tick_step(uint32_t rows) {
  uint32_t step = 1;
  for (uint32_t k = 0; rows / step > MOST_TICKS; ++k) step = k % 3 == 1 ? step / 2 * 5 : step * 2;
  return step;
}

/* Residues have ticks if their own number is round; of several with this number, by insertion codes, the first. */
static bool has_tick(const struct contact_map *map, uint32_t row, uint32_t step) {
  if (map->groups->grouping != GROUPING_RESIDUE) return row % step == 0;
  const struct residue_label *label = label_of(map, row), *before = row == 0 ? NULL : label_of(map, row - 1);
  const bool again =
      before != NULL && strcmp(label->number, before->number) == 0 && strcmp(label->chain, before->chain) == 0;
  return !again && strtol(label->number, NULL, 10) % (long)step == 0;
}

static void name_row(char text[LABEL_BYTES], const struct contact_map *map, uint32_t row) {
  if (map->groups->grouping == GROUPING_NONE) {
    snprintf(text, LABEL_BYTES, "%" PRIu32, row);
  } else if (map->groups->grouping == GROUPING_CHAIN) {
    snprintf(text, LABEL_BYTES, "%s", label_of(map, row)->chain);
  } else {
    snprintf(text, LABEL_BYTES, "%s", label_of(map, row)->number);
  }
}

/* On both axes, with ticks. */
static void add_label(struct text_buffer *out, const struct contact_map *map, const char *text, double at) {
  chart_tick_left(out, LEFT - 0.5, TOP + floor(at) + 0.5, text);
  chart_tick_below(out, LEFT + floor(at) + 0.5, TOP + side_of(map) + 0.5, text);
}

/* Add labels of rows with ticks, except labels that would touch the one before. */
static void add_labels(struct text_buffer *out, const struct contact_map *map) {
  const uint32_t step = tick_step(map->rows);
  double free_from = -HUGE_VAL;
  for (uint32_t row = 0; row < map->rows; ++row) {
    if (!has_tick(map, row, step)) continue;
    char text[LABEL_BYTES];
    name_row(text, map, row);
    const double at = (row + 0.5) * unit_of(map);
    const double width = text_width(text, CHART_LETTER);
    const double half = (width > CHART_LETTER ? width : CHART_LETTER) / 2.0 + 2.0;
    if (at - half < free_from) continue;
    add_label(out, map, text, at);
    free_from = at + half;
  }
}

static bool begins_chain(const struct contact_map *map, uint32_t row) {
  return map->groups->grouping == GROUPING_RESIDUE && row > 0 &&
         strcmp(label_of(map, row)->chain, label_of(map, row - 1)->chain) != 0;
}

/* The names of chains, above and to the right of their rows, where these have room for them. */
static void add_chains(struct text_buffer *out, const struct contact_map *map) {
  uint32_t first = 0;
  for (uint32_t row = 1; row <= map->rows; ++row) {
    if (row < map->rows && !begins_chain(map, row)) continue;
    const char *const chain = label_of(map, first)->chain;
    const double room = (row - first) * unit_of(map);
    const double middle = (first + row) / 2.0 * unit_of(map);
    first = row;
    if (room < text_width(chain, CHART_LETTER) + 4.0 || room < CHART_LETTER + 4.0) continue;
    chart_text(out, LEFT + middle, TOP - 7, "middle", chain);
    chart_text(out, LEFT + side_of(map) + 7.0, TOP + middle + CHART_HALF_LETTER, "start", chain);
  }
}

/* Add the names of both axes. */
static void add_axis_names(struct text_buffer *out, const struct contact_map *map, bool several) {
  static const char *const names[] = {
      [GROUPING_NONE] = "ball", [GROUPING_RESIDUE] = "residue", [GROUPING_CHAIN] = "chain"};
  char text[LABEL_BYTES];
  const bool of_chain = map->groups->grouping == GROUPING_RESIDUE && !several && label_of(map, 0)->chain[0] != '\0';
  snprintf(text, sizeof text, "%s%s%s", names[map->groups->grouping], of_chain ? ", chain " : "",
           of_chain ? label_of(map, 0)->chain : "");
  const struct chart_frame frame = {LEFT, TOP, side_of(map), side_of(map)};
  chart_name_across(out, &frame, text, "");
  chart_name_up(out, &frame, text, "");
}

/* Lines between rows cover the pixels before them; the frame is around all squares. */
static void add_axes(struct text_buffer *out, const struct contact_map *map) {
  const double side = side_of(map), low[2] = {LEFT - 0.5, TOP - 0.5};
  bool several = false;
  text_buffer_add(out, "<path fill=\"none\" stroke=\"" CHART_GREY "\" d=\"M%.1f %.1fh%.6gv%.6gh-%.6gzl%.6g %.6g",
                  low[0], low[1], side + 1.0, side + 1.0, side + 1.0, side + 1.0, side + 1.0);
  for (uint32_t row = 1; row < map->rows; ++row) {
    if (!begins_chain(map, row)) continue;
    const double at = floor(row * unit_of(map));
    text_buffer_add(out, "M%.1f %.1fh%.6gM%.1f %.1fv%.6g", low[0], low[1] + at, side + 1.0, low[0] + at, low[1],
                    side + 1.0);
    several = true;
  }
  text_buffer_add(out, "\"/>\n");
  add_labels(out, map);
  if (several) add_chains(out, map);
  add_axis_names(out, map, several);
}

/* A path of all squares of a shade. Where a row is less than a pixel, a square is a pixel all the same. */
static void add_squares(struct text_buffer *out, const struct contact_map *map, const double end[SHADES]) {
  const double unit = unit_of(map);
  const double side = unit < 1.0 ? 1.0 / unit : 1.0;
  text_buffer_add(out, "<g transform=\"translate(%d %d) scale(%.9g)\">\n", LEFT, TOP, unit);
  for (int shade = 0; shade < SHADES; ++shade) {
    const double above = shade == 0 ? 0.0 : end[shade - 1];
    const double most = shade + 1 == SHADES ? HUGE_VAL : end[shade];
    bool any = false;
    for (uint32_t k = 0; k < map->count; ++k) {
      const struct contact_square *square = &map->squares[k];
      if (!(square->area > above && square->area <= most)) continue;
      if (!any) text_buffer_add(out, "<path fill=\"%s\" d=\"", shades[map->dark ? 1 : 0][shade]);
      any = true;
      text_buffer_add(out, "M%" PRIu32 " %" PRIu32 "h%.4gv%.4gh-%.4gz", square->first, square->second, side, side,
                      side);
      text_buffer_add(out, "M%" PRIu32 " %" PRIu32 "h%.4gv%.4gh-%.4gz", square->second, square->first, side, side,
                      side);
    }
    if (any) text_buffer_add(out, "\"/>\n");
  }
  text_buffer_add(out, "</g>\n");
}

/* The shades side by side, and the areas between them where they meet. */
static void add_scale(struct text_buffer *out, const struct contact_map *map, const double end[SHADES]) {
  const double y = TOP + side_of(map) + SCALE_BELOW;
  const double left = LEFT + side_of(map) - SHADES * SHADE_WIDTH;
  const char *sign = map->molecule->format->sign;
  for (int shade = 0; shade < SHADES; ++shade) {
    const double x = left + shade * SHADE_WIDTH;
    char text[LABEL_BYTES];
    snprintf(text, sizeof text, "%.3g", end[shade]);
    text_buffer_add(out, "<rect x=\"%.6g\" y=\"%.6g\" width=\"%d\" height=\"%d\" fill=\"%s\"/>\n", x, y, SHADE_WIDTH,
                    SCALE_HEIGHT, shades[map->dark ? 1 : 0][shade]);
    chart_text(out, x + SHADE_WIDTH, y + SCALE_HEIGHT + CHART_LETTER + 3, "middle", text);
  }
  chart_text(out, left, y + SCALE_HEIGHT + CHART_LETTER + 3, "middle", "0");
  text_buffer_add(out, "<text x=\"%.6g\" y=\"%.6g\" text-anchor=\"end\">contact area%s%s%s</text>\n", left - 12.0,
                  y + SCALE_HEIGHT / 2.0 + CHART_HALF_LETTER, sign[0] == '\0' ? "" : ", ", sign,
                  sign[0] == '\0' ? "" : "²");
}

bool contact_map_write(const struct contact_map *map, const char *path, struct failure *failure) {
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  double largest = 0.0;
  for (uint32_t k = 0; k < map->count; ++k) {
    if (map->squares[k].area > largest) largest = map->squares[k].area;
  }
  double end[SHADES] = {0.0};
  if (largest > 0.0) find_shade_ends(largest, end);
  const int side = (int)ceil(side_of(map)), least = LEFT + SHADES * SHADE_WIDTH;
  const int width = LEFT + (side < least ? least : side) + RIGHT, height = TOP + side + BOTTOM;
  chart_begin_before(&out, width, height, "Contacts", map->dark);
  if (map->rows > 0) {
    add_squares(&out, map, end);
    add_axes(&out, map);
  }
  if (largest > 0.0) add_scale(&out, map, end);
  text_buffer_add(&out, "</svg>\n");
  const bool done = output_file_write_text(path, &out, failure);
  text_buffer_free(&out);
  return done;
}
