/* Pictures of views and maps of every set of topology_sets.h in every format and style: the same bytes every time and
 * for every order of the balls but for data-ball, nothing that is not a number, one path for each piece or ball that is
 * seen, and what titles become. */
#include <hardsphere.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "map_result.h"
#include "picture_sink.h"
#include "topology_sets.h"
#include "view_result.h"

static int starts_with(const picture_sink *sink, const char *text) {
  return strncmp(sink->bytes, text, strlen(text)) == 0;
}

static uint32_t occurrences(const picture_sink *sink, const char *text) {
  uint32_t count = 0;
  const char *at = sink->bytes;
  while ((at = strstr(at, text)) != NULL) {
    ++count;
    at += strlen(text);
  }
  return count;
}

/* The object that is drawn: a view, or a map if there is no view. */
typedef struct subject {
  hsp_view *view;
  hsp_map *map;
  uint32_t paths;
} subject;

static subject of_view(const view_result *v) {
  const subject s = {v->view, NULL, v->info.pieces};
  return s;
}

static subject of_map(const map_result *m) {
  const subject s = {NULL, m->map, m->info.balls};
  return s;
}

static void write_subject(const subject *s, const uint32_t *colour, const hsp_picture_options *options,
                          const char *title, const char *description, picture_sink *sink) {
  uint64_t bytes = 77;
  int32_t status;
  picture_sink_start(sink, SIZE_MAX);
  if (s->view != NULL) {
    status = hsp_picture_write(s->view, colour, options, title, description, picture_sink_take, sink, &bytes);
  } else {
    status = hsp_picture_write_map(s->map, colour, options, title, description, picture_sink_take, sink, &bytes);
  }
  CHECK_EQUAL(status, HSP_OK);
  CHECK_EQUAL(bytes, sink->count);
  CHECK_EQUAL(sink->odd, 0);
  CHECK_EQUAL(sink->refused, 0);
}

static void write_picture(const view_result *v, const uint32_t *colour, const hsp_picture_options *options,
                          const char *title, const char *description, picture_sink *sink) {
  const subject s = of_view(v);
  write_subject(&s, colour, options, title, description, sink);
}

static void check_text(const picture_sink *sink, const hsp_picture_options *options, uint32_t paths) {
  CHECK_EQUAL(occurrences(sink, "nan"), 0);
  CHECK_EQUAL(occurrences(sink, "inf"), 0);
  if (options->format == HSP_FORMAT_SVG) {
    CHECK(occurrences(sink, "<svg") == 1 && occurrences(sink, "</svg>") == 1);
    CHECK_EQUAL(occurrences(sink, "data-ball=\""), options->flags & HSP_PICTURE_NO_IDS ? 0 : paths);
    CHECK(occurrences(sink, "<path") + occurrences(sink, "<circle") >= paths);
    CHECK_EQUAL(strlen(sink->bytes), sink->count);
  } else if (options->format == HSP_FORMAT_EPS) {
    CHECK(starts_with(sink, "%!PS-Adobe-3.0 EPSF-3.0"));
    CHECK_EQUAL(occurrences(sink, "%%BoundingBox:"), 1);
    CHECK_EQUAL(strlen(sink->bytes), sink->count);
  } else {
    CHECK(starts_with(sink, "%PDF-1."));
    CHECK(sink->count > 6 && strstr(sink->bytes + sink->count - 7, "%%EOF") != NULL);
  }
}

/* hsp_picture_write and hsp_picture_write_map, property 1: the same bytes for every order of the balls, but for the
 * values of data-ball. */
static void check_order(const picture_sink *one, const picture_sink *other) {
  size_t length = 0, other_length = 0;
  char *bare = picture_without_ids(one->bytes, one->count, &length);
  char *other_bare = picture_without_ids(other->bytes, other->count, &other_length);
  if (CHECK_EQUAL(length, other_length)) CHECK_BYTES(bare, other_bare, length);
  free(bare);
  free(other_bare);
}

/* The same balls in two orders, with their colours. */
static void every_order(const subject subjects[2], const uint32_t *colour, const uint32_t *other_colour,
                        const hsp_picture_options *options) {
  picture_sink one, again, of_other;
  write_subject(&subjects[0], colour, options, "title", NULL, &one);
  write_subject(&subjects[0], colour, options, "title", "", &again);
  write_subject(&subjects[1], other_colour, options, "title", NULL, &of_other);
  check_text(&one, options, subjects[0].paths);
  if (CHECK_EQUAL(one.count, again.count)) CHECK_BYTES(one.bytes, again.bytes, one.count);
  check_order(&one, &of_other);
  picture_sink_release(&one);
  picture_sink_release(&again);
  picture_sink_release(&of_other);
}

static void every_set(void) {
  static ball_set set, shuffled;
  static uint32_t order[BALL_SET_MOST], colour[BALL_SET_MOST], other_colour[BALL_SET_MOST];
  uint32_t which, i, format, style, invariant, id;
  for (which = 0; which < topology_set_count(); ++which) {
    computed c, other;
    view_result v, w;
    map_result m, o;
    hsp_view_options looking;
    topology_set_make(which, &set);
    ball_set_shuffle(set.n, which + 1, order);
    ball_set_permute(&set, order, &shuffled);
    /* of the place alone, so that equal balls have equal colours */
    for (i = 0; i < set.n; ++i) colour[i] = hsp_palette_colour(which % 3, (uint32_t)(8 + set.radius[i]) % 20, 0);
    for (i = 0; i < set.n; ++i) other_colour[i] = colour[order[i]];
    check_scene("%s", set.name);
    CHECK_EQUAL(hsp_view_options_init(&looking, (uint32_t)sizeof looking), HSP_OK);
    CHECK_EQUAL(hsp_view_options_turn(&looking, which % 3 * 90.0, which % 4 * 25.0, which * 10.0), HSP_OK);
    looking.pieces = which % 2;
    CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
    CHECK_EQUAL(computed_make(set.n, shuffled.xyz, shuffled.radius, NULL, &other), HSP_OK);
    memset(&w, 0, sizeof w);
    memset(&m, 0, sizeof m);
    memset(&o, 0, sizeof o);
    if (CHECK_EQUAL(view_result_make(&c, &looking, 1, &v), HSP_OK) &&
        CHECK_EQUAL(view_result_make(&other, &looking, 1, &w), HSP_OK) &&
        CHECK_EQUAL(map_result_make(&c, &looking, &m), HSP_OK) &&
        CHECK_EQUAL(map_result_make(&other, &looking, &o), HSP_OK)) {
      for (format = HSP_FORMAT_SVG; format <= HSP_FORMAT_PDF; ++format) {
        for (style = HSP_STYLE_FLAT; style <= HSP_STYLE_SOFT; ++style) {
          hsp_picture_options options;
          const subject views[2] = {of_view(&v), of_view(&w)}, maps[2] = {of_map(&m), of_map(&o)};
          check_scene("%s, format %u, style %u", set.name, (unsigned)format, (unsigned)style);
          CHECK_EQUAL(hsp_picture_options_init(&options, (uint32_t)sizeof options), HSP_OK);
          options.format = format;
          options.style = style;
          options.flags = (which + style) % 4;
          if (which % 3 == 0) options.outline = 0;
          if (which % 5 == 0) options.height = 250;
          every_order(views, colour, other_colour, &options);
          every_order(maps, colour, other_colour, &options);
        }
      }
      CHECK_EQUAL(hsp_map_check(m.map, &invariant, &id), HSP_OK);
    }
    map_result_release(&m);
    map_result_release(&o);
    view_result_release(&v);
    view_result_release(&w);
    computed_release(&c);
    computed_release(&other);
  }
  check_scene("%s", "");
}

/* ---- a small picture ---- */

static void small_picture(computed *c, view_result *v) {
  static const double xyz[6] = {0, 0, 0, 1, 1, 9}, radius[2] = {1.5, 1.25};
  hsp_view_options looking;
  CHECK_EQUAL(hsp_view_options_init(&looking, (uint32_t)sizeof looking), HSP_OK);
  CHECK_EQUAL(computed_make(2, xyz, radius, NULL, c), HSP_OK);
  CHECK_EQUAL(view_result_make(c, &looking, 0, v), HSP_OK);
}

static void titles(void) {
  static const struct {
    const char *text, *in_svg;
  } texts[] = {{"a plain title", "a plain title"},
               {"a<b & \"c\">d", "a&lt;b &amp; "},
               {"bell\x07", "bell?"},
               {"cut \xE2\x82", "cut ?"},
               {"lone \xFF byte", "lone ? byte"},
               {"\xC3\xA9t\xC3\xA9", "\xC3\xA9t\xC3\xA9"},
               {"long \xC0\xAF", "long ?"},
               {"half \xED\xA0\x80", "half ?"}};
  hsp_picture_options options;
  picture_sink sink;
  computed c;
  view_result v;
  size_t i;
  uint32_t format;
  small_picture(&c, &v);
  CHECK_EQUAL(hsp_picture_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  for (i = 0; i < sizeof texts / sizeof texts[0]; ++i) {
    for (format = HSP_FORMAT_SVG; format <= HSP_FORMAT_PDF; ++format) {
      check_scene("title %u, format %u", (unsigned)i, (unsigned)format);
      options.format = format;
      write_picture(&v, NULL, &options, texts[i].text, NULL, &sink);
      check_text(&sink, &options, v.info.pieces);
      if (format == HSP_FORMAT_SVG) CHECK_EQUAL(occurrences(&sink, texts[i].in_svg), 1);
      picture_sink_release(&sink);
      write_picture(&v, NULL, &options, "x", texts[i].text, &sink);
      if (format == HSP_FORMAT_SVG) CHECK_EQUAL(occurrences(&sink, texts[i].in_svg), 1);
      picture_sink_release(&sink);
    }
  }
  check_scene("%s", "no title");
  options.format = HSP_FORMAT_SVG;
  write_picture(&v, NULL, &options, NULL, "", &sink);
  CHECK_EQUAL(occurrences(&sink, "<title"), 0);
  CHECK_EQUAL(occurrences(&sink, "<desc"), 0);
  picture_sink_release(&sink);
  check_scene("%s", "");
  view_result_release(&v);
  computed_release(&c);
}

/* A colour as it may be written in SVG, upper or lower case. */
static uint32_t colour_occurs(const picture_sink *sink, uint32_t colour) {
  char upper[20], lower[20];
  snprintf(upper, sizeof upper, "#%06lX", (unsigned long)colour);
  snprintf(lower, sizeof lower, "#%06lx", (unsigned long)colour);
  return occurrences(sink, upper) + (strcmp(upper, lower) == 0 ? 0 : occurrences(sink, lower));
}

static void colours(void) {
  static const uint32_t colour[2] = {0x12AB9F, 0xC0FFEE};
  hsp_picture_options options;
  picture_sink sink, usual;
  computed c;
  view_result v;
  small_picture(&c, &v);
  CHECK_EQUAL(hsp_picture_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  write_picture(&v, colour, &options, NULL, NULL, &sink);
  write_picture(&v, colour, NULL, NULL, NULL, &usual);
  if (CHECK_EQUAL(sink.count, usual.count)) CHECK_BYTES(sink.bytes, usual.bytes, sink.count);
  CHECK_EQUAL(occurrences(&sink, "width=\"1000"), 1 + occurrences(&sink, "<rect width=\"1000"));
  picture_sink_release(&sink);
  picture_sink_release(&usual);
  options.fog = 0;
  options.outline = 2;
  options.outline_colour = 0x654321;
  options.background = 0xFEDCBA;
  write_picture(&v, colour, &options, NULL, NULL, &sink);
  CHECK(colour_occurs(&sink, colour[0]) > 0 && colour_occurs(&sink, colour[1]) > 0);
  CHECK(colour_occurs(&sink, options.outline_colour) > 0);
  CHECK(colour_occurs(&sink, options.background) > 0);
  picture_sink_release(&sink);
  options.outline = 0;
  options.flags = HSP_PICTURE_NO_BACKGROUND;
  write_picture(&v, NULL, &options, NULL, NULL, &sink);
  CHECK(colour_occurs(&sink, 0xD2CDC3) > 0); /* the colour of balls without one */
  CHECK_EQUAL(colour_occurs(&sink, options.outline_colour), 0);
  CHECK_EQUAL(colour_occurs(&sink, options.background), 0);
  picture_sink_release(&sink);
  options.fog = 1; /* the farthest ball becomes background, which is nowhere else */
  write_picture(&v, colour, &options, NULL, NULL, &sink);
  CHECK(colour_occurs(&sink, options.background) > 0);
  CHECK_EQUAL(colour_occurs(&sink, colour[0]), 0);
  picture_sink_release(&sink);
  view_result_release(&v);
  computed_release(&c);
}

int main(void) {
  every_set();
  titles();
  colours();
  return check_report();
}
