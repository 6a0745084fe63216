// Balls that touch exactly: which of them are flagged, and whether their derivatives are those of either side.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

#include "brute_boundary.hpp"
#include "gradient_sets.hpp"
#include "library_derivatives.hpp"
#include "measure_differences.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using oracle::Int128;
using oracle::LatticeBall;
using oracle::Vector;

// Whether two balls of positive radius touch, from outside or from inside, in a point that lies inside no third ball.
// Nothing is said about points on a third sphere: the perturbation decides them. Equal balls touch all over: freely if
// one of them has a face.
std::optional<bool> touch_freely(const Balls &balls, size_t i, size_t j) {
  const LatticeBall &a = balls[i];
  const LatticeBall &b = balls[j];
  const Vector v = oracle::centre_difference(a, b);
  const Int128 squared = oracle::dot(v, v);
  const Int128 sum = Int128{a.radius} + b.radius;
  const Int128 difference = Int128{a.radius} - b.radius;
  if (squared == 0 && difference == 0) {
    const std::vector<oracle::BoundaryRecord::Face> faces = oracle::brute_boundary(balls).faces;
    return std::any_of(faces.begin(), faces.end(),
                       [&](const oracle::BoundaryRecord::Face &face) { return balls[face.ball] == a; });
  }
  if (squared != sum * sum && squared != difference * difference) return false;
  // The point is c_a + r_a v / d, with d = r_a + r_b from outside and d = r_a - r_b from inside, whichever is larger.
  const Int128 d = squared == sum * sum ? sum : difference;
  for (size_t k = 0; k < balls.size(); ++k) {
    if (k == i || k == j) continue;
    const Vector w = oracle::centre_difference(balls[k], a);
    const Vector point = {d * w[0] + a.radius * v[0], d * w[1] + a.radius * v[1], d * w[2] + a.radius * v[2]};
    const int side = oracle::sign_of(oracle::dot(point, point) - d * d * balls[k].radius * balls[k].radius);
    if (side == 0) return std::nullopt;
    if (side < 0) return false;
  }
  return true;
}

std::string flags_are_wrong(const Balls &balls) {
  std::set<size_t> expected;
  for (const LatticeBall &ball : balls)
    if (ball.radius == 0) return "";  // where they lie on a sphere they touch it from both sides
  for (size_t i = 0; i < balls.size(); ++i)
    for (size_t j = 0; j < i; ++j) {
      const std::optional<bool> touch = touch_freely(balls, i, j);
      if (!touch) return "";
      if (*touch) expected.insert({i, j});
    }
  const LibraryBoundary boundary(balls);
  std::ostringstream text;
  for (const uint32_t tangency : {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT}) {
    const LibraryGradient found = gradient(boundary, {1, 0, {}, tangency});
    for (size_t i = 0; i < balls.size(); ++i)
      if (found.flags[i] != (expected.contains(i) ? HSP_GRADIENT_ONE_SIDED : 0U))
        text << "ball " << i << " is flagged " << found.flags[i] << "\n";
  }
  return text.str();
}

TEST(OneSidedGradients, FlagsNameTheBallsThatTouchAtAFreePoint) {
  oracle::RandomSource random(111);
  for (int k = 0; k < oracle::sets(6000); ++k) {
    const Balls balls = k % 2 == 0 ? oracle::degenerate_balls(random, static_cast<size_t>(random.in(2, 8)))
                                   : oracle::tangent_balls(random, static_cast<size_t>(random.in(2, 6)));
    ASSERT_EQ(complaint_about_smallest(balls, flags_are_wrong), "");
  }
}

// As in files whose atoms have no coordinates yet.
TEST(OneSidedGradients, FlagsOfManyEqualBalls) {
  const LibraryBoundary boundary(Balls(2000, LatticeBall{3, 4, 5, 100}));
  for (const uint32_t flag : gradient(boundary, EnergyTerms{}).flags) EXPECT_EQ(flag, HSP_GRADIENT_ONE_SIDED);
}

TEST(OneSidedGradients, NoFlagsInGeneralPosition) {
  for (const oracle::NamedBalls &set : sets_of_every_kind(112))
    for (const uint32_t flag : gradient(LibraryBoundary(set.balls), EnergyTerms{}).flags) EXPECT_EQ(flag, 0U);
}

// Balls in general position but for the last one, which touches the first exactly. The shift is the shortest move that
// takes the last one straight away from the first.
struct TouchingSet {
  Balls balls;
  std::array<int64_t, 3> shift;

  [[nodiscard]] Balls moved(int times) const {
    Balls result = balls;
    result.back().x += times * shift[0];
    result.back().y += times * shift[1];
    result.back().z += times * shift[2];
    return result;
  }
};

TouchingSet touching_set(oracle::RandomSource &random, bool from_inside) {
  const auto [x, y, z, length] = oracle::integer_length_vector(random);
  TouchingSet set = {in_general_position(oracle::loose_balls(random, 8), random), {x, y, z}};
  LatticeBall &first = set.balls.front();
  // Lengths that the direction's length divides, near to these shares of the first radius.
  const int64_t times = first.radius / length * (from_inside ? 3 : 16) / 10;
  const int64_t distance = times * length;
  const int64_t radius = from_inside ? first.radius - distance : distance - first.radius;
  set.balls.push_back({first.x + times * x, first.y + times * y, first.z + times * z, radius});
  return set;
}

// Do all derivatives of a weighted area nearly agree, relative to the largest radius? One step out of 1e8 is between
// them.
std::string derivatives_differ(const Balls &balls, uint32_t tangency, const Balls &close_by, double tolerance = 1e-5) {
  EnergyTerms terms = {1, 0, {}, tangency};
  for (size_t i = 0; i < balls.size(); ++i) terms.sigma.push_back(1 + 0.125 * static_cast<double>(i));
  const LibraryGradient here = gradient(LibraryBoundary(balls), terms);
  const LibraryGradient there = gradient(LibraryBoundary(close_by), terms);
  std::ostringstream text;
  for (size_t i = 0; i < balls.size(); ++i)
    for (size_t c = 0; c < 4; ++c)
      if (!(std::abs(here.by_ball[i][c] - there.by_ball[i][c]) <=
            tolerance * static_cast<double>(largest_radius(balls))))
        text << "number " << c << " of ball " << i << ": " << here.by_ball[i][c] << " and " << there.by_ball[i][c]
             << "\n";
  return text.str();
}

TEST(OneSidedGradients, AreThoseOfTheSideAskedFor) {
  oracle::RandomSource random(113);
  int free = 0;
  for (int k = 0; k < oracle::sets(400); ++k) {
    const TouchingSet set = touching_set(random, false);
    ASSERT_EQ(derivatives_differ(set.balls, HSP_TANGENT_OVERLAP, set.moved(-1)), "") << oracle::to_text(set.balls);
    ASSERT_EQ(derivatives_differ(set.balls, HSP_TANGENT_DISJOINT, set.moved(1)), "") << oracle::to_text(set.balls);
    if (touch_freely(set.balls, 0, set.balls.size() - 1).value_or(false)) {
      ++free;
      ASSERT_NE(derivatives_differ(set.balls, HSP_TANGENT_OVERLAP, set.moved(1)), "") << oracle::to_text(set.balls);
      ASSERT_NE(derivatives_differ(set.balls, HSP_TANGENT_DISJOINT, set.moved(-1)), "") << oracle::to_text(set.balls);
    }
  }
  EXPECT_GT(free, oracle::sets(50));
  EXPECT_LT(free, 350);
}

// A ball that touches another from inside counts as lying inside it, whichever side is asked for.
TEST(OneSidedGradients, FromInsideAreThoseOfTheBallInside) {
  oracle::RandomSource random(114);
  for (int k = 0; k < oracle::sets(400); ++k) {
    const TouchingSet set = touching_set(random, true);
    for (const uint32_t tangency : {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT}) {
      ASSERT_EQ(derivatives_differ(set.balls, tangency, set.moved(-1)), "") << oracle::to_text(set.balls);
      if (touch_freely(set.balls, 0, set.balls.size() - 1).value_or(false)) {
        ASSERT_NE(derivatives_differ(set.balls, tangency, set.moved(1)), "") << oracle::to_text(set.balls);
      }
    }
  }
}

// Do three spheres meet in one circle, or could they? Their planes of intersection coincide.
bool share_a_circle(const LatticeBall &a, const LatticeBall &b, const LatticeBall &c) {
  const Vector v = oracle::centre_difference(a, b);
  const Vector w = oracle::centre_difference(a, c);
  if (!oracle::is_zero(oracle::cross(v, w))) return false;
  const auto twice_height = [&](const Vector &u, const LatticeBall &other) {
    return oracle::dot(u, u) + Int128{a.radius} * a.radius - Int128{other.radius} * other.radius;
  };
  for (size_t k = 0; k < 3; ++k)
    if (twice_height(v, b) * w[k] != twice_height(w, c) * v[k]) return false;
  return true;
}

bool has_one_sided_derivatives(const Balls &balls) {
  for (size_t i = 0; i < balls.size(); ++i) {
    if (balls[i].radius == 0) return true;
    for (size_t j = 0; j < i; ++j) {
      if (touch_freely(balls, i, j).value_or(true)) return true;
      for (size_t k = 0; k < j; ++k)
        if (share_a_circle(balls[i], balls[j], balls[k])) return true;
    }
  }
  return false;
}

// Where circles touch on a sphere, or four spheres go through a point, derivatives are continuous: at the tie they are,
// but for roots of one step out of 2^24 for each unit, those of balls in general position next to it.
TEST(OneSidedGradients, OtherTiesMakeNoJump) {
  oracle::RandomSource random(115);
  int compared = 0;
  for (int k = 0; k < oracle::sets(12000); ++k) {
    const Balls balls = k % 2 == 0 ? oracle::degenerate_balls(random, static_cast<size_t>(random.in(3, 8)))
                                   : oracle::crowned_balls(random, static_cast<size_t>(random.in(9, 14)));
    if (has_one_sided_derivatives(balls) || LibraryBoundary(balls).counts().tied_vertices == 0) continue;
    ++compared;
    constexpr int64_t scale = int64_t{1} << 24;
    Balls tied;
    Balls untied;
    for (const LatticeBall &b : balls) {
      tied.push_back({b.x * scale, b.y * scale, b.z * scale, b.radius * scale});
      untied.push_back(tied.back());
      for (int64_t *number : {&untied.back().x, &untied.back().y, &untied.back().z, &untied.back().radius})
        *number += random.in(-1, 1);
    }
    for (const uint32_t tangency : {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT})
      ASSERT_EQ(derivatives_differ(tied, tangency, untied, 1e-2), "") << oracle::to_text(balls);
  }
  EXPECT_GT(compared, oracle::sets(400));
}

}  // namespace
