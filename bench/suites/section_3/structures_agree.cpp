// section_3_structures_agree: a test that the structures of Section 3 find the balls that the library finds, on
// molecules, random sets, and sets full of ties, for points and balls inside, outside and far away.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "handles.hpp"
#include "query_workload.hpp"
#include "random_numbers.hpp"
#include "section_3/centre_grid.hpp"
#include "section_3/dense_cubes.hpp"
#include "section_3/double_hashing.hpp"
#include "section_3/paper_grid.hpp"
#include "section_3/perfect_hashing.hpp"
#include "section_3/range_tree.hpp"
#include "section_3/sorted_cubes.hpp"

namespace {

using bench::Balls;
using support::Random;
using Ids = std::vector<uint32_t>;

int failures = 0;

void expect(bool holds, const std::string &what) {
  if (holds) return;
  ++failures;
  std::printf("FAILED: %s\n", what.c_str());
}

struct Query {
  std::vector<double> centre;
  double radius;
};

Ids by_library(const bench::Model &model, const Query &query) {
  Ids ids(model.size());
  uint32_t needed = 0;
  support::expect_ok(hsp_query_ball(model.get(), query.centre.data(), query.radius, ids.data(), model.size(), &needed),
                     "hsp_query_ball");
  ids.resize(needed);
  return ids;
}

template <class Structure>
Ids by_structure(const Structure &structure, const Query &query, uint32_t balls) {
  Ids ids(64 * size_t{balls} + 64);  // the paper's grid finds a ball once for each cube that it shares with the query
  bench::Hits hits{ids.data(), static_cast<uint32_t>(ids.size())};
  structure.meeting(query.centre.data(), query.radius, hits);
  ids.resize(hits.count);
  std::sort(ids.begin(), ids.end());
  return ids;
}

// Multiples of 1/4 are exact in binary and on the library's decimal lattice: ties of such numbers are ties for all
// structures.
double quarters(double value) {
  return std::round(4 * value) / 4;
}

std::vector<Query> queries_of(const bench::Model &model, bool tied) {
  std::vector<Query> queries;
  const double largest = model.largest_radius();
  const std::vector<double> points = bench::random_points_in_box(model, 60);
  for (size_t i = 0; i < points.size(); i += 3) {
    for (const double radius : {0.0, largest / 2, largest, 3.5 * largest}) {
      Query query{{points[i], points[i + 1], points[i + 2]}, radius};
      if (tied) {
        for (double &coordinate : query.centre) coordinate = quarters(coordinate);
        query.radius = quarters(query.radius);
      }
      queries.push_back(query);
    }
  }
  const std::vector<double> &xyz = model.balls().xyz;
  for (size_t i = 0; i < xyz.size(); i += 3 * (1 + xyz.size() / 300)) {
    for (const double radius : {0.0, tied ? quarters(largest) : largest}) {
      queries.push_back({{xyz[i], xyz[i + 1], xyz[i + 2]}, radius});
    }
  }
  for (const double far : {-1000.0, 1000.0}) {
    queries.push_back({{far, 0, 0}, largest});
    queries.push_back({{0, far, far}, largest});
    queries.push_back({{far, 0, 0}, 1500});
  }
  return queries;
}

template <class Structure>
void check_queries(const char *name, const Balls &balls, const bench::Model &model, bool tied, Structure &structure) {
  structure.build(balls);
  structure.build(balls);  // again, in the same memory
  for (const Query &query : queries_of(model, tied)) {
    const Ids expected = by_library(model, query);
    const Ids found = by_structure(structure, query, balls.size());
    expect(found == expected, std::string(name) + ", " + balls.name + ": " + std::to_string(found.size()) +
                                  " balls instead of " + std::to_string(expected.size()));
  }
}

template <class Directory>
void check_grid(const char *name, const Balls &balls, const bench::Model &model, bool tied) {
  bench::CentreGrid<Directory> grid;
  check_queries(name, balls, model, tied, grid);
  const uint64_t pairs = grid.count_pairs();
  expect(pairs == bench::query_all_neighbours(model),
         std::string(name) + ", " + balls.name + ": " + std::to_string(pairs) + " pairs");
}

void check(const Balls &balls, bool tied, bool dense = true) {
  const bench::Model model(balls, 0);
  const int before = failures;
  if (dense) {
    check_grid<bench::DenseCubes>("dense cubes", balls, model, tied);
  } else {
    bool refused = false;
    try {
      bench::CentreGrid<bench::DenseCubes>().build(balls);
    } catch (const std::length_error &) {
      refused = true;
    }
    expect(refused, "dense cubes, " + balls.name + ": not refused");
  }
  check_grid<bench::SortedCubes>("sorted cubes", balls, model, tied);
  check_grid<bench::DoubleHashing>("double hashing", balls, model, tied);
  check_grid<bench::PerfectHashing>("perfect hashing", balls, model, tied);
  bench::PaperGrid paper;
  check_queries("the paper's grid", balls, model, tied, paper);
  bench::RangeTree tree;
  check_queries("range tree", balls, model, tied, tree);
  std::printf("%-28s %6u balls  %s\n", balls.name.c_str(), balls.size(), failures == before ? "ok" : "FAILED");
}

Balls random_balls(const char *name, uint32_t n, double side, double least, double largest) {
  Random random(n);
  Balls balls;
  balls.name = name;
  const auto coordinate = [&] { return side * random.fraction(); };
  for (uint32_t i = 0; i < n; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    balls.add(x, y, z, least + (largest - least) * random.fraction());
  }
  return balls;
}

// Coordinates and radii in quarters, most of them several times; along some axes all may be equal.
Balls tied_balls(const char *name, uint32_t n, std::vector<double> sides) {
  Random random(n);
  Balls balls;
  balls.name = name;
  for (uint32_t i = 0; i < n; ++i) {
    std::vector<double> centre;
    for (const double side : sides) centre.push_back(quarters(side * random.fraction()));
    balls.add(centre[0], centre[1], centre[2], 0.25 * random.below(5));
  }
  balls.add(0, 0, 0, 1);
  return balls;
}

Balls lattice(uint32_t side, double radius) {
  Balls balls;
  balls.name = "touching lattice";
  for (uint32_t i = 0; i < side * side * side; ++i) balls.add(i % side, i / side % side, i / side / side, radius);
  return balls;
}

void test() {
  for (const bench::Molecule &molecule : bench::paper_molecules()) {
    if (molecule.atoms.size() < 1000) check(with_radii(molecule, bench::Radii::paper), false);
  }
  check(random_balls("one ball", 1, 1, 1, 1), false);
  check(random_balls("two balls", 2, 1, 1, 1), false);
  check(random_balls("few neighbours", 3000, 40, 0.5, 2), false);
  check(random_balls("many neighbours", 1000, 6, 0.1, 2), false);
  check(random_balls("small balls and large ones", 600, 30, 0.01, 6), false);
  check(random_balls("far apart", 300, 20000, 1, 2), false, false);
  check(lattice(9, 0.5), true);
  check(tied_balls("ties", 1500, {12, 12, 12}), true);
  check(tied_balls("ties in a plane", 500, {12, 0, 12}), true);
  check(tied_balls("ties on a line", 200, {0, 24, 0}), true);
  check(tied_balls("ties at a point", 100, {0, 0, 0}), true);
}

}  // namespace

int main() {
  test();
  return failures == 0 ? 0 : 1;
}
