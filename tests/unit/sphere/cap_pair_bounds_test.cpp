// The floating-point stage of the vertex search (sphere/cap_pair.hpp, and sphere/caps.hpp below it) at the worst
// inputs a search finds, in units of its stated error bounds: radii as different as 1 and 2^29, nearly parallel axes,
// circles that nearly touch. q is compared as a fraction of integers; quantities with roots in long double, after every
// sum that could cancel was done in integers. Wherever an answer is certain, it is held against signs of integers. The
// same for the numbers in lanes of floats and doubles (sphere/float_caps.hpp, sphere/crossing_pairs.hpp), of all
// targets that the processor has.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "filter_bounds_search.hpp"
#include "gridless_balls.hpp"
#include "lane_pairs.hpp"
#include "sphere/cap_pair.hpp"
#include "sphere/caps.hpp"
#include "sphere/float_caps.hpp"

namespace {

using namespace filter_bounds;
using hsp::CapPair;
using hsp::CapPairBounds;
using hsp::Caps;
using hsp::CrossingPoints;
using hsp::Target;
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

// The caps of ball 0 of four in some arithmetic: the caps, pairs of them, and their points.
struct CapNumbers {
  double u[3], b;
};
struct PairNumbers {
  double g, q, centre_jk, centre_kj;
  bool cross, apart, inside, contains, separate;
  bool has_points;
};
struct PointNumbers {
  double depth[2][3];  // of p- and p+ in all caps
  double error;
};
// Its error bounds: of u, b, g, q and the centres, in units of its roundoff.
struct StatedBounds {
  double roundoff, axis, height, cosine, q, centre;
};

class InDoubles {
 public:
  static constexpr StatedBounds bounds{unit_roundoff, 3.5, 7, 10, 108, 26};

  InDoubles(const FourBalls &four, CapsOfFour &maker) : caps_(maker.of(four)) {}
  bool is_sure() const { return true; }
  int ball(uint32_t k) const { return static_cast<int>(caps_.ball[k]); }
  CapNumbers cap(uint32_t k) const { return {{caps_.ux[k], caps_.uy[k], caps_.uz[k]}, caps_.b[k]}; }
  PairNumbers pair(uint32_t j, uint32_t k) const {
    const CapPair p(caps_, j, k);
    return {p.g.v,
            p.q.v,
            p.g.v * p.bj.v - p.bk.v,
            p.g.v * p.bk.v - p.bj.v,
            p.certainly_cross(),
            p.certainly_apart(),
            p.certainly_inside(),
            p.certainly_contains(),
            p.certainly_separate() != 0,
            p.certainly_cross_in_points()};
  }
  PointNumbers points(uint32_t j, uint32_t k) const {
    const CrossingPoints points(caps_, j, k, CapPair(caps_, j, k));
    PointNumbers numbers{};
    for (uint32_t l = 0; l < 3; ++l) {
      for (int point = 0; point < 2; ++point) {
        numbers.depth[point][l] =
            points.x[point] * caps_.ux[l] + points.y[point] * caps_.uy[l] + points.z[point] * caps_.uz[l] - caps_.b[l];
      }
    }
    numbers.error = points.error;
    return numbers;
  }

 private:
  const Caps &caps_;
};

#if HSP_LANES
// In lanes of floats or doubles.
template <class Real, Target target>
class InLanes {
 public:
  using Bounds = CapPairBounds<Real>;
  static constexpr StatedBounds bounds = sizeof(Real) == sizeof(float)
                                             ? StatedBounds{0x1p-24, 6.5, 29, 16, 308, 76}
                                             : StatedBounds{unit_roundoff, 3.5, 7, 10, 108, 26};

  InLanes(const FourBalls &four, CapsOfFour &maker) {
    if constexpr (sizeof(Real) == sizeof(float)) {
      GridlessBalls<4> balls;
      for (const hsp::exact::LatticeBall &ball : four.ball) balls.add(ball);
      uint32_t near[3 + hsp::spare_ids] = {1, 2, 3};
      const hsp::BallSet &set = balls.set();
      is_sure_ = hsp::make_float_caps(target, {set.x.data(), set.y.data(), set.z.data(), set.r.data(), set.words()}, 0,
                                      near, 3, {x_, y_, z_, b_});
    } else {
      const Caps &caps = maker.of(four);
      for (uint32_t k = 0; k < 3; ++k) {
        x_[k] = caps.ux[k];
        y_[k] = caps.uy[k];
        z_[k] = caps.uz[k];
        b_[k] = caps.b[k];
      }
    }
  }
  bool is_sure() const { return is_sure_; }
  int ball(uint32_t k) const { return static_cast<int>(k) + 1; }
  CapNumbers cap(uint32_t k) const { return {{x_[k], y_[k], z_[k]}, b_[k]}; }
  PairNumbers pair(uint32_t j, uint32_t k) const {
    const hsp::LanePair<Real> p = hsp::lane_pair(target, caps(), j, k);
    const bool apart = p.q < -Bounds::crossing;
    return {p.g,
            p.q,
            p.centre_jk,
            p.centre_kj,
            p.q > Bounds::crossing,
            apart,
            apart && p.centre_jk > Bounds::centre,
            apart && p.centre_kj > Bounds::centre,
            apart && p.centre_jk < -Bounds::centre && p.centre_kj<-Bounds::centre, p.q> Bounds::points};
  }
  PointNumbers points(uint32_t j, uint32_t k) const {
    const hsp::LanePair<Real> p = hsp::lane_pair(target, caps(), j, k);
    PointNumbers numbers{};
    for (int point = 0; point < 2; ++point) {
      for (int l = 0; l < 3; ++l) numbers.depth[point][l] = p.depth[point][l];
    }
    numbers.error = p.error;
    return numbers;
  }

 private:
  hsp::ThreeCaps<Real> caps() const { return {x_, y_, z_, b_}; }

  Real x_[16] = {}, y_[16] = {}, z_[16] = {}, b_[16] = {};
  bool is_sure_ = true;
};
#endif

struct Ratios {
  double axis = 0.0, height = 0.0, cosine = 0.0, q = 0.0, centre = 0.0, point = -1.0;
  bool contradiction = false;
  bool crosses = false, apart = false;

  static void raise(double &ratio, long double error, double bound) {
    ratio = std::max(ratio, static_cast<double>(std::fabs(error) / static_cast<long double>(bound)));
  }
};

// How much is measured: the caps, their pairs as well, or the points of these as well. The integers of pairs and points
// take nearly all of the time, which a search for the worst cap saves.
enum class Extent { caps, pairs, points };

template <class Arithmetic>
class Measurement {
 public:
  Measurement(const FourBalls &four, CapsOfFour &maker, Extent extent)
      : numbers_(four, maker), balls_(as_given(four)), origin_(balls_, 0), extent_(extent) {
    for (uint32_t k = 0; k < 3; ++k) half_space_[k] = perturbation::half_space(balls_, 0, numbers_.ball(k));
  }

  Ratios run() {
    if (!numbers_.is_sure()) return ratios_;
    for (uint32_t k = 0; k < 3; ++k) measure_cap(k);
    if (extent_ == Extent::caps) return ratios_;
    for (uint32_t j = 0; j < 3; ++j) {
      for (uint32_t k = j + 1; k < 3; ++k) measure_pair(j, k);
    }
    return ratios_;
  }

 private:
  long double diameter() const { return std::sqrt(origin_.W.to_long_double()); }

  void measure_cap(uint32_t k) {
    const HalfSpace &P = half_space_[k];
    const CapNumbers cap = numbers_.cap(k);
    long double squared = 0.0L;
    for (int a = 0; a < 3; ++a) {
      const long double error = cap.u[a] - static_cast<long double>(P.v[a]) / length(P);
      squared += error * error;
    }
    Ratios::raise(ratios_.axis, std::sqrt(squared), unit(bounds.axis));
    Ratios::raise(ratios_.height, cap.b - P.h.to_long_double() / (diameter() * length(P)), unit(bounds.height));
  }

  void measure_pair(uint32_t j, uint32_t k) {
    const HalfSpace &P = half_space_[j];
    const HalfSpace &Q = half_space_[k];
    const PairNumbers pair = numbers_.pair(j, k);
    const Integer D = origin_.D(P, Q);
    const Integer beta_jk = origin_.beta(P, Q);
    const Integer beta_kj = origin_.beta(Q, P);
    const Integer uu = inner(P, P);
    const Integer vv = inner(Q, Q);

    Ratios::raise(ratios_.cosine, pair.g - inner(P, Q).to_long_double() / (length(P) * length(Q)), unit(bounds.cosine));
    // q = D / (W u.u v.v)
    constexpr int fraction_bits = 200;
    const Integer denominator = origin_.W * uu * vv;
    const Integer computed = Integer::from_double(std::ldexp(pair.q, fraction_bits));
    const Integer error = computed * denominator - D.times_power_of_two(fraction_bits);
    Ratios::raise(ratios_.q, std::ldexp(error.to_long_double(), -fraction_bits) / denominator.to_long_double(),
                  unit(bounds.q));
    // u_k . (centre of circle j) - b_k = -beta / (u.u 2r |v|)
    const long double centre_jk = -beta_jk.to_long_double() / (uu.to_long_double() * diameter() * length(Q));
    const long double centre_kj = -beta_kj.to_long_double() / (vv.to_long_double() * diameter() * length(P));
    Ratios::raise(ratios_.centre, pair.centre_jk - centre_jk, unit(bounds.centre));
    Ratios::raise(ratios_.centre, pair.centre_kj - centre_kj, unit(bounds.centre));

    contradicts(pair.cross && D.sign() <= 0);
    contradicts(pair.apart && D.sign() >= 0);
    contradicts(pair.inside && beta_jk.sign() >= 0);
    contradicts(pair.contains && beta_kj.sign() >= 0);
    contradicts(pair.separate && (beta_jk.sign() <= 0 || beta_kj.sign() <= 0));
    ratios_.crosses = ratios_.crosses || pair.cross;
    ratios_.apart = ratios_.apart || pair.apart;
    if (extent_ == Extent::points && pair.has_points && D.sign() > 0) measure_points(j, k, D);
  }

  void measure_points(uint32_t j, uint32_t k, const Integer &D) {
    const HalfSpace &P = half_space_[j];
    const HalfSpace &Q = half_space_[k];
    const PointNumbers points = numbers_.points(j, k);
    const long double root = std::sqrt(D.to_long_double());
    const long double N = origin_.N(P, Q).to_long_double();
    for (uint32_t l = 0; l < 3; ++l) {
      const HalfSpace &R = half_space_[l];
      const bool own = l == j || l == k;
      const Integer A = origin_.A(P, Q, R);
      const Integer B = origin_.B(P, Q, R);
      for (int point = 0; point < 2; ++point) {
        const int s = point == 1 ? 1 : -1;
        const double depth = points.depth[point][l];
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

  static constexpr StatedBounds bounds = Arithmetic::bounds;
  static double unit(double bound) { return bound * bounds.roundoff; }
  static Integer inner(const HalfSpace &a, const HalfSpace &b) {
    perturbation::Int128 sum = 0;
    for (int k = 0; k < 3; ++k) sum += static_cast<perturbation::Int128>(a.v[k]) * b.v[k];
    return Integer(sum);
  }
  void contradicts(bool it_does) { ratios_.contradiction = ratios_.contradiction || it_does; }

  Arithmetic numbers_;
  perturbation::Balls balls_;
  Origin origin_;
  HalfSpace half_space_[3];
  Extent extent_;
  Ratios ratios_;
};

// Searches for the worst of one ratio, while all that is certain of what is measured is checked on the way.
template <class Arithmetic = InDoubles>
void search(const char *name, uint64_t seed, double Ratios::*ratio, Extent extent) {
  oracle::RandomSource random(seed);
  CapsOfFour maker;
  int sets = 0, contradictions = 0, crossing = 0, apart = 0;
  const double largest = worst(random, 20, 3000, [&](const FourBalls &four) {
    const Ratios ratios = Measurement<Arithmetic>(four, maker, extent).run();
    ++sets;
    contradictions += ratios.contradiction;
    crossing += ratios.crosses;
    apart += ratios.apart;
    return ratios.*ratio;
  });
  testing::Test::RecordProperty(name, std::to_string(largest));
  std::cout << "  worst error of " << name << ": " << largest << " of its bound, " << sets << " sets\n";
  EXPECT_EQ(contradictions, 0);
  if (extent != Extent::caps) {
    EXPECT_GT(crossing, 1000);
    EXPECT_GT(apart, 1000);
  }
  EXPECT_LT(largest, 1.0) << name << ": the bound does not hold";
  EXPECT_GT(largest, 0.01) << name << ": the bound is so wide that the faster stage passes on what it could answer";
}

TEST(CapPairBounds, Axis) {
  search("axis", 301, &Ratios::axis, Extent::caps);
}
TEST(CapPairBounds, Height) {
  search("height", 302, &Ratios::height, Extent::caps);
}
TEST(CapPairBounds, Cosine) {
  search("cosine", 303, &Ratios::cosine, Extent::pairs);
}
TEST(CapPairBounds, DiscriminantQ) {
  search("q", 304, &Ratios::q, Extent::pairs);
}
TEST(CapPairBounds, Centre) {
  search("centre", 305, &Ratios::centre, Extent::pairs);
}
TEST(CapPairBounds, Points) {
  search("points", 306, &Ratios::point, Extent::points);
}

#if HSP_LANES
// Everything of one arithmetic in lanes.
template <class Arithmetic>
void search_in_lanes(const std::string &name, uint64_t seed) {
  search<Arithmetic>((name + "_axis").c_str(), seed, &Ratios::axis, Extent::caps);
  search<Arithmetic>((name + "_height").c_str(), seed + 1, &Ratios::height, Extent::caps);
  search<Arithmetic>((name + "_cosine").c_str(), seed + 2, &Ratios::cosine, Extent::pairs);
  search<Arithmetic>((name + "_q").c_str(), seed + 3, &Ratios::q, Extent::pairs);
  search<Arithmetic>((name + "_centre").c_str(), seed + 4, &Ratios::centre, Extent::pairs);
  search<Arithmetic>((name + "_points").c_str(), seed + 5, &Ratios::point, Extent::points);
}

TEST(CapPairBounds, InFloatLanesOfTheBaseline) {
  search_in_lanes<InLanes<float, Target::baseline>>("baseline_floats", 331);
}
TEST(CapPairBounds, InFloatLanes) {
  if (hsp::best_target() != Target::avx2) GTEST_SKIP() << "no such processor";
  search_in_lanes<InLanes<float, Target::avx2>>("floats", 311);
}
TEST(CapPairBounds, InDoubleLanes) {
  if (hsp::best_target() != Target::avx2) GTEST_SKIP() << "no such processor";
  search_in_lanes<InLanes<double, Target::avx2>>("doubles", 321);
}
#endif

// The bound of q lies far below the threshold, and that of the centre below its own.
TEST(CapPairBounds, ThresholdsExceedTheBounds) {
  EXPECT_GT(CapPairBounds<double>::crossing, 1000 * 108 * unit_roundoff);
  EXPECT_GT(CapPairBounds<double>::centre, 26 * unit_roundoff);
  EXPECT_GT(CapPairBounds<float>::crossing, 308 * 0x1p-24);
  EXPECT_GT(CapPairBounds<float>::centre, 76 * 0x1p-24);
}

// A ball of radius 0 has no caps: on the sphere of another it is inside that one.
TEST(CapPairBounds, RadiusZeroHasNone) {
  FourBalls four;
  four.ball[0] = {{0, 0, 0}, 0, 0};
  four.ball[1] = {{3, 0, 0}, 3, 1};
  four.ball[2] = {{0, 0, 5}, 5, 2};
  four.ball[3] = {{2, 3, 6}, 7, 3};
  CapsOfFour maker;
  const Caps &caps = maker.of(four);
  EXPECT_EQ(caps.count, 0U);
  EXPECT_TRUE(caps.contained);
}

}  // namespace
