// Pieces are what the header says: laws of their records, the balls' points that belong to them, their order, areas.
#include <gtest/gtest.h>

#include <ostream>

#include "exact_depth.hpp"
#include "smallest_failing.hpp"
#include "view_laws.hpp"
#include "view_sets.hpp"

namespace {

using oracle::Balls;

using Law = std::string (*)(const Balls &, const Direction &);
struct NamedLaw {
  const char *name;
  Law law;
};
void PrintTo(const NamedLaw &law, std::ostream *stream) {
  *stream << law.name;
}

std::string laws(const Balls &balls, const Direction &towards) {
  return view_laws_broken(balls, towards);
}
std::string orders(const Balls &balls, const Direction &towards) {
  return view_orders_disagree(balls, towards);
}
std::string members(const Balls &balls, const Direction &towards) {
  return members_disagree(balls, 12, towards);
}

void expect_law(Law law, const Balls &balls, const std::vector<Direction> &directions, const std::string &name) {
  for (const Direction &towards : directions)
    ASSERT_EQ(complaint_about_smallest(balls, [&](const Balls &set) { return law(set, towards); }), "") << name;
}

class Pieces : public testing::TestWithParam<NamedLaw> {};

TEST_P(Pieces, OfSmallSetsAndLattices) {
  for (const auto &views : {small_views(), lattice_views()})
    for (const NamedView &view : views) {
      expect_law(GetParam().law, view.balls, even_directions(), view.name);
      expect_law(GetParam().law, view.balls, {uneven_directions()[0], uneven_directions()[2]}, view.name);
    }
}

TEST_P(Pieces, OfDegenerateSets) {
  for (const NamedView &view : degenerate_views(60)) {
    expect_law(GetParam().law, view.balls, {even_directions()[0], even_directions()[4]}, view.name);
    expect_law(GetParam().law, view.balls, {uneven_directions()[0]}, view.name);
  }
}

TEST_P(Pieces, OfRandomSets) {
  oracle::RandomSource random(94);
  for (int k = 0; k < 4; ++k)
    for (const auto make : {oracle::loose_balls, oracle::dense_balls, oracle::clustered_balls, oracle::belted_balls,
                            sparse_balls, mixed_balls, flat_balls})
      expect_law(GetParam().law, make(random, 50), {{0, 0, 1}, uneven_directions()[1]}, "");
}

TEST_P(Pieces, OfRandomDegenerateSets) {
  oracle::RandomSource random(95);
  for (int k = 0; k < 400; ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<std::size_t>(random.in(2, 16)));
    expect_law(GetParam().law, balls, {even_directions()[static_cast<std::size_t>(random.in(0, 4))]}, "");
  }
}

std::string name_of(const testing::TestParamInfo<NamedLaw> &info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(All, Pieces,
                         testing::Values(NamedLaw{"KeepTheLaws", laws}, NamedLaw{"DoNotDependOnTheOrder", orders},
                                         NamedLaw{"HoldTheirPoints", members},
                                         NamedLaw{"HaveEqualBackAreas", opposite_areas_disagree}),
                         name_of);

/// Centres as far apart as the lattice allows, of which pairs differ in depth by a few units of the integer direction
/// or not at all.
TEST(DepthOrder, IsThatOfIntegers) {
  oracle::RandomSource random(96);
  constexpr std::int64_t largest = std::int64_t{1} << 28;
  for (int k = 0; k < 200; ++k) {
    // Of the largest component, so that the direction stays as it is.
    const std::array<std::int64_t, 3> v = {largest, largest - random.in(1, 9), random.in(1, 3)};
    Balls balls;
    for (int pair = 0; pair < 15; ++pair) {
      const oracle::LatticeBall ball = {random.in(-largest, largest) * (largest >> 10),
                                        random.in(-largest, largest) * (largest >> 10), random.in(-50, 50),
                                        random.in(1, 5)};
      balls.push_back(ball);
      const std::int64_t times = random.in(1, 1000);  // along a vector whose product with v is 0
      balls.push_back({ball.x + times * v[1], ball.y - times * v[0], ball.z + random.in(-1, 1), random.in(1, 5)});
    }
    const Direction towards = {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
    ASSERT_EQ(integer_direction(towards), v);
    const LibraryScene scene(balls);
    for (const ViewChoice &choice : all_choices(towards)) {
      const ViewRecords view = view_of(scene, choice);
      ASSERT_EQ(depths_disagree(view, balls, choice), "") << oracle::to_text(balls);
      ASSERT_TRUE((choice.flags & HSP_VIEW_ALL_BALLS) == 0 || view.pieces.size() == balls.size());
    }
  }
}

}  // namespace
