// Every vertex with its sign, every arc with its ends and faces, every circle, face, shell and component, flags and
// counts, against the brute-force boundary, in several orders of the same balls; half of the sets of each kind, and all
// in the long form.
#include <gtest/gtest.h>

#include "boundary_comparison.hpp"
#include "named_balls.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;
using oracle::RandomSource;

using Maker = Balls (*)(RandomSource &, size_t);

struct Kind {
  const char *name;
  Maker make;
  int sets;
  int64_t fewest;
  int64_t most;
};

void PrintTo(const Kind &kind, std::ostream *out) {
  *out << kind.name;
}

class RandomBoundary : public testing::TestWithParam<Kind> {};

TEST_P(RandomBoundary, IsThatOfBruteForce) {
  const Kind &kind = GetParam();
  RandomSource random(11);
  for (int k = 0; k < oracle::rounds(kind.sets / 2, kind.sets); ++k) {
    const Balls balls = kind.make(random, static_cast<size_t>(random.in(kind.fewest, kind.most)));
    ASSERT_EQ(complaint_about_smallest(balls, boundary_differs(2, static_cast<uint64_t>(k))), "");
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, RandomBoundary,
    testing::Values(
        Kind{"loose", oracle::loose_balls, 500, 2, 25}, Kind{"dense", oracle::dense_balls, 500, 2, 14},
        Kind{"clustered", oracle::clustered_balls, 500, 5, 24}, Kind{"belted", oracle::belted_balls, 500, 6, 30},
        Kind{"grid", oracle::grid_balls, 1500, 2, 11}, Kind{"coplanar", oracle::coplanar_balls, 500, 2, 11},
        Kind{"collinear", oracle::collinear_balls, 500, 2, 9},
        Kind{"through_point", oracle::balls_through_point, 1000, 2, 11},
        Kind{"through_circle", oracle::balls_through_circle, 500, 2, 9},
        Kind{"around_circle", oracle::balls_around_circle, 8, 28, 34},
        Kind{"tangent", oracle::tangent_balls, 1000, 2, 11}, Kind{"lattice", oracle::lattice_balls, 500, 4, 16},
        Kind{"repeated", oracle::repeated_balls, 500, 2, 12}, Kind{"crowned", oracle::crowned_balls, 500, 9, 34},
        Kind{"colliding", oracle::colliding_balls, 8, 200, 300}, Kind{"mixed", oracle::degenerate_balls, 1000, 4, 12}),
    [](const auto &kind) { return std::string(kind.param.name); });

class NamedBoundary : public testing::TestWithParam<oracle::KnownBalls> {};

TEST_P(NamedBoundary, IsThatOfBruteForce) {
  EXPECT_EQ(complaint_about_smallest(GetParam().balls, boundary_differs(4, 12)), "");
}

TEST_P(NamedBoundary, HasTheTopologyBuiltIn) {
  const hsp_boundary_counts counts = LibraryBoundary(GetParam().balls).counts();
  EXPECT_EQ(counts.components, GetParam().components);
  EXPECT_EQ(counts.voids, GetParam().voids);
  if (GetParam().euler) {
    EXPECT_EQ(counts.euler, *GetParam().euler);
  }
}

INSTANTIATE_TEST_SUITE_P(Named, NamedBoundary, testing::ValuesIn(oracle::known_balls()), [](const auto &set) {
  std::string name;
  for (const char c : set.param.name) name += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '_';
  return name;
});

// A systematic sweep: one ball at the origin and two of a small grid around it, all radii up to 2.
TEST(SmallGrid, EveryThreeBallsAreRight) {
  Balls others;
  for (int64_t x = 0; x <= 2; ++x)
    for (int64_t y = 0; y <= x; ++y)
      for (int64_t z = -1; z <= 2; ++z)
        for (int64_t radius = 0; radius <= 2; ++radius) others.push_back({x, y, z, radius});
  for (int64_t radius = 0; radius <= 2; ++radius)
    for (size_t i = 0; i < others.size(); ++i)
      for (size_t j = 0; j <= i; ++j) {
        const Balls balls = {{0, 0, 0, radius}, others[i], others[j]};
        ASSERT_EQ(complaint_about_smallest(balls, boundary_differs(1, 13)), "");
      }
}

// The same structure far from the origin and at every scale of the lattice that the radii allow.
TEST(Placement, ChangesNothing) {
  RandomSource random(14);
  for (int k = 0; k < oracle::sets(300); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 12)));
    const oracle::BoundaryRecord record = oracle::brute_boundary(balls);
    const auto expected = oracle::canonical(record, oracle::tie_ranks(balls));
    const int64_t far = int64_t{1} << random.in(0, 49);
    const int64_t factor = int64_t{1} << random.in(0, 22);
    Balls moved;
    Balls scaled;
    for (const auto &b : balls) {
      moved.push_back({b.x + far, b.y - far, b.z + far / 3, b.radius});
      scaled.push_back({b.x * factor, b.y * factor, b.z * factor, b.radius * factor});
    }
    for (const Balls &other : {moved, scaled}) {
      const auto found = oracle::canonical(LibraryBoundary(other, 0.125).record(), oracle::tie_ranks(other));
      ASSERT_EQ(oracle::differences(found, expected), "") << oracle::to_text(other);
    }
  }
}

}  // namespace
