// The linear program: it looks for the furthest point of the cell along a direction between the normals of three
// planes. It begins with the corner where these meet. While some plane cuts the corner off, this plane takes the place
// of one of the three (the dual simplex method; exact/PROOFS.md, section 7, "An empty cell").
//
// As an example the planes x = 1, y = 1 and z = 1, each of a ball beyond it, and the direction (1, 1, 1).
//   (1, 1, 1)        is the furthest point
//   x + y + z <= 1   cuts it off; its plane may take the place of any of the three, and the furthest points are on it
//   x + y + z >= 4   cuts off all that the first three leave: the cell is empty
#include "contacts/empty_cell.hpp"

#include "core/small_code.hpp"
#include "exact/power_vertex.hpp"

namespace hsp {
namespace {

using exact::Plane;

int orientation(const Plane &P, const Plane &Q, const Plane &R) {
  return exact::Exact::triple_product_sign(P.v, Q.v, R.v);
}

// The planes of three caps, in right-handed order, which meet in one point.
class Corner {
 public:
  // Takes the first plane, one whose normal is about as far as can be from the direction of the first normal, and one
  // whose normal is about as far as can be from the plane of both. False if the three do not meet in a point.
  bool start(const Caps &caps) {
    const Vec3 u = caps.axis(0);
    const uint32_t q = largest(caps, [&u](const Vec3 &v) {
      const Vec3 across = cross(u, v);
      return dot(across, across);
    });
    const Vec3 across = cross(u, caps.axis(q));
    const uint32_t r = largest(caps, [&across](const Vec3 &v) { return std::fabs(dot(across, v)); });
    put(caps, 0, 0);
    put(caps, 1, q);
    put(caps, 2, r);
    const int sign = orientation(plane_[0], plane_[1], plane_[2]);
    if (sign < 0) {
      put(caps, 1, r);
      put(caps, 2, q);
    }
    return sign != 0;
  }
  void put(const Caps &caps, uint32_t place, uint32_t cap) {
    cap_[place] = cap;
    plane_[place] = caps.plane(cap);
  }

  const Plane (&planes() const)[3] { return plane_; }
  bool has(uint32_t cap) const { return cap == cap_[0] || cap == cap_[1] || cap == cap_[2]; }
  // The orientation of the three with S in place of one of them.
  int with(const Plane &S, uint32_t place) const {
    return orientation(S, plane_[(place + 1) % 3], plane_[(place + 2) % 3]);
  }

  // Whether the three meet outside the ball: on the line of the first two, and not between the two points of the sphere
  // there.
  bool is_outside(const exact::Predicates &predicates) const {
    if (predicates.crossing(plane_[0], plane_[1]).sign < 0) return true;
    const exact::PointStatus status = predicates.point_status(plane_[0], plane_[1], plane_[2]);
    return (status.side[0] < 0) == (status.side[1] < 0);
  }

  // Roughly the point where the three meet, in units of the ball's radius.
  Vec3 place(const Caps &caps) const {
    const Vec3 u = caps.axis(cap_[0]), v = caps.axis(cap_[1]), w = caps.axis(cap_[2]);
    const Vec3 sum = combine(caps.b[cap_[0]], cross(v, w), caps.b[cap_[1]], cross(w, u));
    return 1.0 / dot(u, cross(v, w)) * combine(1.0, sum, caps.b[cap_[2]], cross(u, v));
  }
  // A direction between the three normals, as the normal of a plane.
  Plane direction(const Caps &caps) const {
    constexpr double weights[3] = {200000033.0, 260000041.0, 340000049.0};
    const Vec3 two = combine(weights[0], caps.axis(cap_[0]), weights[1], caps.axis(cap_[1]));
    const Vec3 sum = combine(1.0, two, weights[2], caps.axis(cap_[2]));
    return exact::virtual_plane({static_cast<int64_t>(sum.x), static_cast<int64_t>(sum.y), static_cast<int64_t>(sum.z)},
                                0);
  }

 private:
  template <class Size>
  static uint32_t largest(const Caps &caps, Size size) {
    double most = 0.0;
    uint32_t found = 0;
    for (uint32_t k = 0; k < caps.count; ++k) {
      const double of_cap = size(caps.axis(k));
      if (!(of_cap > most)) continue;
      most = of_cap;
      found = k;
    }
    return found;
  }

  Plane plane_[3];
  uint32_t cap_[3] = {0, 0, 0};
};

// A cap that holds the corner, so that its plane cuts it off: the deepest one by doubles if integers agree, else any.
// no_id if there is none.
uint32_t find_violated(const Caps &caps, const Corner &corner) {
  const exact::PowerVertex vertex(caps.sphere, corner.planes());
  const Vec3 p = corner.place(caps);
  double most = 0.0;
  uint32_t deepest = no_id;
  for (uint32_t k = 0; k < caps.count; ++k) {
    const double depth = dot(caps.axis(k), p) - caps.b[k];
    if (!(depth > most) || corner.has(k)) continue;
    most = depth;
    deepest = k;
  }
  if (deepest != no_id && vertex.near(caps.plane(deepest)).sign < 0) return deepest;
  for (uint32_t k = 0; k < caps.count; ++k) {
    if (!corner.has(k) && vertex.near(caps.plane(k)).sign < 0) return k;
  }
  return no_id;
}

}  // namespace

bool has_empty_cell(const Caps &caps) {
  constexpr uint32_t most_steps = 64, none = 3;
  Corner corner;
  if (small_code || caps.count == 0 || !corner.start(caps)) return false;
  const Plane along = corner.direction(caps);
  for (uint32_t place = 0; place < 3; ++place) {
    if (corner.with(along, place) <= 0) return false;
  }
  for (uint32_t step = 0; step < most_steps; ++step) {
    const uint32_t violated = find_violated(caps, corner);
    if (violated == no_id) return corner.is_outside(caps.predicates());
    const Plane S = caps.plane(violated);
    uint32_t leaves = none;
    for (uint32_t place = 0; place < 3; ++place) {
      if (corner.with(S, place) <= 0) continue;
      if (leaves == none) {
        leaves = place;
        continue;
      }
      // The plane that stays in any case is neither of these two.
      const bool next = place == leaves + 1;
      const int sign = orientation(along, S, corner.planes()[3 - place - leaves]);
      if (sign == 0) return false;
      if ((sign < 0) != next) leaves = place;
    }
    if (leaves == none) return true;
    corner.put(caps, leaves, violated);
  }
  return false;
}

}  // namespace hsp
