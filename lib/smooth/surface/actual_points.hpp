// Positions of the points of the actual set (actual_balls.hpp) by which the smooth surface is decided, in numbers with
// an error bound: doubles, or floats of some width.
#pragma once

#include "core/extremes.hpp"
#include "core/small_code.hpp"
#include "surface/actual_numbers.hpp"
#include "surface/border_points.hpp"

namespace hsp {

template <class Number>
class ActualPoints : public ActualNumbers<Number> {
 public:
  using Vector = NumberVector<Number>;
  using Base = ActualNumbers<Number>;
  using Base::number;

  // All positions are relative to the centre of this ball, or for floats to the origin of its component.
  ActualPoints(const Base &numbers, uint32_t ball) : Base(numbers), ball_(ball), origin_(this->origin_for(ball)) {}

  uint32_t ball() const { return ball_; }
  Number probe() const { return number(this->balls.probe_steps); }
  Number probe_weight() const {
    const Number p = probe();
    return p * p;
  }
  Number square_of_diameter() const { return probe_weight().scaled(2); }
  // Writes the position of a ball's centre to x.
  void find_centre(uint32_t ball, Vector &x) const { this->find_difference(origin_, ball, x); }
  // Writes the position of a vertex to x. Floats are kept as they are returned; doubles are kept relative to the
  // vertex's first ball, where they are precise.
  void find_vertex(uint32_t v, Vector &x) const {
    const bool found = find_kept(v, x);
    if (!found) find_from_first_ball(v, x);
    if (!found && !Base::from_one_place) keep(v, x);
    if (!found || !Base::from_one_place) add_centre(this->boundary.vertex(v).ball[0], x);
    if (!found && Base::from_one_place) keep(v, x);
  }
  // The vector from a vertex to a point.
  [[gnu::noinline]] void find_arm(uint32_t v, const BorderPoint &point, Vector &arm) const {
    find_point(point, arm);
    if (point.kind == BorderPoint::Kind::cusp || v != point.id[0]) add_way_to_origin_of(point, v, arm);
  }
  [[gnu::noinline]] void add_way_to_origin_of(const BorderPoint &point, uint32_t v, Vector &arm) const {
    Vector way;
    if (point.kind == BorderPoint::Kind::cusp) {
      find_arm_to_ball(v, point.id[0], way);
    } else {
      find_arm_to_vertex(v, point.id[0], way);
    }
    arm += way;
  }
  [[gnu::noinline]] void find_arm_to_vertex(uint32_t v, uint32_t other, Vector &arm) const {
    Vector here;
    find_vertex(other, arm);
    find_vertex(v, here);
    arm -= here;
  }
  [[gnu::noinline]] void find_arm_to_ball(uint32_t v, uint32_t ball, Vector &arm) const {
    Vector here;
    find_centre(ball, arm);
    find_vertex(v, here);
    arm -= here;
  }
  // The normal of a side of the patch of v, towards the inside of the patch: the cross product of the vectors from v to
  // the first ball and to the second.
  [[gnu::noinline]] void find_inward(uint32_t v, uint32_t first, uint32_t second, Vector &normal) const {
    Vector arm;
    find_arm_to_ball(v, first, normal);
    find_arm_to_ball(v, second, arm);
    normal = cross(normal, arm);
  }
  // The probes' spheres at three vertices meet in the points middle - half and middle + half, relative to the first
  // vertex, or in none if D < 0. Returns the sign of D, or 0 if it is not certain; then `half` is not certain either.
  [[gnu::noinline]] int find_meeting(uint32_t a, uint32_t b, uint32_t c, Vector &middle, Vector &half) const {
    find_planes(a, b, c, half, middle);
    const Number square = dot(half, half);
    Number root = discriminant_of(square, middle, probe_weight());
    const int sign = root.sign();
    if (sign < 0) return sign;
    root = square_root(root);
    to_meeting(half, middle, square, root);
    return sign;
  }
  // Whether the point at `arm` from vertex v lies inside the three sides of v's patch: 1, -1, or 0 if that is not
  // certain.
  [[gnu::noinline]] int inside_of_sides(uint32_t v, const Vector &arm) const {
    int sure = 1;
    for (uint32_t slot = 0; slot < 3 && sure >= 0; ++slot) {
      const int inside = inside_of_side(v, slot, arm);
      if (inside <= 0) sure = inside;
    }
    return sure;
  }
  [[gnu::noinline]] int inside_of_side(uint32_t v, uint32_t slot, const Vector &arm) const {
    const VertexRecord &record = this->boundary.vertex(v);
    const SideOfPatch side = side_of_patch(record, slot);
    Vector inward;
    find_inward(v, record.ball[side.first], record.ball[side.second], inward);
    return dot(arm, inward).sign();
  }
  // Whether the probe at another vertex cuts something off the patch of v. It never cuts off a corner. So its centre
  // lies over the patch, or it reaches over a side whose point nearest to it lies between the side's ends
  // (near_probes.hpp).
  [[gnu::noinline]] int cuts_patch(uint32_t other, uint32_t v) const {
    Vector way;
    find_arm_to_vertex(v, other, way);
    const Number square = dot(way, way);
    Number reach = square_of_diameter() - square;
    if (const int overlap = reach.sign(); overlap <= 0) return overlap;
    reach = reach * square;
    int cuts = inside_of_sides(v, way);
    for (uint32_t slot = 0; slot < 3 && cuts < 0; ++slot) cuts = reaches_over_side(v, slot, way, reach);
    return cuts;
  }
  // Whether the point at `arm` from vertex v, |arm| = p, is in the probe at `other`: with d the vector from `other` to
  // v, (arm + d)^2 < arm^2.
  [[gnu::noinline]] int in_probe(uint32_t other, uint32_t v, const Vector &arm) const {
    Vector way, sum;
    find_arm_to_vertex(other, v, way);
    sum = {arm.x.scaled(1), arm.y.scaled(1), arm.z.scaled(1)};
    sum += way;
    return -dot(way, sum).sign();
  }
  // rho^2 - p^2, times the square of twice the distance of the centres. If this is less than 0 and the circle's plane
  // lies between the centres, saddles reach the axis.
  Number height_over_axis(uint32_t a, uint32_t b) const {
    Vector u;
    this->find_difference(a, b, u);
    const Number square = dot(u, u), twice = square + this->weight_difference(a, b);
    return (square * this->weight_over_probe(a)).scaled(2) - twice * twice;
  }
  // Twice the distance of ball a's centre from the plane of its circle with b, times the distance of the two centres.
  Number height_of_circle(uint32_t a, uint32_t b) const {
    Vector u;
    this->find_difference(a, b, u);
    return height(a, b, u);
  }
  // A vector at right angles to u, of about its length if `axis` is the coordinate axis that u is least along.
  [[gnu::noinline]] void find_across(const Vector &u, int axis, Vector &across) const {
    constexpr int64_t along[] = {104, 39, 25, 104, 39};  // the axis, the next one, the last one
    const int first = (3 - axis) % 3;
    across = cross(u, Vector{number(along[first]), number(along[first + 1]), number(along[first + 2])});
    across *= number(1).scaled(-7);
  }

 private:
  Number height(uint32_t a, uint32_t b, const Vector &u) const { return dot(u, u) + this->weight_difference(a, b); }
  [[gnu::noinline]] void add_centre(uint32_t ball, Vector &x) const {
    Vector centre;
    find_centre(ball, centre);
    x += centre;
  }

  // Where three spheres meet (exact/PROOFS.md), as seen from the centre of the first: u and z are the centres of the
  // others, h_u and h_z twice the distances of the planes, times those of the centres, n = u x z, q = h_u z - h_z u, D
  // = 4 w n.n - q.q. Writes n to u, and q to z.
  [[gnu::noinline]] static void to_normals(Vector &u, const Number &h_u, Vector &z, const Number &h_z) {
    Vector n = cross(u, z);
    z *= h_u;
    u *= h_z;
    z -= u;
    u = n;
  }
  [[gnu::noinline]] Number half_over(const Number &square) const { return (number(1) / square).scaled(-1); }
  [[gnu::noinline]] static void to_cross(Vector &a, const Vector &b) { a = cross(a, b); }
  // Writes q x n / (2 n.n) to q, and root n / (2 n.n) to n.
  [[gnu::noinline]] void to_meeting(Vector &n, Vector &q, const Number &square, const Number &root) const {
    const Number factor = half_over(square);
    to_cross(q, n);
    q *= factor;
    n *= root * factor;
  }
  [[gnu::noinline]] void find_planes_of_balls(const VertexRecord &record, Vector &n, Vector &q) const {
    this->find_difference(record.ball[0], record.ball[1], n);
    this->find_difference(record.ball[0], record.ball[2], q);
    const Number h_n = height(record.ball[0], record.ball[1], n);
    to_normals(n, h_n, q, height(record.ball[0], record.ball[2], q));
  }
  // name: a vertex, or for another point a number that no vertex has.
  bool find_kept(uint32_t name, Vector &x) const {
    if constexpr (small_code) return false;
    return this->kept.find(name, this->bits, x);
  }
  void keep(uint32_t name, const Vector &x) const {
    if constexpr (!small_code) this->kept.keep(name, this->bits, x);
  }
  // With w = way, g the side's normal and t the probe's diameter: the ends as below, w.g < 0 and (w.g)^2 t^2 < w^2 (t^2
  // - w^2) g^2 = reach g^2.
  [[gnu::noinline]] int reaches_over_side(uint32_t v, uint32_t slot, const Vector &way, const Number &reach) const {
    const VertexRecord &record = this->boundary.vertex(v);
    const SideOfPatch side = side_of_patch(record, slot);
    const uint32_t first = record.ball[side.first], last = record.ball[side.second];
    const int over = over_side(v, first, last, way, reach);
    return over < 0 ? over : smaller_of(over, between_ends(v, first, last, way));
  }
  [[gnu::noinline]] int over_side(uint32_t v, uint32_t first, uint32_t last, const Vector &way,
                                  const Number &reach) const {
    Vector normal;
    find_inward(v, first, last, normal);
    const Number along = dot(way, normal);
    const int outside = -along.sign();
    if (outside < 0) return outside;
    return smaller_of(outside, (reach * dot(normal, normal) - along * along * square_of_diameter()).sign());
  }
  // Whether the point of the side's circle nearest to w = way lies between the side's ends d and e: w.(e d^2 - d d.e) >
  // 0, and the same with d and e exchanged.
  [[gnu::noinline]] int between_ends(uint32_t v, uint32_t first, uint32_t last, const Vector &way) const {
    Vector d, e;
    find_arm_to_ball(v, first, d);
    find_arm_to_ball(v, last, e);
    const Number to_first = dot(way, d), to_last = dot(way, e), together = dot(d, e);
    const int beyond_first = (to_last * dot(d, d) - to_first * together).sign();
    if (beyond_first < 0) return beyond_first;
    return smaller_of(beyond_first, (to_first * dot(e, e) - to_last * together).sign());
  }
  // A cusp is relative to the centre of its first ball, any other point to its first vertex. Doubles are not kept, as
  // their last bits depend on the ball that positions are relative to.
  [[gnu::noinline]] void find_point(const BorderPoint &point, Vector &x) const {
    const bool has_name = Base::from_one_place && point.number < BorderPoint::no_number;
    const uint32_t name = ~point.number;
    if (has_name && find_kept(name, x)) return;
    switch (point.kind) {
      case BorderPoint::Kind::cusp:
        find_cusp(point.id[0], point.id[1], point.sign, x);
        break;
      case BorderPoint::Kind::corner:
        find_corner(point, x);
        break;
      case BorderPoint::Kind::towards_ball:
        find_towards_ball(point.id[0], point.id[1], x);
        break;
      default:
        find_on_crease(point, x);
    }
    if (has_name) keep(name, x);
  }
  [[gnu::noinline]] void find_from_first_ball(uint32_t v, Vector &x) const {
    const VertexRecord &record = this->boundary.vertex(v);
    Vector half;
    find_planes_of_balls(record, half, x);
    const Number square = dot(half, half);
    to_meeting(half, x, square, this->root_discriminant(v, square, x));
    to_one_of_two(x, half, record.positive());
  }
  static void to_one_of_two(Vector &middle, const Vector &half, bool positive) {
    if (positive) {
      middle += half;
    } else {
      middle -= half;
    }
  }
  // n and q for the probes' spheres at three vertices, relative to the first.
  [[gnu::noinline]] void find_planes(uint32_t a, uint32_t b, uint32_t c, Vector &n, Vector &q) const {
    find_arm_to_vertex(a, b, n);
    find_arm_to_vertex(a, c, q);
    const Number h_n = dot(n, n);
    to_normals(n, h_n, q, dot(q, q));
  }
  [[gnu::noinline]] void find_corner(const BorderPoint &point, Vector &x) const {
    Vector half;
    find_meeting(point.id[0], point.id[1], point.id[2], x, half);
    to_one_of_two(x, half, point.sign > 0);
  }
  [[gnu::noinline]] void find_cusp(uint32_t a, uint32_t b, int sign, Vector &x) const {
    this->find_difference(a, b, x);
    x *= share_of_cusp(a, b, sign, x);
  }
  [[gnu::noinline]] Number share_of_cusp(uint32_t a, uint32_t b, int sign, const Vector &u) const {
    const Number square = dot(u, u);
    const Number h = height(a, b, u).scaled(-1) / square;
    const Number e = square_root(h * h - this->weight_over_probe(a) / square);
    return sign > 0 ? h + e : h - e;
  }
  [[gnu::noinline]] void find_towards_ball(uint32_t v, uint32_t ball, Vector &x) const {
    find_arm_to_ball(v, ball, x);
    x *= probe() / square_root(this->weight(ball));
  }
  [[gnu::noinline]] void find_on_crease(const BorderPoint &point, Vector &x) const {
    find_arm_to_vertex(point.id[0], point.id[1], x);
    to_point_on_crease(point.sign, x);
  }
  [[gnu::noinline]] void to_point_on_crease(int axis, Vector &x) const {
    Vector across;
    find_across(x, axis, across);
    across *= square_root((probe_weight() - dot(x, x).scaled(-2)) / dot(across, across));
    x *= number(1).scaled(-1);
    x += across;
  }

  uint32_t ball_, origin_;
};

}  // namespace hsp
