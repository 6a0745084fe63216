// Which caps stay, of any number of them: all that is found with these alone is what is found with all.
#include "sphere/exposed_caps.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "built_grid.hpp"
#include "indexed_search.hpp"
#include "lattice_lengths.hpp"
#include "model/block_sweep.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"
#include "sphere/cap_clusters.hpp"
#include "sphere/float_caps.hpp"
#include "sphere/vertex_finder.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::RandomSource;

// The search on the caps of one ball, as if it came before all others.
class Search {
 public:
  explicit Search(uint32_t capacity) {
    memory_of_caps_.carve(caps_, capacity);
    memory_of_finder_.carve(finder_, capacity);
    memory_of_clusters_.carve(clusters_, capacity);
    order_.resize(capacity);
    state_.resize(capacity);
    vertices_.resize(6 * size_t{capacity} * capacity + 16);
    circles_.resize(capacity + 1);
  }

  // The caps of all others, or of later ones as the boundary has them.
  void gather(const hsp::CubeGrid &grid, uint32_t ball, hsp::Target target, bool all) {
    hsp::BlockSweep sweep(grid);
    caps_.target = target;
    caps_.gather(grid.balls(), sweep.block_around_ball(ball), ball, nullptr);
    if (all) caps_.first_later = 0;
  }
  const hsp::Caps &caps() const { return caps_; }

  // All that is found of the free part, as text. may_cull: with caps that matter alone, where it takes long.
  std::string found(const hsp::BallSet &balls, bool may_cull = false) {
    hsp::FixedVector<hsp::VertexRecord> vertices(
        hsp::Span<hsp::VertexRecord>(vertices_.data(), static_cast<uint32_t>(vertices_.size())));
    hsp::FixedVector<hsp::CircleRecord> circles(
        hsp::Span<hsp::CircleRecord>(circles_.data(), static_cast<uint32_t>(circles_.size())));
    vertices.push({});  // of another ball
    if (may_cull) {
      finder_.cull_and_find(balls, caps_, vertices, circles);
    } else {
      finder_.find(balls, caps_, vertices, circles);
    }
    std::string text = text_of(vertices.items().part(1, vertices.size()), circles.items());
    if (!text.empty()) text += std::to_string(clusters_.find(caps_)) + " clusters";
    return text;
  }
  // Keeps the exposed ones, found with floats besides or without, and with integers where so many are in doubt. False
  // if nothing is free.
  bool keep_exposed(bool with_floats, uint32_t fewest_ties) {
    std::vector<float> floats[4];
    const auto array = [&](size_t which, const hsp::Span<double> &from, float behind) {
      for (uint32_t k = 0; k < caps_.count; ++k) floats[which].push_back(static_cast<float>(from[k]));
      floats[which].resize(caps_.count + hsp::FloatCaps::spare, behind);
      return floats[which].data();
    };
    const hsp::FloatCaps in_floats{array(0, caps_.ux, 0.0F), array(1, caps_.uy, 0.0F), array(2, caps_.uz, 0.0F),
                                   array(3, caps_.b, 4.0F)};
    hsp::ExposedCaps exposed({order_.data(), static_cast<uint32_t>(order_.size())},
                             {state_.data(), static_cast<uint32_t>(state_.size())});
    exposed.fewest_ties = fewest_ties;
    if (!exposed.find(hsp::ExposedCaps::Part::sphere, caps_, with_floats ? &in_floats : nullptr)) return false;
    caps_.keep(exposed.kept());
    return true;
  }

 private:
  CarvedMemory memory_of_caps_, memory_of_finder_, memory_of_clusters_;
  hsp::Caps caps_;
  hsp::VertexFinder finder_;
  hsp::CapClusters clusters_;
  std::vector<uint32_t> order_;
  std::vector<uint8_t> state_;
  std::vector<hsp::VertexRecord> vertices_;
  std::vector<hsp::CircleRecord> circles_;
};

struct Counts {
  int balls = 0, buried = 0, dropped = 0, kept = 0;
};

// One ball after the other.
void expect_same_finds(const support::BallList &balls, Counts &counts) {
  const BuiltGrid built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const uint32_t n = balls.size();
  Search search(n);
  for (const hsp::Target target : runnable_targets()) {
    for (uint32_t i = 0; i < n; ++i) {
      search.gather(built.grid(), i, target, true);
      if (search.caps().contained || search.caps().count == 0 || !(built.grid().balls().r[i] > 0)) continue;
      const uint32_t all = search.caps().count;
      for (const bool of_all : {true, false}) {
        search.gather(built.grid(), i, target, of_all);
        const std::string expected = search.found(built.grid().balls());
        for (const bool with_floats : {false, hsp::has_lanes}) {
          for (const uint32_t fewest_ties : {hsp::ExposedCaps::fewest, 1U}) {
            search.gather(built.grid(), i, target, of_all);
            const bool some = search.keep_exposed(with_floats, fewest_ties);
            EXPECT_EQ(some ? search.found(built.grid().balls()) : "", expected) << "ball " << i;
            ++counts.balls;
            counts.buried += some ? 0 : 1;
            if (some) counts.dropped += static_cast<int>(all - search.caps().count);
            if (some) counts.kept += static_cast<int>(search.caps().count);
          }
        }
      }
    }
  }
}

struct Kind {
  const char *name;
  oracle::Balls (*make)(RandomSource &, size_t);
  int64_t most;
};

void PrintTo(const Kind &kind, std::ostream *out) {
  *out << kind.name;
}

class ExposedCaps : public testing::TestWithParam<Kind> {};

TEST_P(ExposedCaps, FindWhatAllFind) {
  RandomSource random(31);
  Counts counts;
  for (int k = 0; k < oracle::rounds(40, 800); ++k) {
    const oracle::Balls balls = GetParam().make(random, static_cast<size_t>(random.in(2, GetParam().most)));
    expect_same_finds(oracle::in_lengths(balls, 1), counts);
  }
  EXPECT_GT(counts.balls, 100);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ExposedCaps,
    testing::Values(Kind{"loose", oracle::loose_balls, 40}, Kind{"dense", oracle::dense_balls, 40},
                    Kind{"clustered", oracle::clustered_balls, 40}, Kind{"belted", oracle::belted_balls, 30},
                    Kind{"grid", oracle::grid_balls, 30}, Kind{"coplanar", oracle::coplanar_balls, 30},
                    Kind{"collinear", oracle::collinear_balls, 20},
                    Kind{"through_point", oracle::balls_through_point, 20},
                    Kind{"through_circle", oracle::balls_through_circle, 20},
                    Kind{"around_circle", oracle::balls_around_circle, 40},
                    Kind{"around_sphere", oracle::balls_around_sphere, 60}, Kind{"tangent", oracle::tangent_balls, 30},
                    Kind{"lattice", oracle::lattice_balls, 30}, Kind{"repeated", oracle::repeated_balls, 30},
                    Kind{"crowned", oracle::crowned_balls, 34}, Kind{"mixed", oracle::degenerate_balls, 30}),
    [](const auto &kind) { return std::string(kind.param.name); });

// Models of one molecule: most balls are buried by a few others, and of the rest most caps go.
TEST(ExposedCapsOfCopies, AreFew) {
  RandomSource random(7);
  for (const int64_t jitter : {0, 1, 30, 3000}) {
    Counts counts;
    support::BallList balls;
    int64_t place[12][3];
    for (auto &p : place) {
      for (int64_t &x : p) x = random.in(-20000, 20000);
    }
    for (int copy = 0; copy < 14; ++copy) {
      for (const auto &p : place) {
        const auto at = [&](int axis) { return static_cast<double>(p[axis] + random.in(-jitter, jitter)); };
        const double x = at(0), y = at(1), z = at(2);
        balls.add(x, y, z, 16000);
      }
    }
    expect_same_finds(balls, counts);
    EXPECT_GT(counts.buried, jitter == 3000 ? counts.balls / 4 : -1);
    EXPECT_GT(counts.dropped, jitter != 1 ? counts.kept : -1);
  }
}

// So many caps that floats order a sample of them alone.
TEST(ExposedCapsOfCopies, AreFewOfManyCopies) {
  if (!hsp::has_lanes) GTEST_SKIP();
  RandomSource random(9);
  support::BallList balls;
  for (int copy = 0; copy < 200; ++copy) {
    for (const int place : {-12000, 0, 12000}) {
      const auto at = [&](int x) { return static_cast<double>(x + random.in(-3000, 3000)); };
      const double x = at(place), y = at(0), z = at(0);
      balls.add(x, y, z, 16000);
    }
  }
  const BuiltGrid built(balls);
  Search search(balls.size());
  uint32_t compared = 0;
  for (uint32_t i = 0; i < balls.size(); i += 7) {
    const auto gather = [&] { search.gather(built.grid(), i, runnable_targets().back(), true); };
    gather();
    if (search.caps().contained) continue;
    EXPECT_GT(search.caps().count, 512U);
    const std::string expected = search.found(built.grid().balls());
    gather();
    const bool some = search.keep_exposed(true, hsp::ExposedCaps::fewest);
    EXPECT_EQ(some ? search.found(built.grid().balls()) : "", expected) << "ball " << i;
    compared += some ? 1U : 0U;
  }
  EXPECT_GT(compared, 10U);
}

// Planes that nearly agree, of which doubles alone decide by the better formula: pair by pair that takes longer.
TEST(ExposedCapsOfCopies, AreKeptWhereEachPairTakesLong) {
  RandomSource random(10);
  support::BallList balls;
  for (int copy = 0; copy < 120; ++copy) {
    const auto at = [&](int x) { return static_cast<double>(x + random.in(-2000, 2000)); };
    const double x = at(900000), y = at(300000), z = at(0);
    balls.add(x, y, z, 1000000);
  }
  balls.add(0, 0, 0, 1000001);
  const BuiltGrid built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  Search search(balls.size());
  uint32_t compared = 0;
  for (uint32_t i = 0; i < balls.size(); ++i) {
    if (built.grid().balls().r[i] != 1000001) continue;
    const auto gather = [&] { search.gather(built.grid(), i, runnable_targets().back(), true); };
    gather();
    EXPECT_EQ(search.caps().count, 120U);
    const std::string expected = search.found(built.grid().balls());
    gather();
    EXPECT_EQ(search.found(built.grid().balls(), true), expected);
    EXPECT_LT(search.caps().count, 60U);
    ++compared;
  }
  EXPECT_EQ(compared, 1U);
}

// All spheres go through one point, radii are of one size or not, and centres in one plane or not: caps that meet the
// cell in that point alone go, but one that shows the tie.
TEST(ExposedCapsThroughOnePoint, AreFew) {
  struct Family {
    int64_t size;
    bool in_plane;
  };
  for (const auto &[size, in_plane] : {Family{0, false}, Family{135135, false}, Family{0, true}}) {
    RandomSource random(8);
    support::BallList balls;
    while (balls.size() < 120) {
      const int64_t across = in_plane ? 0 : 9;
      const int64_t m = random.in(-9, 9), n = random.in(-across, across), p = random.in(-across, across),
                    q = random.in(-9, 9);
      const int64_t radius = m * m + n * n + p * p + q * q;
      if (radius == 0 || (size > 0 && size % radius != 0)) continue;
      const int64_t scale = size > 0 ? size / radius : 1;
      const auto length = [scale](int64_t x) { return static_cast<double>(scale * x); };
      balls.add(length(m * m + n * n - p * p - q * q), length(2 * (m * q + n * p)), length(2 * (n * q - m * p)),
                length(radius));
    }
    const BuiltGrid built(balls);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    Search search(balls.size());
    uint32_t all = 0, kept[2] = {0, 0};
    for (uint32_t i = 0; i < balls.size(); ++i) {
      for (const uint32_t by_integers : {0U, 1U}) {
        search.gather(built.grid(), i, runnable_targets().front(), true);
        if (search.caps().contained) continue;
        all += search.caps().count;
        if (search.keep_exposed(false, by_integers == 0 ? UINT32_MAX : 1)) kept[by_integers] += search.caps().count;
      }
      const auto gather = [&] { search.gather(built.grid(), i, runnable_targets().front(), true); };
      gather();
      const std::string expected = search.caps().contained ? "" : search.found(built.grid().balls());
      gather();
      if (expected.empty()) continue;
      EXPECT_EQ(search.found(built.grid().balls(), true), expected);
      EXPECT_LT(search.caps().count, 60U);
    }
    EXPECT_GT(3 * kept[0], all / 2);
    EXPECT_LT(6 * kept[1], kept[0]) << kept[0] << " of " << all / 2;
  }
}

// Balls of one radius around points of a sphere: all planes go through its centre. Where that is not on the balls'
// spheres, only caps that meet the rest of the cell stay.
TEST(ExposedCapsAroundASphere, AreFew) {
  RandomSource random(3);
  int sphere_sizes = 0;
  for (int k = 0; k < 40; ++k) {
    const oracle::Balls some = oracle::balls_around_sphere(random, 120);
    const BuiltGrid built(oracle::in_lengths(some, 1));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    if (some.front().radius == 21) continue;
    ++sphere_sizes;
    Search search(static_cast<uint32_t>(some.size()));
    for (uint32_t i = 0; i < some.size(); i += 10) {
      search.gather(built.grid(), i, runnable_targets().front(), true);
      if (search.caps().contained || search.caps().count < 50) continue;
      const std::string expected = search.found(built.grid().balls());
      search.gather(built.grid(), i, runnable_targets().front(), true);
      EXPECT_TRUE(search.keep_exposed(false, 1));
      EXPECT_EQ(search.found(built.grid().balls()), expected);
      EXPECT_LT(search.caps().count, 25U);
    }
  }
  EXPECT_GT(sphere_sizes, 20);
}

}  // namespace
