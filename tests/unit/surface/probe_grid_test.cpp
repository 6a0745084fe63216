#include "surface/probe_grid.hpp"

#include <algorithm>

#include "boundary/boundary_builder.hpp"
#include "built_grid.hpp"
#include "expect_cases.hpp"
#include "probe_grid_cases.hpp"

TEST(ProbeGrid, Cases) {
  expect_cases(cases::surface_probe_grid);
}

namespace {

// Groups of three balls so many cubes apart along x, each with two probes that overlap, in neighbouring cubes of a row.
class Groups {
 public:
  Groups(uint32_t groups, uint32_t cubes_apart) : built_(list(groups, cubes_apart), probe) {
    const uint32_t n = 3 * groups;
    boundary_memory_.carve(builder_, hsp::BoundaryLimits{n, n, 8 * n, n, 0});
    EXPECT_EQ(builder_.build(built_.grid()), hsp::Status::ok);
    EXPECT_EQ(vertices(), 2 * groups);
    grid_memory_.carve(grid, vertices());
    hsp::Patience endless;
    grid.build(balls(), builder_.boundary(), endless);
  }

  uint32_t vertices() const { return builder_.boundary().vertex_count(); }
  const hsp::BallSet &balls() const { return built_.grid().balls(); }

  // Those that a search around a vertex looks at.
  std::vector<uint32_t> looked_at(uint32_t vertex) const {
    hsp::ProbeSearch search{};
    grid.start_search(balls(), vertex, search);
    std::vector<uint32_t> found;
    for (uint32_t k = 0; k < search.ranges; ++k) {
      for (uint32_t at = search.range[k].first; at < search.range[k].last; ++at) found.push_back(search.vertex[at]);
    }
    return found;
  }

  static constexpr double probe = 50;

 private:
  static support::BallList list(uint32_t groups, uint32_t cubes_apart) {
    support::BallList balls;
    for (uint32_t k = 0; k < groups; ++k) {
      const double x = std::round(k * cubes_apart * (2 * probe * (1.0 + 0x1p-12) + 4.0));
      balls.add(x, 0, 0, 80);
      balls.add(x, 216, 0, 80);
      balls.add(x, 108, 187, 80);
    }
    return balls;
  }

  BuiltGrid built_;
  CarvedMemory boundary_memory_, grid_memory_;
  hsp::BoundaryBuilder builder_;

 public:
  hsp::ProbeGrid grid;
};

void expect_few(const Groups &groups, uint32_t most) {
  uint32_t others = 0;
  for (uint32_t v = 0; v < groups.vertices(); v += groups.vertices() / 100 + 1) {
    const std::vector<uint32_t> found = groups.looked_at(v);
    EXPECT_LE(found.size(), most);
    for (uint32_t w = 0; w < groups.vertices(); ++w) {
      const hsp::Vec3 to = groups.grid.difference(groups.balls(), v, w);
      if (dot(to, to) < 4 * Groups::probe * Groups::probe) {
        EXPECT_EQ(std::count(found.begin(), found.end(), w), 1) << v << " " << w;
        others += v == w ? 0 : 1;
      }
    }
  }
  EXPECT_GT(others, 80U);
}

// Where all probes would be in one bucket, or in a few, or in as many as there are groups.
TEST(ProbeGrid, CollidingCubes) {
  for (const uint32_t groups : {500U, 4000U}) {
    const Groups colliding(groups, 65536);
    EXPECT_FALSE(colliding.grid.has_buckets());
    expect_few(colliding, 2);
    const Groups spread(groups, 65);
    EXPECT_TRUE(spread.grid.has_buckets());
    if (groups == 500) expect_few(spread, 27 * 65);
  }
}

}  // namespace
