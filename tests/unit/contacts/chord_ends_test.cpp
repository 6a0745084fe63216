// The terms of ends of chords in areas, in doubles for every target, against the same from integers: balls of every
// size down to single steps, the largest there may be, planes that are nearly parallel, and balls on a small lattice.
#include "contacts/chord_ends.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "built_boundary.hpp"
#include "carved_memory.hpp"
#include "exact/exact_predicates.hpp"
#include "exact/lattice_ball.hpp"
#include "measure/arc_batches.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"
#include "sphere/caps.hpp"

namespace {

using hsp::exact::LatticeBall;

// chord_ends.hpp has the bound, in parts of the squared radius; parts are times the distance of two balls.
constexpr double most_error = 0x1p-41;

class PowerVertices {
 public:
  PowerVertices() {
    memory_.carve(balls_, 4 * hsp::PowerVertexBatch::capacity);
    balls_.n = 4 * hsp::PowerVertexBatch::capacity;
  }

  // If the others meet the first one in circles, as the power vertex of four such balls that it lies in.
  void add(const LatticeBall (&ball)[4], int64_t kept) {
    for (uint32_t k = 1; k < 4; ++k) {
      if (hsp::exact::pair_relation(ball[0], ball[k]) != hsp::exact::PairRelation::circle) return;
      if (k > 1 && hsp::exact::pair_relation(ball[1], ball[k]) != hsp::exact::PairRelation::circle) return;
    }
    const hsp::exact::Plane P = plane_of(ball[0], ball[1]), Q = plane_of(ball[0], ball[2]),
                            R = plane_of(ball[0], ball[3]);
    if (hsp::exact::Exact::triple_product_sign(P.v, Q.v, R.v) == 0) return;
    const uint32_t s = batch_.count++;
    for (uint32_t k = 0; k < 4; ++k) {
      balls_.store(4 * s + k, ball[k]);
      batch_.ball[k][s] = 4 * s + k;
      batch_.kept[k][s] = static_cast<double>(kept >> k & 1);
    }
    if (batch_.count == hsp::PowerVertexBatch::capacity) compare();
  }

  uint32_t all() const { return all_; }
  uint32_t served() const { return served_; }

 private:
  void compare() {
    hsp::PowerVertexBatch exact = batch_;
    for (uint32_t s = 0; s < batch_.count; ++s) hsp::measure_in_integers(balls_, exact, s);
    hsp::PowerVertexBatch first = batch_;
    const uint32_t unserved =
        hsp::measure_power_vertices(hsp::Target::baseline, hsp::arrays_of(balls_), first, batch_.count);
    for (const hsp::Target target : runnable_targets()) {
      hsp::PowerVertexBatch found = batch_;
      EXPECT_EQ(hsp::measure_power_vertices(target, hsp::arrays_of(balls_), found, batch_.count), unserved);
      for (uint32_t s = 0; s < batch_.count; ++s) {
        if ((unserved >> s & 1U) == 0) expect_near(first, found, exact, s);
      }
    }
    all_ += batch_.count;
    served_ += batch_.count - static_cast<uint32_t>(__builtin_popcount(unserved));
    batch_.count = 0;
  }

  void expect_near(const hsp::PowerVertexBatch &first, const hsp::PowerVertexBatch &found,
                   const hsp::PowerVertexBatch &exact, uint32_t s) const {
    constexpr uint32_t pairs[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {3, 1}, {2, 3}};
    double longest = 0.0, r = 0.0;
    for (uint32_t k = 0; k < 4; ++k) r = std::fmax(r, balls_.r[4 * s + k]);
    for (const auto &pair : pairs) {
      const hsp::Vec3 v = balls_.difference(4 * s + pair[0], 4 * s + pair[1]);
      longest = std::fmax(longest, std::sqrt(dot(v, v)));
    }
    for (uint32_t pair = 0; pair < 6; ++pair) {
      EXPECT_EQ(found.part[pair][s], first.part[pair][s]);
      EXPECT_NEAR(found.part[pair][s], exact.part[pair][s], most_error * r * r * longest);
    }
  }

  CarvedMemory memory_;
  hsp::BallSet balls_;
  hsp::PowerVertexBatch batch_{};
  uint32_t all_ = 0, served_ = 0;
};

TEST(PowerVertices, OfBallsOfEverySize) {
  oracle::RandomSource random(51);
  PowerVertices vertices;
  for (int64_t k = 0; k < 60000; ++k) {
    const int64_t size = int64_t{1} << random.in(4, 30);
    LatticeBall ball[4];
    for (LatticeBall &b : ball) {
      const int64_t x = random.in(-size / 3, size / 3), y = random.in(-size / 3, size / 3);
      b = {{x, y, random.in(-size / 3, size / 3)}, random.in(size / 3, size - 1), 0};
    }
    vertices.add(ball, k % 3 == 0 ? k % 16 : 15);
  }
  EXPECT_GT(vertices.all(), 60000U / 8);
  EXPECT_GT(vertices.served(), vertices.all() / 10 * 9);
}

// Centres near one line or plane, so that polynomials lose most of their digits.
TEST(PowerVertices, OfNearlyParallelPlanes) {
  oracle::RandomSource random(52);
  PowerVertices vertices;
  for (int64_t k = 0; k < 60000; ++k) {
    const int64_t size = (int64_t{1} << 30) - 1;
    LatticeBall ball[4];
    const int64_t wide = int64_t{1} << random.in(18, 29);
    for (LatticeBall &b : ball) {
      const int64_t x = random.in(-size / 2, size / 2);
      b = {{x, random.in(-wide, wide), k % 2 == 0 ? random.in(-wide, wide) : random.in(-size / 2, size / 2)}, 0, 0};
      b.radius = size - random.in(0, wide);
    }
    vertices.add(ball, 15);
  }
  EXPECT_GT(vertices.all(), 60000U / 8);
  EXPECT_GT(vertices.served(), vertices.all() / 4);
  EXPECT_LT(vertices.served(), vertices.all());
}

TEST(PowerVertices, OfBallsOnASmallLattice) {
  oracle::RandomSource random(53);
  PowerVertices vertices;
  for (int64_t k = 0; k < 60000; ++k) {
    const int64_t step = int64_t{1} << random.in(0, 25);
    LatticeBall ball[4];
    for (LatticeBall &b : ball) {
      b = {{step * random.in(-3, 3), step * random.in(-3, 3), step * random.in(-3, 3)}, step * random.in(2, 6), 0};
    }
    vertices.add(ball, 15);
  }
  EXPECT_GT(vertices.all(), 60000U / 16);
  EXPECT_GT(vertices.served(), vertices.all() / 10 * 9);
}

// The contacts of small balls are small beside the square of the largest radius.
TEST(PowerVertices, OfUnlikeBalls) {
  oracle::RandomSource random(56);
  for (const int64_t large : {800, 801}) {
    PowerVertices vertices;
    for (int64_t k = 0; k < 20000; ++k) {
      LatticeBall ball[4];
      const auto number = [&] { return random.in(-100, 100); };
      for (LatticeBall &b : ball) {
        const int64_t x = number(), y = number();
        b = {{x, y, number()}, random.in(100, 300), 0};
      }
      ball[k % 4].radius = 100;
      ball[(k + 1) % 4] = {{ball[k % 4].centre.x + large, 0, 0}, large, 0};
      vertices.add(ball, 15);
    }
    EXPECT_GT(vertices.all(), 100U);
    EXPECT_EQ(vertices.served() > 0, large == 800);
  }
}

struct FreeEnds {
  uint32_t arcs = 0, served = 0, batches = 0;
};

void compare_free_ends(const oracle::Balls &balls, FreeEnds &seen) {
  BuiltBoundary built(balls);
  for (uint32_t i = 0; i < built.balls().n; ++i) {
    const double r = built.balls().r[i];
    hsp::ArcBatches arcs(built.balls(), built.boundary(), i);
    hsp::ArcProducts products;
    arcs.batch().products = &products;
    while (arcs.next()) {
      const hsp::ArcBatch &batch = arcs.batch();
      ++seen.batches;
      double first[hsp::ArcBatch::room], cosines = 0.0;
      const bool all_served = hsp::measure_free_ends(hsp::Target::baseline, batch, r, first, cosines);
      EXPECT_EQ(cosines, hsp::sum_areas(hsp::Target::baseline, batch, r).cosines);
      bool any_unserved = false;
      for (uint32_t s = 0; s < batch.count; ++s) {
        any_unserved = any_unserved || first[s] != first[s];
        if (batch.arc[s] == 0) {
          EXPECT_EQ(first[s], 0.0);
          continue;
        }
        ++seen.arcs;
        if (first[s] != first[s]) continue;
        ++seen.served;
        EXPECT_LE(std::fmax(r, batch.other_radius[s]), 8 * std::fmin(r, batch.other_radius[s]));
        const hsp::Vec3 v = built.balls().difference(i, batch.other[s]);
        EXPECT_NEAR(first[s], hsp::free_ends_in_integers(built.balls(), i, batch, s),
                    most_error * r * r * std::sqrt(dot(v, v)));
      }
      EXPECT_EQ(all_served, !any_unserved);
      for (const hsp::Target target : runnable_targets()) {
        double found[hsp::ArcBatch::room], same = 0.0;
        EXPECT_EQ(hsp::measure_free_ends(target, batch, r, found, same), all_served);
        EXPECT_EQ(same, cosines);
        for (uint32_t s = 0; s < batch.count; ++s) {
          EXPECT_TRUE(found[s] == first[s] || (found[s] != found[s] && first[s] != first[s]));
        }
      }
    }
  }
}

TEST(FreeEnds, OfBallsOfEveryKind) {
  oracle::RandomSource random(54);
  FreeEnds seen;
  for (int k = 0; k < 200; ++k) {
    const size_t n = static_cast<size_t>(random.in(3, 40));
    compare_free_ends(k % 3 == 0   ? oracle::dense_balls(random, n)
                      : k % 3 == 1 ? oracle::any_balls(random, n)
                                   : oracle::degenerate_balls(random, n),
                      seen);
  }
  EXPECT_GT(seen.arcs, 3000U);
  EXPECT_GT(seen.served, seen.arcs / 10 * 9);
}

// More arcs on one ball than a batch has room for.
TEST(FreeEnds, OfManyBatches) {
  oracle::RandomSource random(55);
  FreeEnds seen;
  for (int k = 0; k < 4; ++k) {
    oracle::Balls balls;
    balls.push_back({0, 0, 0, 100000});
    for (int i = 0; i < 400; ++i) {
      const auto number = [&] { return static_cast<double>(random.in(-1000, 1000)); };
      const double x = number(), y = number(), z = number();
      const double scale = 100000 / std::sqrt(x * x + y * y + z * z + 1);
      balls.push_back({static_cast<int64_t>(scale * x), static_cast<int64_t>(scale * y),
                       static_cast<int64_t>(scale * z), random.in(12500, 18000)});
    }
    compare_free_ends(balls, seen);
  }
  EXPECT_GT(seen.batches, 1500U);
  EXPECT_GT(seen.served, 4000U);
}

}  // namespace
