// Power cells of the balls of one cube: their vertices are all points of three planes that are beyond no other plane,
// each joined to three others, and they are polyhedra by Euler. Doubles say of them what integers say.
#include "cells/power_cell.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "built_free_space.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"

namespace {

using hsp::no_id;
using hsp::PolytopeVertex;
using hsp::PowerPlane;
using oracle::Balls;

struct Seen {
  uint32_t cells = 0, empty = 0, several = 0, doubtful = 0, most_vertices = 0, most_parts = 0;
  uint32_t discs = 0, doubtful_discs = 0, apart = 0;
};

using Triple = std::array<uint32_t, 3>;

Triple sorted(const uint32_t *plane) {
  Triple triple{plane[0], plane[1], plane[2]};
  std::sort(triple.begin(), triple.end());
  return triple;
}

void check_graph(const hsp::PowerCell &cell) {
  const hsp::PowerPolytope &polytope = cell.polytope();
  std::set<uint32_t> planes;
  for (uint32_t v = 0; v < polytope.size(); ++v) {
    const PolytopeVertex &vertex = polytope[v];
    for (uint32_t k = 0; k < 3; ++k) {
      planes.insert(vertex.plane[k]);
      const PolytopeVertex &other = polytope[vertex.neighbour(k)];
      ASSERT_NE(vertex.neighbour(k), v);
      for (uint32_t l = 0; l < 3; ++l) ASSERT_EQ(other.has(vertex.plane[l]), l != k);
      uint32_t back = 0;
      for (uint32_t l = 0; l < 3; ++l) back += other.neighbour(l) == v ? 1U : 0U;
      ASSERT_EQ(back, 1U);
    }
  }
  // Of three edges at each vertex each is there twice.
  ASSERT_EQ(2 * (polytope.size() + planes.size()) - 3 * polytope.size(), 4U);
}

// All common points of three planes that are beyond none.
std::set<Triple> all_vertices(const hsp::BallSet &balls, const hsp::CubeFrame &frame, hsp::Span<const uint32_t> members,
                              uint32_t k) {
  const uint32_t ball = members[k];
  const hsp::PowerPredicates exact(balls, ball, frame);
  std::vector<uint32_t> numbers;
  for (uint32_t side = 0; side < 6; ++side) numbers.push_back(side);
  const auto plane = [&](uint32_t number) {
    return number < 6 ? hsp::side_plane(number) : PowerPlane{ball, members[number - 6]};
  };
  for (uint32_t m = 0; m < members.size(); ++m) {
    if (m == k) continue;
    if (hsp::exact::is_zero(balls.exact_difference(ball, members[m]))) {
      // One of the two is nowhere.
      const bool wins = balls.r[ball] != balls.r[members[m]] ? balls.r[ball] > balls.r[members[m]]
                                                             : balls.ranks_before(ball, members[m]);
      if (!wins) return {};
      continue;
    }
    numbers.push_back(6 + m);
  }
  std::set<Triple> found;
  const auto normal = [&](uint32_t number) -> oracle::Vector {
    if (number >= 6) {
      const auto v = balls.exact_difference(ball, members[number - 6]);
      return {v.x, v.y, v.z};
    }
    oracle::Vector v{0, 0, 0};
    v[number / 2] = number % 2 == 0 ? -1 : 1;
    return v;
  };
  for (const uint32_t a : numbers) {
    for (const uint32_t b : numbers) {
      for (const uint32_t c : numbers) {
        if (a >= b || b >= c) continue;
        if (oracle::dot(oracle::cross(normal(a), normal(b)), normal(c)) == 0) continue;
        bool inside = true;
        for (const uint32_t d : numbers) {
          if (d == a || d == b || d == c) continue;
          if (exact.side_of(plane(a), plane(b), plane(c), plane(d)) < 0) inside = false;
        }
        if (inside) found.insert({a, b, c});
      }
    }
  }
  return found;
}

// Whether a cell without vertices in its ball meets that, by integers alone: it has the centre, or a disc that a facet
// has as a whole.
void check_meeting(const hsp::BallSet &balls, const hsp::PowerCell &cell, Seen &seen) {
  const hsp::PolytopeVertex *const vertices = &cell.polytope()[0];
  const uint32_t size = cell.polytope().size();
  const hsp::PowerPredicates exact(balls, cell.ball(), cell.frame());
  std::set<uint32_t> planes;
  for (uint32_t v = 0; v < size; ++v) {
    for (uint32_t k = 0; k < 3; ++k) {
      planes.insert(vertices[v].plane[k]);
      if (cell.part_of(v) != no_id && cell.is_free_edge(v, k)) continue;
      ASSERT_TRUE(cell.meets_ball());
      return;
    }
  }
  const hsp::Vec3 centre = cell.frame().centre_of(balls, cell.ball());
  const double little = 1e-12 * cell.frame().side();
  bool centre_inside = true, disc_inside = false;
  for (const uint32_t number : planes) {
    const PowerPlane plane = cell.plane(number);
    centre_inside = centre_inside && exact.side_of_centre(plane) >= 0;
    if (!exact.meets_plane(plane)) continue;
    const hsp::UnitPlane &disc = cell.unit_plane(number);
    const hsp::Vec3 middle = centre + (disc.h - dot(disc.v, centre)) * disc.v;
    bool inside = true;
    for (uint32_t v = 0; v < size; ++v) {
      if (!vertices[v].has(number)) continue;
      for (const uint32_t other : vertices[v].plane) {
        if (other == number) continue;
        inside = inside && exact.side_of_disc(plane, cell.plane(other)) >= 0;
        const hsp::UnitPlane &border = cell.unit_plane(other);
        seen.doubtful_discs += std::fabs(dot(border.v, middle) - border.h) < little ? 1U : 0U;
      }
    }
    disc_inside = disc_inside || inside;
    seen.discs += !centre_inside && inside ? 1U : 0U;
  }
  ASSERT_EQ(cell.meets_ball(), centre_inside || disc_inside);
  seen.apart += centre_inside || disc_inside ? 0U : 1U;
}

// Of balls that are large enough.
void check(const Balls &balls, Seen &seen, int64_t least_radius = 0) {
  const BuiltFreeSpace built(balls);
  const hsp::CubeCover &cover = built.space().cover;
  hsp::PowerCell cell;
  CarvedMemory memory;
  memory.carve(cell, static_cast<uint32_t>(balls.size()));
  for (uint32_t cube = 0; cube < cover.cubes(); ++cube) {
    const hsp::CubeFrame frame(cover.cube(cube), built.grid().side());
    const auto members = cover.balls(cube);
    cell.enter(built.balls(), frame, members);
    cell.drop_dominated();
    for (uint32_t k = 0; k < members.size(); ++k) {
      if (built.balls().r[members[k]] < static_cast<double>(least_radius)) continue;
      cell.build(k);
      std::set<Triple> vertices;
      for (uint32_t v = 0; v < cell.polytope().size(); ++v) vertices.insert(sorted(cell.polytope()[v].plane));
      ASSERT_EQ(vertices.size(), cell.polytope().size());
      ASSERT_EQ(vertices, all_vertices(built.balls(), frame, members, k));
      ++(cell.empty() ? seen.empty : seen.cells);
      if (cell.empty()) continue;
      ASSERT_NO_FATAL_FAILURE(check_graph(cell));
      cell.find_free_parts();
      ASSERT_NO_FATAL_FAILURE(check_meeting(built.balls(), cell, seen));
      seen.several += cell.parts() > 1 ? 1U : 0U;
      seen.most_vertices = std::max(seen.most_vertices, cell.polytope().size());
      seen.most_parts = std::max(seen.most_parts, cell.parts());
      const hsp::PowerPredicates exact(built.balls(), members[k], frame);
      for (uint32_t v = 0; v < cell.polytope().size(); ++v) {
        const PolytopeVertex &vertex = cell.polytope()[v];
        std::array<PowerPlane, 3> plane{};
        for (uint32_t l = 0; l < 3; ++l) plane[l] = cell.plane(vertex.plane[l]);
        ASSERT_EQ(cell.part_of(v) != no_id, exact.is_outside(plane[0], plane[1], plane[2]));
        seen.doubtful += cell.polytope().at(v).error == hsp::no_certainty ? 1U : 0U;
        for (uint32_t l = 0; l < 3; ++l) {
          const uint32_t w = vertex.neighbour(l);
          if (cell.part_of(v) == no_id || cell.part_of(w) == no_id) {
            ASSERT_FALSE(cell.is_free_edge(v, l));
            continue;
          }
          uint32_t other = 0;
          while (vertex.has(cell.polytope()[w].plane[other])) ++other;
          const bool is_free = exact.is_free(plane[(l + 1) % 3], plane[(l + 2) % 3], plane[l],
                                             cell.plane(cell.polytope()[w].plane[other]));
          ASSERT_EQ(cell.is_free_edge(v, l), is_free);
          if (is_free) {
            ASSERT_EQ(cell.part_of(v), cell.part_of(w));
          }
        }
      }
    }
  }
}

TEST(PowerCell, HasAllItsVertices) {
  oracle::RandomSource random(1);
  Seen seen;
  for (int k = 0; k < 100; ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 9)));
    ASSERT_NO_FATAL_FAILURE(check(balls, seen)) << oracle::to_text(balls);
  }
  for (const int64_t radius : {50, 71, 87}) {
    ASSERT_NO_FATAL_FAILURE(check(oracle::box_lattice({2, 2, 2}, {100, 100, 100}, radius), seen));
  }
  EXPECT_GT(seen.cells, 1000U);
  EXPECT_GT(seen.empty, 100U);
  EXPECT_GT(seen.several, 50U);
  EXPECT_GT(seen.discs, 10U);
  EXPECT_GT(seen.doubtful_discs, 10U);
  EXPECT_GT(seen.apart, 10U);
}

// Balls around one, in a cube whose side another ball far away decides.
Balls studded(int around, int64_t radius) {
  Balls balls{{1200, 1200, 1200, 1000}, {20000, 1200, 1200, 1200}};
  for (int k = 0; k < around; ++k) {
    const double z = (2 * k + 1.0) / around - 1, turn = 2.39996 * k, flat = std::sqrt(1 - z * z);
    const auto along = [](double part) { return 1200 + std::llround(1000 * part); };
    balls.push_back({along(flat * std::cos(turn)), along(flat * std::sin(turn)), along(z), radius});
  }
  return balls;
}

// More than 64 vertices: what is found as bits takes several words then. Where the balls are larger, only corners of
// the cell are outside the ball.
TEST(PowerCell, HasManyVertices) {
  Seen seen;
  for (const int64_t radius : {100, 320}) ASSERT_NO_FATAL_FAILURE(check(studded(38, radius), seen, 1000));
  EXPECT_GT(seen.most_vertices, 64U);
  EXPECT_GT(seen.most_parts, 30U);
}

// So many that their planes are put in order: a closed graph of which no vertex is beyond a plane.
TEST(PowerCell, HasManyNeighbours) {
  const BuiltFreeSpace built(studded(400, 60));
  const hsp::CubeCover &cover = built.space().cover;
  hsp::PowerCell cell;
  CarvedMemory memory;
  memory.carve(cell, built.balls().n);
  uint32_t checked = 0;
  for (uint32_t cube = 0; cube < cover.cubes(); ++cube) {
    const auto members = cover.balls(cube);
    if (members.size() < 200) continue;
    cell.enter(built.balls(), hsp::CubeFrame(cover.cube(cube), built.grid().side()), members);
    cell.drop_dominated();
    for (uint32_t k = 0; k < members.size(); k += 40) {
      cell.build(k);
      if (cell.empty()) continue;
      ASSERT_NO_FATAL_FAILURE(check_graph(cell));
      const hsp::PowerPredicates exact(built.balls(), members[k], cell.frame());
      for (uint32_t v = 0; v < cell.polytope().size(); ++v) {
        const PolytopeVertex &vertex = cell.polytope()[v];
        for (uint32_t other = 0; other < 6 + members.size(); ++other) {
          if (other == 6 + k || vertex.has(other)) continue;
          ASSERT_GE(exact.side_of(cell.plane(vertex.plane[0]), cell.plane(vertex.plane[1]), cell.plane(vertex.plane[2]),
                                  cell.plane(other)),
                    0);
        }
      }
      ++checked;
    }
  }
  EXPECT_GT(checked, 5U);
}

}  // namespace
