// Searches for probes that may cut a triangle, against the directions that overlapping probes cut off, and against
// all pairs.
#pragma once

#include <cmath>
#include <initializer_list>

#include "lanes/target.hpp"
#include "small_surface.hpp"
#include "surface/probe_grid.hpp"

namespace cases {

// The probes of a union at random, sorted, and a search around one of them.
class SearchedProbes {
 public:
  // In the last rounds far from the origin, where doubles hold whole steps and little more.
  bool build(Random &random, uint32_t round) {
    SmallBall balls[10];
    const int32_t origin = round < 30 ? 0 : 1500000000;
    for (SmallBall &ball : balls) {
      ball = {origin + static_cast<int32_t>(random.below(1500)), static_cast<int32_t>(random.below(1500)) - origin,
              static_cast<int32_t>(random.below(1500)), static_cast<int32_t>(random.below(300))};
    }
    probe_ = 1 + static_cast<int32_t>(random.below(400));
    if (!small_union().build(balls, 10, probe_)) return false;
    hsp::Workspace measured;
    grid_.carve(measured, vertices());
    if (measured.bytes() > sizeof memory_) return false;
    hsp::Workspace workspace(memory_, sizeof memory_);
    grid_.carve(workspace, vertices());
    hsp::Patience endless;
    grid_.build(small_union().balls(), small_union().boundary(), endless);
    return true;
  }

  static uint32_t vertices() { return small_union().boundary().vertex_count(); }
  const hsp::ProbeGrid &grid() const { return grid_; }
  double diameter() const { return 2.0 * probe_; }

  // How often each vertex is found; everything that overlaps is, if all directions count.
  void search(uint32_t vertex, const hsp::ProbeTriangles *triangles, hsp::Target target, uint32_t (&times)[60]) const {
    hsp::ProbeSearch search;
    grid_.start_search(small_union().balls(), vertex, search);
    const uint32_t lane = vertex % hsp::ProbeTriangles::lanes;
    for (int k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        search.inward[k][axis] = triangles != nullptr ? static_cast<float>(triangles->inward[k][axis][lane]) : 0;
        search.corner[k][axis] = triangles != nullptr ? static_cast<float>(triangles->corner[k][axis][lane]) : 0;
      }
      search.cosine[k] = triangles != nullptr ? static_cast<float>(triangles->cosine[k][lane]) : 0;
    }
    for (uint32_t &count : times) count = 0;
    uint32_t found[hsp::ProbeSearch::room + hsp::ProbeSearch::spare];
    while (!search.done()) {
      const uint32_t count = hsp::find_near_probes(target, search, found);
      for (uint32_t k = 0; k < count; ++k) ++times[found[k]];
    }
  }

 private:
  hsp::ProbeGrid grid_;
  int32_t probe_ = 1;
  alignas(64) unsigned char memory_[8 * 1024];
};
inline SearchedProbes &searched_probes() {
  static SearchedProbes one;
  return one;
}

// Once each, on all targets.
template <class Judge>
uint32_t first_bad_search(const hsp::ProbeTriangles *(*triangles_of)(uint32_t vertex), Judge judge) {
  Random random(20261121);
  for (uint32_t round = 0; round < 40; ++round) {
    if (!searched_probes().build(random, round)) return round;
    for (uint32_t v = 0; v < SearchedProbes::vertices(); ++v) {
      for (const hsp::Target target : {hsp::Target::baseline, hsp::best_target()}) {
        uint32_t times[60];
        searched_probes().search(v, triangles_of(v), target, times);
        for (uint32_t w = 0; w < SearchedProbes::vertices(); ++w) {
          if (times[w] > 1 || !judge(v, w, times[w] == 1)) return round;
        }
      }
    }
  }
  return all_hold;
}

inline hsp::Vec3 from_to(uint32_t v, uint32_t w) {
  return searched_probes().grid().difference(small_union().balls(), v, w);
}

// Without sides everything counts that overlaps.
inline uint32_t all_that_overlap() {
  return first_bad_search([](uint32_t) -> const hsp::ProbeTriangles * { return nullptr; },
                          [](uint32_t v, uint32_t w, bool found) {
                            const hsp::Vec3 to = from_to(v, w);
                            return found || std::sqrt(dot(to, to)) >= searched_probes().diameter();
                          });
}

// The triangle of a vertex, from positions alone.
inline const hsp::ProbeTriangles *triangle_of(uint32_t vertex) {
  static hsp::ProbeTriangles triangles;
  const hsp::BallSet &balls = small_union().balls();
  const uint32_t lane = vertex % hsp::ProbeTriangles::lanes;
  const uint32_t first = vertex - lane;
  hsp::gather_triangles(small_union().boundary(), searched_probes().grid().positions(), first, triangles);
  for (uint32_t k = 0; k < hsp::ProbeTriangles::lanes; ++k) {
    const uint32_t last = SearchedProbes::vertices() - 1;
    const hsp::Vec3 offset = searched_probes().grid().position(first + k < last ? first + k : last).offset;
    triangles.offset[0][k] = offset.x;
    triangles.offset[1][k] = offset.y;
    triangles.offset[2][k] = offset.z;
  }
  hsp::measure_triangles(hsp::Target::baseline, hsp::arrays_of(balls), triangles);
  return &triangles;
}

// Directions of the triangle, from corner to corner and between, are cut off by none that is not found. Of those that
// are found most cut off some: the others are few.
inline uint32_t all_that_cut() {
  static uint32_t found_in_vain;
  static uint32_t cutting;
  found_in_vain = cutting = 0;
  const uint32_t bad = first_bad_search(triangle_of, [](uint32_t v, uint32_t w, bool found) {
    const hsp::Vec3 to = from_to(v, w);
    const double length = std::sqrt(dot(to, to));
    const double t = searched_probes().diameter();
    if (v == w || length == 0 || length >= t) return true;
    const hsp::ProbeTriangles &triangles = *triangle_of(v);
    const uint32_t lane = v % hsp::ProbeTriangles::lanes;
    constexpr int steps = 40;
    bool cuts = false;
    for (int i = 0; i <= steps && !cuts; ++i) {
      for (int j = 0; i + j <= steps && !cuts; ++j) {
        const double share[3] = {i / double{steps}, j / double{steps}, (steps - i - j) / double{steps}};
        hsp::Vec3 direction{0, 0, 0};
        for (int k = 0; k < 3; ++k) {
          direction = direction + share[k] * hsp::Vec3{triangles.corner[k][0][lane], triangles.corner[k][1][lane],
                                                       triangles.corner[k][2][lane]};
        }
        const double along = dot(direction, to) / (length * std::sqrt(dot(direction, direction)));
        cuts = along > length / t + 1e-9;
      }
    }
    // Far from the middle of a set floats are coarse.
    if (small_union().balls().x[0] < 1e6) {
      cutting += cuts ? 1U : 0U;
      found_in_vain += found && !cuts ? 1U : 0U;
    }
    return found || !cuts;
  });
  if (bad != all_hold) return bad;
  return cutting > 200 && 3 * found_in_vain < cutting ? all_hold : 100;
}

inline constexpr Check surface_near_probes[] = {{"all_that_overlap", all_that_overlap}, {"all_that_cut", all_that_cut}};

}  // namespace cases
