#include "pores/tied_balls.hpp"

#include "core/extremes.hpp"

namespace hsp {
namespace {

// Signs of some numbers.
struct Signs {
  bool positive = false, negative = false;
  void add(int sign) {
    positive = positive || sign > 0;
    negative = negative || sign < 0;
  }
  bool any() const { return positive || negative; }
  bool both() const { return positive && negative; }
};

// All balls and the point in one plane: whether the directions span it.
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

// On which side of planes a point is, in doubles. Normals are products of differences, which are exact: of three of
// them that are at most 1 along each axis a component is below 8 and wrong by less than 2^-48.
class PlainSides {
 public:
  PlainSides(const BallSet &balls, const TangentPoint &point, double scale)
      : balls_(balls), at_(point.place_estimate()), error_(point.place_error()), scale_(scale) {}
  // Of a plane through a centre; 0 if that is not certain. length: the product of the lengths that the normal is of,
  // but for the common ones.
  int side(const Vec3 &normal, double length, uint32_t centre) const {
    const Vec3 off = at_ - Vec3{balls_.x[centre], balls_.y[centre], balls_.z[centre]};
    const double height = dot(normal, off), most = scale_ * length;
    const double doubt = most * (24.0 * error_ + 0x1p-44 * (longest_part(off) + error_));
    return height > doubt ? 1 : height < -doubt ? -1 : 0;
  }

 private:
  const BallSet &balls_;
  Vec3 at_;
  double error_, scale_;
};

constexpr double clear_of_rounding = 1e-9, clear_of_slivers = 1e-5;

}  // namespace

namespace {

// The plane through three of some unit vectors that bounds the hull of all, and is nearest to 0 or farthest beyond it.
struct HullSide {
  Vec3 outward;
  double inside;  // how far 0 is inside of it
  bool any;
};
HullSide nearest_side(Span<const Vec3> a, const uint32_t *chosen, uint32_t size) {
  HullSide nearest{{0.0, 0.0, 0.0}, 1.0, false};
  for (uint32_t i = 0; i < size; ++i) {
    for (uint32_t j = i + 1; j < size; ++j) {
      for (uint32_t k = j + 1; k < size; ++k) {
        const Vec3 &p = a[chosen[i]];
        const Vec3 n = cross(a[chosen[j]] - p, a[chosen[k]] - p);
        const double length = std::sqrt(dot(n, n));
        if (length < 1e-6) continue;
        // A plane counts if all are on one side of it, or nearly: one too many only makes the bound less.
        bool above = false, below = false;
        for (uint32_t l = 0; l < size && !(above && below); ++l) {
          const double height = dot(n, a[chosen[l]] - p);
          above = above || height > 1e-9 * length;
          below = below || height < -1e-9 * length;
        }
        if (above && below) continue;
        const double offset = dot(n, p) / length;
        // All in one plane have no inside.
        const double inside = above ? -offset : below ? offset : -std::fabs(offset);
        if (inside < nearest.inside) {
          nearest.inside = inside;
          nearest.outward = above ? -n : n;
        }
        nearest.any = true;
      }
    }
  }
  return nearest;
}

}  // namespace

double depth_of_hull(Span<const Vec3> a) {
  const uint32_t count = a.size();
  constexpr uint32_t spread_out = 10, most = 16;  // the hull of some of them is inside that of all
  uint32_t chosen[most] = {0};
  uint32_t size = count <= spread_out ? count : 1;
  for (uint32_t k = 0; k < size; ++k) chosen[k] = k;
  // Each the farthest one from those before.
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
  // Then those that are farthest beyond the side that is nearest to 0.
  for (;;) {
    const HullSide side = nearest_side(a, chosen, size);
    if (!side.any) return -1.0;
    if (side.inside > 0.1 || size == count || size == most) return side.inside - 1e-8;
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
  for (uint32_t k = 0; k < count; ++k) off_plane = larger_of(off_plane, std::fabs(dot(n, y[k])) + 4.0);
  double depth = 1.0;
  bool any = false;
  for (uint32_t i = 0; i < count; ++i) {
    for (uint32_t j = 0; j < count; ++j) {
      const Vec3 inward = cross(n, a[j] - a[i]);
      const double size = std::sqrt(dot(inward, inward));
      if (size < 1e-6) continue;
      // Lines through two of them with all others on the left, or nearly.
      bool right = false;
      for (uint32_t k = 0; k < count && !right; ++k) right = dot(inward, a[k] - a[i]) < -1e-9 * size;
      if (right) continue;
      depth = smaller_of(depth, -dot(inward, a[i]) / size);
      any = true;
    }
  }
  return any ? depth - 1e-8 : -1.0;
}

TiedDirections::TiedDirections(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied,
                               Span<Vec3> room) {
  if (tied.size() < 4 || tied.size() > room.size()) return;
  const Vec3 at = point.place_estimate();
  const double error = point.place_error();
  for (uint32_t k = 0; k < tied.size(); ++k) {
    const Vec3 y = at - Vec3{balls.x[tied[k]], balls.y[tied[k]], balls.z[tied[k]]};
    const double length = std::sqrt(dot(y, y));
    if (!(error < 1e-11 * length)) return;
    room[k] = (1.0 / length) * y;
  }
  count_ = tied.size();
  a_ = room.part(0, count_);
}

// Along their line the others surround it.
bool TiedDirections::is_inner(uint32_t i, uint32_t j) const {
  if (count_ == 0) return false;
  const Vec3 along = a_[j] - a_[i];
  // Two directions across it, of a length that is not small.
  const Vec3 some = std::fabs(along.x) < std::fabs(along.y) ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 u = cross(along, some), v = cross(along, u);
  constexpr double clear = 16 * clear_of_rounding;     // lengths are up to 8
  double right[2] = {0.0, 0.0}, left[2] = {0.0, 0.0};  // the outermost ones so far, less than half a turn apart
  const auto turn = [](const double *p, const double *q) { return p[0] * q[1] - p[1] * q[0]; };
  bool any = false;
  for (uint32_t l = 0; l < count_; ++l) {
    if (l == i || l == j) continue;
    const Vec3 d = a_[l] - a_[i];
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

bool TiedDirections::surround() const {
  return count_ > 0 && depth_of_hull(a_) > clear_of_slivers;
}

// The way along which all three distances grow alike is across their plane, and up where 0 is below it.
bool TiedDirections::is_closed(uint32_t i, uint32_t j, uint32_t k) const {
  if (count_ == 0) return false;
  const Vec3 n = cross(a_[j] - a_[i], a_[k] - a_[i]);
  const double offset = dot(n, a_[i]);
  bool above = false, below = false;
  for (uint32_t l = 0; l < count_; ++l) {
    const double height = dot(n, a_[l]) - offset;
    above = above || height > clear_of_rounding;
    below = below || height < -clear_of_rounding;
    if ((above && (below || offset < -clear_of_rounding)) || (below && offset > clear_of_rounding)) return true;
  }
  return false;
}

bool TiedDirections::is_off_plane(uint32_t i, uint32_t j, uint32_t k) const {
  return count_ > 0 && std::fabs(dot(cross(a_[i], a_[j]), a_[k])) > clear_of_rounding;
}

bool TiedDirections::are_apart(uint32_t i, uint32_t j) const {
  if (count_ == 0) return false;
  const Vec3 n = cross(a_[i], a_[j]);
  return dot(n, n) > clear_of_rounding;
}

bool TiedDirections::are_on_both_sides(uint32_t i, uint32_t j) const {
  if (count_ == 0) return false;
  const Vec3 n = cross(a_[i], a_[j]);
  bool above = false, below = false;
  for (uint32_t l = 0; l < count_ && !(above && below); ++l) {
    const double height = dot(n, a_[l]);
    above = above || height > clear_of_rounding;
    below = below || height < -clear_of_rounding;
  }
  return above && below;
}

int TiedDirections::surround(uint32_t i, uint32_t j, uint32_t k, uint32_t l) const {
  if (count_ == 0) return 0;
  const Vec3 u = cross(a_[i], a_[j]), v = cross(a_[k], a_[l]);
  const double part[4] = {dot(a_[j], v), -dot(a_[i], v), dot(u, a_[l]), -dot(u, a_[k])};
  bool positive = false, negative = false, certain = true;
  for (const double each : part) {
    positive = positive || each > clear_of_rounding;
    negative = negative || each < -clear_of_rounding;
    certain = certain && std::fabs(each) > clear_of_rounding;
  }
  return positive && negative ? -1 : certain ? 1 : 0;
}

PointKind kind_of(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, Span<Vec3> room) {
  const TiedDirections directions(balls, point, tied, room);
  if (directions.surround()) return PointKind::maximum;
  // The extreme rays of K are orthogonal to two directions that are not parallel.
  bool solid = false, flat = false;
  for (uint32_t a = 0; a < tied.size() && !flat; ++a) {
    for (uint32_t b = a + 1; b < tied.size() && !flat; ++b) {
      if (directions.are_on_both_sides(a, b)) {
        solid = true;
        continue;
      }
      Signs signs;
      for (uint32_t c = 0; c < tied.size() && !signs.both(); ++c) {
        if (c != a && c != b) signs.add(point.side_of_plane(tied[a], tied[b], tied[c]));
      }
      if (signs.any() && !signs.both()) return PointKind::passing;
      solid = solid || signs.any();
      flat = !signs.any() && directions.are_apart(a, b);
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
    // Without corner 3, 2, 1, 0: each exchange of two corners is a turn the other way.
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

void name_of_maximum(const BallSet &balls, const TangentPoint &point, Span<const uint32_t> tied, Span<Vec3> room,
                     uint32_t *name) {
  const uint32_t n = tied.size();
  const TiedDirections directions(balls, point, tied, room);
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
