#include "maps/stick_arcs.hpp"

#include <initializer_list>

#include "maps/hidden_parts.hpp"
#include "maps/trigonometric_roots.hpp"

namespace hsp {
namespace {

constexpr ArcEnd natural_end{MapVertexKind::tangency, no_id};

// The parts of a curve that balls and sticks hide. On a circle breakpoints are the roots of trigonometric polynomials
// of degree 2, on a line those of quadratic ones.
template <class Curve>
class HiddenByBodies : public HiddenParts {
 public:
  HiddenByBodies(const Curve &curve, double from, double to, FixedVector<HiddenInterval> &hidden)
      : HiddenParts(from, to, hidden), curve_(curve) {}

  // Hides the parts that a ball covers; true if that is the whole curve. An end at the ball's contour is a T on `id`,
  // an end at its surface has the label `at_surface`.
  bool add_ball(const SeenBall &ball, uint32_t id, const ArcEnd &at_surface) {
    begin_body();
    add_distance(ball, true);
    for (uint32_t k = 0; k < count_; ++k) at_[k].end = at_surface;
    // At the height of the centre a curve goes through the front and the contour, and rounding may let it miss both.
    uint32_t at_centre = 0, kept = 0;
    const auto counted = [&](const Vec3 &q, bool good) {
      if (std::fabs(q.z - ball.z) >= level_height * ball.r) return good;
      ++at_centre;
      kept += good ? 1 : 0;
      return good;
    };
    keep([&](const Vec3 &q) { return counted(q, q.z >= ball.z); }, 0);
    const uint32_t first = count_;
    add_distance(ball, false);
    for (uint32_t k = first; k < count_; ++k) at_[k].end = {MapVertexKind::t, id};
    keep([&](const Vec3 &q) { return counted(q, q.z < ball.z); }, first);
    if (at_centre > 0 && kept == 0) certain_ = false;
    return cut_by(ball.r, [&](const Vec3 &q) { return depth_behind(q, ball) / ball.r; });
  }

  // The same for a curve that is a silhouette, all of it at one height. A nearer ball hides what is in its disc, a
  // farther one what is inside it.
  bool add_ball_at_silhouette(const SeenBall &ball, uint32_t id, bool nearer) {
    begin_body();
    add_distance(ball, !nearer);
    for (uint32_t k = 0; k < count_; ++k) at_[k].end = {nearer ? MapVertexKind::t : MapVertexKind::tangency, id};
    return cut_by(ball.r, [&](const Vec3 &q) { return depth_behind(q, ball) / ball.r; });
  }

  // Hides the parts of the curve that a stick covers. first_part: the body of the stick's first part.
  bool add_stick(const Stick &stick, uint32_t first_part) {
    const Vec3 along{stick.e[0], stick.e[1], 0.0};
    const Vec3 across{-stick.e[1], stick.e[0], 0.0};
    const double squared = stick.radius * stick.radius;
    begin_body();
    for (const double side : {stick.radius, -stick.radius}) add_level(stick.foot, across, side);
    for (uint32_t k = 0; k < count_; ++k) {
      const Vec3 q = curve_.at(at_[k].t);
      const double s = dot(q - stick.foot, along) / stick.seen;
      at_[k].end = {MapVertexKind::t, first_part + (stick.parts == 2 && s >= stick.middle() ? 1U : 0U)};
    }
    const uint32_t first = count_;
    const double up = stick.axis.z;
    for (const double s : {0.0, stick.length}) {
      // The half circle at this end of the front appears as a half ellipse; as a line if it is seen edge on.
      const Vec3 end = stick.on_axis(s);
      add_level(end, along, 0.0);
      add_squares(end, along, up * across, {}, up * up * squared);
    }
    add_squares(stick.foot, across, {up * -stick.e[0], up * -stick.e[1], stick.seen}, {}, squared);
    for (uint32_t k = first; k < count_; ++k) at_[k].end = {};
    return cut_by(stick.radius, [&](const Vec3 &q) {
      const StickFront front = front_of(stick, q.x, q.y);
      if (front.beside <= 0.0) return front.beside;
      if (!front.exists) return -stick.radius;
      const double above = front.z - q.z;
      return above < front.beside ? above : front.beside;
    });
  }

 private:
  // Drops breakpoints from `first` on where `good` does not hold.
  template <class Good>
  void keep(Good good, uint32_t first) {
    uint32_t kept = first;
    for (uint32_t k = first; k < count_; ++k) {
      if (good(curve_.at(at_[k].t))) at_[kept++] = at_[k];
    }
    count_ = kept;
  }

  // Adds breakpoints where n . (q - c) = value.
  void add_level(const Vec3 &c, const Vec3 &n, double value) { add_level_on(curve_, c, n, value); }
  void add_level_on(const RoundCurve &curve, const Vec3 &c, const Vec3 &n, double value) {
    const double A = dot(n, curve.first);
    const double B = dot(n, curve.second);
    visit_level(A, B, value - dot(n, curve.middle - c), [this](double t) { add(t); });
  }
  void add_level_on(const StraightCurve &curve, const Vec3 &c, const Vec3 &n, double value) {
    const double slope = dot(n, curve.step);
    if (slope != 0.0) add((value - dot(n, curve.start - c)) / slope);
  }

  // Adds breakpoints where the distance from the centre of a ball, in space or in the view plane, is its radius.
  void add_distance(const SeenBall &ball, bool in_space) {
    const Vec3 towards{0.0, 0.0, in_space ? 1.0 : 0.0};
    add_squares({ball.x, ball.y, ball.z}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, towards, ball.r * ball.r);
  }
  // Adds breakpoints where (n1 . (q - c))^2 + (n2 . (q - c))^2 + (n3 . (q - c))^2 = sum.
  void add_squares(const Vec3 &c, const Vec3 &n1, const Vec3 &n2, const Vec3 &n3, double sum) {
    const Vec3 normals[3] = {n1, n2, n3};
    add_squares_on(curve_, c, normals, sum);
  }
  // If angles count from the maximum of the terms of twice the angle, there is no product of cosine and sine.
  void add_squares_on(const RoundCurve &curve, const Vec3 &c, const Vec3 normals[3], double sum) {
    const Vec3 d = curve.middle - c;
    double constant = -sum, cosine = 0.0, sine = 0.0, twice_cosine = 0.0, twice_sine = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double p = dot(normals[k], d);
      const double a = dot(normals[k], curve.first);
      const double b = dot(normals[k], curve.second);
      constant += p * p + 0.5 * (a * a + b * b);
      cosine += 2 * p * a;
      sine += 2 * p * b;
      twice_cosine += 0.5 * (a - b) * (a + b);
      twice_sine += a * b;
    }
    const double turn = 0.5 * arc_tangent(twice_sine, twice_cosine);
    const double amplitude = std::sqrt(twice_cosine * twice_cosine + twice_sine * twice_sine);
    const SinCos at = sin_cos(turn);
    const TrigonometricPolynomial f{constant - amplitude, cosine * at.cosine + sine * at.sine,
                                    sine * at.cosine - cosine * at.sine, 2 * amplitude};
    double root[most_trigonometric_roots];
    const uint32_t count = find_roots(f, from_ - turn, to_ - turn, root);
    for (uint32_t k = 0; k < count; ++k) add(root[k] + turn);
  }
  void add_squares_on(const StraightCurve &curve, const Vec3 &c, const Vec3 normals[3], double sum) {
    const Vec3 d = curve.start - c;
    double constant = -sum, half_slope = 0.0, square = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double p = dot(normals[k], d);
      const double a = dot(normals[k], curve.step);
      constant += p * p;
      half_slope += p * a;
      square += a * a;
    }
    const double discriminant = half_slope * half_slope - square * constant;
    if (!(discriminant > 0.0) || !(square > 0.0)) return;
    // One of the two roots is computed without cancellation, the other one from their product.
    const double root = std::sqrt(discriminant);
    const double sum_of = half_slope > 0.0 ? -half_slope - root : root - half_slope;
    add(sum_of / square);
    if (sum_of != 0.0) add(constant / sum_of);
  }

  // The label is set later.
  void add(double t) { HiddenParts::add(t, {}); }
  // depth(q): how far q is behind the body, negative if it is not behind.
  template <class Depth>
  bool cut_by(double radius, Depth depth) {
    return cut(shallow_depth * radius, [&](double from, double to) { return depth(curve_.at(0.5 * (from + to))); });
  }

  const Curve &curve_;
};

}  // namespace

void StickArcs::carve(Workspace &workspace, const StickLimits &limits) {
  arcs_ = FixedVector<MapArc>(workspace.take<MapArc>(limits.edges));
  hidden_ = FixedVector<HiddenInterval>(workspace.take<HiddenInterval>(limits.edges));
  above_.carve(workspace, limits);
  asked_ = workspace.take<uint32_t>(limits.sticks);
}

// Marks the balls inside others. Of equal balls the first one is not inside.
void StickArcs::mark_inside(Span<SeenBall> balls) const {
  for (uint32_t i = 0; i < scene_.balls.size(); ++i) {
    balls[i].inside = 0;
    const SeenBall &ball = scene_.balls[i];
    for (const uint32_t k : above_.of(i)) {
      if (!scene_.is_ball(k)) continue;
      const SeenBall &other = scene_.balls[k];
      const bool smaller = ball.r != other.r ? ball.r < other.r : i > k;
      if (smaller && is_inside(ball, other)) balls[i].inside = 1;
    }
  }
}

void StickArcs::begin_curve() {
  hidden_.clear();
  ++curve_;
}

template <class Parts>
bool StickArcs::hide_by_stick(Parts &parts, uint32_t body, uint32_t except_stick) {
  const uint32_t k = scene_.stick_of(body);
  if (k == except_stick || scene_.sticks[k].parts == 0 || asked_[k] == curve_) return false;
  asked_[k] = curve_;
  return parts.add_stick(scene_.sticks[k], scene_.body_of(k, 0));
}

// Hides the parts of a body's curve that the bodies above it cover; true if that is the whole curve.
template <class Parts>
bool StickArcs::hide(Parts &parts, uint32_t body, uint32_t except_ball, uint32_t except_stick,
                     const ArcEnd &at_surface) {
  for (const uint32_t k : above_.of(body)) {
    if (!scene_.is_ball(k)) {
      if (hide_by_stick(parts, k, except_stick)) return true;
    } else if (k != except_ball && scene_.balls[k].inside == 0) {
      if (parts.add_ball(scene_.balls[k], k, {at_surface.kind, k})) return true;
    }
  }
  return false;
}

template <class Parts>
void StickArcs::end_curve(const Parts &parts, bool hidden, double from, double to, const ArcEnd &natural, uint32_t body,
                          uint32_t nearer) {
  most_hidden_ = larger_count(most_hidden_, clamped_count(hidden_.required()));
  if (!parts.certain()) certain_ = false;
  if (hidden) return;
  if (hidden_.overflowed()) {
    not_found_ += hidden_.required() + 1;
    return;
  }
  push_visible(hidden_.items(), from, to, natural, body, nearer, arcs_);
}

// A stick that comes out of a ball towards the viewer hides the part of the ball's silhouette between its two lines. If
// the stick is nearly level, the silhouette goes into its side almost where it goes behind its lines: roots cannot tell
// these points apart, so that no roots are used. False if the body is no stick of the ball, or if the stick is so steep
// that it ends before the silhouette.
bool StickArcs::hide_by_own_stick(uint32_t body, uint32_t ball) {
  const Stick &stick = scene_.stick_at(body);
  if (stick.ball[0] != ball || stick.parts == 0 || !(stick.first < stick.length * stick.seen)) return false;
  const uint32_t k = scene_.stick_of(body);
  if (asked_[k] == curve_) return true;
  asked_[k] = curve_;
  const uint32_t part = stick.parts == 2 && stick.first >= stick.middle() * stick.seen ? 1U : 0U;
  hide_angles(hidden_, arc_tangent(stick.e[1], stick.e[0]), arc_tangent(stick.radius, stick.first),
              {MapVertexKind::t, scene_.body_of(k, part)});
  return true;
}

// Adds the arcs of a ball's silhouette. Sticks that go away from the viewer cut out their bites.
void StickArcs::add_silhouette(uint32_t ball) {
  begin_curve();
  const RoundCurve curve = scene_.round_curve(ball, no_id);
  HiddenByBodies<RoundCurve> parts(curve, -pi, pi, hidden_);
  bool hidden = false;
  for (const uint32_t k : above_.of(ball)) {
    if (hidden) break;
    if (!scene_.is_ball(k)) {
      hidden = !hide_by_own_stick(k, ball) && hide_by_stick(parts, k, no_id);
    } else if (scene_.balls[k].inside == 0) {
      hidden = parts.add_ball_at_silhouette(scene_.balls[k], k, is_nearer(k, ball));
    }
  }
  for (const StickBite &bite : view_->bites_of(ball)) {
    hide_angles(hidden_, bite.middle, bite.half, {MapVertexKind::tangency, scene_.body_of(bite.stick, 0)});
  }
  end_curve(parts, hidden, -pi, pi, {}, ball, no_id);
}

void StickArcs::add_crease(uint32_t ball, uint32_t nearer) {
  const Crease crease(scene_.balls[ball], scene_.balls[nearer]);
  if (!crease.exists) return;
  begin_curve();
  const RoundCurve curve = scene_.round_curve(ball, nearer);
  HiddenByBodies<RoundCurve> parts(curve, -crease.end, crease.end, hidden_);
  const bool hidden = hide(parts, ball, nearer, no_id, {MapVertexKind::triple, no_id});
  end_curve(parts, hidden, -crease.end, crease.end, crease.is_whole() ? ArcEnd{} : natural_end, ball, nearer);
}

void StickArcs::add_top_ring(const StickBite &bite) {
  const Stick &stick = scene_.sticks[bite.stick];
  const uint32_t body = scene_.body_of(bite.stick, stick.parts - 1);
  const uint32_t ball = stick.ball[1];
  begin_curve();
  const RoundCurve curve = scene_.round_curve(body, ball);
  const double end = pi / 2 - bite.from;
  HiddenByBodies<RoundCurve> parts(curve, -end, end, hidden_);
  end_curve(parts, hide(parts, ball, no_id, bite.stick, {}), -end, end, natural_end, body, ball);
}

// Adds the arcs of the half circles at the foot and in the middle. The ball at the top may hide them.
void StickArcs::add_rings(uint32_t k) {
  const Stick &stick = scene_.sticks[k];
  const uint32_t low = scene_.body_of(k, 0);
  const uint32_t names[2][2] = {{stick.ball[0], low}, {low, low + 1}};
  for (uint32_t ring = 0; ring < stick.parts; ++ring) {
    begin_curve();
    const RoundCurve curve = scene_.round_curve(names[ring][0], names[ring][1]);
    HiddenByBodies<RoundCurve> parts(curve, -pi / 2, pi / 2, hidden_);
    const bool hidden =
        parts.add_ball(scene_.balls[stick.ball[1]], stick.ball[1], {}) || hide(parts, low, stick.ball[1], k, {});
    end_curve(parts, hidden, -pi / 2, pi / 2, natural_end, names[ring][0], names[ring][1]);
  }
}

// Adds the arcs of a line of a contour. A line ends on the silhouette of the ball at the top, at the latest where it
// enters the ball.
void StickArcs::add_line(uint32_t body, bool left) {
  const Stick &stick = scene_.stick_at(body);
  const uint32_t part = scene_.part_of(body);
  const uint32_t top = stick.ball[1];
  begin_curve();
  const double begin = stick.begin_of(part) / stick.length;
  const double end = stick.end_of(part) / stick.length;
  const double from = left ? -end : begin;
  const double to = left ? -begin : end;
  const StraightCurve curve = scene_.line_of(stick, left);
  HiddenByBodies<StraightCurve> parts(curve, from, to, hidden_);
  const bool hidden = parts.add_ball(scene_.balls[top], top, {}) || hide(parts, body, top, scene_.stick_of(body), {});
  const uint32_t first = arcs_.size();
  end_curve(parts, hidden, from, to, natural_end, body, no_id);
  if (part + 1 < stick.parts) return;
  for (uint32_t a = first; a < arcs_.size(); ++a) {
    MapArc &arc = arcs_[a];
    if (left && arc.from == from) arc.end[0] = {MapVertexKind::t, top};
    if (!left && arc.to == to) arc.end[1] = {MapVertexKind::t, top};
  }
}

void StickArcs::add_contour(uint32_t body) {
  add_line(body, true);
  add_line(body, false);
}

bool StickArcs::find(const StickScene &scene, const StickView &view, Span<const StickPair> pairs, Span<SeenBall> balls,
                     Patience &patience) {
  scene_ = scene;
  view_ = &view;
  arcs_.clear();
  not_found_ = 0;
  most_hidden_ = 0;
  certain_ = true;
  curve_ = 0;
  for (uint32_t k = 0; k < scene.sticks.size(); ++k) asked_[k] = 0;
  above_.sort(pairs, scene.bodies());
  mark_inside(balls);
  for (uint32_t i = 0; i < scene.balls.size(); ++i) {
    if (!(scene.balls[i].r > 0.0) || scene_.balls[i].inside != 0) continue;
    if (!patience.allows(10000)) return false;
    add_silhouette(i);
    for (const StickBite &bite : view.bites_of(i)) {
      if (!patience.allows(10000)) return false;
      add_top_ring(bite);
    }
    for (const uint32_t k : above_.of(i)) {
      if (!patience.allows(10000)) return false;
      if (scene.is_ball(k) && scene_.balls[k].inside == 0 && is_nearer(k, i)) add_crease(i, k);
    }
  }
  for (uint32_t k = 0; k < scene.sticks.size(); ++k) {
    if (!patience.allows(40000)) return false;
    add_rings(k);
    for (uint32_t part = 0; part < scene.sticks[k].parts; ++part) add_contour(scene.body_of(k, part));
  }
  return true;
}

}  // namespace hsp
