#include "hessian_in_113_bits.hpp"

#include <quadmath.h>

namespace {

using Real = __float128;

const Real half_turn = acosq(-1);

// A value and its derivative along the direction.
struct Dual {
  Real value = 0, slope = 0;
};
Dual operator+(Dual a, Dual b) {
  return {a.value + b.value, a.slope + b.slope};
}
Dual operator-(Dual a, Dual b) {
  return {a.value - b.value, a.slope - b.slope};
}
Dual operator*(Dual a, Dual b) {
  return {a.value * b.value, a.value * b.slope + a.slope * b.value};
}
Dual operator/(Dual a, Dual b) {
  const Real quotient = a.value / b.value;
  return {quotient, (a.slope - quotient * b.slope) / b.value};
}
Dual root(Dual a) {
  const Real r = sqrtq(a.value);
  return {r, a.slope / (2 * r)};
}
Dual number(Real value) {
  return {value, 0};
}

struct DualVector {
  Dual x, y, z;
};
DualVector operator+(DualVector a, DualVector b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
DualVector operator-(DualVector a, DualVector b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
DualVector operator*(Dual s, DualVector a) {
  return {s * a.x, s * a.y, s * a.z};
}
Dual dot(DualVector a, DualVector b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
DualVector cross(DualVector a, DualVector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The first derivatives by all centres, each with its slope.
class MovingGradient {
 public:
  MovingGradient(const oracle::Balls &balls, const std::vector<double> &sigma, bool of_volume,
                 const std::vector<double> &direction)
      : sigma_(sigma), of_volume_(of_volume), by_centre_(balls.size()) {
    for (size_t i = 0; i < balls.size(); ++i) {
      const auto coordinate = [&](int64_t value, size_t axis) {
        return Dual{static_cast<Real>(value), static_cast<Real>(direction[3 * i + axis])};
      };
      centre_.push_back({coordinate(balls[i].x, 0), coordinate(balls[i].y, 1), coordinate(balls[i].z, 2)});
      radius_.push_back(number(static_cast<Real>(balls[i].radius)));
    }
  }

  // The point of three spheres, on its side of the plane of their centres.
  DualVector position(const hsp_vertex &vertex) const {
    const uint32_t i = vertex.ball[0], j = vertex.ball[1], k = vertex.ball[2];
    const DualVector v = centre_[j] - centre_[i], w = centre_[k] - centre_[i], normal = cross(v, w);
    const auto height = [&](DualVector to, uint32_t other) {
      return (dot(to, to) + radius_[i] * radius_[i] - radius_[other] * radius_[other]) / number(2);
    };
    const Dual square = dot(normal, normal);
    const DualVector foot = (number(1) / square) * (height(v, j) * cross(w, normal) + height(w, k) * cross(normal, v));
    const Dual above = radius_[i] * radius_[i] - dot(foot, foot);
    return centre_[i] + foot + number(vertex.sign) * root(above / square) * normal;
  }

  void add_circle(const hsp_circle &circle) { add(circle.ball, number(2 * half_turn), {}, {}, false); }
  // angle: nearly that of the arc, so that it is known modulo whole turns.
  void add_arc(const hsp_arc &arc, DualVector first, DualVector last) {
    add(arc.ball, number(static_cast<Real>(arc.angle)), first, last, true);
  }

  std::vector<double> slopes() const {
    std::vector<double> result;
    for (const DualVector &gradient : by_centre_)
      for (const Dual &component : {gradient.x, gradient.y, gradient.z})
        result.push_back(static_cast<double>(component.slope));
    return result;
  }

 private:
  void add(const uint32_t ball[2], Dual angle, DualVector first, DualVector last, bool has_ends) {
    const uint32_t i = ball[0], j = ball[1];
    const DualVector between = centre_[j] - centre_[i];
    const Dual distance = root(dot(between, between));
    const DualVector axis = (number(1) / distance) * between;
    const Dual height = (distance + (radius_[i] * radius_[i] - radius_[j] * radius_[j]) / distance) / number(2);
    const DualVector middle = centre_[i] + height * axis;
    const DualVector chord = last - first;
    if (has_ends) {
      const DualVector from = first - middle, to = last - middle;
      const Dual cosine = dot(from, to), sine = dot(axis, cross(from, to));
      Real value = atan2q(sine.value, cosine.value);
      const Real turn = 2 * half_turn;
      while (value < angle.value - half_turn) value += turn;
      while (value > angle.value + half_turn) value -= turn;
      const Real square = cosine.value * cosine.value + sine.value * sine.value;
      angle = {value, (cosine.value * sine.slope - sine.value * cosine.slope) / square};
    }
    if (of_volume_) {
      const Dual square = radius_[i] * radius_[i] - height * height;
      // Vector areas of the faces on either side.
      const auto vector_area = [&](uint32_t of) {
        const DualVector flat = square * angle * axis;
        return has_ends ? flat + cross(middle - centre_[of], chord) : flat;
      };
      by_centre_[i] = by_centre_[i] - number(0.5) * vector_area(i);
      by_centre_[j] = by_centre_[j] + number(0.5) * vector_area(j);
    } else {
      const DualVector X = has_ends ? cross(chord, axis) : DualVector{};
      add_side(i, j, angle, X, axis, distance, height);
      add_side(j, i, angle, X, number(-1) * axis, distance, distance - height);
    }
  }
  // The derivative of the area of ball `of` by the other's centre.
  void add_side(uint32_t of, uint32_t other, Dual angle, DualVector X, DualVector axis, Dual distance, Dual height) {
    const DualVector part = radius_[of] * (angle * (number(1) - height / distance) * axis - (number(1) / distance) * X);
    const DualVector weighted = number(static_cast<Real>(sigma_[of])) * part;
    by_centre_[other] = by_centre_[other] + weighted;
    by_centre_[of] = by_centre_[of] - weighted;
  }

  const std::vector<double> &sigma_;
  const bool of_volume_;
  std::vector<DualVector> centre_, by_centre_;
  std::vector<Dual> radius_;
};

}  // namespace

std::vector<double> hessian_in_113_bits(const oracle::Balls &balls, const LibraryBoundary &boundary,
                                        const std::vector<double> &sigma, bool of_volume,
                                        const std::vector<double> &direction) {
  MovingGradient gradient(balls, sigma, of_volume, direction);
  std::vector<DualVector> position;
  for (const hsp_vertex &vertex : boundary.vertices()) position.push_back(gradient.position(vertex));
  for (const hsp_arc &arc : boundary.arcs()) gradient.add_arc(arc, position[arc.vertex[0]], position[arc.vertex[1]]);
  for (const hsp_circle &circle : boundary.circles()) gradient.add_circle(circle);
  return gradient.slopes();
}
