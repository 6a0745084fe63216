// Balls and images that meet a ball, against all images; in boxes at points in any copy.
#include "pores/balls_around.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "built_grid.hpp"
#include "built_periodic.hpp"
#include "lattice_ball.hpp"
#include "random_balls.hpp"
#include "sweep_length.hpp"

namespace {

using Image = std::array<int64_t, 4>;  // ball, shift

class Found {
 public:
  explicit Found(const hsp::BallsAround &balls) : balls_(balls) {}
  std::set<Image> at(const hsp::LatticeQuery &query) {
    std::set<Image> images;
    count_ = balls_.find(query, near_, hsp::BallsAround::most);
    for (uint32_t k = 0; k < count_ && count_ <= hsp::BallsAround::most; ++k) {
      const auto &[ball, shift] = near_[k];
      images.insert({ball, shift.k[0], shift.k[1], shift.k[2]});
      touching_ = touching_ && is_met(near_[k], query);
    }
    return images;
  }
  uint32_t count() const { return count_; }
  bool all_meet() const { return touching_; }
  bool is_met(const hsp::NearImage &image, const hsp::LatticeQuery &query) const {
    const hsp::exact::LatticeBall ball = balls_.ball(image);
    const auto square = [](int64_t a, int64_t b) { return static_cast<double>(a - b) * static_cast<double>(a - b); };
    const auto sum = static_cast<double>(ball.radius + query.radius);
    return square(ball.centre.x, query.centre.x) + square(ball.centre.y, query.centre.y) +
               square(ball.centre.z, query.centre.z) <=
           sum * sum;
  }
  double gap_of(const Image &image, const hsp::exact::Vector &point) const {
    const hsp::exact::LatticeBall ball = balls_.ball(
        {static_cast<uint32_t>(image[0]),
         {{static_cast<int32_t>(image[1]), static_cast<int32_t>(image[2]), static_cast<int32_t>(image[3])}}});
    const double x = static_cast<double>(point.x - ball.centre.x), y = static_cast<double>(point.y - ball.centre.y),
                 z = static_cast<double>(point.z - ball.centre.z);
    return std::sqrt(x * x + y * y + z * z) - static_cast<double>(ball.radius);
  }

 private:
  hsp::BallsAround balls_;
  hsp::NearImage near_[hsp::BallsAround::most];
  uint32_t count_ = 0;
  bool touching_ = true;
};

TEST(BallsAround, AreThoseOfAllImages) {
  oracle::RandomSource random(1);
  size_t images = 0, own = 0, all_deep = 0;
  for (int turn = 0; turn < oracle::sets(10); ++turn) {
    support::BallList list;
    for (int64_t n = random.in(1, 6); n > 0; --n) {
      const auto along = [&] { return static_cast<double>(random.in(-3000, 3000)); };
      list.add(along(), along(), along(), static_cast<double>(random.in(100, 900)));
    }
    const auto side = [&] { return static_cast<double>(random.in(700, 2000)); };
    const auto skew = [&] { return turn % 2 == 0 ? 0.0 : static_cast<double>(random.in(-1500, 1500)); };
    const BoxVectors box{side(), 0, 0, skew(), side(), 0, skew(), skew(), side()};
    const BuiltPeriodic periodic(list, box);
    ASSERT_EQ(periodic.status(), hsp::Status::ok);
    const BuiltGrid grid(list);
    Found in_box{hsp::BallsAround(periodic.get())}, alone{hsp::BallsAround(grid.grid())};
    const hsp::BallsAround around(periodic.get());
    for (int k = 0; k < 20; ++k) {
      const int64_t far = k % 2 == 0 ? 5000 : 1000;
      const hsp::LatticeQuery query{{random.in(-far, far), random.in(-far, far), random.in(-far, far)},
                                    random.in(0, k % 3 == 0 ? 1500 : 200)};
      std::set<Image> expected, expected_alone;
      for (uint32_t ball = 0; ball < list.size(); ++ball) {
        for (int x = -25; x <= 25; ++x) {
          for (int y = -14; y <= 14; ++y) {
            for (int z = -14; z <= 14; ++z) {
              const hsp::NearImage image{ball, {{x, y, z}}};
              if (in_box.is_met(image, query)) expected.insert({ball, x, y, z});
            }
          }
        }
        if (alone.is_met({ball, {}}, query)) expected_alone.insert({ball, 0, 0, 0});
      }
      const std::set<Image> found = in_box.at(query);
      ASSERT_EQ(in_box.count(), expected.size());
      if (in_box.count() <= hsp::BallsAround::most) {
        ASSERT_EQ(found, expected);
      }
      ASSERT_EQ(around.find(query, nullptr, 0), expected.size());
      // Of these the nearest one, and all that the middle is deep in.
      double nearest = INFINITY;
      uint32_t deep = 0;
      for (const Image &image : expected) {
        const double gap = in_box.gap_of(image, query.centre);
        nearest = std::min(nearest, gap);
        deep += gap <= -50.0 ? 1 : 0;
      }
      double gap = INFINITY;
      hsp::NearImage first{hsp::no_id, {}};
      around.visit(query, [&](const hsp::NearImage &image) {
        const auto &[ball, shift] = image;
        const double here = in_box.gap_of({ball, shift.k[0], shift.k[1], shift.k[2]}, query.centre);
        if (!(here < gap)) return;
        gap = here;
        first = image;
      });
      ASSERT_EQ(gap, nearest);
      ASSERT_EQ(first.ball == hsp::no_id, expected.empty());
      if (!expected.empty()) {
        ASSERT_EQ(in_box.gap_of({first.ball, first.shift.k[0], first.shift.k[1], first.shift.k[2]}, query.centre), gap);
      }
      hsp::NearImage found_deep[hsp::BallsAround::most];
      ASSERT_EQ(around.find_deep(query.centre, -50.0, found_deep, hsp::BallsAround::most), deep);
      for (uint32_t i = 0; i < deep && i < hsp::BallsAround::most; ++i) {
        const auto &[ball, shift] = found_deep[i];
        ASSERT_LE(in_box.gap_of({ball, shift.k[0], shift.k[1], shift.k[2]}, query.centre), -50.0);
      }
      all_deep += deep;
      ASSERT_EQ(alone.at(query), expected_alone);
      images += found.size();
      own += expected_alone.size();
    }
    ASSERT_TRUE(in_box.all_meet() && alone.all_meet());
  }
  EXPECT_GT(images, 500U);
  EXPECT_GT(own, 0U);
  EXPECT_GT(all_deep, 100U);
}

}  // namespace
