#include "query_workload.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "random_numbers.hpp"

namespace bench {
namespace {

constexpr uint64_t seed = 1994;
constexpr uint32_t most_hits = 4096;

// Uniform in the ball of radius 1.
std::array<double, 3> uniform_in_ball(support::Random &random) {
  for (;;) {
    std::array<double, 3> point{};
    double square = 0;
    for (double &component : point) {
      component = 2 * random.fraction() - 1;
      square += component * component;
    }
    if (square <= 1) return point;
  }
}

}  // namespace

std::vector<double> random_points_in_box(const Model &model, size_t count) {
  const std::vector<double> &xyz = model.balls().xyz;
  const double margin = model.largest_radius();
  std::array<double, 3> low{};
  std::array<double, 3> size{};
  for (size_t axis = 0; axis < 3; ++axis) {
    low[axis] = xyz[axis];
    double high = xyz[axis];
    for (size_t i = axis; i < xyz.size(); i += 3) {
      low[axis] = std::min(low[axis], xyz[i]);
      high = std::max(high, xyz[i]);
    }
    low[axis] -= margin;
    size[axis] = high + margin - low[axis];
  }
  support::Random random(seed);
  std::vector<double> points;
  for (size_t i = 0; i < 3 * count; ++i) points.push_back(low[i % 3] + size[i % 3] * random.fraction());
  return points;
}

std::vector<double> random_points_near_atoms(const Model &model, size_t count) {
  const std::vector<double> &xyz = model.balls().xyz;
  support::Random random(seed);
  std::vector<double> points;
  while (points.size() < 3 * count) {
    const std::array<double, 3> offset = uniform_in_ball(random);
    const size_t atom = random.next() % model.size();
    for (size_t axis = 0; axis < 3; ++axis) points.push_back(xyz[3 * atom + axis] + offset[axis]);
  }
  return points;
}

std::vector<double> random_points_near_surface(const Model &model, size_t count) {
  const Balls &balls = model.balls();
  support::Random random(seed);
  std::vector<double> points;
  while (points.size() < 3 * count) {
    const std::array<double, 3> direction = uniform_in_ball(random);
    const size_t atom = random.next() % model.size();
    const double distance = balls.radius[atom] + model.probe() + random.fraction();
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    if (length < 0.01) continue;
    std::array<double, 3> point{};
    for (size_t axis = 0; axis < 3; ++axis) {
      point[axis] = balls.xyz[3 * atom + axis] + distance / length * direction[axis];
    }
    uint32_t meets = 0;
    expect_ok(hsp_query_meets(model.get(), point.data(), 0, &meets), "hsp_query_meets");
    if (meets == 0) points.insert(points.end(), point.begin(), point.end());
  }
  return points;
}

size_t query_points(const Model &model, const std::vector<double> &points) {
  std::array<uint32_t, most_hits> ids;
  size_t hits = 0;
  for (size_t i = 0; i < points.size(); i += 3) {
    uint32_t needed = 0;
    const int32_t status = hsp_query_point(model.get(), &points[i], ids.data(), most_hits, &needed);
    if (status != HSP_OK) expect_ok(status, "hsp_query_point");
    hits += needed;
  }
  benchmark::DoNotOptimize(ids);
  return hits;
}

size_t query_balls(const Model &model, const std::vector<double> &points, double radius) {
  std::array<uint32_t, most_hits> ids;
  size_t hits = 0;
  for (size_t i = 0; i < points.size(); i += 3) {
    uint32_t needed = 0;
    const int32_t status = hsp_query_ball(model.get(), &points[i], radius, ids.data(), most_hits, &needed);
    if (status != HSP_OK) expect_ok(status, "hsp_query_ball");
    hits += needed;
  }
  benchmark::DoNotOptimize(ids);
  return hits;
}

size_t query_rays(const Model &model, const std::vector<double> &points) {
  size_t hits = 0;
  for (size_t i = 0; i + 5 < points.size(); i += 3) {
    const double *const from = &points[i];
    const double direction[3] = {from[3] - from[0], from[4] - from[1], from[5] - from[2]};
    hsp_ray_hit hit{};
    const int32_t status = hsp_query_ray(model.get(), from, direction, &hit);
    if (status != HSP_OK) expect_ok(status, "hsp_query_ray");
    hits += hit.ball != HSP_NONE ? 1 : 0;
  }
  return hits;
}

size_t query_all_neighbours(const Model &model) {
  std::array<uint32_t, most_hits> ids;
  size_t hits = 0;
  for (uint32_t ball = 0; ball < model.size(); ++ball) {
    uint32_t needed = 0;
    const int32_t status = hsp_query_neighbours(model.get(), ball, ids.data(), most_hits, &needed);
    if (status != HSP_OK) expect_ok(status, "hsp_query_neighbours");
    hits += needed;
  }
  benchmark::DoNotOptimize(ids);
  return hits;
}

size_t query_all_pairs(const Model &model, std::vector<uint32_t> &first, std::vector<uint32_t> &ids) {
  first.resize(size_t{model.size()} + 1);
  const auto ask = [&](uint32_t &needed) {
    return hsp_query_pairs(model.get(), 0, first.data(), ids.data(), static_cast<uint32_t>(ids.size()), &needed);
  };
  uint32_t needed = 0;
  int32_t status = ask(needed);
  if (status == HSP_E_CAPACITY) {
    ids.resize(needed);
    status = ask(needed);
  }
  if (status != HSP_OK) expect_ok(status, "hsp_query_pairs");
  benchmark::DoNotOptimize(ids);
  return needed;
}

Located locate_points(Topology &topology, const std::vector<double> &points) {
  Located located;
  for (size_t i = 0; i < points.size(); i += 3) {
    uint32_t cell = 0;
    const int32_t status = hsp_topology_locate(topology.get(), &points[i], &cell);
    if (status != HSP_OK) expect_ok(status, "hsp_topology_locate");
    located.inside += cell == HSP_NONE ? 1 : 0;
    located.in_voids += cell != HSP_NONE && cell != 0 ? 1 : 0;
  }
  return located;
}

}  // namespace bench
