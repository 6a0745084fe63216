// Clusters of caps on a ball of radius 25. A ball of radius 25 at distance 40 covers 36.87 degrees about its direction.
#pragma once

#include "small_union.hpp"

namespace cases {

struct Clustered {
  uint32_t others;
  SmallBall other[5];
  uint32_t clusters;
};
constexpr Clustered clustered[] = {
    {1, {{40, 0, 0, 25}}, 1},
    {2, {{40, 0, 0, 25}, {-40, 0, 0, 25}}, 2},
    {2, {{40, 0, 0, 25}, {0, 40, 0, 25}}, 2},                                   // 90 degrees apart
    {2, {{40, 0, 0, 25}, {24, 32, 0, 25}}, 1},                                  // 53 degrees
    {2, {{40, 0, 0, 25}, {38, 0, 0, 20}}, 1},                                   // one inside the other
    {3, {{40, 0, 0, 25}, {24, 32, 0, 25}, {0, 40, 0, 25}}, 1},                  // a chain
    {4, {{40, 0, 0, 26}, {38, 0, 0, 20}, {37, 6, 0, 20}, {-40, 0, 0, 25}}, 2},  // the largest takes two, not the last
    {4, {{40, 0, 0, 25}, {24, 32, 0, 25}, {0, 0, 40, 25}, {0, 0, -40, 25}}, 3},
    {5, {{40, 0, 0, 25}, {-40, 0, 0, 25}, {0, 40, 0, 25}, {0, -40, 0, 25}, {0, 0, 40, 25}}, 5},
    {2, {{40, 0, 0, 25}, {3, 0, 0, 4}}, 1}};  // a ball inside has no cap

inline uint32_t clusters_are_counted() {
  return first_failing(clustered, [](const Clustered &c) {
    SmallBall balls[6] = {{0, 0, 0, 25}};
    for (uint32_t k = 0; k < c.others; ++k) balls[k + 1] = c.other[k];
    if (!small_union().build(balls, c.others + 1)) return false;
    const hsp::Caps &caps = small_union().gathered(0).caps;
    hsp::CapClusters &clusters = small_union().clusters();
    if (clusters.find(caps) != c.clusters) return false;
    uint32_t representatives = 0;
    for (uint32_t k = 0; k < caps.count; ++k) representatives += clusters.is_representative(k) ? 1U : 0U;
    return representatives == c.clusters;
  });
}

inline constexpr Check sphere_cap_clusters[] = {{"clusters_are_counted", clusters_are_counted}};

}  // namespace cases
