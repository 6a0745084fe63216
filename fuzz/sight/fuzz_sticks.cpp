// Balls and sticks of any set: a painting order or a named conflict; pictures, some with contours; the same twice; no
// effect of the order of the balls; limits that are too small. Maps of balls and sticks: their invariants, the bodies
// seen at points against all balls and cylinders (tests/oracle/seen_cylinders.hpp), and limits.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "computed_set.hpp"
#include "owned_views.hpp"
#include "picture_calls.hpp"
#include "required_limits.hpp"
#include "seen_cylinders.hpp"
#include "topology_input.hpp"
#include "view_input.hpp"

namespace {

// Balls on a loose lattice, which rarely meet, or any set.
fuzz::ScaledBalls stick_set(fuzz::Bytes &bytes) {
  if (bytes.one_in(4)) return fuzz::topology_set(bytes);
  fuzz::ScaledBalls set;
  const uint32_t n = bytes.below(12);
  for (uint32_t k = 0; k < n; ++k) {
    oracle::LatticePoint centre{};
    for (int64_t &coordinate : centre) coordinate = 16 * int64_t{bytes.below(6)};
    centre[2] += bytes.below(16);
    set.balls.push_back(oracle::ball_around(centre, bytes.below(9)));
  }
  return set;
}

std::vector<hsp_stick> sticks_between(uint32_t n, fuzz::Bytes &bytes) {
  static constexpr uint32_t kinds[] = {0, 0, 0, HSP_STICK_DOUBLE, HSP_STICK_TRIPLE, HSP_STICK_AROMATIC};
  std::vector<hsp_stick> sticks(bytes.below(12));
  for (hsp_stick &stick : sticks) {
    stick = {{bytes.below(n + (bytes.one_in(16) ? 1 : 0) + (n == 0 ? 1 : 0)), 0}, bytes.below(2), 0};
    stick.flags |= kinds[bytes.below(6)];
    stick.ball[1] = n == 0 ? 0 : bytes.below(n);
  }
  return sticks;
}

struct Result {
  int32_t status;
  hsp_sticks_conflict conflict;
  hsp_sticks_limits needed;
  hsp_sticks_info info;
};

Result computed_with(const hsp_model *model, const hsp_view_options &options, const std::vector<hsp_stick> &stick,
                     double radius) {
  Result result{};
  const auto count = static_cast<uint32_t>(stick.size());
  // Limits that suffice for so few balls.
  result.needed = {sizeof result.needed, 200, 200, 200 * 200, 4000};
  support::OwnedHandle<support::SticksKind> sticks;
  sticks.take(result.needed);
  result.status =
      hsp_sticks_compute(sticks.get(), model, &options, stick.data(), count, radius, &result.conflict, &result.needed);
  // A stick far thinner than roundings has both its sides on one line.
  const bool thin = radius < 1e-9;
  FUZZ_REQUIRE(
      result.status == HSP_OK || result.status == HSP_E_CONFLICT || (thin && result.status == HSP_E_DEGENERATE),
      hsp_status_text(result.status));
  const int32_t read = hsp_sticks_get_info(sticks.get(), &result.info);
  FUZZ_REQUIRE(read == (result.status == HSP_OK ? HSP_OK : HSP_E_STATE), "results, by the status");
  return result;
}

// The ids of a conflict must be those of balls or of sticks, as its kind says.
void require_named(const Result &result, uint32_t n, uint32_t count) {
  if (result.status == HSP_E_DEGENERATE) return;
  const uint32_t kind = result.conflict.kind, first = result.conflict.first, second = result.conflict.second;
  const bool without_order = kind == HSP_STICKS_BALLS_MEET || kind == HSP_STICKS_CYCLE;
  FUZZ_REQUIRE((result.status == HSP_OK) == (kind == HSP_STICKS_NO_CONFLICT || without_order),
               "a conflict, by the status");
  FUZZ_REQUIRE(result.status != HSP_OK || (result.needed.edges > 0) == without_order, "edges, by the order");
  if (result.status == HSP_OK) {
    FUZZ_REQUIRE(result.info.balls <= n && result.info.sticks == count, "numbers of info");
    FUZZ_REQUIRE(result.info.paths <= result.info.balls + 2 * count, "paths of info");
  }
  switch (kind) {
    case HSP_STICKS_NO_CONFLICT:
      FUZZ_REQUIRE(first == HSP_NONE && second == HSP_NONE, "no conflict");
      break;
    case HSP_STICKS_BALLS_MEET:
      FUZZ_REQUIRE(first < second && second < n, "two balls");
      break;
    case HSP_STICKS_NO_BALL:
      FUZZ_REQUIRE(first < count && second >= n, "a stick without a ball");
      break;
    case HSP_STICKS_THIN_BALL:
    case HSP_STICKS_STICK_IN_BALL:
      FUZZ_REQUIRE(first < count && second < n, "a stick and a ball");
      break;
    case HSP_STICKS_CYCLE:
      FUZZ_REQUIRE(first < count && second > 2, "a stick of a cycle");
      break;
    default:
      FUZZ_REQUIRE(kind <= HSP_STICKS_CYCLE && first <= second && second < count, "two sticks");
  }
}

// Balls and sticks in view coordinates, by the numbers of their map.
struct PlainScene {
  std::vector<oracle::PlainBall> balls;
  std::vector<oracle::PlainCylinder> cylinders;
  double largest = 0;

  struct Highest {
    uint32_t number = HSP_NONE;
    double depth = -HUGE_VAL;
    double runner_up = -HUGE_VAL;

    void take(uint32_t other, double front) {
      if (front > depth) number = other;
      runner_up = std::fmax(runner_up, std::fmin(front, depth));
      depth = std::fmax(depth, front);
    }
  };

  Highest highest_at(double x, double y) const {
    Highest highest;
    const auto n = static_cast<uint32_t>(balls.size());
    for (uint32_t i = 0; i < n; ++i)
      if (balls[i].radius > 0) highest.take(i, oracle::front_of(balls[i], x, y));
    for (uint32_t k = 0; k < cylinders.size(); ++k) {
      const oracle::CylinderFront front = oracle::front_of(cylinders[k], x, y);
      highest.take(HSP_STICKS_HALF(n, k, front.part < cylinders[k].change ? 0 : 1), front.depth);
    }
    return highest;
  }
};

PlainScene scene_of(const fuzz::ScaledBalls &set, const std::vector<hsp_stick> &sticks, double of_one,
                    const hsp_map_info &info) {
  PlainScene scene;
  const support::BallList list = set.in_lengths();
  oracle::ViewAxes axes;
  std::copy(info.origin, info.origin + 3, axes.origin.begin());
  std::copy(info.right, info.right + 3, axes.right.begin());
  std::copy(info.up, info.up + 3, axes.up.begin());
  std::copy(info.towards, info.towards + 3, axes.towards.begin());
  for (size_t i = 0; i < list.radius.size(); ++i) {
    scene.balls.push_back(
        {axes.coordinates({list.xyz[3 * i], list.xyz[3 * i + 1], list.xyz[3 * i + 2]}), set.length(set.radius_of(i))});
    scene.largest = std::fmax(scene.largest, scene.balls[i].radius);
  }
  for (const hsp_stick &stick : sticks) {
    const oracle::PlainBall &one = scene.balls[stick.ball[0]], &two = scene.balls[stick.ball[1]];
    const double radius = (stick.flags & ~HSP_STICK_WHOLE) == 0 ? of_one : 1.5 * of_one;
    const double length =
        std::hypot(two.centre[0] - one.centre[0], two.centre[1] - one.centre[1], two.centre[2] - one.centre[2]);
    const double out = std::sqrt((one.radius - radius) * (one.radius + radius));
    const double in = std::sqrt((two.radius - radius) * (two.radius + radius));
    const bool whole = (stick.flags & HSP_STICK_WHOLE) != 0;
    scene.cylinders.push_back({one.centre, two.centre, radius, whole ? 2 : (out + length - in) / (2 * length)});
  }
  return scene;
}

// The owners seen at some points where they are the same all around.
void require_sights(const hsp_sticks *sticks, const hsp_map_info &info, const hsp_sticks_info &box,
                    const PlainScene &scene, const std::vector<hsp_map_face> &faces, fuzz::Bytes &bytes) {
  const double close = 1e-6 * scene.largest + 8 * info.perturbation;
  for (int sample = 0; sample < 8; ++sample) {
    const double right = bytes.below(256) / 255.0, up = bytes.below(256) / 255.0;
    const double x = box.low[0] + 1.0001 * right * (box.high[0] - box.low[0]);
    const double y = box.low[1] + 1.0001 * up * (box.high[1] - box.low[1]);
    const PlainScene::Highest highest = scene.highest_at(x, y);
    const uint32_t seen = highest.number;
    bool sure = seen == HSP_NONE || highest.depth - highest.runner_up > close;
    for (int side = 0; side < 4; ++side) {
      const double aside[2] = {side < 2 ? close : -close, side % 2 == 0 ? close : -close};
      if (scene.highest_at(x + aside[0], y + aside[1]).number != seen) sure = false;
    }
    hsp_map_sight sight{};
    FUZZ_REQUIRE(hsp_sticks_pick(sticks, x, y, &sight) == HSP_OK, "a sight anywhere");
    FUZZ_REQUIRE(sight.face == HSP_NONE || faces[sight.face].ball == sight.ball, "the face of a sight");
    if (!sure) continue;
    FUZZ_REQUIRE(sight.ball == seen, "another one is seen");
    FUZZ_REQUIRE(sight.face != HSP_NONE, "no face away from edges");
    if (seen != HSP_NONE) FUZZ_REQUIRE(std::fabs(sight.depth - highest.depth) < 0.05 * scene.largest, "another depth");
  }
}

// A point of any edge, a pole of any face and the outline of any ball or half of a stick.
void require_answers(const hsp_sticks *sticks, uint32_t bodies, const hsp_map_info &info,
                     const std::vector<hsp_map_edge> &edges, const std::vector<hsp_map_face> &faces,
                     fuzz::Bytes &bytes) {
  const uint32_t e = bytes.below(info.edges + 1), f = bytes.below(info.faces + 1), body = bytes.below(bodies + 1);
  hsp_map_point point{};
  const int32_t of_edge = hsp_sticks_get_point(sticks, e, e < info.edges ? edges[e].from : 0, &point);
  FUZZ_REQUIRE(of_edge == (e < info.edges ? HSP_OK : HSP_E_ID), "a point of any edge");
  FUZZ_REQUIRE(point.gap[0] == 0 && point.gap[1] >= 0, "the gaps of a point");
  hsp_map_pole pole{};
  const int32_t of_face = hsp_sticks_get_pole(sticks, f, &pole);
  FUZZ_REQUIRE(of_face == (f == 0 || f >= info.faces ? HSP_E_ID : HSP_OK), "the status of a pole");
  FUZZ_REQUIRE(pole.radius >= 0 && pole.bound >= pole.radius && std::isfinite(pole.bound), "the radius of a pole");
  if (of_face == HSP_OK)
    FUZZ_REQUIRE(3.1415 * pole.radius * pole.radius <= faces[f].area * (1 + 1e-6), "a circle larger than its face");
  std::vector<uint32_t> outline(info.edges + 1);
  uint32_t loops = 0;
  const int32_t of_body =
      hsp_sticks_get_outline(sticks, body, outline.data(), static_cast<uint32_t>(outline.size()), &loops);
  FUZZ_REQUIRE(of_body == (body < bodies ? HSP_OK : HSP_E_ID), "the outline of any number");
  for (uint32_t k = 0; k < loops; ++k)
    FUZZ_REQUIRE(faces[edges[outline[k] / 2].face[outline[k] % 2]].ball == body, "an outline around another one");
}

// The map of the same balls and sticks must be sound and show at points the body that is seen there.
void require_map(const fuzz::ScaledBalls &set, const hsp_model *model, const hsp_view_options &options,
                 const std::vector<hsp_stick> &stick, double radius, const Result &reference, fuzz::Bytes &bytes) {
  const auto count = static_cast<uint32_t>(stick.size());
  support::OwnedHandle<support::SticksKind> sticks;
  hsp_sticks_limits needed_limits{sizeof needed_limits, 200, 200, 200 * 200, 4000};
  sticks.take(needed_limits);
  const auto compute = [&](hsp_sticks *handle, hsp_sticks_limits *limits) {
    return hsp_sticks_compute_map(handle, model, &options, stick.data(), count, radius, nullptr, limits);
  };
  const int32_t status = compute(sticks.get(), &needed_limits);
  hsp_map_info info{};
  if (reference.status != HSP_OK || status == HSP_E_DEGENERATE) {
    FUZZ_REQUIRE(status == reference.status || status == HSP_E_DEGENERATE, "a map by another status");
    FUZZ_REQUIRE(hsp_sticks_get_map_info(sticks.get(), &info) == HSP_E_STATE, "a map after a failure");
    return;
  }
  FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
  FUZZ_REQUIRE(hsp_sticks_get_map_info(sticks.get(), &info) == HSP_OK, "hsp_sticks_get_map_info");
  uint32_t invariant = 0, id = 0, needed = 0;
  FUZZ_REQUIRE(hsp_sticks_check(sticks.get(), &invariant, &id) == HSP_OK, "an invariant of the map");
  std::vector<hsp_map_vertex> vertices(info.vertices);
  std::vector<hsp_map_edge> edges(info.edges);
  std::vector<hsp_map_face> faces(info.faces);
  std::vector<double> area(set.n() + 2 * size_t{count});
  FUZZ_REQUIRE(hsp_sticks_get_vertices(sticks.get(), 0, info.vertices, vertices.data()) == HSP_OK, "vertices");
  FUZZ_REQUIRE(hsp_sticks_get_edges(sticks.get(), 0, info.edges, edges.data()) == HSP_OK, "edges");
  FUZZ_REQUIRE(hsp_sticks_get_faces(sticks.get(), 0, info.faces, faces.data()) == HSP_OK, "faces");
  const auto bodies = static_cast<uint32_t>(area.size());
  FUZZ_REQUIRE(hsp_sticks_get_areas(sticks.get(), area.data(), bodies, &needed) == HSP_OK, "areas");
  double sum = 0;
  for (const double each : area) sum += each;
  FUZZ_REQUIRE(std::fabs(sum - info.area) <= 1e-9 * info.area, "the sum of areas");
  for (const hsp_map_edge &edge : edges) {
    FUZZ_REQUIRE(edge.ball[0] < bodies && (edge.ball[1] < bodies || edge.ball[1] == HSP_NONE), "whose edge it is");
    FUZZ_REQUIRE(faces[edge.face[0]].ball == edge.ball[0], "what is on the left of an edge");
    FUZZ_REQUIRE(edge.ball[1] == HSP_NONE || faces[edge.face[1]].ball == edge.ball[1], "and on the right");
  }
  require_sights(sticks.get(), info, reference.info, scene_of(set, stick, radius, info), faces, bytes);
  require_answers(sticks.get(), bodies, info, edges, faces, bytes);
  fuzz::require_limits<support::SticksKind>(needed_limits, bytes, compute, [&info](const hsp_sticks *other) {
    hsp_map_info read{};
    const int32_t result = hsp_sticks_get_map_info(other, &read);
    if (result == HSP_OK) FUZZ_REQUIRE(std::memcmp(&read, &info, sizeof read) == 0, "a map differs with more room");
    return result;
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const hsp_view_options options = fuzz::view_options(bytes);
  const fuzz::ScaledBalls set = stick_set(bytes);
  std::vector<hsp_stick> stick = sticks_between(set.n(), bytes);
  const double radius = std::ldexp(1.0 + bytes.below(64), -static_cast<int>(bytes.below(8))) *
                        (bytes.one_in(32) ? 1e-300 : set.length(1));
  const auto count = static_cast<uint32_t>(stick.size());
  const fuzz::ComputedSet base(set);
  const Result reference = computed_with(base.get().model, options, stick, radius);
  require_named(reference, set.n(), count);
  const Result again = computed_with(base.get().model, options, stick, radius);
  FUZZ_REQUIRE(std::memcmp(&again, &reference, sizeof again) == 0, "another result the second time");

  const auto compute = [&](hsp_sticks *sticks, hsp_sticks_limits *limits) {
    return hsp_sticks_compute(sticks, base.get().model, &options, stick.data(), count, radius, nullptr, limits);
  };
  const auto read = [&](const hsp_sticks *sticks) {
    hsp_sticks_info info{};
    const int32_t status = hsp_sticks_get_info(sticks, &info);
    if (status == HSP_OK)
      FUZZ_REQUIRE(std::memcmp(&info, &reference.info, sizeof info) == 0, "info differs with more room");
    return status;
  };
  hsp_sticks_limits limits;
  FUZZ_REQUIRE(hsp_sticks_limits_init(&limits, sizeof limits, set.n()) == HSP_OK, "hsp_sticks_limits_init");
  if (reference.status == HSP_OK) fuzz::require_limits<support::SticksKind>(reference.needed, bytes, compute, read);

  if (reference.status == HSP_OK) {
    support::OwnedHandle<support::SticksKind> sticks;
    sticks.take(reference.needed);
    FUZZ_REQUIRE(compute(sticks.get(), nullptr) == HSP_OK, "with what is needed");
    // Some with contours, where there is a map of the same.
    support::OwnedHandle<support::SticksKind> map;
    map.take({sizeof(hsp_sticks_limits), 200, 200, 200 * 200, 4000});
    const bool mapped = hsp_sticks_compute_map(map.get(), base.get().model, &options, stick.data(), count, radius,
                                               nullptr, nullptr) == HSP_OK;
    const auto write = [&](const uint32_t *colour, const hsp_picture_options *asked, auto... arguments) {
      hsp_picture_options chosen = *asked;
      if (mapped && asked->width >= 1) chosen.ink_of_sticks = map.get();
      return hsp_picture_write_sticks(sticks.get(), colour, &chosen, arguments...);
    };
    fuzz::require_pictures(base.get(), write, base.get(), write, bytes);
  }

  require_map(set, base.get().model, options, stick, radius, reference, bytes);

  const std::vector<uint32_t> order = fuzz::shuffled(set.n(), bytes);
  std::vector<uint32_t> place(set.n());
  for (uint32_t k = 0; k < set.n(); ++k) place[order[k]] = k;
  for (hsp_stick &each : stick)
    for (uint32_t &ball : each.ball) ball = ball < set.n() ? place[ball] : ball;
  const fuzz::ComputedSet other(fuzz::permuted(set, order));
  const Result permuted = computed_with(other.get().model, options, stick, radius);
  FUZZ_REQUIRE(permuted.status == reference.status, "the status depends on the order of the balls");
  FUZZ_REQUIRE(permuted.info.paths == reference.info.paths, "paths depend on the order of the balls");
  return 0;
}
