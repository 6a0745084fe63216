#include "draw/contact_map.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read/text_buffer.h"
#include "write/output_file.h"

/* Pixels. Within the frame a row is a unit, so that squares have small coordinates. */
enum { LEFT = 64, TOP = 32, SIDE = 640, RIGHT = 16, BOTTOM = 72, SHADES = 6, MOST_TICKS = 16 };

/* Even steps of lightness. */
static const char *const shades[SHADES] = {"#d6dfeb", "#b0c2d9", "#8aa5c6", "#6488b2", "#3e6b9d", "#174e87"};

/* The k-th shade ends at this part of the largest area: areas of contacts differ by powers of ten. */
static double shade_end(int shade) {
  const double part = (shade + 1) / (double)SHADES;
  return part * part;
}

static const struct residue_label *label_of(const struct contact_map *map, uint32_t row) {
  return map->molecule->label[map->groups->group[row].first].residue;
}

/* 1, 2, 5, 10, ...: the least of them that leaves no more than MOST_TICKS ticks. */
static uint32_t tick_step(uint32_t rows) {
  uint32_t step = 1;
  for (uint32_t k = 0; rows / step > MOST_TICKS; ++k) step = k % 3 == 1 ? step / 2 * 5 : step * 2;
  return step;
}

/* Residues have ticks where their own number is round. */
static bool has_tick(const struct contact_map *map, uint32_t row, uint32_t step) {
  if (map->groups->grouping != GROUPING_RESIDUE) return row % step == 0;
  return strtol(label_of(map, row)->number, NULL, 10) % (long)step == 0;
}

static void add_label(struct text_buffer *out, const struct contact_map *map, uint32_t row) {
  const double at = (row + 0.5) * SIDE / map->rows;
  for (int axis = 0; axis < 2; ++axis) {
    if (axis == 0) {
      text_buffer_add(out, "<text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">", LEFT - 6, TOP + at + 4.0);
    } else {
      text_buffer_add(out, "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">", LEFT + at, TOP + SIDE + 16);
    }
    if (map->groups->grouping == GROUPING_NONE) {
      text_buffer_add(out, "%" PRIu32, row);
    } else if (map->groups->grouping == GROUPING_CHAIN) {
      text_buffer_add_xml(out, label_of(map, row)->chain);
    } else {
      text_buffer_add_xml(out, label_of(map, row)->number);
      text_buffer_add_xml(out, label_of(map, row)->insertion);
    }
    text_buffer_add(out, "</text>\n");
  }
}

static bool begins_chain(const struct contact_map *map, uint32_t row) {
  return map->groups->grouping == GROUPING_RESIDUE && row > 0 &&
         strcmp(label_of(map, row)->chain, label_of(map, row - 1)->chain) != 0;
}

static void add_axes(struct text_buffer *out, const struct contact_map *map) {
  const uint32_t step = tick_step(map->rows);
  text_buffer_add(out, "<path fill=\"none\" stroke=\"#9a9a9a\" d=\"M%d %dh%dv%dh-%dzl%d %d", LEFT, TOP, SIDE, SIDE,
                  SIDE, SIDE, SIDE);
  for (uint32_t row = 1; row < map->rows; ++row) {
    if (!begins_chain(map, row)) continue;
    const double at = (double)row * SIDE / map->rows;
    text_buffer_add(out, "M%d %.2fh%dM%.2f %dv%d", LEFT, TOP + at, SIDE, LEFT + at, TOP, SIDE);
  }
  text_buffer_add(out, "\"/>\n");
  for (uint32_t row = 0; row < map->rows; ++row) {
    if (has_tick(map, row, step)) add_label(out, map, row);
  }
}

/* A path of all squares of a shade. Where a row is less than a pixel, a square is a pixel all the same. */
static void add_squares(struct text_buffer *out, const struct contact_map *map, double largest) {
  const double unit = (double)SIDE / map->rows;
  const double side = unit < 1.0 ? 1.0 / unit : 1.0;
  text_buffer_add(out, "<g transform=\"translate(%d %d) scale(%.9g)\">\n", LEFT, TOP, unit);
  for (int shade = 0; shade < SHADES; ++shade) {
    const double above = shade == 0 ? 0.0 : shade_end(shade - 1) * largest;
    const double most = shade + 1 == SHADES ? HUGE_VAL : shade_end(shade) * largest;
    bool any = false;
    for (uint32_t k = 0; k < map->count; ++k) {
      const struct contact_square *square = &map->squares[k];
      if (!(square->area > above && square->area <= most)) continue;
      if (!any) text_buffer_add(out, "<path fill=\"%s\" d=\"", shades[shade]);
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

static void add_scale(struct text_buffer *out, const struct contact_map *map, double largest) {
  const int y = TOP + SIDE + 32, width = SIDE / (SHADES + 2);
  const char *sign = map->molecule->format->sign;
  text_buffer_add(out, "<text x=\"%d\" y=\"%d\">area up to%s%s%s</text>\n", LEFT, y + 12,
                  sign[0] == '\0' ? "" : ", in ", sign, sign[0] == '\0' ? "" : "²");
  for (int shade = 0; shade < SHADES; ++shade) {
    const int x = LEFT + (shade + 2) * width;
    text_buffer_add(out, "<rect x=\"%d\" y=\"%d\" width=\"14\" height=\"14\" fill=\"%s\"/>\n", x, y, shades[shade]);
    text_buffer_add(out, "<text x=\"%d\" y=\"%d\">%.3g</text>\n", x + 19, y + 12, shade_end(shade) * largest);
  }
}

bool contact_map_write(const struct contact_map *map, const char *path, struct failure *failure) {
  struct text_buffer out = TEXT_BUFFER_EMPTY;
  double largest = 0.0;
  for (uint32_t k = 0; k < map->count; ++k) {
    if (map->squares[k].area > largest) largest = map->squares[k].area;
  }
  const int width = LEFT + SIDE + RIGHT, height = TOP + SIDE + BOTTOM;
  text_buffer_add(
      &out,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
      "font-family=\"sans-serif\" font-size=\"12\" fill=\"#333333\" role=\"img\">\n<title>Contacts</title>\n"
      "<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>\n",
      width, height, width, height, width, height);
  if (map->rows > 0) {
    add_squares(&out, map, largest);
    add_axes(&out, map);
  }
  if (largest > 0.0) add_scale(&out, map, largest);
  text_buffer_add(&out, "</svg>\n");
  bool done = !out.out_of_memory || failure_of_memory(failure);
  struct output_file file;
  if (done && output_file_open(&file, path, failure)) {
    output_file_write(&file, out.text, out.length);
    done = output_file_finish(&file, failure);
  } else {
    done = false;
  }
  text_buffer_free(&out);
  return done;
}
