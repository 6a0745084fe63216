#include "cell_comparison.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "brute_queries.hpp"
#include "cell_pairs.hpp"
#include "finding.hpp"
#include "nerve.hpp"
#include "random_balls.hpp"
#include "set_arrangements.hpp"

namespace {

using oracle::Balls;
using oracle::DualComplex;
using oracle::LatticeBall;
using oracle::LatticePoint;

constexpr int64_t farthest = int64_t{1} << 18;

// A factor so large that a step above a ball's top lies in no other ball: a lattice point outside another ball of
// radius r is at least sqrt(r^2 + 1) - r > 1 / (2 r + 1) away from it.
int64_t factor_for(const Balls &balls) {
  int64_t largest = 0;
  for (const LatticeBall &ball : balls) largest = std::max(largest, ball.radius);
  int64_t factor = 2;
  while (factor <= 2 * largest + 1) factor *= 2;
  return factor;
}

std::vector<Balls> members_of_components(const LibraryTopology &topology, const Balls &balls) {
  std::vector<Balls> members(topology.components().size());
  const std::vector<hsp_ball> records = topology.boundary().balls();
  for (size_t i = 0; i < balls.size(); ++i) members[records[i].component].push_back(balls[i]);
  return members;
}

LatticePoint above_top(const Balls &members) {
  const auto top = std::max_element(members.begin(), members.end(), [](const LatticeBall &a, const LatticeBall &b) {
    return a.z + a.radius < b.z + b.radius;
  });
  return {top->x, top->y, top->z + top->radius + 1};
}

uint32_t cell_of(const DualComplex &complex, const LatticePoint &point) {
  return complex.cell_of(point[0], point[1], point[2]);
}

// The components in whose voids a component lies, by the library.
std::set<uint32_t> components_around(const LibraryTopology &topology, uint32_t component) {
  const auto components = topology.components();
  const auto cells = topology.cells();
  const auto shells = topology.shells();
  std::set<uint32_t> around;
  for (uint32_t cell = components[component].region; cell != 0;) {
    const uint32_t outer = shells[cells[cell].enclosing_shell].component;
    if (!around.insert(outer).second) break;
    cell = components[outer].region;
  }
  return around;
}

std::string text_of(const LatticePoint &point) {
  return std::to_string(point[0]) + " " + std::to_string(point[1]) + " " + std::to_string(point[2]);
}

}  // namespace

std::string betti_numbers_disagree(const Balls &balls, int orders, uint64_t seed) {
  oracle::RandomSource random(seed);
  Finding finding;
  for (int k = 0; k <= orders; ++k) {
    const Balls mixed = k == 0 ? balls : oracle::permuted(balls, random.permutation(balls.size()));
    const LibraryTopology topology(mixed);
    const std::vector<Balls> members = members_of_components(topology, mixed);
    std::vector<int64_t> genus(members.size(), 0);
    std::vector<int64_t> voids(members.size(), 0);
    for (const hsp_shell &shell : topology.shells()) {
      genus[shell.component] += shell.genus;
      voids[shell.component] += shell.kind == HSP_SHELL_VOID ? 1 : 0;
    }
    for (size_t c = 0; c < members.size(); ++c) {
      const std::array<int64_t, 3> betti = oracle::nerve_betti_numbers(members[c]);
      finding.require(betti[0] == 1, "a component of the library is in", betti[0], "pieces");
      finding.require(genus[c] == betti[1], "genera add up to", genus[c], "instead of", betti[1]);
      finding.require(voids[c] == betti[2], voids[c], "voids instead of", betti[2]);
    }
    // Balls of one piece are not taken apart either.
    finding.require(static_cast<int64_t>(members.size()) == oracle::nerve_betti_numbers(mixed)[0],
                    "number of components");
    if (finding.any()) return finding.text() + "for the order " + oracle::to_text(mixed);
  }
  return "";
}

bool small_enough_for_dual_complex(const Balls &balls) {
  const int64_t factor = factor_for(balls);
  return balls.size() <= 300 && std::all_of(balls.begin(), balls.end(), [&](const LatticeBall &b) {
           return std::max({std::abs(b.x), std::abs(b.y), std::abs(b.z), b.radius}) <= farthest / factor;
         });
}

std::string nesting_disagrees(const Balls &small) {
  const Balls balls = scaled(small, factor_for(small));
  const LibraryTopology topology(balls);
  const std::vector<Balls> members = members_of_components(topology, balls);
  const auto components = topology.components();
  const auto shells = topology.shells();
  const DualComplex all(balls);
  Finding finding;
  finding.require(topology.counts().regions == all.cells(), topology.counts().regions, "cells instead of", all.cells());

  CellPairs pairs;
  for (uint32_t c = 0; c < members.size(); ++c) {
    const LatticePoint top = above_top(members[c]);
    const uint32_t expected = cell_of(all, top);
    finding.require(pairs.pair(components[c].region, expected), "component", c, "lies in the wrong cell,",
                    components[c].region);
    const uint32_t located = topology.cell_of(top);
    finding.require(located == components[c].region, "the point", text_of(top), "above component", c, "lies in cell",
                    located, "not in", components[c].region);
  }
  for (uint32_t outer = 0; outer < members.size(); ++outer) {
    const DualComplex alone(members[outer]);
    finding.require(components[outer].shells == alone.cells(), "component", outer, "has", components[outer].shells,
                    "shells instead of", alone.cells());
    if (alone.cells() == 1) continue;
    for (uint32_t c = 0; c < members.size(); ++c) {
      if (c == outer) continue;
      const bool inside = cell_of(alone, above_top(members[c])) != 0;
      finding.require(inside == components_around(topology, c).contains(outer), "component", c,
                      inside ? "lies in a void of" : "does not lie in a void of", outer);
    }
  }
  return finding.text();
}

std::string cell_balls_disagree(const LibraryTopology &topology, const DualComplex &complex) {
  const std::vector<hsp_ball> records = topology.boundary().balls();
  const auto lists_of = [](uint32_t cells, auto list_of) {
    std::vector<std::vector<uint32_t>> lists;
    for (uint32_t cell = 0; cell < cells; ++cell) lists.push_back(list_of(cell));
    std::sort(lists.begin() + 1, lists.end());  // cell 0 is the outer one for both
    return lists;
  };
  const auto found = lists_of(topology.counts().regions, [&](uint32_t cell) { return topology.cell_balls(cell); });
  const auto expected = lists_of(complex.cells(), [&](uint32_t cell) {
    std::vector<uint32_t> around = complex.balls_around(cell);
    std::erase_if(around, [&](uint32_t ball) { return records[ball].faces == 0; });
    return around;
  });
  Finding finding;
  finding.require(found.size() == expected.size(), found.size(), "cells instead of", expected.size());
  for (size_t k = 0; k < found.size() && !finding.any(); ++k)
    finding.require(found[k] == expected[k], "list", k, "of balls that line a cell has", found[k].size(), "instead of",
                    expected[k].size());
  return finding.text();
}

std::string locations_disagree(const Balls &small, int points, uint64_t seed) {
  const int64_t factor = factor_for(small);
  const Balls balls = scaled(small, factor);
  const LibraryTopology topology(balls);
  const DualComplex complex(balls);
  const oracle::Box box = oracle::box_around(small, 2);
  oracle::RandomSource random(seed);
  CellPairs pairs;
  Finding finding;
  for (int k = 0; k < points && !finding.any(); ++k) {
    LatticePoint point{};
    for (size_t axis = 0; axis < 3; ++axis) point[axis] = factor * random.in(box.low[axis], box.high[axis]);
    const bool near_a_ball = !small.empty() && random.one_in(3);
    if (near_a_ball) {
      // Above or below a ball's centre, up to its surface or beyond.
      const LatticeBall &ball = balls[static_cast<size_t>(random.in(0, static_cast<int64_t>(balls.size()) - 1))];
      point = {ball.x, ball.y, ball.z + random.in(-1, 1) * ball.radius + random.in(-1, 1)};
    } else if (random.one_in(4)) {
      point[static_cast<size_t>(random.in(0, 2))] += random.in(-factor / 2, factor / 2);
    }
    const uint32_t cell = topology.cell_of(point);
    const auto containing = oracle::balls_meeting(balls, {point[0], point[1], point[2], 0});
    finding.require((cell == HSP_NONE) == !containing.empty(), "cell", cell, "of", text_of(point), "in",
                    containing.size(), "balls");
    if (!containing.empty()) continue;
    const uint32_t expected = cell_of(complex, point);
    finding.require(cell < topology.counts().regions && pairs.pair(cell, expected), "the free point", text_of(point),
                    "is located in cell", cell);
  }
  return finding.text();
}
