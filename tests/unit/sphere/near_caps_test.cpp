// The caps near one of very many: none that meets it is left out, and what is found with these alone is what is found
// with all.
#include "sphere/near_caps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "bumps.hpp"
#include "indexed_search.hpp"

namespace {

using oracle::Balls;

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
      IndexedSearch search(bumps(random, n, least, most));
      for (uint32_t i = 0; i < search.size(); ++i) {
        if (search.balls().r[i] < 1e6 || !search.gather(i)) continue;
        const hsp::Caps &caps = search.caps;
        hsp::NearCaps near = search.near_caps();
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
    IndexedSearch search(balls);
    for (uint32_t i = 0; i < search.size(); ++i) {
      if (!search.gather(i)) continue;
      const std::string all = search.found() + search.clusters();
      EXPECT_EQ(search.found(search.near_caps()) + search.clusters(search.near_caps()), all)
          << oracle::to_text(balls) << " ball " << i;
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
    IndexedSearch search(balls);
    for (uint32_t i = 0; i < search.size(); ++i) {
      if (search.balls().r[i] < 1e6 || !search.gather(i)) continue;
      hsp::NearCaps near = search.near_caps();
      near.start(search.caps);
      uint64_t all = 0;
      for (uint32_t j = 0; j < search.caps.count; ++j) all += near.around(search.caps, j).size();
      EXPECT_LT(all, (size < 0.001 ? 16U : 40U) * search.caps.count);
    }
  }
}

// Hundreds of small caps are compared with those near them alone, but no large ones.
TEST(NearCaps, AreAskedForSmallOnes) {
  oracle::RandomSource random(64);
  for (const auto &[count, size, expected] : {std::tuple{300U, 0.01, true}, std::tuple{300U, 0.6, false},
                                              std::tuple{100U, 0.01, false}, std::tuple{1100U, 0.6, false}}) {
    IndexedSearch search(bumps(random, count + 1, size, size));
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
