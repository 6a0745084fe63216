#include "maps/stick_arcs.hpp"

#include "core/elementary.hpp"
#include "maps/hidden_parts.hpp"

namespace hsp {
namespace {

constexpr ArcEnd natural_end{MapVertexKind::tangency, no_id};

}  // namespace

void StickArcs::carve(Workspace &workspace, const StickLimits &limits) {
  arcs_ = FixedVector<MapArc>(workspace.take<MapArc>(limits.edges));
  hidden_ = FixedVector<HiddenInterval>(workspace.take<HiddenInterval>(limits.edges));
  above_.carve(workspace, limits);
  asked_ = workspace.take<uint32_t>(limits.sticks);
}

// Of equal balls the first one is not inside.
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

// Hides the parts of a body's curve that the bodies above cover; true if that is all.
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

// A stick that comes towards the viewer out of a ball hides what is between its lines of the ball's silhouette. Where
// it is nearly level the silhouette goes into its side all but where it goes behind its lines, which roots cannot tell
// apart. False if it is no stick of the ball, or so steep that it ends before the silhouette.
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

// Sticks that go away from the viewer bite the ball.
void StickArcs::add_silhouette(uint32_t ball) {
  begin_curve();
  const RoundCurve curve = scene_.round_curve(ball, no_id);
  HiddenParts<RoundCurve> parts(curve, -pi, pi, hidden_);
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
  HiddenParts<RoundCurve> parts(curve, -crease.end, crease.end, hidden_);
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
  HiddenParts<RoundCurve> parts(curve, -end, end, hidden_);
  end_curve(parts, hide(parts, ball, no_id, bite.stick, {}), -end, end, natural_end, body, ball);
}

// At the foot and in the middle. The ball at the top may hide them.
void StickArcs::add_rings(uint32_t k) {
  const Stick &stick = scene_.sticks[k];
  const uint32_t low = scene_.body_of(k, 0);
  const uint32_t names[2][2] = {{stick.ball[0], low}, {low, low + 1}};
  for (uint32_t ring = 0; ring < stick.parts; ++ring) {
    begin_curve();
    const RoundCurve curve = scene_.round_curve(names[ring][0], names[ring][1]);
    HiddenParts<RoundCurve> parts(curve, -pi / 2, pi / 2, hidden_);
    const bool hidden =
        parts.add_ball(scene_.balls[stick.ball[1]], stick.ball[1], {}) || hide(parts, low, stick.ball[1], k, {});
    end_curve(parts, hidden, -pi / 2, pi / 2, natural_end, names[ring][0], names[ring][1]);
  }
}

// A line ends on the silhouette of the ball at the top, at the latest where it enters the ball.
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
  HiddenParts<StraightCurve> parts(curve, from, to, hidden_);
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

void StickArcs::find(const StickScene &scene, const StickView &view, Span<const StickPair> pairs,
                     Span<SeenBall> balls) {
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
    add_silhouette(i);
    for (const StickBite &bite : view.bites_of(i)) add_top_ring(bite);
    for (const uint32_t k : above_.of(i)) {
      if (scene.is_ball(k) && scene_.balls[k].inside == 0 && is_nearer(k, i)) add_crease(i, k);
    }
  }
  for (uint32_t k = 0; k < scene.sticks.size(); ++k) {
    add_rings(k);
    for (uint32_t part = 0; part < scene.sticks[k].parts; ++part) add_contour(scene.body_of(k, part));
  }
}

}  // namespace hsp
