// The arrays of a topology are as long as their indices run, for every limit, and sets that need exactly what they are
// given fill them to the end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "built_topology.hpp"
#include "point_lattices.hpp"
#include "random_balls.hpp"
#include "stopped_at.hpp"
#include "topology/topology_builder.hpp"
#include "topology/topology_check.hpp"

namespace {

using hsp::Topology;
using hsp::TopologyLimits;

template <class Look>
void with_structure(const TopologyLimits &limits, Look look) {
  Topology structure;
  CarvedMemory memory;
  memory.carve(structure, limits);
  look(structure);
}

TEST(TopologyMemory, ArraysAreAsLongAsTheirIndices) {
  for (const uint32_t balls : {0U, 1U, 2U, 17U}) {
    for (const uint32_t edges : {0U, 2U, 3U, 16U, 41U}) {
      for (const uint32_t extra : {0U, 1U, 13U}) {
        for (const uint32_t shells : {0U, 1U, 5U, 1000U}) {
          with_structure({balls, balls, edges, extra, shells}, [&](const Topology &structure) {
            EXPECT_EQ(structure.cut_arcs.capacity(), extra);
            EXPECT_EQ(structure.cut_first_edge.size(), extra);
            EXPECT_EQ(structure.quads.next.size(), 4 * edges);
            EXPECT_EQ(structure.quads.start.size(), 4 * edges);
            // Arcs have a use on either side and are an edge each; of free circles there are two halves, an edge each.
            EXPECT_GE(structure.chain.size(), 2 * edges);
            EXPECT_GE(structure.shared.size(), 2 * edges);
            EXPECT_GE(structure.host_of_arc.size(), edges);
            EXPECT_GE(structure.edge_source.size(), edges);
            EXPECT_GE(structure.vertex_edge.size(), edges);
            EXPECT_GE(structure.traversal.size(), edges);
            EXPECT_GE(structure.marks.size(), edges);
            const uint32_t most = shells == 0 ? edges / 2 : std::min(shells, edges / 2);
            EXPECT_EQ(structure.shells.size(), most);
            EXPECT_EQ(structure.components.size(), std::min(balls, most));
            // A lens: as many simple faces as edges. A whole sphere: two poles for two edges.
            EXPECT_GE(structure.faces.size(), std::min(edges, 2 * most));
            EXPECT_GE(structure.pole.size(), std::min(edges, 2 * most));
            if (shells == 0) {
              EXPECT_EQ(structure.faces.size(), edges);
            }
            EXPECT_LE(structure.faces.size(), edges);
            EXPECT_LE(structure.pole.size(), edges);
          });
        }
      }
    }
  }
}

void expect_within_arrays(BuiltTopology &built) {
  const Topology &structure = built.structure();
  EXPECT_EQ(structure.quads.edges, built.builder().needed().edges);
  EXPECT_LE(structure.vertex_count, structure.vertex_edge.size());
  EXPECT_LE(structure.vertex_count - structure.first_pole, structure.pole.size());
  EXPECT_LE(structure.face_count, structure.faces.size());
  EXPECT_LE(structure.shell_count, structure.shells.size());
  EXPECT_LE(structure.component_count, structure.components.size());
  EXPECT_LE(built.boundary().half_edge_count() + 2 * built.boundary().circle_count(), structure.chain.size());
  // In proportion: with few shells there is less room.
  EXPECT_EQ(structure.shell_count, structure.shells.size());
  EXPECT_LE(structure.subdivision.size() - structure.subdivision.first_inner(), 2 * structure.cut_arcs.size());
  EXPECT_LE(structure.region_count, built.marks().size() + 1);
  EXPECT_LE(structure.vertex_count, built.marks().size());
}

TEST(TopologyMemory, SetsFillWhatTheyNeed) {
  // Nothing but whole spheres: as many shells as there may be. Nothing but lenses: as many vertices.
  oracle::Balls apart, lenses;
  for (int k = 0; k < 20; ++k) {
    apart.push_back({100 * k, 7 * k, 0, 3});
    lenses.push_back({100 * k, 0, 0, 10});
    lenses.push_back({100 * k + 12, 0, 5, 10});
  }
  for (const auto &balls : {oracle::Balls{}, apart, lenses, {{0, 0, 0, 0}}}) {
    BuiltTopology built(balls);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    expect_within_arrays(built);
  }
  oracle::RandomSource random(1);
  for (int k = 0; k < 200; ++k) {
    BuiltTopology built(oracle::any_balls(random, static_cast<std::size_t>(random.in(1, 20))));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    expect_within_arrays(built);
  }
}

// Zero shells are as many as the edges allow, and stay so.
TEST(TopologyLimits, CoverShells) {
  const TopologyLimits any{4, 3, 21, 2, 0};
  const TopologyLimits two{4, 3, 21, 2, 2};
  EXPECT_EQ(any.most_shells(), 10U);
  EXPECT_EQ(two.most_shells(), 2U);
  EXPECT_EQ(covering(any, {5, 3, 30, 2, 7}).shells, 0U);
  EXPECT_EQ(covering(two, {5, 3, 30, 2, 7}).shells, 7U);
  EXPECT_EQ(covering(two, {5, 3, 30, 2, 0}).shells, 2U);
  EXPECT_EQ(two.most_poles(), 6U);
  EXPECT_EQ(two.most_simple_faces(), 15U);
  EXPECT_EQ(any.most_simple_faces(), 21U);
}

// A whole sphere, a lens, and a ball with three studs, whose face has three loops.
TEST(TopologyLimits, ForOneBoundary) {
  BuiltTopology built(oracle::Balls{{0, 0, 0, 1000},
                                    {1000, 0, 0, 100},
                                    {0, 1000, 0, 100},
                                    {0, 0, -1000, 100},
                                    {5000, 0, 0, 500},
                                    {5600, 0, 0, 500},
                                    {9000, 0, 0, 500}});
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const TopologyLimits limits = hsp::limits_for(built.balls(), built.boundary(), 3);
  EXPECT_EQ(limits.balls, 7U);
  EXPECT_EQ(limits.neighbours, 3U);
  EXPECT_EQ(limits.cut_arcs, 4U * 2);
  EXPECT_EQ(limits.shells, 3U);
  EXPECT_EQ(limits.edges, 2U * 3 + 2 + 2 + 4 * limits.cut_arcs);
  EXPECT_LE(built.builder().needed().edges, limits.edges);
  EXPECT_LE(built.builder().needed().cut_arcs, limits.cut_arcs);
}

// Of thousands of loops great circles cross more: balls in a spiral, all close to each other, on a large one.
TEST(TopologyLimits, OfThousandsOfLoops) {
  constexpr int studs = 3000;
  constexpr double large = 1e6, pi = 3.14159265358979323846;
  const double small = 0.9 * large / std::sqrt(studs);
  oracle::Balls balls{{0, 0, 0, static_cast<int64_t>(large)}};
  for (int k = 0; k < studs; ++k) {
    const double up = (2.0 * k + 1) / studs - 1, angle = pi * (3 - std::sqrt(5.0)) * k;
    const double flat = large * std::sqrt(1 - up * up);
    balls.push_back({static_cast<int64_t>(flat * std::cos(angle)), static_cast<int64_t>(flat * std::sin(angle)),
                     static_cast<int64_t>(large * up), static_cast<int64_t>(small)});
  }
  BuiltTopology built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const TopologyLimits limits = hsp::limits_for(built.balls(), built.boundary(), studs);
  EXPECT_EQ(limits.cut_arcs, 5U * (studs - 1));
  EXPECT_GT(built.builder().needed().cut_arcs, 4U * (studs - 1));
  EXPECT_LE(built.builder().needed().cut_arcs, limits.cut_arcs);
  EXPECT_LE(built.builder().needed().edges, limits.edges);
}

// The left face of a loop's start is the first of the parts that its maximal face is cut into, if the loop is the
// first.
TEST(Topology, StartsOfLoops) {
  oracle::RandomSource random(2);
  uint32_t cut_faces = 0;
  for (int k = 0; k < 300; ++k) {
    BuiltTopology built(oracle::any_balls(random, static_cast<std::size_t>(random.in(2, 20))));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const Topology &topology = built.structure();
    const hsp::Boundary &boundary = built.boundary();
    for (uint32_t loop = 0; loop < boundary.loop_count(); ++loop) {
      const uint32_t q = topology.start_of_loop(boundary, loop);
      EXPECT_EQ(topology.faces[topology.quads.left(q)].face, boundary.face_of_loop(loop));
    }
    std::vector<uint32_t> first_part(boundary.face_count(), hsp::no_id);
    for (uint32_t simple = topology.face_count; simple-- > 0;) first_part[topology.faces[simple].face] = simple;
    for (uint32_t face = 0; face < boundary.face_count(); ++face) {
      const hsp::IdRange loops = boundary.loops_of_face(face);
      if (loops.empty()) continue;
      EXPECT_EQ(topology.quads.left(topology.start_of_loop(boundary, loops.first)), first_part[face]);
      cut_faces += loops.size() > 1 ? 1U : 0U;
    }
  }
  EXPECT_GT(cut_faces, 100U);
}

TEST(ShellRecord, EulerCharacteristicAndGenus) {
  hsp::ShellRecord shell{};
  shell.vertices = 8;
  shell.edges = 12;
  shell.simple_faces = 6;
  EXPECT_EQ(shell.euler(), 2);
  EXPECT_EQ(shell.genus(), 0U);
  shell.edges = 20;
  EXPECT_EQ(shell.euler(), -6);
  EXPECT_EQ(shell.genus(), 4U);
}

void expect_stops(const oracle::Balls &balls, uint32_t last) {
  BuiltTopology built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  expect_stops_at_questions(3, last,
                            [&](const hsp::Executor &executor) { return built.build_again(hsp::Patience(&executor)); });
  EXPECT_EQ(check_topology(built.boundary(), built.structure(), built.marks()).invariant, hsp::TopologyInvariant::none);
}

// Of a void and many components it is to be found which are in it.
TEST(TopologyBuilder, StopsBetweenComponents) {
  oracle::Balls balls = oracle::balls_on_sphere(1, 1000, 850);
  for (int k = 0; k < 600; ++k) balls.push_back({5000 + 300 * k, 40 * k, 10 * k, 100});
  expect_stops(balls, 8);
}

// So many that one shell is visited in parts.
TEST(TopologyBuilder, StopsWithinAShell) {
  expect_stops(long_row(6500), 2);
}

}  // namespace
