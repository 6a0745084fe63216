#include "maps/silhouette_arcs.hpp"

#include "maps/curves.hpp"

namespace hsp {
namespace {

// Whether depth cells hide the whole circle, asked for each eighth of it.
bool is_buried(SeenBalls &seen, const SeenBall &ball) {
  constexpr double diagonal = 0x1.6a09e667f3bcdp-1;  // sqrt(1/2), rounded up
  const double r = ball.r;
  const double inner = diagonal * (1.0 - 0x1p-50) * r;
  const double outer = r * (1.0 + 0x1p-50);
  for (uint32_t eighth = 0; eighth < 8; ++eighth) {
    const double right = (eighth & 1U) != 0 ? -1.0 : 1.0;
    const double up = (eighth & 2U) != 0 ? -1.0 : 1.0;
    const bool steep = (eighth & 4U) != 0;
    // From 0 to the diagonal along one axis, from the diagonal to the radius along the other.
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

// Adds what another ball hides of the circle. A nearer one hides what is in its disc, a farther one what is inside it,
// which is a smaller disc at this height. True if that is everything.
//
// Whether a farther ball hides nothing, a part or everything is the question whether their crease does not exist, ends
// at this silhouette or is a whole circle above it. Crease answers both, so that roundings cannot make them differ.
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

}  // namespace hsp
