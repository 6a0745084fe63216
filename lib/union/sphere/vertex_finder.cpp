// Finds the free vertices and free circles of one ball, by pairs of its caps.
//
// As an example the ball of radius 5 at 0 with the caps of balls of radius 5 at (6,0,0) and (0,6,0), whose circles
// cross at (0.6, 0.6, +-0.529) on the unit sphere (cap_pair.hpp), and a third cap z >= b:
//   third ball                   b       depth of the upper point, 0.529 - b
//   radius 5 at (0,0,6)         0.6      -0.071      outside, if the error bound is less: the point is free so far
//   radius 5 at (0,0,4)         0.4       0.129      inside: the point is covered, and no other cap is asked
//   radius 5 at (0,0,5.2915)   0.529       0         near 0: uncertain, and integers decide
// A point that is outside all other caps is a vertex of the union, of these two balls and the one at hand.
#include "sphere/vertex_finder.hpp"

#include "lanes/wide.hpp"
#include "sphere/cap_pair.hpp"

namespace hsp {
namespace {

using Two = Wide<double, 2>;

constexpr uint32_t size_classes = 8;

enum class PointAnswer { covered, free, uncertain };

// A point, to be tested against two caps at a time.
struct LanePoint {
  Two::Real x, y, z;

  // Depth in the test caps t and t + 1.
  Two::Real depths(const CapTests &tests, uint32_t t) const {
    return x * Two::load(&tests.ux[t]) + y * Two::load(&tests.uy[t]) + z * Two::load(&tests.uz[t]) -
           Two::load(&tests.b[t]);
  }
  bool inside_any(const CapTests &tests, uint32_t t, const Two::Real &bound) const {
    static_assert(CapTests::group == 2 * Two::lanes);
    return Two::any((depths(tests, t) > bound) | (depths(tests, t + Two::lanes) > bound));
  }
};

// A point is covered if it is inside some cap by more than the error bound. It is free if it is outside all caps by
// more than the bound, but for its own two, on whose circles it lies by construction. `hint` is the group that covered
// the last point, and is tested first: points of one circle are near each other.
PointAnswer test_point(const CapTests &tests, double x, double y, double z, double error, uint32_t &hint) {
  const LanePoint point{Two::all(x), Two::all(y), Two::all(z)};
  const Two::Real bound = Two::all(error);
  if (point.inside_any(tests, hint, bound)) return PointAnswer::covered;
  for (uint32_t t = 0; t < tests.count; t += CapTests::group) {
    if (point.inside_any(tests, t, bound)) {
      hint = t;
      return PointAnswer::covered;
    }
  }
  uint32_t near = 0;
  for (uint32_t t = 0; t < tests.count; t += Two::lanes) near += Two::count(point.depths(tests, t) >= -bound);
  return near == 2 ? PointAnswer::free : PointAnswer::uncertain;
}

// The exact stage: pushes the free points among p+ and p- of the circles of caps j < k. Returns whether the circles
// cross. A vertex is tied if a further sphere passes through it before the perturbation. The sphere of a ball that lies
// inside one of the vertex's three balls and touches it there does not count; without this exception the flag would
// depend on the ball at which the vertex is decided.
// points: null, or, if the circles certainly cross, their points in doubles; then only the caps are asked about that
// doubles leave open. holder: the test cap that covered the last point, which is asked first: where many planes go
// through one point, it mostly covers the next point, too.
bool find_vertices_exactly(const BallSet &balls, const Caps &caps, const CapTests &tests, uint32_t j, uint32_t k,
                           const CrossingPoints *points, uint32_t &holder, FixedVector<VertexRecord> &vertices);

// Whether the circle of cap j is free as a whole.
bool is_free_circle(const Caps &caps, const CapTests &tests, uint32_t j);

}  // namespace

void CapTests::carve(Workspace &workspace, uint32_t capacity) {
  const uint64_t padded = static_cast<uint64_t>(capacity) + group;
  ux = workspace.take<double>(padded);
  uy = workspace.take<double>(padded);
  uz = workspace.take<double>(padded);
  b = workspace.take<double>(padded);
  cap = workspace.take<uint32_t>(capacity);
}

template <class NumberOf>
void CapTests::fill_with(const Caps &caps, uint32_t number, NumberOf number_of) {
  count = number;
  uint32_t start[size_classes + 1] = {};
  for (uint32_t t = 0; t < number; ++t) ++start[size_class(caps.b[number_of(t)], size_classes) + 1];
  for (uint32_t c = 0; c < size_classes; ++c) start[c + 1] += start[c];
  for (uint32_t t = 0; t < number; ++t) {
    const uint32_t k = number_of(t);
    const uint32_t slot = start[size_class(caps.b[k], size_classes)]++;
    ux[slot] = caps.ux[k];
    uy[slot] = caps.uy[k];
    uz[slot] = caps.uz[k];
    b[slot] = caps.b[k];
    cap[slot] = k;
  }
  // Caps in which nothing lies fill the last group.
  for (uint32_t slot = count; slot < count + group; ++slot) {
    ux[slot] = uy[slot] = uz[slot] = 0.0;
    b[slot] = 4.0;
  }
}

void CapTests::fill(const Caps &caps) {
  fill_with(caps, caps.count, [](uint32_t t) { return t; });
}

void CapTests::fill(const Caps &caps, Span<const uint32_t> numbers) {
  fill_with(caps, numbers.size(), [numbers](uint32_t t) { return numbers[t]; });
}

void VertexFinder::carve(Workspace &workspace, uint32_t capacity) {
  tests_.carve(workspace, capacity);
  state_ = workspace.take<uint8_t>(capacity);
}

// Pushes those of the two points that are free. If one of them is uncertain, pushes nothing and returns false.
#if !defined(__OPTIMIZE_SIZE__)
[[gnu::always_inline]]
#endif
inline bool
VertexFinder::decide_points(const Caps &caps, uint32_t j, uint32_t k, const CrossingPoints &points,
                            FixedVector<VertexRecord> &vertices) {
  PointAnswer answer[2];
  for (uint32_t point = 0; point < 2; ++point) {
    answer[point] = test_point(tests_, points.x[point], points.y[point], points.z[point], points.error, hint_[point]);
  }
  if (answer[0] == PointAnswer::uncertain || answer[1] == PointAnswer::uncertain) return false;
  exact::count_answer(exact::Question::vertex_pair, exact::Stage::filter);
  for (uint32_t point = 0; point < 2; ++point) {
    if (answer[point] != PointAnswer::free) continue;
    vertices.push({{caps.origin, caps.ball[j], caps.ball[k]}, point == 1 ? VertexRecord::positive_bit : 0U});
  }
  return true;
}

// Decides circles that certainly cross, in points of which the first formula is not certain: by a better formula, then
// by integers. The points are computed again here: if pair() passed them on, every pair would have to store them.
[[gnu::noinline]] void VertexFinder::decide_crossing(const BallSet &balls, const Caps &caps, uint32_t j, uint32_t k,
                                                     FixedVector<VertexRecord> &vertices) {
  const CrossingPoints points =
      small_code ? CrossingPoints(caps, j, k, CapPair(caps, j, k)) : CrossingPoints(caps, j, k);
  ++effort_;
  if (!small_code && decide_points(caps, j, k, points, vertices)) return;
  exact::count_answer(exact::Question::vertex_pair, exact::Stage::exact);
  effort_ += effort_of_integers;
  find_vertices_exactly(balls, caps, tests_, j, k, &points, holder_, vertices);
}

// Where code size counts there is one copy.
#if !defined(__OPTIMIZE_SIZE__)
[[gnu::always_inline]]
#endif
inline void
VertexFinder::pair(const BallSet &balls, const Caps &caps, uint32_t j, uint32_t k,
                   FixedVector<VertexRecord> &vertices) {
  if ((state_[j] | state_[k]) & covered) return;
  const CapPair circles(caps, j, k);
  if (circles.certainly_apart()) {
    if (circles.certainly_inside()) state_[j] |= covered;
    if (circles.certainly_contains()) state_[k] |= covered;
    return;
  }
  if (!circles.certainly_cross()) {
    exact::count_answer(exact::Question::vertex_pair, exact::Stage::exact);
    effort_ += effort_of_integers;
    if (find_vertices_exactly(balls, caps, tests_, j, k, nullptr, holder_, vertices)) {
      state_[j] |= crossed;
      state_[k] |= crossed;
    }
    return;
  }
  state_[j] |= crossed;
  state_[k] |= crossed;
  const CrossingPoints points(caps, j, k, circles);
  const bool may_be_better = !small_code && points.error > 0x1p-24;
  if (may_be_better || !decide_points(caps, j, k, points, vertices)) decide_crossing(balls, caps, j, k, vertices);
}

void VertexFinder::decide_pair(const BallSet &balls, const Caps &caps, uint32_t j, uint32_t k,
                               FixedVector<VertexRecord> &vertices) {
  pair(balls, caps, j, k, vertices);
}

void VertexFinder::decide_circle(const Caps &caps, uint32_t j, FixedVector<CircleRecord> &circles) const {
  if (state_[j] == 0 && is_free_circle(caps, tests_, j)) circles.push({{caps.origin, caps.ball[j]}, {no_id, no_id}});
}

void VertexFinder::start(const Caps &caps) {
  tests_.fill(caps);
  for (uint32_t j = 0; j < caps.count; ++j) state_[j] = 0;
  hint_[0] = hint_[1] = holder_ = effort_ = 0;
}

bool VertexFinder::search(const BallSet &balls, const Caps &caps, bool may_give_up, FixedVector<VertexRecord> &vertices,
                          FixedVector<CircleRecord> &circles) {
  const uint64_t known = vertices.required();
  start(caps);
  for (uint32_t j = caps.first_later; j < caps.count; ++j) {
    for (uint32_t k = j + 1; k < caps.count; ++k) {
      pair(balls, caps, j, k, vertices);
      if (!may_give_up || !asks_much()) continue;
      vertices.set_count(known);
      return false;
    }
  }
  for (uint32_t j = caps.first_later; j < caps.count; ++j) decide_circle(caps, j, circles);
  return true;
}

void VertexFinder::find(const BallSet &balls, const Caps &caps, FixedVector<VertexRecord> &vertices,
                        FixedVector<CircleRecord> &circles) {
  search(balls, caps, false, vertices, circles);
}

void VertexFinder::cull_and_find(const BallSet &balls, Caps &caps, FixedVector<VertexRecord> &vertices,
                                 FixedVector<CircleRecord> &circles) {
  if (search(balls, caps, true, vertices, circles) || small_code) return;  // small code never gives up
  ExposedCaps exposed = exposed_caps();
  if (!exposed.find(ExposedCaps::Part::sphere, caps)) return;
  caps.keep(exposed.kept());
  find(balls, caps, vertices, circles);
}

// One of the two indices, built; `near` is null for the boxes.
struct VertexFinder::CapIndex {
  const NearCaps *near;
  CapBoxes *boxes;

  Span<const uint32_t> around(const Caps &caps, uint32_t j) const {
    return near != nullptr ? near->around(caps, j) : boxes->around(caps, j);
  }
};

void VertexFinder::find(const BallSet &balls, const Caps &caps, NearCaps near, FixedVector<VertexRecord> &vertices,
                        FixedVector<CircleRecord> &circles) {
  near.start(caps);
  find_along_circles(balls, caps, {&near, nullptr}, vertices, circles);
}

void VertexFinder::find(const BallSet &balls, const Caps &caps, CapBoxes boxes, FixedVector<VertexRecord> &vertices,
                        FixedVector<CircleRecord> &circles) {
  boxes.start(caps);
  find_along_circles(balls, caps, {nullptr, &boxes}, vertices, circles);
}

void VertexFinder::find_along_circles(const BallSet &balls, const Caps &caps, const CapIndex &index,
                                      FixedVector<VertexRecord> &vertices, FixedVector<CircleRecord> &circles) {
  for (uint8_t &state : state_.part(0, caps.count)) state = 0;
  const auto test_those_around = [&](uint32_t j) {
    const Span<const uint32_t> around = index.around(caps, j);
    tests_.fill(caps, around);
    hint_[0] = hint_[1] = holder_ = 0;
    return around;
  };
  for (uint32_t j = caps.first_later; j < caps.count; ++j) {
    if ((state_[j] & covered) != 0) continue;
    for (const uint32_t k : test_those_around(j)) {
      if (k > j) decide_pair(balls, caps, j, k, vertices);
    }
  }
  for (uint32_t j = caps.first_later; j < caps.count; ++j) {
    if (state_[j] != 0) continue;
    test_those_around(j);
    decide_circle(caps, j, circles);
  }
}

void VertexFinder::find_on_last(const BallSet &balls, const Caps &caps, FixedVector<VertexRecord> &vertices,
                                FixedVector<CircleRecord> &circles) {
  start(caps);
  const uint32_t last = caps.count - 1;
  for (uint32_t j = 0; j < last; ++j) pair(balls, caps, j, last, vertices);
  decide_circle(caps, last, circles);
}

namespace {

// False for virtual planes (the view's silhouette), which have no ball.
bool has_ball_inside(const BallSet &balls, uint32_t inner, uint32_t outer) {
  return inner != no_id && outer != no_id && lies_inside(balls, inner, outer);
}

// Whether integers must be asked about a cap: doubles do not tell whether one of the points, which may still be free,
// lies inside it. Points that certainly lie inside are marked as not free.
bool leaves_open(const CrossingPoints &points, const CapTests &tests, uint32_t t, bool (&free)[2]) {
  bool open = false;
  for (int point = 0; point < 2; ++point) {
    const double depth =
        points.x[point] * tests.ux[t] + points.y[point] * tests.uy[t] + points.z[point] * tests.uz[t] - tests.b[t];
    free[point] = free[point] && !(depth > points.error);
    open = open || (free[point] && !(depth < -points.error));
  }
  return open;
}

bool find_vertices_exactly(const BallSet &balls, const Caps &caps, const CapTests &tests, uint32_t j, uint32_t k,
                           const CrossingPoints *points, uint32_t &holder, FixedVector<VertexRecord> &vertices) {
  const exact::Predicates predicates = caps.predicates();
  const exact::Plane P = caps.plane(j);
  const exact::Plane Q = caps.plane(k);
  const exact::Sign crossing = predicates.crossing(P, Q);
  if (crossing.sign < 0) return false;

  bool free[2] = {true, true};
  bool tied[2] = {crossing.tied, crossing.tied};
  const uint32_t first = holder;
  for (uint32_t n = 0; n < tests.count && (free[0] || free[1]); ++n) {
    const uint32_t t = small_code ? n : with_one_first(n, first);
    const uint32_t l = tests.cap[t];
    if (l == j || l == k) continue;
    if (points != nullptr && !leaves_open(*points, tests, t, free)) continue;
    const exact::PointStatus status = predicates.point_status(P, Q, caps.plane(l));
    // Balls inside the origin ball have no cap here, so only the other two are left to ask.
    const bool ties = (status.tied[0] || status.tied[1]) && !has_ball_inside(balls, caps.ball[l], caps.ball[j]) &&
                      !has_ball_inside(balls, caps.ball[l], caps.ball[k]);
    for (int point = 0; point < 2; ++point) {
      if (!small_code && free[point] && status.side[point] >= 0) holder = t;
      free[point] = free[point] && status.side[point] < 0;
      tied[point] = tied[point] || (ties && status.tied[point]);
    }
  }
  for (uint32_t point = 0; point < 2; ++point) {
    if (!free[point]) continue;
    vertices.push({{caps.origin, caps.ball[j], caps.ball[k]},
                   (point == 1 ? VertexRecord::positive_bit : 0U) | (tied[point] ? VertexRecord::tied_bit : 0U)});
  }
  return true;
}

// Whether one point of the circle certainly lies inside another cap. The point is b u + s t with t a unit vector across
// u and s = sqrt(1 - b^2); t has error 8e (the cross product with the axis least along u is at least sqrt(2/3) long), s
// has error 9e/s + 2e, and the test against a cap adds 16e as in cap_pair.hpp, so that 40e + 16e/s bounds all.
bool a_point_is_certainly_covered(const Caps &caps, const CapTests &tests, uint32_t j) {
  const double x = caps.ux[j], y = caps.uy[j], z = caps.uz[j], b = caps.b[j];
  const double squared = (1.0 - b) * (1.0 + b);
  if (!(squared > 0x1p-32)) return false;
  const double s = std::sqrt(squared);
  const double error = unit_roundoff * (40.0 + 16.0 / s);
  double tx = 0.0, ty = 0.0, tz = 0.0;
  if (x * x <= y * y && x * x <= z * z) {
    ty = z;
    tz = -y;
  } else if (y * y <= z * z) {
    tx = -z;
    tz = x;
  } else {
    tx = y;
    ty = -x;
  }
  const double scale = s / std::sqrt(tx * tx + ty * ty + tz * tz);
  const double px = b * x + scale * tx, py = b * y + scale * ty, pz = b * z + scale * tz;
  for (uint32_t t = 0; t < tests.count; ++t) {
    if (px * tests.ux[t] + py * tests.uy[t] + pz * tests.uz[t] - tests.b[t] > error) return true;
  }
  return false;
}

// Called for a circle of which no crossing with a later circle is known; it may still cross others. A circle with a
// covered point is not free as a whole. Any other circle is free as a whole iff it crosses no other circle and lies
// inside no other cap.
bool is_free_circle(const Caps &caps, const CapTests &tests, uint32_t j) {
  if (a_point_is_certainly_covered(caps, tests, j)) return false;
  const exact::Predicates predicates = caps.predicates();
  for (uint32_t t = 0; t < tests.count; ++t) {
    const uint32_t l = tests.cap[t];
    if (l == j) continue;
    if (predicates.crossing(caps.plane(j), caps.plane(l)).sign > 0) return false;
    if (predicates.side(caps.plane(j), caps.plane(l)).sign > 0) return false;
  }
  return true;
}

}  // namespace
}  // namespace hsp
