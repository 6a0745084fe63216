#include "pores/tied_balls.hpp"

#include <initializer_list>

#include "core/extremes.hpp"
#include "exact/filter.hpp"

namespace hsp {
namespace {

// Which signs some numbers have, those of numbers that are no larger than a margin left out.
struct Signs {
  bool positive = false, negative = false;
  void add(double number, double margin = 0.0) {
    positive = positive || number > margin;
    negative = negative || number < -margin;
  }
  bool any() const { return positive || negative; }
  bool both() const { return positive && negative; }
};

// The kind of a point that is in one plane with all tied balls: a gate if the directions positively span the plane.
PointKind kind_in_plane(const TangentPoint &point, Span<const uint32_t> tied, const TangentCurve &plane) {
  bool apart = false;
  for (const uint32_t i : tied) {
    Signs signs;
    for (const uint32_t j : tied) {
      if (j != i && !signs.both()) signs.add(point.side_of_edge(plane, i, j));
    }
    if (signs.any() && !signs.both()) return PointKind::passing;
    apart = apart || signs.any();
  }
  return apart ? PointKind::gate : PointKind::passing;
}

// On which side of planes a point is, in doubles. Normals are products of differences of centres, which are exact. Of a
// product of three differences that are at most 1 along each axis a component is below 8 and wrong by less than 2^-48.
class PlainSides {
 public:
  PlainSides(const BallSet &balls, const TangentPoint &point, double scale)
      : balls_(balls), at_(point.position_estimate()), error_(point.position_error()), scale_(scale) {}
  // The side of a plane through a centre; 0 if it is not certain. The normal is a product of differences; length: the
  // product of their lengths, without those in `scale`.
  int side(const Vec3 &normal, double length, uint32_t centre) const {
    const Vec3 off = at_ - Vec3{balls_.x[centre], balls_.y[centre], balls_.z[centre]};
    const double most = scale_ * length;
    return exact::certain_sign(dot(normal, off), most * (24.0 * error_ + 0x1p-44 * (longest_part(off) + error_)));
  }

 private:
  const BallSet &balls_;
  Vec3 at_;
  double error_, scale_;
};

constexpr double clear_of_rounding = 1e-9, clear_of_slivers = 1e-5;
// A ball is nearly in a plane if its direction is off it by nearly_in_plane at most. The plane is that of two
// directions whose cross product is longer than far_apart.
constexpr double nearly_in_plane = 1e-8, far_apart = 0.02;
constexpr uint32_t fewest_clustered = 9;

// The side of the hull of some unit vectors that 0 is least inside of, or farthest outside.
struct HullSide {
  Vec3 outward;
  double inside;  // how far 0 is inside of it; below 0: outside
  bool any;
  bool leaves_out;  // whether triangles are left out whose planes doubles do not know: sides of the hull may be missing
};
HullSide nearest_side(Span<const Vec3> a, const uint32_t *chosen, uint32_t size) {
  HullSide nearest{{0.0, 0.0, 0.0}, 1.0, false, false};
  for (uint32_t i = 0; i < size; ++i) {
    for (uint32_t j = i + 1; j < size; ++j) {
      for (uint32_t k = j + 1; k < size; ++k) {
        const Vec3 &p = a[chosen[i]];
        const Vec3 n = cross(a[chosen[j]] - p, a[chosen[k]] - p);
        const double length = std::sqrt(dot(n, n));
        if (length < 1e-6) {
          nearest.leaves_out = true;
          continue;
        }
        // A plane is a side if all vectors are on one side of it, or nearly: a plane too many only makes the bound
        // less.
        Signs heights;
        for (uint32_t l = 0; l < size && !heights.both(); ++l) heights.add(dot(n, a[chosen[l]] - p), 1e-9 * length);
        if (heights.both()) continue;
        const double offset = dot(n, p) / length;
        // If all vectors are in one plane, the hull has no inside.
        const double inside = heights.positive ? -offset : heights.negative ? offset : -std::fabs(offset);
        if (inside < nearest.inside) {
          nearest.inside = inside;
          nearest.outward = heights.positive ? -n : n;
        }
        nearest.any = true;
      }
    }
  }
  return nearest;
}

// Leaves out vectors that are near to one before; returns how many stay. Then no triangle has a plane that doubles do
// not know: a triangle of unit vectors whose sides are s and longer has twice an area of s^3 / 2 at least.
uint32_t keep_apart(Span<const Vec3> a, uint32_t *chosen, uint32_t size) {
  uint32_t left = 0;
  for (uint32_t k = 0; k < size; ++k) {
    bool apart = true;
    for (uint32_t c = 0; c < left && apart; ++c) {
      const Vec3 d = a[chosen[k]] - a[chosen[c]];
      apart = dot(d, d) > 2e-4;
    }
    if (apart) chosen[left++] = chosen[k];
  }
  return left;
}

}  // namespace

double depth_of_hull(Span<const Vec3> a, Vec3 *outward) {
  const uint32_t count = a.size();
  constexpr uint32_t spread_out = 10, most = 16;  // the hull of some of them is inside that of all
  uint32_t chosen[most] = {0};
  uint32_t size = count <= spread_out ? count : 1;
  for (uint32_t k = 0; k < size; ++k) chosen[k] = k;
  // Each next vector is the farthest one from those before.
  for (; size < spread_out && size < count; ++size) {
    uint32_t which = 0;
    double farthest = 0.0;
    for (uint32_t k = 0; k < count; ++k) {
      double nearest_chosen = 8.0;
      for (uint32_t c = 0; c < size; ++c) {
        const Vec3 d = a[k] - a[chosen[c]];
        nearest_chosen = smaller_of(nearest_chosen, dot(d, d));
      }
      if (nearest_chosen > farthest) {
        farthest = nearest_chosen;
        which = k;
      }
    }
    chosen[size] = which;
  }
  // Then the vectors that are farthest beyond the side nearest to 0 are added.
  for (;;) {
    HullSide side = nearest_side(a, chosen, size);
    const bool last = side.leaves_out;
    if (last) side = nearest_side(a, chosen, keep_apart(a, chosen, size));
    if (outward != nullptr) *outward = side.outward;
    if (!side.any) return -1.0;
    if (last || side.inside > 0.1 || size == count || size == most) return side.inside - 1e-8;
    uint32_t which = chosen[0];
    for (uint32_t k = 0; k < count; ++k) which = dot(side.outward, a[k] - a[which]) > 0.0 ? k : which;
    for (uint32_t k = 0; k < size; ++k) {
      if (chosen[k] == which) return side.inside - 1e-8;
    }
    chosen[size++] = which;
  }
}

double depth_in_plane(Span<const Vec3> a, Span<const Vec3> y, double &off_plane) {
  const uint32_t count = a.size();
  Vec3 n{0.0, 0.0, 0.0};
  for (uint32_t k = 1; k < count; ++k) {
    const Vec3 other = cross(a[0], a[k]);
    if (dot(other, other) > dot(n, n)) n = other;
  }
  const double length = std::sqrt(dot(n, n));
  if (!(length > 1e-3)) return -1.0;
  n = (1.0 / length) * n;
  off_plane = 0.0;
  double nearly = 0.0;
  for (uint32_t k = 0; k < count; ++k) {
    off_plane = larger_of(off_plane, std::fabs(dot(n, y[k])) + 4.0);
    nearly = larger_of(nearly, std::fabs(dot(n, a[k])));
  }
  uint32_t three[3];
  return depth_in_circle(a, n, nearly, three);
}

double depth_in_circle(Span<const Vec3> a, const Vec3 &n, double nearly, uint32_t *three) {
  // A monotone measure of the angle from one vector to another, from 0 to 4 for a whole turn.
  const auto turn = [&](uint32_t from, uint32_t to) {
    const double across = dot(n, cross(a[from], a[to])), along = dot(a[from], a[to]);
    return across >= 0.0 ? 1.0 - along : 3.0 + along;
  };
  // The first and the last vector of each sector of the circle. Gaps within one sector are at most `narrow`.
  constexpr uint32_t sectors = 64;
  constexpr double narrow = 0.07;
  uint32_t first[sectors], last[sectors];
  double least[sectors], most[sectors];
  for (uint32_t s = 0; s < sectors; ++s) first[s] = last[s] = no_id;
  double before = 0.0, behind = 4.0;
  uint32_t origin = no_id;
  for (uint32_t k = 0; k < a.size(); ++k) {
    if (!(std::fabs(dot(n, a[k])) <= nearly)) continue;
    if (origin == no_id) origin = k;
    const double at = k == origin ? 0.0 : turn(origin, k);
    const auto own = static_cast<uint32_t>(16.0 * at);
    const uint32_t s = own < sectors ? own : sectors - 1;
    if (first[s] == no_id || at < least[s]) {
      first[s] = k;
      least[s] = at;
    }
    if (last[s] == no_id || at > most[s]) {
      last[s] = k;
      most[s] = at;
    }
    // three[1] and three[2] are next to the direction opposite to the first vector, on its two sides.
    if (at > before && at < 2.0) {
      before = at;
      three[1] = k;
    }
    if (at >= 2.0 && at < behind) {
      behind = at;
      three[2] = k;
    }
  }
  if (!(before > 0.0) || !(behind < 4.0)) return -1.0;
  three[0] = origin;
  double widest = narrow;
  uint32_t from = last[0];
  for (uint32_t s = 1; s < sectors; ++s) {
    if (first[s] == no_id) continue;
    widest = larger_of(widest, turn(from, first[s]));
    from = last[s];
  }
  widest = larger_of(widest, turn(from, origin));
  // The cosine of half the widest gap between neighbours, less what the vectors are off the plane.
  return widest < 2.0 ? std::sqrt(0.5 * (2.0 - widest)) - 2.0 * nearly - 1e-7 : -1.0;
}

bool find_far_apart(const BallSet &balls, Span<const uint32_t> near, uint32_t *set) {
  for (uint32_t k = 0; k < 4; ++k) set[k] = near[0];
  for (uint32_t turn = 0; turn < 3; ++turn) {
    double best = 0.0;
    const Vec3 u = balls.difference(set[0], set[1]), v = balls.difference(set[0], set[2]);
    for (const uint32_t ball : near) {
      const Vec3 w = balls.difference(set[0], ball), n = cross(u, turn == 1 ? w : v);
      const double size = turn == 0 ? dot(w, w) : turn == 1 ? dot(n, n) : std::fabs(dot(n, w));
      if (size > best) {
        best = size;
        set[turn + 1] = ball;
      }
    }
    if (best == 0.0) return false;
  }
  return true;
}

// Doubles may not know the point well, because the balls that define it are close together. Then sharper bounds, or
// four tied balls that are far apart, may give it.
TiedDirections::TiedDirections(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied,
                               Span<Vec3> room)
    : balls_(balls), point_(point), tied_(tied) {
  if (tied.size() < 4 || tied.size() > room.size() || take(point, room) || tied.size() < fewest_clustered) return;
  uint32_t four[4];
  if (!take(point.sharpened(), room) && find_far_apart(balls, tied, four)) {
    static_cast<void>(take(point.found_by(four), room));
  }
}

// Takes the directions from the centres to a point, in doubles. False if these do not know the point well.
bool TiedDirections::take(const TangentPoint &point, Span<Vec3> room) {
  const Vec3 at = point.position_estimate();
  const double error = point.position_error();
  for (uint32_t k = 0; k < tied_.size(); ++k) {
    const Vec3 y = at - Vec3{balls_.x[tied_[k]], balls_.y[tied_[k]], balls_.z[tied_[k]]};
    const double length = std::sqrt(dot(y, y));
    if (!(error < 1e-11 * length)) return false;
    room[k] = (1.0 / length) * y;
  }
  count_ = tied_.size();
  a_ = room.part(0, count_);
  return true;
}

// Whether all directions but i and j are certainly all around the line through `from` along `along`, which is not
// short.
bool TiedDirections::is_around(const Vec3 &along, const Vec3 &from, uint32_t i, uint32_t j) const {
  // Two vectors across the line.
  const Vec3 some = std::fabs(along.x) < std::fabs(along.y) ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 u = cross(along, some), v = cross(along, u);
  constexpr double clear = 16 * clear_of_rounding;     // lengths are up to 8
  double right[2] = {0.0, 0.0}, left[2] = {0.0, 0.0};  // the outermost directions so far, less than half a turn apart
  const auto turn = [](const double *p, const double *q) { return p[0] * q[1] - p[1] * q[0]; };
  bool any = false;
  for (uint32_t l = 0; l < count_; ++l) {
    if (l == i || l == j) continue;
    const Vec3 d = a_[l] - from;
    const double here[2] = {dot(u, d), dot(v, d)};
    if (turn(right, left) > clear && turn(left, here) > clear && turn(here, right) > clear) return true;
    const bool beyond_right = !any || turn(right, here) < 0.0, beyond_left = !any || turn(left, here) > 0.0;
    for (int axis = 0; axis < 2; ++axis) {
      if (beyond_right) right[axis] = here[axis];
      if (beyond_left && !(any && beyond_right)) left[axis] = here[axis];
    }
    any = true;
  }
  return false;
}

// On a curve that leads up along v, a.v = s >= 0 for its own balls, and a.v >= s for all others. If ball i is on it,
// then (v - s a_i).a_k >= s - s a_i.a_k >= 0 for all k: as seen along a_i all other directions are on one side.
bool TiedDirections::is_inner(uint32_t i) const {
  return count_ > 0 && is_around(a_[i], {0.0, 0.0, 0.0}, i, i);
}

// As seen along the line through the ends of both directions, the other directions surround it.
bool TiedDirections::is_inner(uint32_t i, uint32_t j) const {
  return count_ > 0 && is_around(a_[j] - a_[i], a_[i], i, j);
}

bool TiedDirections::surround() const {
  return count_ > 0 && depth_of_hull(a_) > clear_of_slivers;
}

bool TiedDirections::surround_in_plane(bool &all) {
  if (count_ == 0) return false;
  Vec3 n{};
  static_cast<void>(depth_of_hull(a_, &n));
  const double length = std::sqrt(dot(n, n));
  if (!(length > 0.0)) return false;
  uint32_t three[3];
  if (!(depth_in_circle(a_, (1.0 / length) * n, nearly_in_plane, three) > 0.01)) return false;
  // A triangle that is as wide as possible.
  uint32_t wide = three[1];
  const auto width = [&](uint32_t k) {
    const Vec3 across = cross(a_[three[0]], a_[k]);
    return dot(across, across);
  };
  for (uint32_t l = 0; l < count_; ++l) {
    wide = std::fabs(dot(n, a_[l])) <= nearly_in_plane * length && width(l) > width(wide) ? l : wide;
  }
  const Plane *const plane = find_plane(three[0], three[1], wide);
  if (plane == nullptr || !plane->is_one || plane->side != 0 || !are_near(*plane, three[0], three[1], three[2])) {
    return false;
  }
  all = true;
  for (uint32_t l = 0; l < count_; ++l) all = all && is_near(*plane, l);
  return true;
}

// The direction in which all three distances grow alike is the normal of the plane through the ends of the three unit
// vectors. Of its two normals the one that points away from 0 leads up.
bool TiedDirections::is_closed(uint32_t i, uint32_t j, uint32_t k, int side) const {
  if (count_ == 0) return false;
  const Vec3 n = cross(a_[j] - a_[i], a_[k] - a_[i]);
  const double offset = dot(n, a_[i]);
  const bool beyond = side > 0 || offset > clear_of_rounding, before = side < 0 || offset < -clear_of_rounding;
  Signs heights;
  for (uint32_t l = 0; l < count_; ++l) {
    heights.add(dot(n, a_[l]) - offset, clear_of_rounding);
    if (heights.both() || (heights.positive && before) || (heights.negative && beyond)) return true;
  }
  return false;
}

bool TiedDirections::is_off_plane(uint32_t i, uint32_t j, uint32_t k) const {
  return count_ > 0 && std::fabs(dot(cross(a_[i], a_[j]), a_[k])) > clear_of_rounding;
}

bool TiedDirections::is_near(const Plane &plane, uint32_t i) const {
  return std::fabs(dot(plane.normal, a_[i])) <= nearly_in_plane;
}

bool TiedDirections::is_known_in_plane(uint32_t i, uint32_t j, uint32_t k) const {
  for (uint32_t p = 0; p < known_planes(); ++p) {
    if (planes_[p].is_one && planes_[p].side == 0 && are_near(planes_[p], i, j, k)) return true;
  }
  return false;
}

bool TiedDirections::are_known_in_plane(uint32_t i, uint32_t j, uint32_t k, uint32_t l) const {
  for (uint32_t p = 0; p < known_planes(); ++p) {
    if (planes_[p].is_one && are_near(planes_[p], i, j, k) && is_near(planes_[p], l)) return true;
  }
  return false;
}

// The plane of three directions that are nearly in one plane with the point. Null if no two of them are far apart, or
// if few balls are near the plane.
const TiedDirections::Plane *TiedDirections::find_plane(uint32_t i, uint32_t j, uint32_t k) {
  for (uint32_t p = 0; p < known_planes(); ++p) {
    if (are_near(planes_[p], i, j, k)) return &planes_[p];
  }
  const uint32_t pair[3][2] = {{i, j}, {i, k}, {j, k}};
  const uint32_t *widest = pair[0];
  Vec3 n{0.0, 0.0, 0.0};
  for (const auto &each : pair) {
    const Vec3 other = cross(a_[each[0]], a_[each[1]]);
    if (!(dot(other, other) > dot(n, n))) continue;
    n = other;
    widest = each;
  }
  const double length = std::sqrt(dot(n, n));
  if (!(length > far_apart)) return nullptr;
  Plane plane{(1.0 / length) * n, {0.0, 0.0, 0.0}, 0, true};
  // A triangle that is as wide as possible.
  const uint32_t first = tied_[widest[0]], second = tied_[widest[1]];
  uint32_t third = first, size = 0;
  for (uint32_t l = 0; l < count_; ++l) {
    if (!is_near(plane, l)) continue;
    ++size;
    const Vec3 other = cross(balls_.difference(first, second), balls_.difference(first, tied_[l]));
    if (!(dot(other, other) > dot(plane.turn, plane.turn))) continue;
    plane.turn = other;
    third = tied_[l];
  }
  if (size < 5 || are_collinear(balls_, first, second, third)) return nullptr;
  for (uint32_t l = 0; l < count_ && plane.is_one; ++l) {
    if (is_near(plane, l)) plane.is_one = are_coplanar(balls_, first, second, third, tied_[l]);
  }
  if (plane.is_one) plane.side = point_.side_of_plane(first, second, third);
  planes_[planes_found_++ % most_planes] = plane;
  return &planes_[(planes_found_ - 1) % most_planes];
}

// The side is the sign of det(C, C', y), C and C' the differences of the centres and y the vector from one to the
// point. That determinant is the one of the three unit vectors times the three distances. For centres in one plane all
// C x C' are parallel, so that each triangle turns one way or the other. The errors are those of PlainSides.
int TiedDirections::side_of_plane(uint32_t i, uint32_t j, uint32_t k) {
  if (count_ > 0) {
    const double height = dot(cross(a_[i], a_[j]), a_[k]);
    if (std::fabs(height) > clear_of_rounding) return height > 0.0 ? 1 : -1;
    const Plane *const plane = find_plane(i, j, k);
    if (plane != nullptr && plane->is_one && are_near(*plane, i, j, k)) {
      if (plane->side == 0) return 0;
      const Vec3 u = balls_.difference(tied_[i], tied_[j]), v = balls_.difference(tied_[i], tied_[k]), w = cross(u, v);
      if (longest_part(w) > 0x1p-40 * longest_part(u) * longest_part(v)) {
        return dot(w, plane->turn) > 0.0 ? plane->side : -plane->side;
      }
    }
  }
  return point_.side_of_plane(tied_[i], tied_[j], tied_[k]);
}

bool TiedDirections::are_apart(uint32_t i, uint32_t j) const {
  if (count_ == 0) return false;
  const Vec3 n = cross(a_[i], a_[j]);
  return dot(n, n) > clear_of_rounding;
}

bool TiedDirections::are_on_both_sides(uint32_t i, uint32_t j) const {
  if (count_ == 0) return false;
  const Vec3 n = cross(a_[i], a_[j]);
  Signs heights;
  for (uint32_t l = 0; l < count_ && !heights.both(); ++l) heights.add(dot(n, a_[l]), clear_of_rounding);
  return heights.both();
}

int TiedDirections::surround(uint32_t i, uint32_t j, uint32_t k, uint32_t l) const {
  if (count_ == 0) return 0;
  const Vec3 u = cross(a_[i], a_[j]), v = cross(a_[k], a_[l]);
  const double part[4] = {dot(a_[j], v), -dot(a_[i], v), dot(u, a_[l]), -dot(u, a_[k])};
  Signs signs;
  bool certain = true;
  for (const double each : part) {
    signs.add(each, clear_of_rounding);
    certain = certain && std::fabs(each) > clear_of_rounding;
  }
  return signs.both() ? -1 : certain ? 1 : 0;
}

PointKind kind_of(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, Span<Vec3> room) {
  TiedDirections directions(balls, point, tied, room);
  return kind_of(balls, point, tied, directions);
}

PointKind kind_of(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied,
                  TiedDirections &directions) {
  if (directions.surround()) return PointKind::maximum;
  // An extreme ray of K is orthogonal to two directions that are not parallel. Pairs that may be parallel come last: as
  // a rule nothing depends on them, and two opposite directions have every other one in a plane with them.
  bool solid = false, flat = false;
  for (const bool apart : {true, false}) {
    for (uint32_t a = 0; a < tied.size() && !flat; ++a) {
      for (uint32_t b = a + 1; b < tied.size() && !flat; ++b) {
        if (directions.are_apart(a, b) != apart) continue;
        if (directions.are_on_both_sides(a, b)) {
          solid = true;
          continue;
        }
        Signs signs;
        for (uint32_t c = 0; c < tied.size() && !signs.both(); ++c) {
          if (c != a && c != b) signs.add(directions.side_of_plane(a, b, c));
        }
        if (signs.any() && !signs.both()) return PointKind::passing;
        solid = solid || signs.any();
        flat = !signs.any() && apart;
      }
    }
  }
  if (solid) return PointKind::maximum;
  for (uint32_t c = 2; c < tied.size(); ++c) {
    if (!are_collinear(balls, tied[0], tied[1], tied[c])) {
      return kind_in_plane(point, tied, {tied[0], tied[1], tied[c]});
    }
  }
  return PointKind::passing;
}

bool is_in_triangle(const BallSet &balls, const TangentPoint &point, uint32_t i, uint32_t j, uint32_t k,
                    bool &on_side) {
  const TangentCurve plane{i, j, k};
  const uint32_t corner[3] = {i, j, k};
  const Vec3 u = balls.difference(i, j), v = balls.difference(i, k), normal = cross(u, v);
  const PlainSides sides(balls, point, longest_part(u) * longest_part(v));
  on_side = false;
  for (uint32_t c = 0; c < 3; ++c) {
    const uint32_t from = corner[c], to = corner[(c + 1) % 3];
    const Vec3 edge = balls.difference(from, to);
    int side = sides.side(cross(normal, edge), longest_part(edge), from);
    if (side == 0) side = point.side_of_edge(plane, from, to);
    if (side < 0) return false;
    on_side = on_side || side == 0;
  }
  return true;
}

bool is_in_tetrahedron(const BallSet &balls, const TangentPoint &point, const uint32_t *ids, bool &on_side) {
  const PlainSides sides(balls, point, 1.0);
  on_side = false;
  int turn = side_of_centre(balls, {ids[0], ids[1], ids[2]}, ids[3]);
  for (uint32_t c = 0; c < 4; ++c) {
    // The faces without corner 3, 2, 1, 0: from one to the next the orientation changes.
    const uint32_t left_out = 3 - c;
    uint32_t face[3], count = 0;
    for (uint32_t k = 0; k < 4; ++k) {
      if (k != left_out) face[count++] = ids[k];
    }
    const Vec3 u = balls.difference(face[0], face[1]), v = balls.difference(face[0], face[2]);
    const int certain = sides.side(cross(u, v), longest_part(u) * longest_part(v), face[0]);
    const int side = turn * (certain != 0 ? certain : point.side_of_plane(face[0], face[1], face[2]));
    if (side < 0) return false;
    on_side = on_side || side == 0;
    turn = -turn;
  }
  return true;
}

namespace {

void name_of_gate(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, uint32_t *name) {
  const uint32_t n = tied.size();
  bool on_side = false;
  name[3] = no_id;
  for (uint32_t a = 0; a < n; ++a) {
    for (uint32_t b = a + 1; b < n; ++b) {
      for (uint32_t c = b + 1; c < n; ++c) {
        name[0] = tied[a];
        name[1] = tied[b];
        name[2] = tied[c];
        if (n == 3 || (!are_collinear(balls, name[0], name[1], name[2]) &&
                       is_in_triangle(balls, point, name[0], name[1], name[2], on_side))) {
          return;
        }
      }
    }
  }
}

}  // namespace

void name_of(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, PointKind kind,
             Span<Vec3> room, uint32_t *name) {
  if (kind == PointKind::gate) return name_of_gate(balls, point, tied, name);
  const uint32_t n = tied.size();
  TiedDirections directions(balls, point, tied, room);
  bool on_side = false;
  for (uint32_t a = 0; a < n; ++a) {
    for (uint32_t b = a + 1; b < n; ++b) {
      for (uint32_t c = b + 1; c < n; ++c) {
        for (uint32_t d = c + 1; d < n; ++d) {
          name[0] = tied[a];
          name[1] = tied[b];
          name[2] = tied[c];
          name[3] = tied[d];
          const int certain = directions.surround(a, b, c, d);
          if (certain < 0) continue;
          if (certain == 0 && !directions.is_off_plane(a, b, c)) static_cast<void>(directions.side_of_plane(a, b, c));
          if (certain == 0 && directions.are_known_in_plane(a, b, c, d)) continue;
          if (n == 4 || certain > 0 ||
              (!are_coplanar(balls, name[0], name[1], name[2], name[3]) &&
               is_in_tetrahedron(balls, point, name, on_side))) {
            return;
          }
        }
      }
    }
  }
}

}  // namespace hsp
