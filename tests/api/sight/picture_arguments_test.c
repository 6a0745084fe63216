/* Arguments of the functions for pictures that the header refuses, calls out of order, and sinks that refuse; of
 * views and of maps. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>

#include "ball_sets.h"
#include "check.h"
#include "picture_sink.h"
#include "untouched.h"

enum { BALLS = THREE_BALLS, ARCS = 40, EDGES = 40 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char view_memory[HSP_VIEW_BYTES(BALLS, BALLS, ARCS)];
static unsigned char map_memory[HSP_MAP_BYTES(BALLS, BALLS, EDGES)];
static hsp_model *model;
static hsp_view *view;
static hsp_map *map;

static const uint32_t colours[BALLS] = {0x000000, 0xFFFFFF, 0x123456};

static hsp_picture_options good_options(void) {
  hsp_picture_options options;
  CHECK_EQUAL(hsp_picture_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  return options;
}

static void options_init(void) {
  hsp_picture_options options;
  FILL(options);
  CHECK_UNTOUCHED(options);
  CHECK_EQUAL(hsp_picture_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(options.struct_size, sizeof options);
  CHECK_EQUAL(options.format, HSP_FORMAT_SVG);
  CHECK_EQUAL(options.style, HSP_STYLE_FLAT);
  CHECK_EQUAL(options.unit, HSP_UNIT_PX);
  CHECK(options.width == 1000 && options.height == 0 && options.margin == 0.03 && options.outline == -1);
  CHECK(options.fog == 0.3);
  CHECK_EQUAL(options.outline_colour, 0x23202B);
  CHECK_EQUAL(options.background, 0xFFFFFF);
  CHECK_EQUAL(options.flags, 0);
  CHECK_EQUAL(options.reserved, 0);
  CHECK(options.ink == NULL && options.group == NULL);
  for (int k = 0; k < 3; ++k) {
    CHECK(options.ink_width[k] == -1);
    CHECK_EQUAL(options.ink_colour[k], 0x23202B);
  }
  CHECK_EQUAL(options.reserved_for_ink, 0);
  CHECK_EQUAL(options.reserved_for_sticks, 0);
  CHECK(options.atom_class == NULL);
  CHECK(options.atom_title == NULL);
  CHECK(options.scale == 0 && options.centre[0] == 0 && options.centre[1] == 0 && options.centre[2] == 0);
}

/* Of the view, or of the map if there is no view. */
static int32_t write_either(hsp_view *of_view, hsp_map *of_map, const uint32_t *colour,
                            const hsp_picture_options *options, picture_sink *sink, uint64_t *bytes) {
  if (of_view == NULL) {
    return hsp_picture_write_map(of_map, colour, options, "t", "", picture_sink_take, sink, bytes);
  }
  return hsp_picture_write(of_view, colour, options, "t", "", picture_sink_take, sink, bytes);
}

/* Calls for the view and for the map are refused before the sink hears of it, handles before anything is written. */
static void check_refused(const uint32_t *colour, const hsp_picture_options *options, int32_t expected) {
  picture_sink sink;
  uint64_t bytes[2] = {77, 77};
  picture_sink_start(&sink, SIZE_MAX);
  CHECK_EQUAL(write_either(view, NULL, colour, options, &sink, &bytes[0]), expected);
  CHECK_EQUAL(write_either(NULL, map, colour, options, &sink, &bytes[1]), expected);
  CHECK_EQUAL(bytes[0] + bytes[1], expected == HSP_E_HANDLE ? 154 : 0);
  CHECK_EQUAL(sink.calls, 0);
  picture_sink_release(&sink);
}

static void check_written(const uint32_t *colour, const hsp_picture_options *options) {
  int which;
  for (which = 0; which < 2; ++which) {
    picture_sink sink;
    uint64_t bytes = 77;
    picture_sink_start(&sink, SIZE_MAX);
    CHECK_EQUAL(write_either(which == 0 ? view : NULL, map, colour, options, &sink, &bytes), HSP_OK);
    CHECK(sink.count > 100 && sink.odd == 0);
    CHECK_EQUAL(bytes, sink.count);
    picture_sink_release(&sink);
  }
}

static void bad_choices(void) {
  static const uint32_t too_large[3] = {0x1000000, 0x80000000, HSP_NONE};
  hsp_picture_options options;
  uint64_t bytes = 77;
  int k;
  CHECK_EQUAL(bytes, 77);
  options = good_options();
  options.struct_size = 0;
  check_refused(colours, &options, HSP_E_VERSION);
  options.struct_size = 1028;
  check_refused(colours, &options, HSP_E_VERSION);
  {
    /* nothing behind the size is read; the sanitizers see it if it is */
    uint32_t *size_alone = malloc(sizeof *size_alone);
    CHECK(size_alone != NULL);
    if (size_alone == NULL) return;
    *size_alone = (uint32_t)sizeof *size_alone;
    check_refused(colours, (const hsp_picture_options *)(const void *)size_alone, HSP_E_VERSION);
    free(size_alone);
  }
  options = good_options();
  options.format = HSP_FORMAT_PDF + 1;
  check_refused(colours, &options, HSP_E_ARGUMENT);
  options = good_options();
  options.style = HSP_STYLE_SOFT + 1;
  check_refused(colours, &options, HSP_E_ARGUMENT);
  options = good_options();
  options.unit = HSP_UNIT_MM + 1;
  check_refused(colours, &options, HSP_E_ARGUMENT);
  options = good_options();
  options.reserved = 1;
  check_refused(colours, &options, HSP_E_VERSION);
  options = good_options();
  options.width = options.height = 0;
  check_refused(colours, &options, HSP_E_ARGUMENT);
  options = good_options();
  options.memory_bytes = HSP_PICTURE_MEMORY;
  check_refused(colours, &options, HSP_E_ARGUMENT);
  options = good_options();
  options.reserved_for_ink = 1;
  check_refused(colours, &options, HSP_E_VERSION);
  options = good_options();
  options.reserved_for_sticks = 1;
  check_refused(colours, &options, HSP_E_VERSION);
  for (k = 0; k < 3; ++k) {
    options = good_options();
    options.ink_colour[k] = 0x1000000;
    check_refused(colours, &options, HSP_E_ARGUMENT);
  }
  for (k = 2; k < 32; ++k) {
    options = good_options();
    options.flags = HSP_PICTURE_NO_IDS | HSP_PICTURE_NO_BACKGROUND | (UINT32_C(1) << k);
    check_refused(colours, &options, HSP_E_ARGUMENT);
  }
  for (k = 0; k < 3; ++k) {
    uint32_t colour[BALLS] = {1, 2, 3};
    check_scene("colour %lx", (unsigned long)too_large[k]);
    options = good_options();
    options.background = too_large[k];
    check_refused(colours, &options, HSP_E_ARGUMENT);
    options = good_options();
    options.outline_colour = too_large[k];
    check_refused(colours, &options, HSP_E_ARGUMENT);
    colour[k] = too_large[k];
    check_refused(colour, NULL, HSP_E_ARGUMENT);
  }
  check_scene("%s", "");
}

/* Ink needs a live, computed map of the same model from the same direction. */
static void bad_ink(void) {
  static const uint32_t group[BALLS] = {1, 1, 2};
  static unsigned char other_memory[HSP_MAP_BYTES(BALLS, BALLS, EDGES)];
  hsp_picture_options options = good_options();
  hsp_view_options sideways;
  hsp_map_limits limits = {.struct_size = sizeof limits, .balls = BALLS, .neighbours = BALLS, .edges = EDGES};
  hsp_map *other;
  options.ink = map;
  check_written(colours, &options);
  options.group = group;
  check_written(colours, &options);
  options.ink = (const hsp_map *)(const void *)view; /* what a compiler refuses without a cast */
  check_refused(colours, &options, HSP_E_HANDLE);
  CHECK_EQUAL(hsp_map_init(other_memory, sizeof other_memory, &limits, &other), HSP_OK);
  options.ink = other;
  check_refused(colours, &options, HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_options_init(&sideways, (uint32_t)sizeof sideways), HSP_OK);
  sideways.towards[0] = 1;
  CHECK_EQUAL(hsp_map_compute(other, model, &sideways, NULL), HSP_OK);
  check_refused(colours, &options, HSP_E_ARGUMENT);
}

static double *value_of(hsp_picture_options *options, int which) {
  double *const values[8] = {&options->width, &options->height,       &options->margin,       &options->outline,
                             &options->fog,   &options->ink_width[0], &options->ink_width[1], &options->ink_width[2]};
  return values[which];
}

static void bad_values(void) {
  static const double odd[3] = {NAN, INFINITY, -INFINITY};
  /* in the order of value_of: the least and the largest, if there is one, and what lies beyond */
  static const double least[8] = {0, 0, 0, -1e300, 0, -1e300, -1e300, -1e300};
  static const double most[8] = {1e6, 1e6, 10, 1e6, 1, 1e6, 1e6, 1e6};
  hsp_picture_options options;
  int which, k;
  for (which = 0; which < 8; ++which) {
    for (k = 0; k < 3; ++k) {
      check_scene("value %d is %g", which, odd[k]);
      options = good_options();
      *value_of(&options, which) = odd[k];
      check_refused(colours, &options, HSP_E_NOT_FINITE);
    }
    check_scene("value %d", which);
    options = good_options();
    options.height = 500;
    *value_of(&options, which) = nextafter(most[which], INFINITY);
    check_refused(colours, &options, HSP_E_RANGE);
    *value_of(&options, which) = 1e300;
    check_refused(colours, &options, HSP_E_RANGE);
    *value_of(&options, which) = most[which];
    check_written(colours, &options);
    *value_of(&options, which) = least[which];
    check_written(colours, &options);
    if (which == 3 || which > 4) continue; /* any negative width of lines is good */
    *value_of(&options, which) = -5e-324;
    check_refused(colours, &options, HSP_E_RANGE);
    *value_of(&options, which) = -10;
    check_refused(colours, &options, HSP_E_RANGE);
  }
  check_scene("%s", "");
}

static void bad_frames(void) {
  static const double odd[3] = {NAN, INFINITY, -INFINITY};
  hsp_picture_options options;
  int axis, k;
  for (k = 0; k < 3; ++k) {
    options = good_options();
    options.scale = odd[k];
    check_refused(colours, &options, HSP_E_NOT_FINITE);
    for (axis = 0; axis < 3; ++axis) {
      options = good_options();
      options.scale = 1;
      options.centre[axis] = odd[k];
      check_refused(colours, &options, HSP_E_NOT_FINITE);
    }
  }
  for (axis = 0; axis < 3; ++axis) {
    options = good_options();
    options.centre[axis] = 1;
    check_refused(colours, &options, HSP_E_ARGUMENT); /* without a scale */
    options.scale = 1;
    check_written(colours, &options);
    if (axis == 2) continue; /* towards the viewer: any distance is good */
    options.centre[axis] = 9.99e6;
    check_written(colours, &options);
    options.centre[axis] = -1.001e7;
    check_refused(colours, &options, HSP_E_RANGE);
    options.centre[axis] = 1e300;
    check_refused(colours, &options, HSP_E_RANGE);
  }
  options = good_options();
  options.scale = -5e-324;
  check_refused(colours, &options, HSP_E_RANGE);
  options.scale = -1;
  check_refused(colours, &options, HSP_E_RANGE);
  options.scale = 5e-324;
  check_written(colours, &options);
  options.scale = 1e6;
  check_written(colours, &options);
  options.scale = 1e8;
  check_refused(colours, &options, HSP_E_RANGE);
  options.scale = 1e308;
  check_refused(colours, &options, HSP_E_RANGE);
}

static void states(void) {
  hsp_view_limits limits;
  hsp_map_limits map_limits;
  hsp_view_options options;
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  limits.arcs = ARCS;
  CHECK_EQUAL(hsp_map_limits_init(&map_limits, (uint32_t)sizeof map_limits, BALLS), HSP_OK);
  map_limits.edges = EDGES;
  check_scene("nothing computed");
  CHECK_EQUAL(hsp_view_init(view_memory, sizeof view_memory, &limits, &view), HSP_OK);
  CHECK_EQUAL(hsp_map_init(map_memory, sizeof map_memory, &map_limits, &map), HSP_OK);
  check_refused(colours, NULL, HSP_E_STATE);
  check_scene("a failed computation");
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.towards[1] = NAN;
  CHECK_EQUAL(hsp_view_compute(view, model, NULL, &options, NULL), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_map_compute(map, model, &options, NULL), HSP_E_NOT_FINITE);
  check_refused(colours, NULL, HSP_E_STATE);
  check_scene("the model was set again");
  CHECK_EQUAL(hsp_view_compute(view, model, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  check_written(colours, NULL);
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_refused(colours, NULL, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  check_written(colours, NULL);
  CHECK_EQUAL(hsp_view_compute(view, model, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  check_written(colours, NULL);
  check_written(NULL, NULL);
  check_scene("%s", "");
}

/* With memory PDF is compressed; other formats stay as they are. */
static void compressed(void) {
  static unsigned char memory[HSP_PICTURE_MEMORY + 2];
  hsp_picture_options options = good_options();
  picture_sink plain, packed;
  uint32_t format;
  size_t accepts;
  options.memory = memory + 1;
  check_refused(colours, &options, HSP_E_MEMORY);
  options.memory_bytes = HSP_PICTURE_MEMORY - 1;
  check_refused(colours, &options, HSP_E_MEMORY);
  memory[0] = memory[HSP_PICTURE_MEMORY + 1] = 77;
  for (format = HSP_FORMAT_SVG; format <= HSP_FORMAT_PDF; ++format) {
    options = good_options();
    options.format = format;
    picture_sink_start(&plain, SIZE_MAX);
    CHECK_EQUAL(write_either(view, NULL, colours, &options, &plain, NULL), HSP_OK);
    options.memory = memory + 1;
    options.memory_bytes = HSP_PICTURE_MEMORY;
    check_written(colours, &options);
    picture_sink_start(&packed, SIZE_MAX);
    CHECK_EQUAL(write_either(view, NULL, colours, &options, &packed, NULL), HSP_OK);
    CHECK((packed.count == plain.count && memcmp(packed.bytes, plain.bytes, plain.count) == 0) ==
          (format != HSP_FORMAT_PDF));
    if (format == HSP_FORMAT_PDF) CHECK_BYTES(packed.bytes, "%PDF-1.5\n", 9);
    for (accepts = 0; accepts < packed.count; accepts += 200) {
      picture_sink sink;
      picture_sink_start(&sink, accepts);
      CHECK_EQUAL(write_either(view, NULL, colours, &options, &sink, NULL), HSP_E_SINK);
      CHECK(sink.refused == 1 && sink.odd == 0 && sink.count <= accepts);
      CHECK_BYTES(sink.bytes, packed.bytes, sink.count);
      picture_sink_release(&sink);
    }
    picture_sink_release(&plain);
    picture_sink_release(&packed);
  }
  CHECK(memory[0] == 77 && memory[HSP_PICTURE_MEMORY + 1] == 77);
}

/* A sink that refuses: at every byte of a small picture the status, the number of bytes taken, and no call after. */
static void refusing_sinks(hsp_view *of_view, hsp_map *of_map) {
  hsp_picture_options options = good_options();
  picture_sink all;
  uint32_t format, style;
  for (format = HSP_FORMAT_SVG; format <= HSP_FORMAT_PDF; ++format) {
    for (style = HSP_STYLE_FLAT; style <= HSP_STYLE_SOFT; ++style) {
      size_t accepts;
      options.format = format;
      options.style = style;
      picture_sink_start(&all, SIZE_MAX);
      CHECK_EQUAL(write_either(of_view, of_map, colours, &options, &all, NULL), HSP_OK);
      for (accepts = 0; accepts < all.count; accepts += accepts < 40 || accepts + 40 > all.count ? 1 : 37) {
        picture_sink sink;
        uint64_t bytes = 77;
        check_scene("format %u, style %u, %u of %u bytes", (unsigned)format, (unsigned)style, (unsigned)accepts,
                    (unsigned)all.count);
        picture_sink_start(&sink, accepts);
        CHECK_EQUAL(write_either(of_view, of_map, colours, &options, &sink, &bytes), HSP_E_SINK);
        CHECK_EQUAL(bytes, sink.count);
        CHECK_EQUAL(sink.refused, 1);
        CHECK_EQUAL(sink.odd, 0);
        CHECK(sink.count <= accepts);
        CHECK_BYTES(sink.bytes, all.bytes, sink.count);
        picture_sink_release(&sink);
      }
      check_scene("exactly enough");
      {
        picture_sink sink;
        picture_sink_start(&sink, all.count);
        CHECK_EQUAL(write_either(of_view, of_map, colours, &options, &sink, NULL), HSP_OK);
        CHECK_EQUAL(sink.count, all.count);
        picture_sink_release(&sink);
      }
      picture_sink_release(&all);
    }
  }
  check_scene("%s", "");
}

static void palettes(void) {
  uint32_t palette, number, chain;
  for (palette = 0; palette < 5; ++palette) {
    for (number = 0; number < 130; ++number) {
      const uint32_t colour = hsp_palette_colour(palette, number, 0);
      check_scene("palette %u, element %u", (unsigned)palette, (unsigned)number);
      CHECK(colour <= 0xFFFFFF);
      if (number == 0 || number > 118) CHECK_EQUAL(colour, hsp_palette_colour(palette, HSP_NONE, 0));
      if (palette > HSP_PALETTE_CHAIN) CHECK_EQUAL(colour, hsp_palette_colour(HSP_PALETTE_SOFT, number, 0));
      for (chain = 1; chain < 30; ++chain) {
        const uint32_t other = hsp_palette_colour(palette, number, chain);
        if (palette != HSP_PALETTE_CHAIN || chain % 12 == 0) CHECK_EQUAL(other, colour);
        CHECK_EQUAL(other, hsp_palette_colour(palette, number, chain + 12));
        if (palette == HSP_PALETTE_CHAIN && chain < 12) CHECK(other != colour);
      }
    }
  }
  CHECK_EQUAL(hsp_palette_colour(HSP_NONE, 6, 0), hsp_palette_colour(HSP_PALETTE_SOFT, 6, 0));
  CHECK_EQUAL(hsp_palette_colour(HSP_PALETTE_JMOL, 6, 5), 0x909090);
  CHECK_EQUAL(hsp_palette_colour(HSP_PALETTE_JMOL, 7, 5), 0x3050F8);
  CHECK_EQUAL(hsp_palette_colour(HSP_PALETTE_JMOL, 8, 5), 0xFF0D0D);
  CHECK(hsp_palette_colour(HSP_PALETTE_CHAIN, 6, 3) != hsp_palette_colour(HSP_PALETTE_CHAIN, 8, 3));
  check_scene("%s", "");
}

int main(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, three_balls_xyz, three_balls_radius, NULL, NULL), HSP_OK);
  options_init();
  palettes();
  states();
  bad_choices();
  bad_ink();
  bad_values();
  bad_frames();
  compressed();
  refusing_sinks(view, NULL);
  refusing_sinks(NULL, map);
  return check_report();
}
