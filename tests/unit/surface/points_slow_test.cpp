// Points of raw patches at random against the definition of the smooth surface: what the caps of other probes and the
// axes of saddles leave of the patches is on it, and what they cut off is not (lib/smooth/surface/PROOFS.md, sections 4
// and 5).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "built_surface.hpp"
#include "excluded_surface.hpp"
#include "measure/boundary_positions.hpp"
#include "mesh/saddle_band.hpp"
#include "random_numbers.hpp"
#include "sphere/arc_geometry.hpp"
#include "surface/probe_caps.hpp"
#include "surface/surface_map.hpp"

namespace {

using hsp::Vec3;

// Points nearer to a border are not asked about: lengths are about 1.
constexpr double border = 1e-6;
constexpr double same = 1e-9;
constexpr double step = 0x1p-24;  // all numbers are multiples of it

struct Tally {
  uint64_t concave = 0, saddle = 0, cut_off = 0, cut_patches = 0, cusped = 0;
};

class RandomPoints {
 public:
  RandomPoints(const support::BallList &list, double probe, support::Random &random, Tally &tally)
      : built_(list, probe, step),
        probe_(probe),
        random_(random),
        tally_(tally),
        distance_(with_probe(list, probe)),
        p_(static_cast<double>(built_.balls().probe_steps)) {
    EXPECT_EQ(built_.status(), hsp::Status::ok);
  }

  void ask(uint32_t concave_points, uint32_t saddle_points) {
    const hsp::Boundary &boundary = built_.boundary();
    CarvedMemory grid_memory, cap_memory;
    hsp::ProbeGrid probes;
    hsp::ProbeCaps caps;
    grid_memory.carve(probes, boundary.vertex_count());
    cap_memory.carve(caps, 4 * boundary.vertex_count());
    hsp::Patience endless;
    if (boundary.vertex_count() > 0) probes.build(balls(), boundary, endless);
    for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
      const bool crossed = caps.gather(balls(), boundary, built_.surface().chosen(), probes, v);
      ASSERT_FALSE(caps.overflowed());
      if (crossed) ++tally_.cut_patches;
      for (uint32_t k = 0; k < concave_points; ++k) ask_concave(v, crossed, caps.caps());
    }
    const hsp::SurfaceMap map(balls(), boundary, built_.surface());
    for (uint32_t arc = 0; arc < boundary.arc_count(); ++arc) {
      const hsp::LoopElement element = map.element_of(arc, 1);
      const bool has_cusps = map.cusped_circle_of(element) != hsp::no_id;
      if (has_cusps) ++tally_.cusped;
      for (uint32_t k = 0; k < saddle_points; ++k) ask_saddle(element, has_cusps);
    }
  }

 private:
  static std::vector<oracle::ProbedBall> with_probe(const support::BallList &list, double probe) {
    std::vector<oracle::ProbedBall> balls(list.size());
    for (uint32_t i = 0; i < list.size(); ++i) {
      balls[i] = {{list.xyz[3 * i], list.xyz[3 * i + 1], list.xyz[3 * i + 2]}, list.radius[i] + probe};
    }
    return balls;
  }
  const hsp::BallSet &balls() const { return built_.balls(); }

  // The definition's answer at the point in this direction from where the probe stands.
  void expect_on_surface(const hsp::Position &centre, const Vec3 &w, bool on_surface) {
    oracle::Point x;
    hsp::to_coordinates(balls(), {centre.ball, centre.offset + p_ * w}, x.data());
    const double depth = distance_({x[0], x[1], x[2]}).distance - probe_;
    if (on_surface) {
      EXPECT_NEAR(depth, 0, same);
    } else {
      EXPECT_LT(depth, -1e-12);
      ++tally_.cut_off;
    }
  }
  Vec3 direction(const hsp::Position &from, uint32_t ball) const {
    const Vec3 v = balls().difference(from.ball, ball) - from.offset;
    return 1 / std::sqrt(dot(v, v)) * v;
  }
  // In the cone of these directions.
  template <size_t n>
  Vec3 inside(const Vec3 (&cone)[n]) {
    Vec3 sum{0, 0, 0};
    for (const Vec3 &d : cone) sum = hsp::combine(1, sum, random_.fraction(), d);
    return 1 / std::sqrt(dot(sum, sum)) * sum;
  }

  void ask_concave(uint32_t v, bool crossed, const hsp::Caps &caps) {
    const hsp::Position centre = hsp::position_of_vertex(balls(), built_.boundary(), v);
    const uint32_t *const ball = built_.boundary().vertex(v).ball;
    const Vec3 cone[] = {direction(centre, ball[0]), direction(centre, ball[1]), direction(centre, ball[2])};
    const Vec3 w = inside(cone);
    double above = -1;
    double height = 1;
    if (crossed) {
      for (uint32_t k = hsp::ProbeCaps::sides; k < caps.count; ++k) {
        const double a = dot(caps.axis(k), w) - caps.b[k];
        if (a > above) {
          above = a;
          height = caps.b[k];
        }
      }
    }
    if (std::fabs(above) * height < border) return;
    ++tally_.concave;
    expect_on_surface(centre, w, above < 0);
  }

  void ask_saddle(hsp::LoopElement element, bool has_cusps) {
    const hsp::SaddleBand band(balls(), built_.boundary(), element, has_cusps);
    const Vec3 outward = band.outward(1 + random_.below(62), 64);
    const hsp::Position centre = band.probe(outward);
    const Vec3 cone[] = {direction(centre, band.ball(0)), direction(centre, band.ball(1))};
    const Vec3 w = inside(cone);
    const double rho = hsp::CircleGeometry(balls(), band.ball(0), band.ball(1)).radius;
    const double from_axis = has_cusps ? (rho + p_ * dot(w, outward)) / p_ : 1;
    if (std::fabs(from_axis) < border) return;
    ++tally_.saddle;
    expect_on_surface(centre, w, from_axis > 0);
  }

  const BuiltSurface built_;
  const double probe_;
  support::Random &random_;
  Tally &tally_;
  const oracle::DistanceFromOutside distance_;
  const double p_;  // in steps
};

TEST(Points, OfRawPatches) {
  support::Random random(43);
  Tally tally;
  const auto below = [&random](double x) { return std::floor(x * random.fraction() / step) * step; };
  while (tally.concave < 1000000 && !testing::Test::HasFailure()) {
    const uint32_t n = 4 + random.below(16);
    const double probe = 0.25 + below(2);
    const double side = std::cbrt(static_cast<double>(n)) * (1 + below(2));
    support::BallList list;
    for (uint32_t i = 0; i < n; ++i) {
      const double x = below(side);
      const double y = below(side);
      const double z = below(side);
      list.add(x, y, z, random.below(10) == 0 ? 0x1p-7 : 0.25 + below(1.25));
    }
    RandomPoints(list, probe, random, tally).ask(60, 5);
  }
  std::cout << tally.concave << " points of concave patches, " << tally.saddle << " of saddles, " << tally.cut_off
            << " cut off; " << tally.cut_patches << " patches with caps, " << tally.cusped << " saddles with cusps\n";
  EXPECT_GT(tally.saddle, 50000U);
  EXPECT_GT(tally.cut_off, 50000U);
  EXPECT_GT(tally.cusped, 500U);
}

}  // namespace
