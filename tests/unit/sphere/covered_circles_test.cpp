// Circles that certainly lie inside caps as a whole, against intervals of angles in long double: what is said to be
// covered is, and most of what is covered is said to be.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "lane_circles.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"
#include "sweep_length.hpp"

#if HSP_LANES
namespace {

using Real = long double;
using hsp::FloatCapArrays;
constexpr Real pi = std::numbers::pi_v<Real>;

struct Vector {
  Real x, y, z;
};
Real dot(const Vector &a, const Vector &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vector sum(const Vector &a, Real s, const Vector &b, Real t) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
}
Vector cross(const Vector &a, const Vector &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vector unit(const Vector &a) {
  return sum(a, 1 / std::sqrt(dot(a, a)), a, 0);
}

struct Cap {
  Vector u;
  Real b;
};

// Unit vectors across u and each other.
struct Frame {
  Vector e, f;

  explicit Frame(const Vector &u) {
    const Vector axis = std::fabs(u.x) < 0.6L ? Vector{1, 0, 0} : Vector{0, 1, 0};
    e = unit(cross(u, axis));
    f = cross(u, e);
  }
  Vector at(Real angle) const { return sum(e, std::cos(angle), f, std::sin(angle)); }
};

Vector on_circle(const Cap &circle, Real angle) {
  return sum(circle.u, circle.b, Frame(circle.u).at(angle), std::sqrt(1 - circle.b * circle.b));
}

bool is_inside(const std::vector<Cap> &caps, const Vector &point, size_t but) {
  for (size_t k = 0; k < caps.size(); ++k) {
    if (k != but && dot(caps[k].u, point) > caps[k].b) return true;
  }
  return false;
}

// By the ends of the caps' intervals: each has to lie inside another cap, and one point at least inside any.
bool is_covered(const Cap &circle, const std::vector<Cap> &caps) {
  if (!is_inside(caps, on_circle(circle, 0), caps.size())) return false;
  const Frame frame(circle.u);
  const Real r = std::sqrt(1 - circle.b * circle.b);
  for (size_t k = 0; k < caps.size(); ++k) {
    const Real a = circle.b * dot(circle.u, caps[k].u) - caps[k].b;
    const Real x = r * dot(frame.e, caps[k].u), y = r * dot(frame.f, caps[k].u), most = std::hypot(x, y);
    if (std::fabs(a) >= most) continue;
    const Real middle = std::atan2(y, x), half = std::acos(-a / most);
    for (const Real end : {middle - half, middle + half}) {
      if (!is_inside(caps, on_circle(circle, end), k)) return false;
    }
  }
  return true;
}

class Arrays {
 public:
  explicit Arrays(const std::vector<Cap> &caps) {
    for (const Cap &cap : caps) {
      x_.push_back(static_cast<float>(cap.u.x));
      y_.push_back(static_cast<float>(cap.u.y));
      z_.push_back(static_cast<float>(cap.u.z));
      b_.push_back(static_cast<float>(cap.b));
    }
  }
  FloatCapArrays get() const { return {x_.data(), y_.data(), z_.data(), b_.data()}; }

 private:
  std::vector<float> x_, y_, z_, b_;
};

class CoveredCircles : public testing::TestWithParam<hsp::Target> {
 protected:
  // A bit for each of sixteen circles.
  static uint32_t covered(const std::vector<Cap> &circles, const std::vector<Cap> &caps) {
    return hsp::covered_circles(GetParam(), Arrays(circles).get(), Arrays(caps).get(),
                                static_cast<uint32_t>(caps.size()));
  }
  static bool said_to_be_covered(const Cap &circle, const std::vector<Cap> &caps) {
    const uint32_t said = covered(std::vector<Cap>(16, circle), caps);
    EXPECT_TRUE(said == 0 || said == 0xFFFFU);
    return said != 0;
  }
};
INSTANTIATE_TEST_SUITE_P(Targets, CoveredCircles, testing::ValuesIn(runnable_targets()));

Vector random_direction(oracle::RandomSource &random) {
  for (;;) {
    const Real x = random.fraction(), y = random.fraction(), z = random.fraction();
    const Vector v{2 * x - 1, 2 * y - 1, 2 * z - 1};
    if (dot(v, v) > 0.01L && dot(v, v) < 1) return unit(v);
  }
}

// A cap that covers the circle from one angle to another: its plane goes through both points, and its axis is tilted to
// the circle's by so much.
Cap cap_over(const Cap &circle, Real from, Real to, Real tilt) {
  const Real r = std::sqrt(1 - circle.b * circle.b);
  const Vector u = sum(Frame(circle.u).at((from + to) / 2), std::cos(tilt), circle.u, std::sin(tilt));
  return {u, circle.b * std::sin(tilt) + r * std::cos(tilt) * std::cos((to - from) / 2)};
}

// On axes too, from both sides.
std::vector<Vector> directions(oracle::RandomSource &random) {
  std::vector<Vector> all = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, unit({1e-9L, 0, -1}), unit({0, 1, -1e-9L})};
  for (int k = 0; k < 20; ++k) all.push_back(random_direction(random));
  return all;
}

TEST_P(CoveredCircles, RandomCaps) {
  oracle::RandomSource random(911);
  int truly = 0, found = 0;
  for (int set = 0; set < oracle::sets(400); ++set) {
    std::vector<Cap> circles, caps;
    const auto add = [&random](std::vector<Cap> &to, int count, Real low, Real high) {
      for (int k = 0; k < count; ++k) {
        const Vector u = random_direction(random);
        to.push_back({u, low + (high - low) * static_cast<Real>(random.fraction())});
      }
    };
    add(circles, 16, -0.9L, 0.99L);
    add(caps, 2 + set % 16, -0.5L, 0.87L);
    const uint32_t said = covered(circles, caps);
    for (uint32_t lane = 0; lane < 16; ++lane) {
      const bool is = is_covered(circles[lane], caps), told = (said >> lane & 1U) != 0;
      EXPECT_TRUE(is || !told) << "set " << set << ", circle " << lane;
      truly += is ? 1 : 0;
      found += told ? 1 : 0;
    }
  }
  EXPECT_GT(2 * found, truly);
  EXPECT_GT(truly, oracle::sets(400));
}

// One cap covers all but a gap, which may lie between two ends of arcs.
TEST_P(CoveredCircles, GapsInOneCap) {
  oracle::RandomSource random(912);
  for (const Vector &u : directions(random)) {
    for (const Real b : {-0.8L, -0.1L, 0.0L, 0.6L, 0.95L}) {
      for (int k = 0; k < 35; ++k) {
        const Real from = 2 * pi * k / 35;
        for (const Real gap : {1e-3L, 0.05L, 0.2L, 0.39L, 0.5L}) {
          const Cap circle{u, b}, cap = cap_over(circle, from + gap, from + 2 * pi, 0.3L * (k % 5 - 2));
          EXPECT_FALSE(said_to_be_covered(circle, {cap, cap})) << k << ", gap " << static_cast<double>(gap);
        }
      }
    }
  }
}

// Their fractions are the largest and the least that there are. Six caps, or all but one.
TEST_P(CoveredCircles, CapsOnAxes) {
  const std::vector<Vector> axes = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const Vector &u : axes) {
    for (const Real b : {-0.9L, -0.4L, 0.0L, 0.4L, 0.9L}) {
      for (const Real c : {-0.9L, -0.3L, 0.0L, 0.3L, 0.6L, 0.69L, 0.75L, 0.87L}) {
        const Cap circle{u, b};
        for (size_t without = 0; without <= axes.size(); ++without) {
          std::vector<Cap> caps;
          for (size_t k = 0; k < axes.size(); ++k) {
            if (k != without) caps.push_back({axes[k], c});
          }
          const bool said = said_to_be_covered(circle, caps);
          EXPECT_TRUE(!said || is_covered(circle, caps)) << without << ", height " << static_cast<double>(c);
          // Each of the four around the circle covers two arcs.
          const bool told = without == axes.size() && c + 0.01L < std::sqrt((1 - b * b) / 2);
          EXPECT_TRUE(said || !told) << "height " << static_cast<double>(c);
        }
      }
    }
  }
}

// Caps that cover a third or more each: together the circle, or all but a gap.
TEST_P(CoveredCircles, ThreeCaps) {
  oracle::RandomSource random(913);
  for (const Vector &u : directions(random)) {
    for (const Real b : {-0.9L, -0.5L, 0.0L, 0.3L, 0.9L}) {
      for (int k = 0; k < 23; ++k) {
        const Real third = 2 * pi / 3, from = 2 * pi * k / 23, arc = pi / 4 + 0.01L;
        const Cap circle{u, b};
        const auto three = [&](Real before, Real after) {
          std::vector<Cap> caps;
          for (int part = 0; part < 3; ++part) {
            caps.push_back(cap_over(circle, from + third * part - before, from + third * (part + 1) + after,
                                    0.2L * ((k + part) % 5 - 2)));
          }
          return caps;
        };
        EXPECT_TRUE(said_to_be_covered(circle, three(0, arc))) << k;
        EXPECT_FALSE(said_to_be_covered(circle, three(0, -1e-5L))) << k;
        std::vector<Cap> without_end = three(0, arc);
        without_end[2] = cap_over(circle, from + 2 * third, from + 2 * pi - 1e-5L, 0);
        without_end[0] = cap_over(circle, from, from + third + arc, 0);
        EXPECT_FALSE(said_to_be_covered(circle, without_end)) << k;
      }
    }
  }
}

// Nothing is said of circles that are so small that floats do not tell where they are.
TEST_P(CoveredCircles, SmallCircles) {
  const Vector u = unit({1, 2, 3});
  const std::vector<Cap> caps = {cap_over({u, 0.9L}, 0, 2, 0.1L), {u, 0.5L}};
  std::vector<Cap> around;
  for (int k = 0; k < 4; ++k) around.push_back({sum(u, 0.6L, Frame(u).at(k * pi / 2), 0.8L), 0.5L});
  EXPECT_TRUE(said_to_be_covered({u, 0.95L}, around));
  EXPECT_FALSE(said_to_be_covered({u, 0.999L}, around));
  EXPECT_FALSE(said_to_be_covered({u, 1.0L}, around));
  EXPECT_FALSE(said_to_be_covered({u, 4.0L}, around));
}

}  // namespace
#endif
