// The caps near one of very many: none that meets it is left out, and what is found with these alone is what is found
// with all.
#include "sphere/near_caps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "built_grid.hpp"
#include "bumps.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"
#include "sphere/cap_clusters.hpp"
#include "sphere/vertex_finder.hpp"

namespace {

using oracle::Balls;

class Search {
 public:
  explicit Search(const Balls &balls) : built_(oracle::in_lengths(balls, 1)), n_(static_cast<uint32_t>(balls.size())) {
    memory_of_caps_.carve(caps, n_);
    memory_of_finder_.carve(finder_, n_);
    memory_of_clusters_.carve(clusters_, n_);
    memory_of_index_.carve(intervals_, n_);
    vertices_.resize(6 * size_t{n_} * std::min(n_, 60U) + 16);
    circles_.resize(n_ + 1);
  }

  // Of the caps of one ball; false if there are none to be indexed.
  bool gather(uint32_t ball) {
    caps.gather(built_.grid().balls(), built_.grid().block_around(built_.grid().cube_at(balls().ball(ball).centre)),
                ball, nullptr);
    return !caps.contained && caps.count > 0 && balls().r[ball] > 0;
  }
  hsp::NearCaps index() const { return intervals_.near_caps(); }
  uint32_t size() const { return balls().n; }
  const hsp::BallSet &balls() const { return built_.grid().balls(); }

  // All that is found of the free part and of the clusters, as text.
  std::string found(bool by_index) {
    hsp::FixedVector<hsp::VertexRecord> vertices({vertices_.data(), static_cast<uint32_t>(vertices_.size())});
    hsp::FixedVector<hsp::CircleRecord> circles({circles_.data(), static_cast<uint32_t>(circles_.size())});
    if (by_index) {
      finder_.find(balls(), caps, index(), vertices, circles);
    } else {
      finder_.find(balls(), caps, vertices, circles);
    }
    std::string text;
    for (const hsp::VertexRecord &v : vertices.items()) {
      text += std::to_string(v.ball[1]) + " " + std::to_string(v.ball[2]) + " " + std::to_string(v.code) + "\n";
    }
    for (const hsp::CircleRecord &c : circles.items()) text += std::to_string(c.ball[1]) + "\n";
    text += std::to_string(by_index ? clusters_.find(caps, index()) : clusters_.find(caps)) + " clusters";
    return text;
  }
  // How many caps stand for their clusters.
  uint32_t representatives() const {
    uint32_t count = 0;
    for (uint32_t k = 0; k < caps.count; ++k) count += clusters_.is_representative(k) ? 1U : 0U;
    return count;
  }

  hsp::Caps caps;

 private:
  BuiltGrid built_;
  uint32_t n_;
  CarvedMemory memory_of_caps_, memory_of_finder_, memory_of_clusters_, memory_of_index_;
  hsp::VertexFinder finder_;
  hsp::CapClusters clusters_;
  hsp::FreeIntervals intervals_;
  std::vector<hsp::VertexRecord> vertices_;
  std::vector<hsp::CircleRecord> circles_;
};

// Whether two caps have a common point, with a margin for which all of them are listed.
bool certainly_meet(const hsp::Caps &caps, uint32_t j, uint32_t k) {
  const auto angle = [](double cosine) { return std::acos(std::clamp<long double>(cosine, -1, 1)); };
  const long double x = static_cast<long double>(caps.ux[j] - caps.ux[k]), y = caps.uy[j] - caps.uy[k],
                    z = caps.uz[j] - caps.uz[k];
  const long double between = 2 * std::asin(std::min(1.0L, std::sqrt(x * x + y * y + z * z) / 2));
  return between <= angle(caps.b[j]) + angle(caps.b[k]);
}

TEST(NearCaps, AreAllThatMeet) {
  oracle::RandomSource random(61);
  constexpr double sizes[][2] = {{0.001, 0.001}, {0.02, 0.3}, {0.0001, 1.2}, {0.1, 0.1}, {0.5, 0.9}};
  uint64_t meetings = 0;
  for (const auto &[least, most] : sizes) {
    for (const uint32_t n : {3U, 20U, 300U}) {
      Search search(bumps(random, n, least, most));
      for (uint32_t i = 0; i < search.size(); ++i) {
        if (search.balls().r[i] < 1e6 || !search.gather(i)) continue;
        const hsp::Caps &caps = search.caps;
        hsp::NearCaps near = search.index();
        near.start(caps);
        for (uint32_t j = 0; j < caps.count; ++j) {
          const auto around = near.around(caps, j);
          EXPECT_TRUE(std::is_sorted(around.begin(), around.end()));
          EXPECT_EQ(std::adjacent_find(around.begin(), around.end()), around.end());
          for (uint32_t k = 0; k < caps.count; ++k) {
            if (!certainly_meet(caps, j, k)) continue;
            ASSERT_TRUE(std::binary_search(around.begin(), around.end(), k)) << j << " " << k;
            ++meetings;
          }
        }
      }
    }
  }
  EXPECT_GT(meetings, 10000U);
}

TEST(NearCaps, FindWhatAllFind) {
  oracle::RandomSource random(62);
  uint32_t balls_tried = 0;
  for (int k = 0; k < 300 && !HasFailure(); ++k) {
    const size_t n = static_cast<size_t>(random.in(2, 40));
    const Balls balls = k % 3 == 0   ? bumps(random, static_cast<uint32_t>(n), 0.01, 0.6)
                        : k % 3 == 1 ? oracle::any_balls(random, n)
                                     : oracle::degenerate_balls(random, n);
    Search search(balls);
    for (uint32_t i = 0; i < search.size(); ++i) {
      if (!search.gather(i)) continue;
      const std::string all = search.found(false);
      EXPECT_EQ(search.found(true), all) << oracle::to_text(balls) << " ball " << i;
      EXPECT_EQ(all.substr(all.rfind('\n') + 1), std::to_string(search.representatives()) + " clusters");
      ++balls_tried;
    }
  }
  EXPECT_GT(balls_tried, 2000U);
}

// Caps that are apart, or that just cover the sphere, with a few large ones among them: a few for each.
TEST(NearCaps, AreFew) {
  oracle::RandomSource random(63);
  for (const double size : {0.0005, 0.025}) {
    Balls balls = bumps(random, 4000, size, size);
    for (uint32_t k = 0; k < 10; ++k) balls.push_back({0, 1000000 - 10 * k, 0, 700000 - 1000 * k});
    Search search(balls);
    for (uint32_t i = 0; i < search.size(); ++i) {
      if (search.balls().r[i] < 1e6 || !search.gather(i)) continue;
      hsp::NearCaps near = search.index();
      near.start(search.caps);
      uint64_t all = 0;
      for (uint32_t j = 0; j < search.caps.count; ++j) all += near.around(search.caps, j).size();
      EXPECT_LT(all, (size < 0.001 ? 16U : 40U) * search.caps.count);
    }
  }
}

// Hundreds of small caps are compared with those near them alone; hundreds of large ones each with each.
TEST(NearCaps, AreAskedForSmallOnes) {
  oracle::RandomSource random(64);
  for (const auto &[count, size, expected] : {std::tuple{300U, 0.01, true}, std::tuple{300U, 0.6, false},
                                              std::tuple{100U, 0.01, false}, std::tuple{1100U, 0.6, true}}) {
    Search search(bumps(random, count + 1, size, size));
    uint32_t asked = 0;
    for (uint32_t i = 0; i < search.size(); ++i) {
      if (search.balls().r[i] < 1e6 || !search.gather(i)) continue;
      EXPECT_EQ(search.caps.count, count);
      EXPECT_EQ(hsp::NearCaps::are_many(search.caps, search.caps.b.data()), expected) << count << " of " << size;
      ++asked;
    }
    EXPECT_EQ(asked, 1U);
  }
}

}  // namespace
