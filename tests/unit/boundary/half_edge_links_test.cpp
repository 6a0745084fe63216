#include "half_edge_links_cases.hpp"

#include <gtest/gtest.h>

#include "balls_around.hpp"
#include "built_boundary.hpp"
#include "expect_cases.hpp"

TEST(HalfEdgeLinks, Cases) {
  expect_cases(cases::boundary_half_edge_links);
}

namespace {

struct Seen {
  int half_edges = 0, same_x = 0, many = 0;
};

// Half-edges on a ball are sorted by the ranks of the balls around it.
void expect_order_of_ranks(const oracle::Balls &balls, Seen &seen) {
  const BuiltBoundary built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const hsp::Boundary &boundary = built.boundary();
  for (uint32_t i = 0; i < boundary.ball_count(); ++i) {
    const hsp::IdRange all = boundary.half_edges(i);
    seen.half_edges += static_cast<int>(all.size());
    seen.many += all.size() > 32;
    for (uint32_t e = all.first; e + 1 < all.last; ++e) {
      const hsp::HalfEdge &p = boundary.half_edge(e), &q = boundary.half_edge(e + 1);
      const uint32_t before_p = boundary.previous_circle(i, p), before_q = boundary.previous_circle(i, q);
      ASSERT_TRUE(p.circle != q.circle ? built.balls().ranks_before(p.circle, q.circle)
                                       : built.balls().ranks_before(before_p, before_q));
      seen.same_x += p.circle != q.circle && built.balls().x[p.circle] == built.balls().x[q.circle];
    }
    for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
      for (uint32_t slot = 0; slot < 3; ++slot) {
        if (boundary.vertex(v).ball[slot] != i) continue;
        ASSERT_TRUE(all.contains(boundary.half_edge_at(v, slot)));
        ASSERT_EQ(boundary.half_edge(boundary.half_edge_at(v, slot)).vertex, v);
      }
    }
  }
}

TEST(HalfEdgeLinks, AreInTheOrderOfRanks) {
  oracle::RandomSource random(15);
  Seen seen;
  for (int round = 0; round < 100; ++round) {
    // Centres with different x, with a few that are equal, and with hardly any that are not.
    for (const int64_t step : {INT64_C(1), INT64_C(100), INT64_C(700)}) {
      oracle::Balls balls = balls_around(random, 90, 60, 250);
      for (oracle::LatticeBall &ball : balls) ball.x = ball.x / step * step;
      expect_order_of_ranks(balls, seen);
    }
  }
  EXPECT_GT(seen.half_edges, 10000);
  EXPECT_GT(seen.same_x, 1000);
  EXPECT_GT(seen.many, 10);
}

}  // namespace
