#include "maps/arc_finder.hpp"

#include "maps/ball_scene.hpp"
#include "maps/crease_beside_ball.hpp"
#include "maps/hidden_parts.hpp"
#include "maps/trigonometric_roots.hpp"

namespace hsp {
namespace {

// A crease that rises by less than this fraction of its radius is level: one ball is straight before the other, up to
// rounding.
constexpr double level_slope = 0x1p-30;

// The part of a crease that is not known to be hidden is a window, which shrinks from both ends as occluders are looked
// at, the highest first. Roots are looked for only in the window. After `few` occluders the gaps between hidden parts
// are kept, too: if many balls are in one place, most further ones hide nothing of the gaps.
class CreaseOcclusion : public HiddenParts {
 public:
  CreaseOcclusion(const Crease &crease, FixedVector<HiddenInterval> &hidden)
      : HiddenParts(-crease.end, crease.end, hidden), crease_(crease) {
    hidden.clear();
    find_middle();
  }

  // A box around the part that may be seen, in the view plane.
  BoundingBox box() const {
    const SinCos end = sin_cos(crease_.end);
    BoundingBox box;
    extent(crease_.m.x, crease_.a.x, crease_.b.x, end, box.left, box.right);
    extent(crease_.m.y, crease_.a.y, crease_.b.y, end, box.bottom, box.top);
    return box;
  }

  // Hides what a ball covers. True if nothing is left.
  bool add_ball(const SeenBall &ball, uint32_t id) {
    uint32_t known = hidden_.size();
    if (has_many()) {
      const int side = CreaseBesideBall(crease_, ball).side_of({gap_, gaps_});
      if (side != 0) return side > 0;
    } else if (++tried_ > few) {
      known = 0;
      add_gap({from_, to_});
    }
    begin_body();
    add_breakpoints(ball, id);
    const auto depth = [&](double from, double to) {
      return depth_behind(count_ == 0 ? middle_ : crease_.at(0.5 * (from + to)), ball);
    };
    if (cut(shallow_depth * ball.r * ball.r, depth)) return true;
    if (!has_many()) {
      if (narrow()) find_middle();
      return from_ >= to_;
    }
    for (; known < hidden_.size(); ++known) take_from_gaps(hidden_[known].from, hidden_[known].to);
    if (gaps_ == 0) return true;
    from_ = gap_[0].ends.from;
    to_ = gap_[gaps_ - 1].ends.to;
    find_middle();
    return false;
  }
  // Whether so many balls have been tried that gaps are kept.
  bool has_many() const { return tried_ > few; }

 private:
  void find_middle() { middle_ = crease_.at(0.5 * (from_ + to_)); }

  [[gnu::noinline]] void add_gap(CreaseEnds ends) {
    // If there are too many gaps, the last one goes on to the end of the new one.
    if (gaps_ == most_gaps) ends.from = gap_[--gaps_].ends.from;
    gap_[gaps_++] = PartOfCrease(ends);
  }
  [[gnu::noinline]] void take_from_gaps(double from, double to) {
    CreaseEnds left[most_gaps + 1];
    uint32_t count = 0;
    bool changes = false;
    for (uint32_t k = 0; k < gaps_; ++k) {
      const CreaseEnds gap = gap_[k].ends;
      if (to <= gap.from || from >= gap.to) {
        left[count++] = gap;
        continue;
      }
      changes = true;
      if (from > gap.from) left[count++] = {gap.from, from};
      if (to < gap.to) left[count++] = {to, gap.to};
    }
    if (!changes) return;
    gaps_ = 0;
    for (uint32_t k = 0; k < count; ++k) add_gap(left[k]);
  }

  // The range of m + rho (a cos t + b sin t) over |t| <= end, a little widened.
  void extent(double m, double a, double b, const SinCos &end, double &low, double &high) const {
    const double rho = crease_.rho * (1.0 + 0x1p-40);
    const double first = a * end.cosine - b * end.sine;
    const double last = a * end.cosine + b * end.sine;
    const double amplitude = std::sqrt(a * a + b * b);
    // The extreme points are at the angle of (a, b) and opposite it.
    const bool top_within = a >= amplitude * end.cosine;
    const bool bottom_within = -a >= amplitude * end.cosine;
    high = m + rho * (top_within ? amplitude : first > last ? first : last);
    low = m - rho * (bottom_within ? amplitude : first < last ? -first : -last);
    const double margin = 0x1p-40 * rho;
    high += margin;
    low -= margin;
  }

  // The breakpoints at which the crease may go behind the ball or come out: above the ball's centre on its sphere,
  // below on the cylinder under its silhouette. Sphere and cylinder meet at the height of the centre, |t| = level.
  void add_breakpoints(const SeenBall &ball, uint32_t id) {
    const Crease &c = crease_;
    const Vec3 w{c.m.x - ball.x, c.m.y - ball.y, c.m.z - ball.z};
    double level = pi;
    if (w.z + c.rise <= 0.0) {
      level = 0.0;
    } else if (w.z - c.rise < 0.0) {
      level = arc_tangent(std::sqrt((c.rise - w.z) * (c.rise + w.z)), -w.z);
    }
    if (level > 0.0) {
      const double A = 2 * c.rho * dot(w, c.a);
      const double B = 2 * c.rho * dot(w, c.b);
      const double K = ball.r * ball.r - dot(w, w) - c.rho * c.rho;
      visit_level(A, B, K, [&](double t) {
        const double above = level - std::fabs(t);
        if (above >= 0.0) add(t, {MapVertexKind::triple, id});
        if (std::fabs(above) < level_height && is_open(t)) certain_ = false;
      });
    }
    if (level < to_ || -level > from_) {
      const double wa = w.x * c.a.x + w.y * c.a.y;
      const double wb = w.x * c.b.x + w.y * c.b.y;
      const TrigonometricPolynomial beside{w.x * w.x + w.y * w.y - ball.r * ball.r + c.rho * c.rho, 2 * c.rho * wa,
                                           2 * c.rho * wb, -c.rise * c.rise};
      if (level == 0.0) {
        add_roots(beside, from_, to_, id);
      } else {
        add_roots(beside, from_, to_ < -level ? to_ : -level, id);
        add_roots(beside, from_ > level ? from_ : level, to_, id);
      }
    }
  }

  void add_roots(const TrigonometricPolynomial &f, double from, double to, uint32_t id) {
    double root[most_trigonometric_roots];
    const uint32_t count = find_roots(f, from, to, root);
    for (uint32_t k = 0; k < count; ++k) add(root[k], {MapVertexKind::t, id});
  }

  static constexpr uint32_t few = 12, most_gaps = 4;
  const Crease &crease_;
  Vec3 middle_{};
  PartOfCrease gap_[most_gaps];
  uint32_t gaps_ = 0, tried_ = 0;
};

bool may_hide(const SeenBall &ball, const BoundingBox &box) {
  const double right = box.left - ball.x;
  const double left = ball.x - box.right;
  const double above = box.bottom - ball.y;
  const double below = ball.y - box.top;
  const double dx = right > left ? right : left;
  const double dy = above > below ? above : below;
  const double x = dx > 0.0 ? dx : 0.0;
  const double y = dy > 0.0 ? dy : 0.0;
  return x * x + y * y < ball.r * ball.r;
}

}  // namespace

bool find_crease_arcs(SeenBalls &seen, uint32_t far, uint32_t nearer, Span<const uint32_t> near,
                      FixedVector<HiddenInterval> &hidden, FixedVector<MapArc> &arcs, uint32_t &hider) {
  const Span<const SeenBall> balls = seen.balls();
  const Crease crease(balls[far], balls[nearer]);
  if (!crease.exists) return true;
  // The crease is level with the silhouette of the nearer ball, so that rounding decides where they touch.
  if (!crease.is_whole() && crease.rise < level_slope * crease.rho) return false;
  CreaseOcclusion occlusion(crease, hidden);
  const BoundingBox box = occlusion.box();
  if (seen.hides(box, crease.m.z + crease.rise)) return true;
  // Most often a crease is hidden by the same ball as the crease before.
  if (hider != no_id && hider != nearer && may_hide(balls[hider], box)) {
    if (CreaseOcclusion(crease, hidden).add_ball(balls[hider], hider)) return true;
    hidden.clear();
  }
  const double lowest = crease.is_whole() ? crease.m.z - crease.rise : balls[nearer].z;
  for (const uint32_t k : near) {
    if (balls[k].top() <= lowest) break;
    if (k != nearer && may_hide(balls[k], box) && occlusion.add_ball(balls[k], k)) {
      hider = occlusion.has_many() ? k : no_id;
      return occlusion.certain();
    }
  }
  const ArcEnd natural{crease.is_whole() ? MapVertexKind::plain : MapVertexKind::tangency, no_id};
  push_visible(hidden.items(), -crease.end, crease.end, natural, far, nearer, arcs);
  return occlusion.certain();
}

namespace {

// Whether depth cells hide the whole silhouette of a ball, asked for each eighth of it.
bool is_buried(SeenBalls &seen, const SeenBall &ball) {
  constexpr double diagonal = 0x1.6a09e667f3bcdp-1;  // sqrt(1/2), rounded up
  const double r = ball.r;
  const double inner = diagonal * (1.0 - 0x1p-50) * r;
  const double outer = r * (1.0 + 0x1p-50);
  for (uint32_t eighth = 0; eighth < 8; ++eighth) {
    const double right = (eighth & 1U) != 0 ? -1.0 : 1.0;
    const double up = (eighth & 2U) != 0 ? -1.0 : 1.0;
    const bool steep = (eighth & 4U) != 0;
    // The box of an eighth: from 0 to the diagonal along one axis, from the diagonal to the radius along the other.
    const double x[2] = {steep ? 0.0 : right * inner, right * (steep ? diagonal * r : outer)};
    const double y[2] = {steep ? up * inner : 0.0, up * (steep ? outer : diagonal * r)};
    BoundingBox box;
    box.left = ball.x + (x[0] < x[1] ? x[0] : x[1]);
    box.right = ball.x + (x[0] < x[1] ? x[1] : x[0]);
    box.bottom = ball.y + (y[0] < y[1] ? y[0] : y[1]);
    box.top = ball.y + (y[0] < y[1] ? y[1] : y[0]);
    if (!seen.hides(box, ball.z)) return false;
  }
  return true;
}

// Adds the part of the silhouette that another ball hides. A nearer ball hides what is in its disc; a farther one hides
// what is inside it, which at this height is a smaller disc. True if the whole silhouette is hidden.
//
// A farther ball hides nothing if the two have no crease, a part if the crease ends at this silhouette, and all if the
// crease is a whole circle above it. Crease decides both, so that rounding cannot make them differ.
bool add_hidden(const SeenBall &own, const SeenBall &other, uint32_t id, bool nearer,
                FixedVector<HiddenInterval> &hidden) {
  const double dz = other.z - own.z;
  const double R_squared = nearer ? other.r * other.r : (other.r - dz) * (other.r + dz);
  const double dx = other.x - own.x;
  const double dy = other.y - own.y;
  const double d_squared = dx * dx + dy * dy;
  const double longest = 2 * std::sqrt(d_squared) * own.r;
  const double along = d_squared + own.r * own.r - R_squared;
  if (nearer) {
    if (d_squared == 0.0) return R_squared >= own.r * own.r;
    if (along >= longest) return false;
    if (along <= -longest) return true;
  } else {
    if (along > longest + 0x1p-30 * own.r * own.r) return false;  // for certain
    const Crease crease(other, own);
    if (!crease.exists) return false;
    if (crease.is_whole()) return true;
  }
  const double product = (longest - along) * (longest + along);
  const double half = arc_tangent(std::sqrt(product > 0.0 ? product : 0.0), along);
  const double middle = arc_tangent(dy, dx);
  const ArcEnd end{nearer ? MapVertexKind::t : MapVertexKind::tangency, id};
  hide_angles(hidden, middle, half, end);
  return false;
}

Span<const uint32_t> leave_out_covered(SeenBalls &seen, Span<uint32_t> near, Patience &patience) {
  uint32_t left = 0;
  for (const uint32_t k : near) {
    near[left] = k;
    left += seen.is_covered(k, patience) ? 0U : 1U;
  }
  return near.part(0, left);
}

}  // namespace

bool find_silhouette_arcs(SeenBalls &seen, uint32_t ball, Span<const uint32_t> near,
                          FixedVector<HiddenInterval> &hidden, FixedVector<MapArc> &arcs) {
  const Span<const SeenBall> balls = seen.balls();
  if (is_buried(seen, balls[ball])) return true;
  hidden.clear();
  for (const uint32_t k : near) {
    if (add_hidden(balls[ball], balls[k], k, seen.is_nearer(k, ball), hidden)) return true;
  }
  return push_visible(hidden.items(), -pi, pi, {}, ball, no_id, arcs);
}

void ArcFinder::carve(Workspace &workspace, const MapLimits &limits) {
  arcs_ = FixedVector<MapArc>(workspace.take<MapArc>(limits.edges));
  near_ = FixedVector<uint32_t>(workspace.take<uint32_t>(limits.neighbours));
  const uint64_t intervals = static_cast<uint64_t>(most_hidden_per_occluder) * limits.neighbours;
  hidden_ = FixedVector<HiddenInterval>(workspace.take<HiddenInterval>(intervals));
}

bool ArcFinder::find(SeenBalls &seen, const DiscGrid &grid, Patience &patience) {
  arcs_.clear();
  needed_neighbours_ = 0;
  certain_ = complete_ = true;
  const Span<const SeenBall> balls = seen.balls();
  for (uint32_t i = 0; i < balls.size(); ++i) {
    if (balls[i].inside != 0) continue;
    if (!patience.allows(2000)) return false;
    grid.gather(i, near_);
    needed_neighbours_ = larger_count(needed_neighbours_, clamped_count(near_.required()));
    if (near_.overflowed()) continue;
    Span<const uint32_t> near = near_.items();
    bool marked = false;
    if (CoveredBalls::are_many(near.size())) {
      // Every limit that suffices has memory for so many, and the map is the same with all of these limits.
      seen.use_room(needed_neighbours_);
      if (seen.is_covered(i, patience)) continue;
      near = leave_out_covered(seen, near_.items(), patience);
      marked = seen.mark_creases(i, patience);
    }
    if (!patience.allows(200 * uint64_t{near.size()} * near.size())) return false;
    if (!find_silhouette_arcs(seen, i, near, hidden_, arcs_)) complete_ = false;
    uint32_t hider = no_id;
    for (const uint32_t k : near) {
      if (!seen.is_nearer(k, i) || (marked && !seen.may_crease(k))) continue;
      if (!find_crease_arcs(seen, i, k, near, hidden_, arcs_, hider)) certain_ = false;
    }
    if (marked) seen.unmark_creases();
  }
  return true;
}

}  // namespace hsp
