// Whole maps against the z-buffer: no pixel differs, and areas are those of the pixels.
#include "maps/map_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "built_map.hpp"
#include "degenerate_set.hpp"
#include "maps/map_check.hpp"
#include "molecule_balls.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"
#include "sweep_length.hpp"
#include "touching_balls.hpp"

namespace {

using oracle::Balls;

constexpr Direction along_z{0, 0, 1};
constexpr Direction directions[] = {along_z, {0, 1, 0}, {1, 1, 1}, {0.37, -0.61, 0.83}};

std::string broken_invariant(BuiltMap &built) {
  const hsp::MapViolation violation = hsp::check_map(built.map(), built.builder().scratch());
  if (violation.invariant == hsp::MapInvariant::none) return "";
  return "invariant " + std::to_string(static_cast<int>(violation.invariant)) + " at " + std::to_string(violation.id);
}

// Empty, or what is wrong with the map of these balls.
std::string complaint(const Balls &balls, const Direction &towards, size_t pixels) {
  BuiltMap built(balls, towards);
  const std::string difference = map_disagrees(built, pixels);
  return difference.empty() ? broken_invariant(built) : difference;
}

class MapOfMolecule : public testing::TestWithParam<const char *> {};

TEST_P(MapOfMolecule, ShowsWhatIsVisible) {
  const Balls atoms = read_molecule(support::own_molecule(GetParam()));
  for (const int64_t probe : {0, 1400})
    for (const Direction &towards : directions)
      EXPECT_EQ(complaint(oracle::grown(atoms, probe), towards, 400), "") << "probe " << probe;
}

// Files with three decimals: no ties but those of equal depths, so that nothing is moved.
TEST_P(MapOfMolecule, NeedsNoPerturbation) {
  const Balls atoms = read_molecule(support::own_molecule(GetParam()));
  for (const Direction &towards : directions) EXPECT_EQ(BuiltMap(atoms, towards).map().perturbation, 0);
}

INSTANTIATE_TEST_SUITE_P(Bench, MapOfMolecule, testing::ValuesIn(oracle::some_of(support::bench_molecules())));

TEST(MapBuilder, ShowsRandomSets) {
  oracle::RandomSource random(15);
  for (int time = 0; time < 60; ++time) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(1, 60)));
    for (const Direction &towards : directions) ASSERT_EQ(complaint(balls, towards, 100), "") << oracle::to_text(balls);
  }
  for (int time = 0; time < 4; ++time) EXPECT_EQ(complaint(oracle::loose_balls(random, 2000), directions[3], 400), "");
}

// Most of their balls are covered by others.
TEST(MapBuilder, ShowsModelsOfOneMolecule) {
  oracle::RandomSource random(16);
  for (const int64_t most : {0, 3, 300}) {
    const Balls atoms = oracle::grown(oracle::loose_balls(random, 12), 100);
    const Balls balls = oracle::as_models(atoms, 80, most, random);
    for (const Direction &towards : directions) EXPECT_EQ(complaint(balls, towards, 200), "") << most;
  }
}

// Balls on lines along the direction, whose discs agree: they are moved, and creases that others covered are seen.
TEST(MapBuilder, ShowsManyBallsOneBehindTheOther) {
  oracle::RandomSource random(19);
  for (int time = 0; time < 4; ++time) {
    Balls balls;
    for (int64_t line = 0; line < 2; ++line)
      for (int ball = 0; ball < 90; ++ball) balls.push_back({line * 600'000, 0, random.in(-400, 400), 536'433});
    EXPECT_EQ(complaint(balls, along_z, 100), "");
    EXPECT_GT(BuiltMap(balls, along_z).map().perturbation, 0);
  }
}

TEST(MapBuilder, ShowsLatticesAlongTheirAxes) {
  for (const int64_t radius : {1, 2, 3, 4})
    for (const Direction &towards : directions) {
      EXPECT_EQ(complaint(oracle::box_lattice({4, 4, 4}, {4, 4, 4}, radius), towards, 200), "") << radius;
      EXPECT_EQ(complaint(oracle::chosen_points(5, 2, radius, oracle::is_face_centred), towards, 200), "") << radius;
    }
  for (const Direction &towards : directions)
    EXPECT_EQ(complaint(oracle::slanted_lattice({3, 3, 3}, {2, 2, 2}, 9), towards, 200), "");
}

TEST(MapBuilder, ShowsDegenerateSets) {
  for (const degenerate::DegenerateSet &set : degenerate::read_sets(HSP_DEGENERATE_SETS)) {
    if (set.balls.size() > 300) continue;
    for (const Direction &towards : {along_z, directions[2], directions[3]})
      EXPECT_EQ(complaint(set.balls, towards, 100), "") << set.name;
  }
}

TEST(MapBuilder, ShowsSmallSets) {
  const Balls sets[] = {
      {{0, 0, 0, 5}, {20, 3, 1, 4}},
      {{0, 0, 0, 5}, {6, 0, 0, 5}},   // at the same depth
      {{0, 0, 0, 5}, {0, 0, 4, 4}},   // straight behind the other
      {{0, 0, 0, 5}, {0, 0, 6, 5}},   // equal discs
      {{0, 0, 0, 5}, {0, 0, 3, 4}},   // the silhouette of one lies on the other's sphere
      {{0, 0, 0, 5}, {6, 8, 0, 5}},   // touching
      {{0, 0, 0, 9}, {2, 4, 4, 3}},   // touching from inside
      {{0, 0, 0, 9}, {6, 0, 30, 3}},  // discs that touch from inside
      {{0, 0, 0, 9}, {6, 0, 30, 3}, {20, 1, 0, 4}},
      {{0, 0, 0, 9}, {0, 6, 30, 3}},
      {{0, 0, 0, 5}, {10, 0, 30, 5}, {5, 12, 70, 8}},
      {{0, 0, 0, 5}, {0, 0, 0, 5}, {4, 0, 0, 3}},
      {{0, 0, 0, 20}, {20, 0, 1, 4}},   // a bump on the silhouette
      {{0, 0, 0, 20}, {3, 2, 19, 4}},   // on the near side
      {{0, 0, 0, 20}, {3, 2, -19, 4}},  // on the far side
      {{0, 0, 0, 5}, {6, 0, 0, 5}, {3, 4, 0, 5}},
      {{1, 1, 1, 1}, {-2, 1, -1, 2}, {0, 1, -1, 2}, {-2, -2, 0, 1}, {-2, -1, 0, 1}},
  };
  for (const Balls &balls : sets)
    for (const Balls &set : oracle::axis_symmetries(balls))
      ASSERT_EQ(complaint(set, along_z, 101), "") << oracle::to_text(set);
}

// Eight unit balls on the lattice, of which silhouettes tie: labels agreed about a loop of a ball that is not there.
TEST(MapBuilder, AsksForFrontsWhereLabelsAgree) {
  Balls balls = {{-2, -1, 2, 1}, {-1, 0, 0, 1}, {-1, -1, -1, 1}, {-3, -2, 0, 1},
                 {-3, -1, 1, 1}, {0, 3, -3, 1}, {2, -2, -3, 1},  {-1, -2, 1, 1}};
  constexpr int64_t steps = 1'000'000'000;
  for (oracle::LatticeBall &ball : balls) ball = {ball.x * steps, ball.y * steps, ball.z * steps, ball.radius * steps};
  EXPECT_EQ(complaint(balls, {-2, -2, 1}, 200), "");
}

// Two balls that touch from outside, seen across the line of their centres: two discs that touch in a point.
TEST(MapBuilder, ShowsBallsThatTouch) {
  const SeenSet sets[] = {
      {{{0, 2, 2, 1}, {0, 0, 2, 1}}, {1, 0, 1}},    {{{0, 0, 0, 4}, {0, 5, 0, 1}}, {-1, 0, 1}},
      {{{5, 5, 0, 2}, {5, 10, 0, 3}}, {-1, 0, -1}}, {{{0, 2, 2, 1}, {0, 0, 2, 1}}, {0, 0, 1}},
      {{{0, 2, 2, 1}, {0, 0, 2, 1}}, {1, 0, 0}},    {{{0, 2, 2, 1}, {0, 0, 2, 1}}, {5, 0, 3}},
      {{{0, 0, -1, 4}, {6, 6, -4, 5}}, {-1, 1, 0}}, {{{-20, -30, 0, 100}, {-180, -50, 80, 80}}, {-7, 0, -14}},
  };
  for (const SeenSet &set : sets)
    for (const int64_t factor : {1, 10000000, 100000000}) {
      const SeenSet scaled{oracle::scaled(set.balls, factor), set.towards};
      if (largest_radius(scaled.balls) >= 0x1p30) continue;
      EXPECT_EQ(pair_complaint(scaled), "") << to_text(scaled);
      const BuiltMap built(scaled.balls, scaled.towards);
      EXPECT_EQ(built.map().perturbation, 0) << to_text(scaled);
      EXPECT_EQ(built.map().faces.size(), 3U) << to_text(scaled);
      EXPECT_EQ(built.map().owners, 2U) << to_text(scaled);
      EXPECT_NE(built.map().faces[0].first_loop, hsp::no_id) << to_text(scaled);
    }
}

TEST(MapBuilder, ShowsPairsThatTouch) {
  oracle::RandomSource random(81);
  for (int time = 0; time < oracle::sets(4000); ++time) {
    const SeenSet set = touching_pair(random);
    ASSERT_EQ(pair_complaint(set), "") << to_text(set);
  }
}

TEST(MapBuilder, ShowsSetsThatTouchAndMeet) {
  oracle::RandomSource random(82);
  for (int time = 0; time < oracle::sets(400); ++time) {
    const SeenSet set = touching_set(random);
    ASSERT_EQ(set_complaint(set, 40), "") << to_text(set);
  }
}

// Where something touches in several ways at one point, so that roundings decide what labels and counts do not notice.
TEST(MapBuilder, ShowsWhatTouchesInSeveralWays) {
  const SeenSet sets[] = {
      {{{2, 2, 1, 1}, {0, 0, 0, 2}, {2, 2, 2, 2}}, {1, 0, 1}},
      // A disc in another one, and one beside it, that touch at one point.
      {{{0, 0, 0, 6}, {4, -8, -8, 6}, {-2, 16, -8, 12}}, {0, -1, 1}},
      {{{6, 6, 6, 1}, {2, 2, 2, 3}, {0, 0, 0, 4}, {4, 4, 4, 1}}, {1, 0, 1}},
      // Three silhouettes through one point.
      {{{4, -2, -2, 4}, {2, -2, -2, 3}, {-2, 4, 4, 4}, {-4, 2, 2, 4}, {-4, -4, 2, 2}}, {-1, 0, 0}},
      {{{-4, 0, 2, 3}, {-2, 0, -4, 4}, {2, -4, 0, 4}, {0, 4, 4, 4}, {2, 4, 2, 4}}, {0, 0, 1}},
      // A crease that enters a ball at the height of its centre.
      {{{4, 4, 0, 2}, {-4, 0, 0, 1}, {0, -2, 4, 1}, {-2, -4, 0, 4}, {-2, 0, 2, 3}}, {-1, 0, -1}},
      // Spheres that touch at a silhouette, where a crease begins.
      {{{-2, -2, 2, 3}, {0, -2, 2, 3}, {0, 0, 0, 4}, {2, 4, -4, 1}, {2, 0, 0, 1}, {-2, -4, 4, 1}}, {0, -1, 1}},
      // A small ball in a large one, on its surface.
      {{{1, 2, 1, 67}, {55, 38, 13, 1}}, {2, 2, 2}},
      // A ball in another one that touches it at the highest point.
      {{{0, 0, 0, 10}, {-1, 2, -2, 7}, {-6, -4, -12, 4}, {-4, -2, -4, 3}, {-12, -6, -4, 4}}, {-1, 2, -2}},
      // A silhouette that is a crease.
      {{{-2, 4, -2, 1}, {-2, 0, 4, 3}, {4, 4, 0, 4}, {-2, 2, 0, 3}}, {0, 1, -1}},
  };
  for (const SeenSet &set : sets)
    for (const int64_t factor : {1, 5000000, 50000000}) {
      const SeenSet scaled{oracle::scaled(set.balls, factor), set.towards};
      if (largest_radius(scaled.balls) >= 0x1p30) continue;
      EXPECT_EQ(set_complaint(scaled, 200), "") << to_text(scaled);
    }
}

// Balls that nearly coincide, farther apart than roundings: each shows its part.
TEST(MapBuilder, ShowsBallsThatNearlyCoincide) {
  const BuiltMap built({{100000000, 40, -100000000, 200000000}, {100000000, -40, -99999960, 200000000}}, {1, 0, 0});
  ASSERT_EQ(built.status(), hsp::Status::ok);
  EXPECT_EQ(built.map().perturbation, 0);
  EXPECT_EQ(built.map().owners, 2U);
  for (const double area : seen_areas(built, 2)) EXPECT_NEAR(area, 0.5 * std::numbers::pi * 4e16, 1e-6 * 4e16);
}

// Two of three balls nearly coincide, so that little says where their crease is: edges ended beside their vertices.
TEST(MapBuilder, ShowsEdgesThatEndAtTheirVertices) {
  EXPECT_EQ(complaint({{141421365, 141421350, 150000009, 200000003},
                       {141421365, -141421362, 150000009, 200000000},
                       {141421365, 141421347, 150000006, 200000003}},
                      {1, 1, 1}, 100),
            "");
}

// Rows across rows: the map is quadratic in the number of rows.
TEST(MapBuilder, ShowsCrossingRows) {
  Balls rows;
  for (int64_t a = 0; a < 12; ++a)
    for (int64_t b = 0; b < 20; ++b) {
      rows.push_back({1500 * a + 11 * b, 900 * b + 3 * a, 10000 + a, 600});
      rows.push_back({900 * b + 13 * a, 1500 * a + 7 * b, a + b, 600});
    }
  EXPECT_EQ(complaint(rows, along_z, 400), "");
}

// Far from the origin and of any size.
TEST(MapBuilder, ShowsSetsOfAnySize) {
  oracle::RandomSource random(16);
  const Balls balls = oracle::loose_balls(random, 80);
  EXPECT_EQ(complaint(oracle::moved(balls, {1LL << 49, -(1LL << 48), 12345}), directions[3], 150), "");
  Balls large = balls;
  for (oracle::LatticeBall &ball : large)
    ball = {ball.x * (1 << 22), ball.y * (1 << 22), ball.z * (1 << 22), ball.radius * (1 << 22)};
  EXPECT_EQ(complaint(large, directions[3], 150), "");
}

// The map names what it had to move, and the order of the balls has no effect.
TEST(MapBuilder, DoesNotDependOnTheOrderOfTheBalls) {
  oracle::RandomSource random(17);
  int moved = 0;
  for (int time = 0; time < 30; ++time) {
    const Balls balls = oracle::any_balls(random, 40);
    const std::vector<uint32_t> order = random.permutation(balls.size());
    const BuiltMap one(balls), two(oracle::permuted(balls, order));
    ASSERT_EQ(one.status(), hsp::Status::ok);
    ASSERT_EQ(one.map().perturbation, two.map().perturbation);
    moved += one.map().perturbation > 0;
    ASSERT_EQ(one.map().edges.size(), two.map().edges.size());
    for (uint32_t e = 0; e < one.map().edges.size(); ++e) {
      ASSERT_EQ(one.map().edges[e].from, two.map().edges[e].from);
      ASSERT_EQ(one.map().half_edges[2 * e].next, two.map().half_edges[2 * e].next);
    }
    ASSERT_EQ(one.map().faces.size(), two.map().faces.size());
    for (uint32_t f = 0; f < one.map().faces.size(); ++f) ASSERT_EQ(one.map().faces[f].area, two.map().faces[f].area);
  }
  EXPECT_GT(moved, 2);
}

TEST(MapBuilder, TellsTheLimitsThatSuffice) {
  oracle::RandomSource random(18);
  for (int time = 0; time < 20; ++time) {
    const Balls balls = oracle::loose_balls(random, 60);
    BuiltMap built(balls, directions[3]);
    const hsp::MapLimits needed = built.builder().needed();
    const auto build_with = [&](const hsp::MapLimits &limits) {
      built.take(limits);
      return built.builder().build(built.grid(), {{0.37, -0.61, 0.83}, {0, 1, 0}});
    };
    ASSERT_EQ(needed.edges, built.map().edges.size());
    EXPECT_EQ(build_with(needed), hsp::Status::ok);
    for (const auto limit : {&hsp::MapLimits::balls, &hsp::MapLimits::neighbours, &hsp::MapLimits::edges}) {
      hsp::MapLimits less = needed;
      --(less.*limit);
      EXPECT_EQ(build_with(less), hsp::Status::capacity);
      EXPECT_EQ(built.builder().retry_limits().*limit, needed.*limit);
    }
    EXPECT_EQ(build_with({60, 0, 0}), hsp::Status::capacity);
    EXPECT_EQ(build_with(built.builder().retry_limits()), hsp::Status::capacity);
    EXPECT_EQ(build_with(built.builder().retry_limits()), hsp::Status::ok);
  }
}

// A large ball has a crease that ties at the height of a third ball, inside a fourth. Some 200 balls are before it, and
// as many studs behind: how many of its caps are looked at together decides whether it is known that the crease is
// covered, and that must not follow from memory that is more than enough.
TEST(MapBuilder, IsTheSameWithAllLimitsThatSuffice) {
  oracle::RandomSource random(20);
  Balls balls = {{0, 0, 0, 5'000'000},
                 {4'000'000, 2'000'000, 2'000'000, 3'000'000},
                 {3'000'000, -1'500'000, 4'000'000, 1'500'000},
                 {2'857'738, 1'428'869, 1'428'869, 3'150'000}};
  const auto within = [&random](int64_t most) { return random.in(-most, most); };
  for (int ball = 0; ball < 180; ++ball)
    balls.push_back({within(4'000'000), within(4'000'000), 8'000'000 + within(1'000'000), 50'000});
  while (balls.size() < 400) {
    const double x = static_cast<double>(within(1000)), y = static_cast<double>(within(1000));
    const double z = static_cast<double>(random.in(-1000, -100)), part = 5e6 / std::sqrt(x * x + y * y + z * z);
    if (z * part > -500'000) continue;
    balls.push_back({std::llround(x * part), std::llround(y * part), std::llround(z * part), 50'000});
  }
  BuiltMap built(balls);
  const hsp::MapLimits exact = built.builder().needed();
  ASSERT_LT(exact.neighbours, 200U);
  for (const uint32_t neighbours : {exact.neighbours, 256U, 10'000U}) {
    built.take({exact.balls, neighbours, exact.edges});
    ASSERT_EQ(built.builder().build(built.grid(), {{0, 0, 1}, {0, 1, 0}}), hsp::Status::ok);
    EXPECT_GT(built.map().perturbation, 0) << neighbours;
  }
}

// A few lattice steps apart, many of them inside others until they are moved: only then they are found to be covered,
// and the least move suffices all the same.
TEST(MapBuilder, LeavesOutTheSameBallsEverywhere) {
  oracle::RandomSource random(21);
  int farther = 0;
  for (int time = 0; time < 30; ++time) {
    Balls balls(350);
    for (oracle::LatticeBall &ball : balls)
      ball = {random.in(-3, 3), random.in(0, 6), random.in(0, 6), 100'000'000 + random.in(0, 2)};
    const BuiltMap built(balls);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    farther += built.map().perturbation > 0x1p-19 * 1e8;
  }
  EXPECT_LT(farther, 6);
}

TEST(MapBuilder, RefusesDirectionsThatAreNone) {
  BuiltMap built({{0, 0, 0, 5}});
  EXPECT_EQ(built.status(), hsp::Status::ok);
  built.look({std::numeric_limits<double>::infinity(), 0, 1});
  EXPECT_EQ(built.status(), hsp::Status::not_finite);
  EXPECT_EQ(built.map().faces.size(), 0U);
}

// Four discs that touch in one point: moved in one way, however far, they leave a loop there that shows nothing for
// certain.
TEST(MapBuilder, MovesBallsInOtherWays) {
  constexpr int64_t r = 1000000000;
  EXPECT_EQ(complaint({{2 * r, r, -2 * r, r}, {3 * r, 2 * r, 3 * r, r}, {2 * r, 3 * r, r, r}, {r, 2 * r, 2 * r, r}},
                      along_z, 200),
            "");
}

}  // namespace
