// Painting whole pieces from the farthest to the nearest shows what is visible: no pixel differs from the z-buffer.
#include <gtest/gtest.h>

#include "picture_comparison.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"
#include "view_sets.hpp"

namespace {

using oracle::Balls;

void expect_right_pictures(const Balls &balls, const std::vector<Direction> &directions, size_t pixels,
                           const std::string &name) {
  for (const Direction &towards : directions)
    ASSERT_EQ(complaint_about_smallest(
                  balls, [&](const Balls &set) { return pictures_disagree(LibraryScene(set), pixels, towards); }),
              "")
        << name;
}

TEST(Painter, ShowsSmallSets) {
  for (const oracle::NamedBalls &view : small_views()) {
    expect_right_pictures(view.balls, even_directions(), 250, view.name);
    expect_right_pictures(view.balls, uneven_directions(), 250, view.name);
  }
}

TEST(Painter, ShowsLattices) {
  for (const oracle::NamedBalls &view : lattice_views()) {
    expect_right_pictures(view.balls, even_directions(), 250, view.name);
    expect_right_pictures(view.balls, {uneven_directions()[0]}, 250, view.name);
  }
}

TEST(Painter, ShowsDegenerateSets) {
  for (const oracle::NamedBalls &view : degenerate_views(130)) {
    expect_right_pictures(view.balls, {even_directions()[0], even_directions()[4]}, 100, view.name);
    expect_right_pictures(view.balls, {uneven_directions()[0]}, 100, view.name);
  }
}

TEST(Painter, ShowsRandomSets) {
  oracle::RandomSource random(91);
  for (int k = 0; k < oracle::sets(8); ++k)
    for (const auto make : {oracle::loose_balls, oracle::dense_balls, oracle::clustered_balls, oracle::belted_balls,
                            sparse_balls, mixed_balls, flat_balls})
      expect_right_pictures(make(random, k == 0 ? 400 : 60), {{0, 0, 1}, uneven_directions()[0]}, 150, "");
}

TEST(Painter, ShowsRandomDegenerateSets) {
  oracle::RandomSource random(92);
  for (int k = 0; k < oracle::sets(300); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(2, 20)));
    expect_right_pictures(balls, {even_directions()[static_cast<size_t>(random.in(0, 4))]}, 60, "");
  }
}

// The same in lengths that are not lattice steps, with a probe and with up chosen.
TEST(Painter, ShowsOtherLengths) {
  oracle::RandomSource random(93);
  const Balls balls = oracle::loose_balls(random, 100);
  for (const double step : {0x1p-40, 0x1p+20})
    for (const double probe : {0.0, 25.0}) {
      const LibraryScene scene(balls, step, probe * step);
      EXPECT_EQ(pictures_disagree(scene, 200, {1, 0, 2}, {3, 1, -1}), "") << step << " " << probe;
      EXPECT_EQ(pictures_disagree(scene, 200, {0, -5e-300, 0}, {0, 1, 0}), "") << step << " " << probe;
    }
}

}  // namespace
