// Balls in a box of any three vectors, and what the C interface tells of them, in the caller's frame.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "owned_boxes.hpp"
#include "random_numbers.hpp"

namespace boxes {

using Vector = std::array<double, 3>;
using Matrix = std::array<double, 9>;  // rows

inline Vector product(const Matrix &m, const double *v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
          m[6] * v[0] + m[7] * v[1] + m[8] * v[2]};
}
inline Matrix transposed(const Matrix &m) {
  return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
}
inline double determinant(const Matrix &m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}
// m x m^T for the rotation m.
inline Matrix turned_matrix(const Matrix &m, const Matrix &x) {
  Matrix sum{};
  for (size_t p = 0; p < 9; ++p) {
    for (size_t k = 0; k < 9; ++k) sum[p] += m[3 * (p / 3) + k / 3] * x[k] * m[3 * (p % 3) + k % 3];
  }
  return sum;
}

// Of a random quaternion.
inline Matrix random_rotation(support::Random &random) {
  for (;;) {
    double q[4], square = 0;
    for (double &x : q) {
      x = 2 * random.fraction() - 1;
      square += x * x;
    }
    if (square < 0.1 || square > 1) continue;
    for (double &x : q) x /= std::sqrt(square);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
            2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
            2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
  }
}

struct AnyBox {
  support::BallList balls;
  Matrix box{};
  std::vector<double> sigma;

  uint32_t n() const { return balls.size(); }
  const double *centre(uint32_t i) const { return &balls.xyz[3 * size_t{i}]; }
  // The centre of a ball, moved by multiples of the vectors.
  Vector image(uint32_t i, const int32_t *shift) const {
    Vector at{centre(i)[0], centre(i)[1], centre(i)[2]};
    for (size_t k = 0; k < 9; ++k) at[k % 3] += shift[k / 3] * box[k];
    return at;
  }
  // Of a point, as multiples of the vectors.
  Vector fractions(const double *point) const {
    Vector result{};
    for (size_t row = 0; row < 3; ++row) {
      Matrix with = box;
      for (size_t k = 0; k < 3; ++k) with[3 * row + k] = point[k];
      result[row] = determinant(with) / determinant(box);
    }
    return result;
  }
  // The distance of the two sides that a vector leads across.
  double height(size_t row) const {
    const double *const u = &box[3 * ((row + 1) % 3)], *const v = &box[3 * ((row + 2) % 3)];
    const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
    return std::fabs(determinant(box)) / std::sqrt(x * x + y * y + z * z);
  }
  AnyBox turned(const Matrix &rotation) const {
    AnyBox result = *this;
    for (size_t row = 0; row < 3; ++row) {
      const Vector v = product(rotation, &box[3 * row]);
      for (size_t k = 0; k < 3; ++k) result.box[3 * row + k] = v[k];
    }
    for (uint32_t i = 0; i < n(); ++i) {
      const Vector v = product(rotation, centre(i));
      for (size_t k = 0; k < 3; ++k) result.balls.xyz[3 * size_t{i} + k] = v[k];
    }
    return result;
  }
  AnyBox reversed(size_t row) const {
    AnyBox result = *this;
    for (size_t k = 0; k < 3; ++k) result.box[3 * row + k] = -box[3 * row + k];
    return result;
  }
  // Component p of everything grows by so much of component q.
  void strain(size_t p, size_t q, double by) {
    for (size_t row = 0; row < 3; ++row) box[3 * row + p] += by * box[3 * row + q];
    for (uint32_t i = 0; i < n(); ++i) balls.xyz[3 * size_t{i} + p] += by * balls.xyz[3 * size_t{i} + q];
  }
  // A component of the vectors grows, with all balls at fixed multiples of them.
  void change_box(size_t component, double by) {
    for (uint32_t i = 0; i < n(); ++i)
      balls.xyz[3 * size_t{i} + component % 3] += by * fractions(centre(i))[component / 3];
    box[component] += by;
  }
};

// Upright vectors with eight decimals and balls that meet images on several sides.
inline AnyBox upright_box(support::Random &random, uint32_t n) {
  const auto between = [&](double low, double high) {
    return std::round(1e8 * (low + (high - low) * random.fraction())) / 1e8;
  };
  AnyBox set;
  set.box = {between(3.5, 5), 0, 0, between(-3, 3), between(3.5, 5), 0, 0, 0, 0};
  for (size_t k = 6; k < 9; ++k) set.box[k] = k == 8 ? between(3.5, 5) : between(-3, 3);
  for (uint32_t i = 0; i < n; ++i) {
    const double x = between(-4, 8), y = between(-4, 8), z = between(-4, 8);
    set.balls.add(x, y, z, between(1, 1.75));
    set.sigma.push_back(between(-1, 2));
  }
  return set;
}

// Turned, and perhaps left-handed or with its vectors in another order.
inline AnyBox random_box(support::Random &random, uint32_t n) {
  AnyBox set = upright_box(random, n).turned(random_rotation(random));
  for (size_t row = 0; row < 3; ++row) {
    if (random.one_in(3)) set = set.reversed(row);
  }
  const size_t from = random.below(3), to = random.below(3);
  for (size_t k = 0; k < 3; ++k) std::swap(set.box[3 * from + k], set.box[3 * to + k]);
  return set;
}

class Computed {
 public:
  explicit Computed(const AnyBox &set) : set_(set) {
    hsp_periodic_limits limits{};
    support::expect_ok(hsp_periodic_limits_init(&limits, sizeof limits, set.n()), "limits");
    owned_.take(limits);
    owned_.compute([&](hsp_periodic *handle, hsp_periodic_limits *asked) {
      return hsp_periodic_compute(handle, set.n(), set.balls.xyz.data(), set.balls.radius.data(), set.box.data(),
                                  nullptr, asked, nullptr);
    });
  }

  hsp_periodic *get() const { return owned_.get(); }
  const AnyBox &set() const { return set_; }
  std::vector<double> areas() const {
    std::vector<double> area(set_.n());
    support::expect_ok(hsp_periodic_measure(get(), nullptr, area.data(), nullptr, set_.n(), nullptr), "measure");
    return area;
  }

 private:
  const AnyBox set_;
  support::OwnedPeriodic owned_;
};

struct Factors {
  double pressure = 0, tension = 0, bending = 0;
};

// Of the morphometric energy; `plain` without bending by the other function.
struct Derivatives {
  double value = 0;
  std::vector<double> centre, radius;
  Matrix strain{}, box{};
};

inline Derivatives plain_derivatives(const Computed &computed, const Factors &factors) {
  const AnyBox &set = computed.set();
  Derivatives found;
  found.centre.resize(3 * size_t{set.n()});
  found.radius.resize(set.n());
  hsp_gradient_request request{};
  request.struct_size = sizeof request;
  request.tension = factors.tension;
  request.pressure = factors.pressure;
  request.sigma = set.sigma.data();
  hsp_energy energy{};
  hsp_periodic_gradient_outputs out{};
  out.struct_size = sizeof out;
  out.capacity = set.n();
  out.energy = &energy;
  out.d_centre = found.centre.data();
  out.d_radius = found.radius.data();
  out.d_strain = found.strain.data();
  out.d_box = found.box.data();
  support::expect_ok(hsp_periodic_get_gradient(computed.get(), &request, &out), "gradient");
  found.value = energy.value;
  return found;
}

inline Derivatives morphometric_derivatives(const Computed &computed, const Factors &factors) {
  const AnyBox &set = computed.set();
  Derivatives found;
  found.centre.resize(3 * size_t{set.n()});
  found.radius.resize(set.n());
  hsp_morphometry_request request{};
  request.struct_size = sizeof request;
  request.tension = factors.tension;
  request.pressure = factors.pressure;
  request.bending = factors.bending;
  request.sigma = set.sigma.data();
  hsp_morphometric_energy energy{};
  hsp_periodic_morphometry_outputs out{};
  out.struct_size = sizeof out;
  out.capacity = set.n();
  out.energy = &energy;
  out.d_centre = found.centre.data();
  out.d_radius = found.radius.data();
  out.d_strain = found.strain.data();
  out.d_box = found.box.data();
  support::expect_ok(hsp_periodic_get_morphometry(computed.get(), &request, &out), "morphometry");
  found.value = energy.value;
  return found;
}

}  // namespace boxes
