// The arcs that areas and derivatives sum over, in doubles and in batches, against the exact integers of single arcs
// and vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "built_boundary.hpp"
#include "lattice_lengths.hpp"
#include "measure/arc_batches.hpp"
#include "measure/gradients.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"
#include "sphere/arc_geometry.hpp"

namespace {

using hsp::Vec3;

struct Seen {
  uint32_t arcs = 0, circles = 0, batches = 0, small_circles = 0, plain_arcs = 0;
};

class ArcsOfBall {
 public:
  ArcsOfBall(BuiltBoundary &built, uint32_t ball)
      : balls_(built.balls()), boundary_(built.boundary()), ball_(ball), own_(balls_.ball(ball)) {}

  // Holds all batches of a face, or of all faces, against the half-edges and closed half-edges that they must hold.
  void check(uint32_t face, Seen &seen) {
    std::map<uint32_t, uint32_t> times;
    uint32_t circles = 0;
    double found_angles = 0.0;
    hsp::ArcBatches arcs(balls_, boundary_, ball_, face);
    while (arcs.next()) {
      const hsp::ArcBatch &batch = arcs.batch();
      ++seen.batches;
      found_angles += batch.exterior_angles + 2 * hsp::pi * batch.exterior_turns;
      for (uint32_t c = 0; c < batch.count; ++c) {
        if (batch.arc[c] != 0) {
          const uint32_t e = arcs.half_edge(c);
          ++times[e];
          check_arc(batch, c, e, seen);
          continue;
        }
        EXPECT_EQ(batch.Xx[c], 0.0);
        EXPECT_EQ(batch.Xz[c], 0.0);
        if (batch.angle[c] == 0.0) continue;
        EXPECT_EQ(batch.angle[c], 2 * hsp::pi);
        ++circles;
      }
    }
    double exterior_angle_sum = 0.0;
    uint32_t half_edges = 0;
    for (const uint32_t u : boundary_.half_edges(ball_)) {
      const hsp::HalfEdge &half_edge = boundary_.half_edge(u);
      if (face != hsp::no_id && boundary_.face_of_loop(half_edge.loop) != face) continue;
      EXPECT_EQ(times[u], 1U);
      ++half_edges;
      exterior_angle_sum +=
          hsp::exterior_angle(boundary_.root_discriminant(half_edge.vertex), hsp::exact::sphere_of(own_),
                              plane(half_edge.circle), plane(boundary_.previous_circle(ball_, half_edge)));
    }
    EXPECT_NEAR(found_angles, exterior_angle_sum, 1e-13 * (1 + half_edges));
    uint32_t sides = 0;
    for (const hsp::ClosedHalfEdge e : boundary_.circles(ball_)) {
      sides += face == hsp::no_id || boundary_.face_of_loop(boundary_.loop_of(e)) == face ? 1U : 0U;
    }
    EXPECT_EQ(circles, sides);
    seen.arcs += half_edges;
    seen.circles += circles;
  }

  // Holds the batch of every arc and circle alone against it.
  void check_singles(Seen &seen) {
    for (const uint32_t e : boundary_.half_edges(ball_)) check_single(hsp::LoopElement::arc(e), seen);
    for (const hsp::ClosedHalfEdge e : boundary_.circles(ball_)) check_single(hsp::LoopElement::circle(e), seen);
  }

 private:
  void check_single(hsp::LoopElement element, Seen &seen) {
    hsp::ArcBatches arcs(balls_, boundary_, element);
    ASSERT_TRUE(arcs.next());
    const hsp::ArcBatch &batch = arcs.batch();
    uint32_t pieces = 0;
    for (uint32_t c = 0; c < batch.count; ++c) {
      if (!batch.has_piece(c)) continue;
      ++pieces;
      if (element.is_circle()) {
        EXPECT_EQ(batch.angle[c], 2 * hsp::pi);
        EXPECT_EQ(batch.other[c], boundary_.neighbour(element.closed_half_edge()));
      } else {
        EXPECT_EQ(arcs.half_edge(c), element.half_edge());
        check_arc(batch, c, element.half_edge(), seen);
      }
    }
    EXPECT_EQ(pieces, 1U);
    EXPECT_FALSE(arcs.next());
  }

  hsp::exact::Plane plane(uint32_t other) const { return hsp::exact::plane_of(own_, balls_.ball(other)); }

  Vec3 offset_of(const hsp::HalfEdge &half_edge) const {
    return hsp::crossing_point(plane(half_edge.circle), plane(boundary_.previous_circle(ball_, half_edge)), -1,
                               boundary_.root_discriminant(half_edge.vertex));
  }

  void check_arc(const hsp::ArcBatch &batch, uint32_t c, uint32_t e, Seen &seen) const {
    const hsp::HalfEdge &half_edge = boundary_.half_edge(e);
    ASSERT_EQ(batch.other[c], half_edge.circle);
    const hsp::CircleGeometry circle(balls_, ball_, half_edge.circle);
    const double r = balls_.r[ball_];
    const bool is_small = r == 0.0 || circle.radius * 8 < r;
    seen.small_circles += is_small ? 1U : 0U;
    seen.plain_arcs += is_small ? 0U : 1U;
    const double exact = hsp::angle_of(balls_, boundary_, ball_, e);
    EXPECT_NEAR(batch.angle[c], exact, is_small ? 0.0 : 0x1p-46 * r / circle.radius);
    // X = 2 (q - p) x u; a loop walks from q to p.
    const Vec3 chord = hsp::combine(2.0, offset_of(half_edge), -2.0, offset_of(boundary_.half_edge(half_edge.next)));
    const Vec3 X = cross(chord, circle.axis);
    const double tolerance = 0x1p-44 * r;
    EXPECT_NEAR(batch.Xx[c], X.x, tolerance);
    EXPECT_NEAR(batch.Xy[c], X.y, tolerance);
    EXPECT_NEAR(batch.Xz[c], X.z, tolerance);
    EXPECT_NEAR(batch.twice_height[c], 2 * dot(circle.centre, circle.axis), 0x1p-46 * r);
    EXPECT_NEAR(batch.ux[c], circle.axis.x, 0x1p-50);
  }

  const hsp::BallSet &balls_;
  const hsp::Boundary &boundary_;
  const uint32_t ball_;
  const hsp::exact::LatticeBall own_;
};

// All targets give the same bits.
void check_targets(BuiltBoundary &built, uint32_t ball) {
  const hsp::Target best = built.boundary().target();
  const auto measured = [&](hsp::Target target) {
    built.arrays().target = target;
    const hsp::BallGradient g = hsp::gradient_of_ball(built.balls(), built.boundary(), {}, ball);
    const hsp::BallMeasure m = hsp::measure_ball(built.balls(), built.boundary(), ball);
    EXPECT_EQ(g.measure.area, m.area);
    EXPECT_EQ(g.measure.volume, m.volume);
    return std::array{m.area,     m.volume,        g.radius,        g.centre.x,     g.centre.y,
                      g.centre.z, g.vector_area.x, g.vector_area.y, g.vector_area.z};
  };
  EXPECT_EQ(measured(hsp::Target::baseline), measured(best));
}

Seen check_all(const oracle::Balls &set) {
  BuiltBoundary built(set);
  EXPECT_EQ(built.status(), hsp::Status::ok);
  Seen seen;
  Seen by_faces;
  for (uint32_t i = 0; i < set.size(); ++i) {
    ArcsOfBall ball(built, i);
    ball.check(hsp::no_id, seen);
    ball.check_singles(by_faces);
    check_targets(built, i);
    for (const uint32_t face : built.boundary().faces(i)) {
      ball.check(face, by_faces);
    }
  }
  EXPECT_EQ(by_faces.arcs, seen.arcs);
  EXPECT_EQ(by_faces.circles, seen.circles);
  return seen;
}

TEST(ArcBatches, AgreeWithTheIntegersOnRandomSets) {
  oracle::RandomSource random(17);
  Seen all;
  for (int round = 0; round < 200; ++round) {
    const int64_t scale = round % 3 == 0 ? 10000 : 100000000;
    oracle::Balls set(static_cast<size_t>(2 + round % 25));
    for (oracle::LatticeBall &ball : set) {
      ball = {random.in(0, 3 * scale), random.in(0, 3 * scale), random.in(0, 3 * scale),
              random.in(scale / 20, 3 * scale / 2)};
    }
    const Seen seen = check_all(set);
    all.small_circles += seen.small_circles;
    all.plain_arcs += seen.plain_arcs;
    all.circles += seen.circles;
  }
  // Both ways were gone.
  EXPECT_GT(all.small_circles, 25U);
  EXPECT_GT(all.plain_arcs, 500U);
  EXPECT_GT(all.circles, 10U);
}

TEST(ArcBatches, TiesOnLattices) {
  oracle::RandomSource random(23);
  for (int round = 0; round < 60; ++round) {
    oracle::Balls set(static_cast<size_t>(2 + round % 20));
    for (oracle::LatticeBall &ball : set) {
      ball = {random.in(0, 3), random.in(0, 3), random.in(0, 3), random.in(0, 3)};
    }
    check_all(set);
  }
}

// A ball whose sphere cuts that of a ball of radius r at the origin in the circle across the unit vector u at the given
// height.
oracle::LatticeBall cutting(double r, const Vec3 &u, double height, double distance) {
  return oracle::nearest_ball(
      {distance * u.x, distance * u.y, distance * u.z, std::sqrt(distance * distance - 2 * distance * height + r * r)});
}
Vec3 unit(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

TEST(ArcBatches, CirclesWithNearlyOneAxis) {
  oracle::RandomSource random(29);
  const auto any = [&random] { return 2 * random.fraction() - 1; };
  Seen all;
  for (int round = 0; round < 60; ++round) {
    const double spread = std::pow(10.0, -1.0 - round % 5);
    oracle::Balls set{{0, 0, 0, 100000000}};
    for (int k = 0; k < 5; ++k) {
      const Vec3 u = unit(1.0, spread * any(), spread * any());
      set.push_back(cutting(1e8, u, 1e8 * (0.4 + 0.5 * spread * any()), 1e8 * (1.0 + 0.3 * any())));
    }
    all.plain_arcs += check_all(set).plain_arcs;
  }
  EXPECT_GT(all.plain_arcs, 300U);
}

TEST(ArcBatches, BallsManyTimesLarger) {
  oracle::RandomSource random(31);
  const auto any = [&random] { return 2 * random.fraction() - 1; };
  Seen all;
  for (int round = 0; round < 60; ++round) {
    const double r = round % 2 == 0 ? 1e4 : 1e6;
    oracle::Balls set{oracle::nearest_ball({0, 0, 0, r})};
    for (int k = 0; k < 4; ++k) {
      const Vec3 u = unit(any(), any(), any());
      set.push_back(cutting(r, u, r * (0.3 + 0.3 * any()), 2e8 * (1.0 + 0.5 * any())));
    }
    BuiltBoundary built(set);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    ArcsOfBall(built, built.grid_index(0)).check(hsp::no_id, all);
  }
  EXPECT_GT(all.plain_arcs, 100U);
}

// Small balls around the equator of a large one, each meeting the next two: two loops with an arc for each, of any
// length beside the batch's.
oracle::Balls ring(uint32_t n) {
  return oracle::joined({{0, 0, 0, 1000000}}, oracle::ring_around_z(static_cast<int>(n), 1e6, 0, 4000000 / n, 0.1));
}

TEST(ArcBatches, LoopsLongerThanABatch) {
  for (uint32_t n = 3; n < 3 * hsp::ArcBatch::capacity + 4; ++n) {
    BuiltBoundary built(ring(n));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const uint32_t large = built.grid_index(0);
    Seen seen;
    ArcsOfBall(built, large).check(hsp::no_id, seen);
    EXPECT_EQ(seen.arcs, 2 * n);
    EXPECT_EQ(seen.batches > 1, 2 * n > hsp::ArcBatch::capacity);
    check_targets(built, large);
    const uint32_t first = built.boundary().faces(large).first;
    ASSERT_EQ(built.boundary().faces(large).size(), 2U);
    const hsp::BallMeasure whole = hsp::measure_ball(built.balls(), built.boundary(), large);
    const hsp::BallMeasure upper = hsp::measure_face(built.balls(), built.boundary(), first);
    const hsp::BallMeasure lower = hsp::measure_face(built.balls(), built.boundary(), first + 1);
    EXPECT_NEAR(upper.area + lower.area, whole.area, 1e-13 * whole.area);
    EXPECT_NEAR(upper.area, lower.area, 1e-13 * whole.area);
  }
}

// The same with small balls twice, a little apart, so that vertices lie between circles of nearly one axis: every
// second one, or one a loop, which is the first of one loop because its ball is the first by x.
TEST(ArcBatches, LongLoopsWithVerticesFromTheIntegers) {
  for (uint32_t n = 8; n < 2 * hsp::ArcBatch::capacity; ++n) {
    for (const bool all : {false, true}) {
      oracle::Balls set = ring(n);
      const int64_t first =
          std::min_element(set.begin(), set.end(), [](const oracle::LatticeBall &a, const oracle::LatticeBall &b) {
            return a.x < b.x;
          })->x;
      for (uint32_t k = 1; k <= n; ++k) {
        if (all || set[k].x == first) {
          set.push_back({set[k].x + 1, set[k].y + (set[k].y < 0 ? 1000 : -1000), 0, set[k].radius});
        }
      }
      BuiltBoundary built(set);
      ASSERT_EQ(built.status(), hsp::Status::ok);
      Seen seen;
      ArcsOfBall(built, built.grid_index(0)).check(hsp::no_id, seen);
      EXPECT_GE(seen.arcs, 2 * n + 2);
    }
  }
}

}  // namespace
