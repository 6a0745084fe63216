// Where the points of the actual set lie that the smooth surface is decided about (actual_balls.hpp), in numbers that
// know their error: doubles, or floats of some width.
#pragma once

#include "boundary/boundary.hpp"
#include "numbers/wide_float.hpp"
#include "surface/border_points.hpp"

namespace hsp {

template <class Number>
struct NumberVector {
  Number x, y, z;
};
// Apart, and into what is there, as each of these is long in wide floats: what stands between them is mostly calls, and
// a frame holds no more than it has names for.
template <class Number>
[[gnu::noinline]] void operator+=(NumberVector<Number> &a, const NumberVector<Number> &b) {
  a.x = a.x + b.x;
  a.y = a.y + b.y;
  a.z = a.z + b.z;
}
template <class Number>
[[gnu::noinline]] void operator-=(NumberVector<Number> &a, const NumberVector<Number> &b) {
  a.x = a.x - b.x;
  a.y = a.y - b.y;
  a.z = a.z - b.z;
}
template <class Number>
[[gnu::noinline]] void operator*=(NumberVector<Number> &a, const Number &s) {
  a.x = s * a.x;
  a.y = s * a.y;
  a.z = s * a.z;
}
template <class Number>
[[gnu::noinline]] Number dot(const NumberVector<Number> &a, const NumberVector<Number> &b) {
  Number sum = a.x * b.x;
  sum = sum + a.y * b.y;
  return sum + a.z * b.z;
}
// a b - c d
template <class Number>
[[gnu::noinline]] Number difference_of_products(const Number &a, const Number &b, const Number &c, const Number &d) {
  const Number first = a * b;
  return first - c * d;
}
template <class Number>
NumberVector<Number> cross(const NumberVector<Number> &a, const NumberVector<Number> &b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}
template <class Number>
[[gnu::noinline]] Number determinant(const NumberVector<Number> &a, const NumberVector<Number> &b,
                                     const NumberVector<Number> &c) {
  const NumberVector<Number> n = cross(b, c);
  return dot(a, n);
}

inline Vec3 to_double(const NumberVector<BoundedDouble> &a) {
  return {a.x.value, a.y.value, a.z.value};
}
inline Vec3 to_double(const NumberVector<WideFloat> &a) {
  return {BoundedDouble(a.x).value, BoundedDouble(a.y).value, BoundedDouble(a.z).value};
}

// The coordinate axis that a vector is least along.
inline int8_t axis_least_along(const Vec3 &d) {
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  if (x <= y && x <= z) return 0;
  return y <= z ? 1 : 2;
}

// Numbers of some width, and the balls in them.
template <class Number>
struct ActualNumbers;

template <>
struct ActualNumbers<BoundedDouble> {
  const BallSet &balls;
  const Boundary &boundary;

  // The input and the actual set differ by far less than the last bit, but by more than the smallest double.
  static constexpr double shift = 0x1p-590;

  BoundedDouble number(int64_t value) const { return {static_cast<double>(value)}; }
  // From ball i to ball j.
  void find_difference(uint32_t i, uint32_t j, NumberVector<BoundedDouble> &v) const {
    const Vec3 exact = balls.difference(i, j);
    v = {{exact.x, shift}, {exact.y, shift}, {exact.z, shift}};
  }
  BoundedDouble weight(uint32_t i) const { return product(balls.r[i], balls.r[i]); }
  BoundedDouble weight_difference(uint32_t i, uint32_t j) const {
    const BoundedDouble rest = product(balls.r[i] - balls.r[j], balls.r[i] + balls.r[j]);
    return {rest.value, rest.error + 0x1p-180 * (balls.r[i] * balls.r[i] + balls.r[j] * balls.r[j])};
  }
  BoundedDouble weight_over_probe(uint32_t i) const {
    const double p = static_cast<double>(balls.probe_steps);
    const BoundedDouble rest = product(balls.r[i] - p, balls.r[i] + p);
    return {rest.value, rest.error + 0x1p-180 * balls.r[i] * balls.r[i]};
  }
  // Of 4 w N - q.q for the vertex (exact/PROOFS.md): that of the input is exact and rounded once, and that of the
  // actual set differs by less than 2^-185 of its terms, so the root by less than the root of that. The balls meet, so
  // the sum of their radii bounds their distances.
  BoundedDouble root_discriminant(uint32_t v, const NumberVector<BoundedDouble> &,
                                  const NumberVector<BoundedDouble> &) const {
    const double root = boundary.root_discriminant(v);
    const VertexRecord &record = boundary.vertex(v);
    const double length = 4 * (balls.r[record.ball[0]] + balls.r[record.ball[1]] + balls.r[record.ball[2]]);
    return {root, 0x1p-50 * root + 0x1p-85 * (length * length * length)};
  }

 private:
  static BoundedDouble product(double a, double b) { return BoundedDouble(a) * BoundedDouble(b); }
};

template <>
struct ActualNumbers<WideFloat> {
  const BallSet &balls;
  const Boundary &boundary;
  uint32_t bits;

  WideFloat number(int64_t value) const { return WideFloat(value, bits); }
  void find_difference(uint32_t i, uint32_t j, NumberVector<WideFloat> &v) const;
  WideFloat weight(uint32_t i) const;
  WideFloat weight_difference(uint32_t i, uint32_t j) const { return weight(i) - weight(j); }
  WideFloat weight_over_probe(uint32_t i) const {
    const WideFloat p = number(balls.probe_steps);
    return weight(i) - p * p;
  }
  WideFloat root_discriminant(uint32_t v, const NumberVector<WideFloat> &n, const NumberVector<WideFloat> &q) const;
};

template <class Number>
class ActualPoints : public ActualNumbers<Number> {
 public:
  using Vector = NumberVector<Number>;
  using Base = ActualNumbers<Number>;
  using Base::number;

  // All points as seen from the centre of this ball.
  ActualPoints(const Base &numbers, uint32_t ball) : Base(numbers), origin_(ball) {}

  Number probe() const { return number(this->balls.probe_steps); }
  Number probe_weight() const {
    const Number p = probe();
    return p * p;
  }
  // Each into x.
  void find_centre(uint32_t ball, Vector &x) const { this->find_difference(origin_, ball, x); }
  void find_vertex(uint32_t v, Vector &x) const {
    find_from_first_ball(v, x);
    add_centre(this->boundary.vertex(v).ball[0], x);
  }
  void find_point(const BorderPoint &point, Vector &x) const {
    switch (point.kind) {
      case BorderPoint::Kind::corner:
        return find_corner(point, x);
      case BorderPoint::Kind::cusp:
        return find_cusp(point.id[0], point.id[1], point.sign, x);
      case BorderPoint::Kind::towards_ball:
        return find_towards_ball(point.id[0], point.id[1], x);
      default:
        return find_on_crease(point, x);
    }
  }
  // The same, as seen from a vertex.
  [[gnu::noinline]] void find_arm(uint32_t v, const BorderPoint &point, Vector &arm) const {
    Vector here;
    find_point(point, arm);
    find_vertex(v, here);
    arm -= here;
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
  // The normal of a side of a patch, towards its inside: the way to the first ball times that to the second.
  [[gnu::noinline]] void find_inward(uint32_t v, uint32_t first, uint32_t second, Vector &normal) const {
    Vector arm;
    find_arm_to_ball(v, first, normal);
    find_arm_to_ball(v, second, arm);
    normal = cross(normal, arm);
  }
  // 4 p^2 N - q.q of the probes at three vertices: more than 0 iff they meet in two points.
  Number discriminant(uint32_t a, uint32_t b, uint32_t c) const {
    Vector n, q;
    find_planes(a, b, c, n, q);
    return discriminant(n, q, probe_weight());
  }
  [[gnu::noinline]] static Number discriminant(const Vector &n, const Vector &q, const Number &weight) {
    return (weight * dot(n, n)).scaled(2) - dot(q, q);
  }
  // rho^2 - p^2, times the square of twice the distance of the centres: where that is less than 0, and both centres are
  // on their own sides of the circle's plane, saddles reach the axis.
  Number height_over_axis(uint32_t a, uint32_t b) const {
    Vector u;
    this->find_difference(a, b, u);
    const Number square = dot(u, u), twice = square + this->weight_difference(a, b);
    return (square * this->weight_over_probe(a)).scaled(2) - twice * twice;
  }
  // Twice the distance of ball a's centre from the plane of its circle with b, times that of the centres.
  Number height_of_circle(uint32_t a, uint32_t b) const {
    Vector u;
    this->find_difference(a, b, u);
    return height(a, b, u);
  }
  // At right angles to a vector, of about its length if the axis is the one that it is least along.
  [[gnu::noinline]] void find_across(const Vector &u, int axis, Vector &across) const {
    constexpr int64_t large = 104, middle = 39, small = 25;
    Vector aside;
    if (axis == 0) {
      aside = {number(large), number(middle), number(small)};
    } else if (axis == 1) {
      aside = {number(small), number(large), number(middle)};
    } else {
      aside = {number(middle), number(small), number(large)};
    }
    across = cross(u, aside);
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
  // others, h_u and h_z twice the distances of the planes, times those of the centres, n = u x z, q = h_u z - h_z u,
  // D = 4 w n.n - q.q. n comes into u, and q into z.
  [[gnu::noinline]] static void to_normals(Vector &u, const Number &h_u, Vector &z, const Number &h_z) {
    Vector n = cross(u, z);
    z *= h_u;
    u *= h_z;
    z -= u;
    u = n;
  }
  // (q x n + root n) / (2 n.n), or with the root's negative, into n.
  [[gnu::noinline]] void to_meeting(Vector &n, const Vector &q, const Number &root, bool positive) const {
    const Number factor = (number(1) / dot(n, n)).scaled(-1);
    Vector along = cross(q, n);
    n *= root;
    if (!positive) n *= number(-1);
    n += along;
    n *= factor;
  }
  [[gnu::noinline]] void find_planes_of_balls(const VertexRecord &record, Vector &n, Vector &q) const {
    this->find_difference(record.ball[0], record.ball[1], n);
    this->find_difference(record.ball[0], record.ball[2], q);
    const Number h_n = height(record.ball[0], record.ball[1], n);
    to_normals(n, h_n, q, height(record.ball[0], record.ball[2], q));
  }
  [[gnu::noinline]] void find_from_first_ball(uint32_t v, Vector &x) const {
    const VertexRecord &record = this->boundary.vertex(v);
    Vector q;
    find_planes_of_balls(record, x, q);
    const Number root = this->root_discriminant(v, x, q);
    to_meeting(x, q, root, record.positive());
  }
  // Of the probes at three vertices, as seen from the first.
  [[gnu::noinline]] void find_planes(uint32_t a, uint32_t b, uint32_t c, Vector &n, Vector &q) const {
    find_arm_to_vertex(a, b, n);
    find_arm_to_vertex(a, c, q);
    const Number h_n = dot(n, n);
    to_normals(n, h_n, q, dot(q, q));
  }
  [[gnu::noinline]] void find_corner(const BorderPoint &point, Vector &x) const {
    find_corner_from_first(point, x);
    add_vertex(point.id[0], x);
  }
  [[gnu::noinline]] void find_corner_from_first(const BorderPoint &point, Vector &x) const {
    Vector q;
    find_planes(point.id[0], point.id[1], point.id[2], x, q);
    const Number root = square_root(discriminant(x, q, probe_weight()));
    to_meeting(x, q, root, point.sign > 0);
  }
  [[gnu::noinline]] void add_vertex(uint32_t v, Vector &x) const {
    Vector here;
    find_vertex(v, here);
    x += here;
  }
  [[gnu::noinline]] void find_cusp(uint32_t a, uint32_t b, int sign, Vector &x) const {
    this->find_difference(a, b, x);
    x *= share_of_cusp(a, b, sign, x);
    add_centre(a, x);
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
    add_vertex(v, x);
  }
  [[gnu::noinline]] void find_on_crease(const BorderPoint &point, Vector &x) const {
    find_arm_to_vertex(point.id[0], point.id[1], x);
    to_point_on_crease(point.sign, x);
    add_vertex(point.id[0], x);
  }
  [[gnu::noinline]] void to_point_on_crease(int axis, Vector &x) const {
    Vector across;
    find_across(x, axis, across);
    across *= square_root((probe_weight() - dot(x, x).scaled(-2)) / dot(across, across));
    x *= number(1).scaled(-1);
    x += across;
  }

  uint32_t origin_;
};

}  // namespace hsp
