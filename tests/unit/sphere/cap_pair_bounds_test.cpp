// The floating-point stage of the vertex search (sphere/cap_pair.hpp, and sphere/caps.hpp below it) at the worst
// inputs a search finds, in units of its stated error bounds: radii as different as 1 and 2^29, nearly parallel axes,
// circles that nearly touch. q is compared as a fraction of integers; quantities with roots in long double, after every
// sum that could cancel was done in integers. Wherever an answer is certain, it is held against signs of integers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "filter_bounds_search.hpp"
#include "gridless_balls.hpp"
#include "sphere/cap_pair.hpp"

namespace {

using namespace filter_bounds;
using hsp::CapPair;
using hsp::Caps;
using hsp::CrossingPoints;
using hsp::unit_roundoff;
using perturbation::HalfSpace;
using perturbation::Integer;
using perturbation::Origin;

// The caps of ball 0, made by the library itself.
class CapsOfFour {
 public:
  CapsOfFour() {
    hsp::Workspace workspace(memory_, sizeof memory_);
    caps_.carve(workspace, 4);
    block_.range[0] = {0, 4};
    block_.ranges = 1;
  }
  ~CapsOfFour() { hsp::unpoison(memory_, sizeof memory_); }
  CapsOfFour(const CapsOfFour &) = delete;
  CapsOfFour &operator=(const CapsOfFour &) = delete;
  const Caps &of(const FourBalls &four) {
    balls_.clear();
    for (const hsp::exact::LatticeBall &ball : four.ball) balls_.add(ball);
    caps_.gather(balls_.set(), block_, 0, nullptr);
    return caps_;
  }

 private:
  GridlessBalls<4> balls_;
  alignas(64) unsigned char memory_[4096];
  hsp::CubeBlock block_;
  Caps caps_;
};

long double length(const HalfSpace &P) {
  long double squared = 0.0L;
  for (const int64_t x : P.v) squared += static_cast<long double>(x) * static_cast<long double>(x);
  return std::sqrt(squared);
}

struct Ratios {
  double axis = 0.0, height = 0.0, cosine = 0.0, q = 0.0, centre = 0.0, point = -1.0;
  bool contradiction = false;
  bool crosses = false, apart = false;

  static void raise(double &ratio, long double error, double bound) {
    ratio = std::max(ratio, static_cast<double>(std::fabs(error) / static_cast<long double>(bound)));
  }
};

class Measurement {
 public:
  Measurement(const FourBalls &four, CapsOfFour &maker)
      : caps_(maker.of(four)), balls_(as_given(four)), origin_(balls_, 0) {
    for (uint32_t k = 0; k < 3; ++k)
      half_space_[k] = perturbation::half_space(balls_, 0, static_cast<int>(caps_.ball[k]));
  }

  Ratios run() {
    for (uint32_t k = 0; k < 3; ++k) measure_cap(k);
    for (uint32_t j = 0; j < 3; ++j) {
      for (uint32_t k = j + 1; k < 3; ++k) measure_pair(j, k);
    }
    return ratios_;
  }

 private:
  long double diameter() const { return std::sqrt(origin_.W.to_long_double()); }

  void measure_cap(uint32_t k) {
    const HalfSpace &P = half_space_[k];
    const double u[3] = {caps_.ux[k], caps_.uy[k], caps_.uz[k]};
    long double squared = 0.0L;
    for (int a = 0; a < 3; ++a) {
      const long double error = u[a] - static_cast<long double>(P.v[a]) / length(P);
      squared += error * error;
    }
    Ratios::raise(ratios_.axis, std::sqrt(squared), 3.5 * unit_roundoff);
    Ratios::raise(ratios_.height, caps_.b[k] - P.h.to_long_double() / (diameter() * length(P)), 7 * unit_roundoff);
  }

  void measure_pair(uint32_t j, uint32_t k) {
    const HalfSpace &P = half_space_[j];
    const HalfSpace &Q = half_space_[k];
    const CapPair pair(caps_, j, k);
    const Integer D = origin_.D(P, Q);
    const Integer beta_jk = origin_.beta(P, Q);
    const Integer beta_kj = origin_.beta(Q, P);
    const Integer uu = inner(P, P);
    const Integer vv = inner(Q, Q);

    Ratios::raise(ratios_.cosine, pair.g - inner(P, Q).to_long_double() / (length(P) * length(Q)), 10 * unit_roundoff);
    // q = D / (W u.u v.v)
    constexpr int fraction_bits = 200;
    const Integer denominator = origin_.W * uu * vv;
    const Integer computed = Integer::from_double(std::ldexp(pair.q, fraction_bits));
    const Integer error = computed * denominator - D.times_power_of_two(fraction_bits);
    Ratios::raise(ratios_.q, std::ldexp(error.to_long_double(), -fraction_bits) / denominator.to_long_double(),
                  111 * unit_roundoff);
    // u_k . (centre of circle j) - b_k = -beta / (u.u 2r |v|)
    const long double centre_jk = -beta_jk.to_long_double() / (uu.to_long_double() * diameter() * length(Q));
    const long double centre_kj = -beta_kj.to_long_double() / (vv.to_long_double() * diameter() * length(P));
    Ratios::raise(ratios_.centre, pair.g * pair.bj - pair.bk - centre_jk, 27 * unit_roundoff);
    Ratios::raise(ratios_.centre, pair.g * pair.bk - pair.bj - centre_kj, 27 * unit_roundoff);

    contradicts(pair.certainly_cross() && D.sign() <= 0);
    contradicts(pair.certainly_apart() && D.sign() >= 0);
    contradicts(pair.certainly_inside() && beta_jk.sign() >= 0);
    contradicts(pair.certainly_contains() && beta_kj.sign() >= 0);
    contradicts(pair.certainly_separate() && (beta_jk.sign() <= 0 || beta_kj.sign() <= 0));
    ratios_.crosses = ratios_.crosses || pair.certainly_cross();
    ratios_.apart = ratios_.apart || pair.certainly_apart();
    if (pair.certainly_cross() && D.sign() > 0) measure_points(j, k, pair, D);
  }

  void measure_points(uint32_t j, uint32_t k, const CapPair &pair, const Integer &D) {
    const HalfSpace &P = half_space_[j];
    const HalfSpace &Q = half_space_[k];
    const CrossingPoints points(caps_, j, k, pair);
    const long double root = std::sqrt(D.to_long_double());
    const long double N = origin_.N(P, Q).to_long_double();
    for (uint32_t l = 0; l < 3; ++l) {
      const HalfSpace &R = half_space_[l];
      const bool own = l == j || l == k;
      const Integer A = origin_.A(P, Q, R);
      const Integer B = origin_.B(P, Q, R);
      for (int point = 0; point < 2; ++point) {
        const int s = point == 1 ? 1 : -1;
        const double depth =
            points.x[point] * caps_.ux[l] + points.y[point] * caps_.uy[l] + points.z[point] * caps_.uz[l] - caps_.b[l];
        const long double exact_depth =
            own ? 0.0L : (A.to_long_double() + s * B.to_long_double() * root) / (N * diameter() * length(R));
        Ratios::raise(ratios_.point, depth - exact_depth, points.error);
        if (own) continue;
        const int sign = Origin::point_sign(D, A, B, s);
        contradicts(depth > points.error && sign <= 0);
        contradicts(depth < -points.error && sign >= 0);
      }
    }
  }

  static Integer inner(const HalfSpace &a, const HalfSpace &b) {
    perturbation::Int128 sum = 0;
    for (int k = 0; k < 3; ++k) sum += static_cast<perturbation::Int128>(a.v[k]) * b.v[k];
    return Integer(sum);
  }
  void contradicts(bool it_does) { ratios_.contradiction = ratios_.contradiction || it_does; }

  const Caps &caps_;
  perturbation::Balls balls_;
  Origin origin_;
  HalfSpace half_space_[3];
  Ratios ratios_;
};

// Searches for the worst of one ratio, while all that is certain is checked on the way.
void search(const char *name, uint64_t seed, double Ratios::*ratio) {
  oracle::RandomSource random(seed);
  CapsOfFour maker;
  int sets = 0, contradictions = 0, crossing = 0, apart = 0;
  const double largest = worst(random, 120, 3000, [&](const FourBalls &four) {
    const Ratios ratios = Measurement(four, maker).run();
    ++sets;
    contradictions += ratios.contradiction;
    crossing += ratios.crosses;
    apart += ratios.apart;
    return ratios.*ratio;
  });
  testing::Test::RecordProperty(name, std::to_string(largest));
  std::cout << "  worst error of " << name << ": " << largest << " of its bound, " << sets << " sets\n";
  EXPECT_EQ(contradictions, 0);
  EXPECT_GT(crossing, 1000);
  EXPECT_GT(apart, 1000);
  EXPECT_LT(largest, 1.0) << name << ": the bound does not hold";
  EXPECT_GT(largest, 0.01) << name << ": the bound is so wide that the faster stage passes on what it could answer";
}

TEST(CapPairBounds, Axis) {
  search("axis", 301, &Ratios::axis);
}
TEST(CapPairBounds, Height) {
  search("height", 302, &Ratios::height);
}
TEST(CapPairBounds, Cosine) {
  search("cosine", 303, &Ratios::cosine);
}
TEST(CapPairBounds, DiscriminantQ) {
  search("q", 304, &Ratios::q);
}
TEST(CapPairBounds, Centre) {
  search("centre", 305, &Ratios::centre);
}
TEST(CapPairBounds, Points) {
  search("points", 306, &Ratios::point);
}

// The bound of q lies far below the threshold, and that of the centre below its own.
TEST(CapPairBounds, ThresholdsExceedTheBounds) {
  EXPECT_GT(hsp::certain_discriminant, 1000 * 111 * unit_roundoff);
  EXPECT_GT(hsp::certain_centre, 27 * unit_roundoff);
}

// A ball of radius 0 meets others only where it lies on their spheres; nothing about its caps is certain.
TEST(CapPairBounds, RadiusZeroIsCertainOfNothing) {
  FourBalls four;
  four.ball[0] = {{0, 0, 0}, 0, 0};
  four.ball[1] = {{3, 0, 0}, 3, 1};
  four.ball[2] = {{0, 0, 5}, 5, 2};
  four.ball[3] = {{2, 3, 6}, 7, 3};
  CapsOfFour maker;
  const Caps &caps = maker.of(four);
  ASSERT_EQ(caps.count, 3U);
  for (uint32_t j = 0; j < 3; ++j) {
    for (uint32_t k = j + 1; k < 3; ++k) {
      const CapPair pair(caps, j, k);
      EXPECT_FALSE(pair.certainly_cross() || pair.certainly_apart() || pair.certainly_inside() ||
                   pair.certainly_contains() || pair.certainly_separate());
    }
  }
}

}  // namespace
