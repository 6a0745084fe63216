/* Balls and sticks: arguments that tests/laws says nothing about, every call out of order, and every conflict by its
 * name. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "picture_sink.h"
#include "untouched.h"

enum { BALLS = 4, STICKS = 3, PAIRS = 40, EDGES = 100 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char sticks_memory[HSP_STICKS_BYTES(BALLS, STICKS, PAIRS, EDGES)];
static hsp_model *model;
static hsp_sticks *sticks;
static hsp_sticks_info info;
static hsp_sticks_conflict conflict;
static hsp_map_info map_info;

/* A corner of a square, its neighbours, and a ball behind the middle. */
static const double xyz[3 * BALLS] = {0, 0, 0, 10, 0, 0, 0, 10, 0, 5, 5, -20};
static const double radius[BALLS] = {2, 2, 2, 1};
static const hsp_stick good[STICKS] = {{{0, 1}, 0, 0}, {{2, 0}, HSP_STICK_WHOLE, 0}, {{3, 1}, 0, 0}};

static hsp_sticks_limits good_limits(void) {
  const hsp_sticks_limits limits = {(uint32_t)sizeof limits, BALLS, STICKS, PAIRS, EDGES};
  return limits;
}

static void check_no_results(const hsp_sticks *which, int32_t status) {
  FILL(info);
  CHECK_EQUAL(hsp_sticks_get_info(which, &info), status);
  CHECK_UNTOUCHED(info);
}

static int32_t compute(const hsp_stick *stick, uint32_t count, double thick) {
  FILL(conflict);
  return hsp_sticks_compute(sticks, model, NULL, stick, count, thick, &conflict, NULL);
}

static void check_has_results(void) {
  CHECK_EQUAL(compute(good, STICKS, 0.5), HSP_OK);
  CHECK(conflict.kind == HSP_STICKS_NO_CONFLICT && conflict.first == HSP_NONE && conflict.second == HSP_NONE);
  CHECK_EQUAL(hsp_sticks_get_info(sticks, &info), HSP_OK);
  CHECK(info.paths == 9 && info.balls == BALLS && info.sticks == STICKS);
  CHECK(info.arcs == 26 || info.arcs == 27); /* 20 of sticks; one of a whole circle, else two for each stick in front */
  CHECK(fabs(info.low[0] + info.origin[0] + 2) < 1e-6 && fabs(info.high[1] + info.origin[1] - 12) < 1e-6);
  CHECK(info.towards[2] == 1 && info.up[1] == 1 && info.right[0] == 1);
}

static void default_limits(void) {
  hsp_sticks_limits limits;
  CHECK_EQUAL(hsp_sticks_limits_init(&limits, (uint32_t)sizeof limits, (HSP_MAX_BALLS - 64) / 64 + 1), HSP_E_RANGE);
  CHECK_EQUAL(hsp_sticks_limits_init(&limits, (uint32_t)sizeof limits, 10), HSP_OK);
  CHECK(limits.balls == 10 && limits.sticks == 20 && limits.pairs == 704 && limits.edges == 0);
}

/* Numbers of the handle's own that do not suffice. */
static void small_limits(void) {
  static const hsp_sticks_limits small[] = {
      {(uint32_t)sizeof small[0], BALLS - 1, STICKS, PAIRS, 0},
      {(uint32_t)sizeof small[0], BALLS, STICKS - 1, PAIRS, 0},
      {(uint32_t)sizeof small[0], BALLS, STICKS, 3, 0},
      {(uint32_t)sizeof small[0], 0, 0, 0, 0},
  };
  size_t which;
  for (which = 0; which < sizeof small / sizeof small[0]; ++which) {
    hsp_sticks_limits asked = small[which];
    int retries = 0;
    int32_t status;
    for (;; ++retries) {
      CHECK_EQUAL(hsp_sticks_init(sticks_memory, sizeof sticks_memory, &asked, &sticks), HSP_OK);
      status = hsp_sticks_compute(sticks, model, NULL, good, STICKS, 0.5, NULL, &asked);
      if (status != HSP_E_CAPACITY || retries == 2) break;
      check_no_results(sticks, HSP_E_STATE);
    }
    CHECK_EQUAL(status, HSP_OK);
    CHECK(retries > 0);
    CHECK(asked.balls == BALLS && asked.sticks == STICKS && asked.pairs > 3 && asked.pairs <= PAIRS);
  }
}

static void check_refused(const hsp_stick *stick, uint32_t count, double thick, int32_t expected) {
  check_has_results();
  CHECK_EQUAL(compute(stick, count, thick), expected);
  CHECK_UNTOUCHED(conflict);
  check_no_results(sticks, HSP_E_STATE);
}

static void computing(void) {
  hsp_sticks_limits asked = good_limits();
  hsp_view_options options;
  hsp_stick bad = good[0];
  CHECK_EQUAL(hsp_sticks_init(sticks_memory, sizeof sticks_memory, &asked, &sticks), HSP_OK);
  check_has_results();
  bad.flags = 16;
  check_refused(&bad, 1, 0.5, HSP_E_ARGUMENT);
  bad.flags = HSP_STICK_DOUBLE | HSP_STICK_AROMATIC;
  check_refused(&bad, 1, 0.5, HSP_E_ARGUMENT);
  bad.flags = HSP_STICK_TRIPLE | HSP_STICK_WHOLE;
  CHECK_EQUAL(compute(&bad, 1, 1.2), HSP_OK);
  CHECK_EQUAL(compute(&bad, 1, 1.4), HSP_E_CONFLICT);
  CHECK_EQUAL(conflict.kind, HSP_STICKS_THIN_BALL);
  check_refused(good, STICKS, 0, HSP_E_RANGE);
  CHECK_EQUAL(compute(NULL, 0, 0.5), HSP_OK);
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.flags = 2;
  CHECK_EQUAL(hsp_sticks_compute(sticks, model, &options, good, STICKS, 0.5, NULL, NULL), HSP_E_ARGUMENT);
  check_no_results(sticks, HSP_E_STATE);
}

static void check_conflict(const hsp_stick *stick, uint32_t count, double thick, uint32_t kind, uint32_t first,
                           uint32_t second) {
  check_has_results();
  CHECK_EQUAL(compute(stick, count, thick), HSP_E_CONFLICT);
  CHECK_EQUAL(conflict.kind, kind);
  CHECK_EQUAL(conflict.first, first);
  CHECK_EQUAL(conflict.second, second);
  CHECK_EQUAL(conflict.reserved, 0);
  check_no_results(sticks, HSP_E_STATE);
}

static void conflicts(void) {
  static const hsp_stick beyond = {{0, BALLS}, 0, 0}, point = {{2, 2}, 0, 0};
  static const hsp_stick twice[2] = {{{0, 1}, 0, 0}, {{1, 0}, 0, 0}};
  static const hsp_stick across[2] = {{{0, 1}, 0, 0}, {{2, 0}, 0, 0}};
  check_conflict(&beyond, 1, 0.5, HSP_STICKS_NO_BALL, 0, BALLS);
  check_conflict(&point, 1, 0.5, HSP_STICKS_SAME_ENDS, 0, 0);
  check_conflict(twice, 2, 0.5, HSP_STICKS_SAME_ENDS, 0, 1);
  check_conflict(good, STICKS, 1.25, HSP_STICKS_THIN_BALL, 2, 3);
  check_conflict(across, 2, 1.5, HSP_STICKS_SHARP_ANGLE, 0, 1); /* 2 < 1.5 sqrt(2) */
  CHECK_EQUAL(compute(across, 2, 1.4), HSP_OK);
}

static int32_t write_picture(hsp_sticks *which, const uint32_t *colour, const hsp_picture_options *options,
                             picture_sink *sink) {
  uint64_t bytes = 1;
  int32_t status;
  picture_sink_start(sink, SIZE_MAX);
  status = hsp_picture_write_sticks(which, colour, options, "a <title>", NULL, picture_sink_take, sink, &bytes);
  CHECK_EQUAL(bytes, sink->count);
  if (status != HSP_OK) CHECK_EQUAL(bytes, 0);
  return status;
}

/* Balls that meet: no order, but what is seen of each. */
static void without_order(void) {
  static const double meeting[BALLS] = {2, 8.5, 2, 1};
  const uint32_t colours[BALLS] = {0x112233, 0x445566, 0x778899, 0xAABBCC};
  hsp_sticks_limits asked = good_limits();
  hsp_picture_options options;
  picture_sink sink;
  int retries = 0;
  int32_t status;
  CHECK_EQUAL(hsp_picture_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, meeting, NULL, NULL), HSP_OK);
  CHECK_EQUAL(compute(good, 2, 0.5), HSP_OK);
  CHECK_EQUAL(conflict.kind, HSP_STICKS_BALLS_MEET);
  CHECK(conflict.first == 0 && conflict.second == 1);
  CHECK_EQUAL(hsp_sticks_get_info(sticks, &info), HSP_OK);
  CHECK(info.sticks == 2 && info.balls == 3 && info.paths == 4); /* a stick and a ball are hidden */
  CHECK(info.arcs > 6 && info.arcs < 40);
  if (CHECK_EQUAL(write_picture(sticks, colours, &options, &sink), HSP_OK)) {
    CHECK(strstr(sink.bytes, "data-ball=\"1\"") != NULL && strstr(sink.bytes, "data-ball=\"3\"") == NULL);
  }
  picture_sink_release(&sink);
  asked.edges = 0;
  for (;; ++retries) {
    CHECK_EQUAL(hsp_sticks_init(sticks_memory, sizeof sticks_memory, &asked, &sticks), HSP_OK);
    status = hsp_sticks_compute(sticks, model, NULL, good, 2, 0.5, NULL, &asked);
    if (status != HSP_E_CAPACITY || retries == 12) break;
    check_no_results(sticks, HSP_E_STATE);
  }
  CHECK_EQUAL(status, HSP_OK);
  CHECK(retries > 0 && asked.edges > 6 && asked.edges <= EDGES);
  asked.edges -= 1;
  CHECK_EQUAL(hsp_sticks_init(sticks_memory, sizeof sticks_memory, &asked, &sticks), HSP_OK);
  CHECK_EQUAL(hsp_sticks_compute(sticks, model, NULL, good, 2, 0.5, NULL, NULL), HSP_E_CAPACITY);
  asked = good_limits();
  CHECK_EQUAL(hsp_sticks_init(sticks_memory, sizeof sticks_memory, &asked, &sticks), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
}

static void check_no_picture(const hsp_picture_options *options) {
  picture_sink sink;
  CHECK_EQUAL(write_picture(sticks, NULL, options, &sink), HSP_E_ARGUMENT);
  picture_sink_release(&sink);
}

/* Contours need a live handle with a map of the same sticks from the same direction, and no map of balls. */
static void bad_ink(void) {
  static unsigned char ink_memory[HSP_STICKS_BYTES(BALLS, STICKS, PAIRS, EDGES)];
  static unsigned char balls_memory[HSP_MAP_BYTES(BALLS, BALLS, EDGES)];
  const hsp_sticks_limits limits = good_limits();
  const hsp_map_limits of_balls = {.struct_size = sizeof of_balls, .balls = BALLS, .neighbours = BALLS, .edges = EDGES};
  const hsp_stick others[STICKS] = {{{0, 1}, 0, 0}, {{2, 0}, 0, 0}, {{3, 1}, 0, 0}};
  hsp_picture_options options;
  hsp_view_options sideways;
  picture_sink plain, inked;
  hsp_sticks *ink;
  hsp_map *map;
  CHECK_EQUAL(hsp_picture_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK(options.ink_of_sticks == NULL);
  CHECK_EQUAL(hsp_view_options_init(&sideways, (uint32_t)sizeof sideways), HSP_OK);
  sideways.towards[0] = 1;
  CHECK_EQUAL(hsp_sticks_init(ink_memory, sizeof ink_memory, &limits, &ink), HSP_OK);
  CHECK_EQUAL(hsp_map_init(balls_memory, sizeof balls_memory, &of_balls, &map), HSP_OK);
  CHECK_EQUAL(hsp_map_compute(map, model, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(write_picture(sticks, NULL, &options, &plain), HSP_OK);
  options.ink_of_sticks = ink;
  check_no_picture(&options);
  CHECK_EQUAL(hsp_sticks_compute(ink, model, NULL, good, STICKS, 0.5, NULL, NULL), HSP_OK);
  check_no_picture(&options); /* an order, and no map */
  CHECK_EQUAL(hsp_sticks_compute_map(ink, model, NULL, good, 2, 0.5, NULL, NULL), HSP_OK);
  check_no_picture(&options);
  CHECK_EQUAL(hsp_sticks_compute_map(ink, model, NULL, others, STICKS, 0.5, NULL, NULL), HSP_OK);
  check_no_picture(&options); /* one is in halves */
  CHECK_EQUAL(hsp_sticks_compute_map(ink, model, NULL, good, STICKS, 0.4, NULL, NULL), HSP_OK);
  check_no_picture(&options);
  CHECK_EQUAL(hsp_sticks_compute_map(ink, model, &sideways, good, STICKS, 0.5, NULL, NULL), HSP_OK);
  check_no_picture(&options);
  CHECK_EQUAL(hsp_sticks_compute_map(ink, model, NULL, good, STICKS, 0.5, NULL, NULL), HSP_OK);
  options.ink = map;
  check_no_picture(&options);
  picture_sink_start(&inked, SIZE_MAX);
  CHECK_EQUAL(hsp_picture_write_map(map, NULL, &options, NULL, NULL, picture_sink_take, &inked, NULL), HSP_E_ARGUMENT);
  options.ink = NULL;
  options.ink_of_sticks = (const hsp_sticks *)(const void *)map; /* what a compiler refuses without a cast */
  CHECK_EQUAL(hsp_picture_write_sticks(sticks, NULL, &options, NULL, NULL, picture_sink_take, &inked, NULL),
              HSP_E_HANDLE);
  picture_sink_release(&inked);
  options.ink_of_sticks = ink;
  if (CHECK_EQUAL(write_picture(sticks, NULL, &options, &inked), HSP_OK)) {
    CHECK(strstr(plain.bytes, "class=") == NULL && strstr(inked.bytes, "class=\"border\"") != NULL);
    CHECK(strstr(inked.bytes, "class=\"depth\"") != NULL);
  }
  picture_sink_release(&plain);
  picture_sink_release(&inked);
  CHECK_EQUAL(write_picture(ink, NULL, &options, &inked), HSP_OK); /* of the map itself */
  picture_sink_release(&inked);
}

static void check_no_map(hsp_sticks *which, int32_t status) {
  CHECK_EQUAL(hsp_sticks_get_map_info(which, &map_info), status);
}

static void refused_records(void) {
  hsp_map_vertex vertex;
  hsp_map_edge edge;
  hsp_map_face face;
  hsp_map_point point;
  uint32_t needed = 0;
  CHECK_EQUAL(hsp_sticks_get_vertices(sticks, map_info.vertices, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_edges(sticks, map_info.edges, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_faces(sticks, map_info.faces, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_vertices(sticks, map_info.vertices, 1, &vertex), HSP_E_ID);
  CHECK_EQUAL(hsp_sticks_get_edges(sticks, map_info.edges, 1, &edge), HSP_E_ID);
  CHECK_EQUAL(hsp_sticks_get_faces(sticks, map_info.faces, 1, &face), HSP_E_ID);
  CHECK_EQUAL(hsp_sticks_get_faces(sticks, 1, HSP_NONE, &face), HSP_E_ID);
  CHECK_EQUAL(hsp_sticks_get_outline(sticks, HSP_NONE, NULL, 0, &needed), HSP_E_ID);
  CHECK_EQUAL(hsp_sticks_get_outline(sticks, 0, NULL, 0, &needed), HSP_E_CAPACITY);
  CHECK(needed >= 1);
  CHECK_EQUAL(hsp_sticks_get_point(sticks, 0, 7, &point), HSP_E_RANGE);
}

/* The body seen at a point of the file's coordinates, which are those of the view but for the origin. */
static uint32_t seen_at(double x, double y, double depth) {
  hsp_map_sight sight;
  CHECK_EQUAL(hsp_sticks_pick(sticks, x - map_info.origin[0], y - map_info.origin[1], &sight), HSP_OK);
  CHECK(sight.face != HSP_NONE);
  if (sight.ball == HSP_NONE) {
    CHECK(isinf(sight.depth));
  } else {
    CHECK(fabs(sight.depth + map_info.origin[2] - depth) < 1e-6 + 8 * map_info.perturbation);
  }
  return sight.ball;
}

static uint32_t half_of(uint32_t stick, uint32_t half) {
  return HSP_STICKS_HALF(UINT32_C(4), stick, half);
}

/* A map where there is an order too: numbers, records and answers. */
static void maps(void) {
  static const hsp_stick turned = {{1, 3}, 0, 0};
  static hsp_map_vertex vertex[EDGES];
  static hsp_map_edge edge[EDGES];
  static hsp_map_face face[EDGES];
  const double slope = 20 / sqrt(450.0); /* how steep the third stick is: the depth of its front over its axis */
  double area[BALLS + 2 * STICKS], sum = 0;
  uint32_t needed = 0, invariant = 1, id = 1, k, kinds[5] = {0, 0, 0, 0, 0};
  hsp_sticks_info other;
  check_has_results();
  check_no_map(sticks, HSP_E_STATE);
  CHECK_EQUAL(hsp_sticks_compute_map(sticks, model, NULL, good, STICKS, 0, NULL, NULL), HSP_E_RANGE);
  check_no_map(sticks, HSP_E_STATE);
  CHECK_EQUAL(hsp_sticks_compute_map(sticks, model, NULL, good, STICKS, 0.5, &conflict, NULL), HSP_OK);
  CHECK_EQUAL(conflict.kind, HSP_STICKS_NO_CONFLICT);
  CHECK_EQUAL(hsp_sticks_get_map_info(sticks, &map_info), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_info(sticks, &other), HSP_OK);
  CHECK(other.paths == 9 && other.balls == BALLS && map_info.balls == BALLS);
  CHECK(map_info.vertices + map_info.faces == map_info.edges + 1 + map_info.components);
  CHECK(map_info.components == 1 && map_info.edges <= EDGES && map_info.perturbation < 1e-4);
  CHECK_EQUAL(hsp_sticks_check(sticks, &invariant, &id), HSP_OK);
  CHECK(invariant == 0 && id == HSP_NONE);
  refused_records();
  CHECK_EQUAL(hsp_sticks_get_vertices(sticks, 0, map_info.vertices, vertex), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_edges(sticks, 0, map_info.edges, edge), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_faces(sticks, 0, map_info.faces, face), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_areas(sticks, area, BALLS + 2 * STICKS, &needed), HSP_OK);
  CHECK(area[half_of(1, 1)] == 0 && area[half_of(1, 0)] > 0 && area[half_of(0, 0)] > 0 && area[half_of(0, 1)] > 0);
  for (k = 0; k < BALLS + 2 * STICKS; ++k) sum += area[k];
  CHECK(fabs(sum - map_info.area) < 1e-9);
  for (k = 1; k < map_info.faces; ++k) {
    if (face[k].ball != HSP_NONE) area[face[k].ball] -= face[k].area;
  }
  for (k = 0; k < BALLS + 2 * STICKS; ++k) CHECK(fabs(area[k]) < 1e-9);
  for (k = 0; k < map_info.vertices; ++k) ++kinds[vertex[k].kind];
  /* Each of two halves has two with the other half; two at the foot of each stick that is not steep. */
  CHECK(kinds[HSP_MAP_PLAIN] == 0 && kinds[HSP_MAP_TRIPLE] == 0 && kinds[HSP_MAP_HALVES] == 4);
  CHECK(kinds[HSP_MAP_TANGENCY] >= 6 && kinds[HSP_MAP_T] >= 4);
  for (k = 0; k < map_info.edges; ++k) {
    const hsp_map_edge *e = &edge[k];
    int end;
    for (end = 0; end < 2; ++end) {
      const double t = end == 0 ? e->from : e->to;
      const double x = e->centre[0] + cos(t) * e->first[0] + sin(t) * e->second[0];
      const double y = e->centre[1] + cos(t) * e->first[1] + sin(t) * e->second[1];
      const hsp_map_vertex *v = &vertex[e->vertex[end]];
      CHECK(fabs(v->xyz[0] - x) < 1e-6 && fabs(v->xyz[1] - y) < 1e-6);
    }
    CHECK(face[e->face[0]].ball == e->ball[0]);
    CHECK(e->ball[1] == HSP_NONE || face[e->face[1]].ball == e->ball[1]);
    /* of the level stick along the x axis the two lines */
    if (e->ball[0] == half_of(0, 0) && e->ball[1] == HSP_NONE) CHECK(e->second[0] == 0 && e->second[1] == 0);
  }
  CHECK_EQUAL(seen_at(0.5, 0, sqrt(3.75)), 0);
  CHECK_EQUAL(seen_at(4, 0, 0.5), half_of(0, 0));
  CHECK_EQUAL(seen_at(6, 0, 0.5), half_of(0, 1));
  CHECK_EQUAL(seen_at(0, 4, 0.5), half_of(1, 0));
  CHECK_EQUAL(seen_at(0, 7, 0.5), half_of(1, 0));
  CHECK_EQUAL(seen_at(4.6, 5.4, -20 + sqrt(1 - 2 * 0.4 * 0.4)), 3);
  CHECK_EQUAL(seen_at(5, 5, -20 + 0.5 / sqrt(1 - slope * slope)), half_of(2, 0));
  CHECK_EQUAL(seen_at(8, 2, -8 + 0.5 / sqrt(1 - slope * slope)), half_of(2, 1));
  CHECK_EQUAL(seen_at(4, 9, 0), HSP_NONE);
  CHECK_EQUAL(seen_at(1e300, -1e300, 0), HSP_NONE);
  /* The steep one from its nearer ball, as the only one. */
  CHECK_EQUAL(hsp_sticks_compute_map(sticks, model, NULL, &turned, 1, 0.5, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_map_info(sticks, &map_info), HSP_OK);
  CHECK_EQUAL(seen_at(8, 2, -8 + 0.5 / sqrt(1 - slope * slope)), half_of(0, 0));
  CHECK_EQUAL(seen_at(5, 5, -20 + 0.5 / sqrt(1 - slope * slope)), half_of(0, 1));
  CHECK(map_info.components == 3);
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, xyz, radius, NULL, NULL), HSP_OK);
  check_no_map(sticks, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_map_info(sticks, &map_info), HSP_OK);
}

/* Arcs of the outlines of two balls and the stick between them. */
static uint32_t arcs_with(uint32_t flags) {
  const hsp_stick stick = {{0, 1}, flags, 0};
  CHECK_EQUAL(compute(&stick, 1, 0.5), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_info(sticks, &info), HSP_OK);
  return info.arcs;
}

/* Each strand has an outline. */
static void strands(void) {
  const uint32_t one = arcs_with(0), two = arcs_with(HSP_STICK_DOUBLE), three = arcs_with(HSP_STICK_TRIPLE);
  CHECK(one < two && two < three);
  CHECK_EQUAL(three - two, two - one);
}

/* One path for each ball and part of a stick, with its colour. */
static void pictures(void) {
  static const uint32_t colours[BALLS] = {0x112233, 0x445566, 0x778899, 0xAABBCC};
  static const uint32_t too_bright[BALLS] = {0x112233, 0x445566, 0x778899, 0x1000000};
  hsp_picture_options options;
  picture_sink sink;
  uint32_t style;
  CHECK_EQUAL(hsp_picture_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(write_picture(NULL, colours, &options, &sink), HSP_E_ARGUMENT);
  picture_sink_release(&sink);
  check_has_results();
  CHECK_EQUAL(write_picture(sticks, too_bright, &options, &sink), HSP_E_ARGUMENT);
  picture_sink_release(&sink);
  options.fog = 2;
  CHECK_EQUAL(write_picture(sticks, colours, &options, &sink), HSP_E_RANGE);
  picture_sink_release(&sink);
  options.fog = 0;
  for (style = HSP_STYLE_FLAT; style <= HSP_STYLE_SOFT; ++style) {
    options.style = style;
    if (CHECK_EQUAL(write_picture(sticks, colours, &options, &sink), HSP_OK)) {
      const char *at;
      int paths = 0, plain = 0;
      CHECK_EQUAL(sink.odd, 0);
      for (at = strchr(sink.bytes, '<'); at != NULL; at = strchr(at + 1, '<')) {
        if (strncmp(at, "<path", 5) != 0 && strncmp(at, "<circle", 7) != 0) continue;
        ++paths;
        plain += strstr(at, "fill=\"#") == strstr(at, "fill=");
      }
      CHECK_EQUAL(paths, 9);
      CHECK_EQUAL(plain, style == HSP_STYLE_FLAT ? 9 : 5);
    }
    picture_sink_release(&sink);
  }
  CHECK_EQUAL(compute(NULL, 1, 0.5), HSP_E_ARGUMENT);
  CHECK_EQUAL(write_picture(sticks, colours, &options, &sink), HSP_E_STATE);
  picture_sink_release(&sink);
}

static void order_of_calls(void) {
  const hsp_sticks_limits limits = good_limits();
  check_has_results();
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, xyz, radius, NULL, NULL), HSP_OK);
  check_no_results(sticks, HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_sticks_get_info(sticks, &info), HSP_OK);
  CHECK_EQUAL(hsp_sticks_init(sticks_memory, sizeof sticks_memory, &limits, &sticks), HSP_OK);
  check_no_results(sticks, HSP_E_STATE);
}

int main(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
  default_limits();
  computing();
  conflicts();
  without_order();
  bad_ink();
  maps();
  strands();
  pictures();
  order_of_calls();
  small_limits();
  return check_report();
}
