#include "packing_statistics_cases.hpp"

#include <algorithm>
#include <vector>

#include "built_grid.hpp"
#include "expect_cases.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"

namespace {

TEST(PackingStatistics, Cases) {
  expect_cases(cases::model_packing_statistics);
}

void expect_those_of_all_pairs(const oracle::Balls &balls) {
  double rho = std::numeric_limits<double>::infinity();
  std::vector<uint32_t> overlaps(balls.size());
  for (size_t i = 0; i < balls.size(); ++i) {
    for (size_t j = i + 1; j < balls.size(); ++j) {
      const auto squared = [](int64_t d) { return static_cast<double>(d) * static_cast<double>(d); };
      const double distance_squared = squared(balls[i].x - balls[j].x) + squared(balls[i].y - balls[j].y) +
                                      squared(balls[i].z - balls[j].z);  // exact, as are those below
      const auto larger = static_cast<double>(std::max(balls[i].radius, balls[j].radius));
      if (larger > 0.0) rho = std::min(rho, std::sqrt(distance_squared) / larger);
      if (distance_squared >= squared(balls[i].radius + balls[j].radius)) continue;
      ++overlaps[i];
      ++overlaps[j];
    }
  }
  uint64_t sum = 0;
  for (const uint32_t each : overlaps) sum += each;
  BuiltGrid built(oracle::in_lengths(balls, 1));
  ASSERT_NE(built.grid().levels(), nullptr);
  for (int with_levels = 1; with_levels >= 0; --with_levels) {
    if (with_levels == 0) built.grid().use_no_levels();
    const hsp::PackingStatistics found = hsp::packing_statistics(built.grid());
    EXPECT_EQ(found.rho, rho);
    EXPECT_EQ(found.coincident, rho == 0.0);
    EXPECT_FALSE(found.no_pair);
    EXPECT_EQ(found.max_overlaps, *std::max_element(overlaps.begin(), overlaps.end()));
    EXPECT_EQ(found.mean_overlaps, static_cast<double>(sum) / static_cast<double>(balls.size()));
  }
}

// Sets for which cubes are wide: of balls that overlap, of such that keep apart by so many radii that all is looked at,
// of points, of copies, of studs.
TEST(PackingStatistics, OfVeryUnequalRadiiAreThoseOfAllPairs) {
  oracle::RandomSource random(91);
  const auto with_large = [&random](oracle::Balls balls, size_t large) {
    for (; large > 0; --large) balls.push_back(oracle::ball_in_box(random, 30000, 12000, 15000));
    return balls;
  };
  for (const auto &[least, most] : {std::pair{500, 1500}, std::pair{20, 60}, std::pair{0, 0}, std::pair{1, 1}}) {
    expect_those_of_all_pairs(with_large(oracle::balls_in_box(random, 1500, 30000, least, most), 3));
  }
  for (const int64_t radius : {1000, 900, 200, 20, 1}) {
    oracle::Balls apart;
    for (int64_t k = 0; k < 1728; ++k) {
      apart.push_back({k % 12 * 2000, k / 12 % 12 * 2000, k / 144 * 2000 + random.in(0, 9), radius});
    }
    apart.push_back({12000, 12000, 12000, 9000});
    expect_those_of_all_pairs(apart);
    apart.back() = {12000, 12000, 100000, 75000};  // meets none
    expect_those_of_all_pairs(apart);
  }
  oracle::Balls far;
  for (int64_t k = 0; k < 1728; ++k)
    far.push_back({k % 12 * 100, k / 12 % 12 * 100, k / 144 * 100 + random.in(0, 9), 1});
  far.push_back({400000, 0, 0, 2000});
  expect_those_of_all_pairs(far);
  oracle::Balls copies = with_large(oracle::balls_in_box(random, 1200, 30000, 500, 1500), 2);
  copies.push_back(copies[17]);
  expect_those_of_all_pairs(copies);
  expect_those_of_all_pairs(oracle::studded_ball(random, 1500, {5, 7, -9}, 100000, 300, 2000));
}

}  // namespace
