// The self-check of a topology finds what is wrong: one record of a correct topology at a time is spoilt, and the
// invariant that it violates is named, with the id where it does. Through the interface a topology is never wrong, so
// that this is the only way to see these answers.
#include "topology/topology_check.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "boundary/half_edge_links.hpp"
#include "built_topology.hpp"
#include "point_lattices.hpp"
#include "set_arrangements.hpp"
#include "topology/shell_volumes.hpp"

namespace {

using hsp::sym;
using hsp::Topology;
using hsp::TopologyInvariant;
using hsp::TopologyViolation;

// A cage of 30 balls with a void (all integer points at distance 3, times 1000), and in the void a lens of two balls; a
// ball with three bumps, whose face with three loops is cut; a ball on its own; a second cage of six with a void.
oracle::Balls scene() {
  oracle::Balls balls = oracle::balls_on_sphere(3, 1000, 1900);
  balls.push_back({0, 0, 0, 300});
  balls.push_back({0, 200, 100, 250});
  balls.push_back({20000, 0, 0, 1000});
  balls.push_back({21000, 0, 0, 100});
  balls.push_back({20000, 1000, 0, 150});
  balls.push_back({20000, 600, 800, 120});
  balls.push_back({0, 20000, 0, 777});
  return joined(balls, oracle::moved(oracle::balls_on_sphere(1, 1000, 850), {0, 0, 20000}));
}

TopologyViolation checked(BuiltTopology &built) {
  const TopologyViolation violation = check_topology(built.boundary(), built.structure(), built.marks());
  if (violation.invariant != TopologyInvariant::none) return violation;
  return check_enclosed_volumes(built.balls(), built.boundary(), built.structure());
}

// Where to spoil: somewhere in the middle of each table.
uint32_t some_edge(BuiltTopology &built) {
  return built.structure().quads.edges / 2;
}
uint32_t extra_edge(BuiltTopology &built) {
  return built.structure().first_cut_edge;
}
uint32_t void_shell(BuiltTopology &built) {
  uint32_t s = 0;
  while (!built.structure().shells[s].is_void) ++s;
  return s;
}
uint32_t lonely_shell(BuiltTopology &built) {
  uint32_t s = 0;
  while (built.structure().shells[s].faces != 1) ++s;
  return s;
}
// The component in the first void.
uint32_t inner_component(BuiltTopology &built) {
  uint32_t c = 0;
  while (built.structure().components[c].region == 0) ++c;
  return c;
}

struct Flaw {
  const char *name;
  TopologyInvariant invariant;
  // Spoils the topology and returns where the invariant is violated.
  std::function<uint32_t(BuiltTopology &)> make;
};

constexpr uint32_t anywhere = hsp::no_id;

const std::vector<Flaw> flaws = {
    {"a step to an edge that is not there", TopologyInvariant::algebra,
     [](BuiltTopology &b) {
       const uint32_t q = hsp::quarter_edge(b.structure().quads.edges - 1) + 3;
       b.structure().quads.next[q] = 4 * b.structure().quads.edges;
       return anywhere;
     }},
    {"a first step to an edge that is not there", TopologyInvariant::algebra,
     [](BuiltTopology &b) {
       b.structure().quads.next[0] = 4 * b.structure().quads.edges;
       return 0U;
     }},
    {"a step from a vertex to a face", TopologyInvariant::algebra,
     [](BuiltTopology &b) {
       b.structure().quads.next[0] = hsp::rot(b.structure().quads.next[0]);
       return 0U;
     }},
    {"two rings exchanged", TopologyInvariant::algebra,
     [](BuiltTopology &b) {
       std::swap(b.structure().quads.next[0], b.structure().quads.next[sym(0)]);
       return 0U;
     }},
    {"an edge that starts elsewhere", TopologyInvariant::algebra,
     [](BuiltTopology &b) {
       const uint32_t q = hsp::quarter_edge(some_edge(b));
       b.structure().quads.start[q] = b.structure().quads.start[q] == 0 ? 1 : 0;
       return anywhere;
     }},
    {"an edge with another face on its left", TopologyInvariant::algebra,
     [](BuiltTopology &b) {
       uint32_t &left = b.structure().quads.start[hsp::quarter_edge(some_edge(b)) + 3];
       left = left == 0 ? 1 : 0;
       return anywhere;
     }},
    {"a vertex that is not there", TopologyInvariant::vertices,
     [](BuiltTopology &b) {
       const uint32_t q = hsp::quarter_edge(some_edge(b)) + 2;
       const uint32_t vertex = b.structure().quads.start[q];
       uint32_t at = q;
       uint32_t first = q;
       do {
         b.structure().quads.start[at] = b.structure().vertex_count + vertex;
         at = b.structure().quads.onext(at);
         // Edges are looked at in order, each first forwards.
         if (at / 4 < first / 4 || (at / 4 == first / 4 && at < first)) first = at;
       } while (at != q);
       return first;
     }},
    {"one vertex of two rings", TopologyInvariant::vertices,
     [](BuiltTopology &b) {
       // All that starts at vertex 1 is said to start at vertex 0.
       const uint32_t q = b.structure().vertex_edge[1];
       uint32_t at = q;
       do {
         b.structure().quads.start[at] = 0;
         at = b.structure().quads.onext(at);
       } while (at != q);
       return 0U;
     }},
    {"a vertex without an edge", TopologyInvariant::vertices,
     [](BuiltTopology &b) {
       b.structure().vertex_edge[b.structure().vertex_count] = 0;
       return b.structure().vertex_count++;
     }},
    {"a vertex with the edge of another", TopologyInvariant::vertices,
     [](BuiltTopology &b) {
       std::swap(b.structure().vertex_edge[3], b.structure().vertex_edge[5]);
       return 3U;
     }},
    {"a vertex that starts a dual edge", TopologyInvariant::vertices,
     [](BuiltTopology &b) {
       b.structure().vertex_edge[2] = hsp::rot(b.structure().vertex_edge[2]);
       return 2U;
     }},
    {"a vertex that starts an edge that is not there", TopologyInvariant::vertices,
     [](BuiltTopology &b) {
       b.structure().vertex_edge[4] = 4 * b.structure().quads.edges;
       return 4U;
     }},
    {"a simple face of a face that is not there", TopologyInvariant::faces,
     [](BuiltTopology &b) {
       b.structure().faces[7].face = b.boundary().face_count();
       return 7U;
     }},
    {"a simple face on an edge that is not there", TopologyInvariant::faces,
     [](BuiltTopology &b) {
       b.structure().faces[8].q = 4 * b.structure().quads.edges;
       return 8U;
     }},
    {"a simple face with the edge of another", TopologyInvariant::faces,
     [](BuiltTopology &b) {
       b.structure().faces[9].q = sym(b.structure().faces[9].q);
       return 9U;
     }},
    {"a simple face with an edge too many", TopologyInvariant::faces,
     [](BuiltTopology &b) {
       ++b.structure().faces[6].edges;
       return 6U;
     }},
    {"a simple face with an edge too few", TopologyInvariant::faces,
     [](BuiltTopology &b) {
       --b.structure().faces[6].edges;
       return 6U;
     }},
    {"a simple face counted twice around", TopologyInvariant::faces,
     [](BuiltTopology &b) {
       b.structure().faces[5].edges *= 2;
       return 5U;
     }},
    {"a simple face of one edge", TopologyInvariant::faces,
     [](BuiltTopology &b) {
       b.structure().faces[5].edges = 1;
       return 5U;
     }},
    {"a simple face left out", TopologyInvariant::faces,
     [](BuiltTopology &b) {
       --b.structure().face_count;
       return anywhere;
     }},
    {"a simple face of two rings, one of them another face's far away", TopologyInvariant::faces,
     [](BuiltTopology &b) {
       const uint32_t last = b.structure().face_count - 1;
       for (uint32_t q = 0; q < 4 * b.structure().quads.edges; q += 2) {
         uint32_t &left = b.structure().quads.start[hsp::inverse_rot(q)];
         if (left == last) left = 0;
       }
       return --b.structure().face_count;
     }},
    {"a simple face with one face on both sides of an edge", TopologyInvariant::faces,
     [](BuiltTopology &b) {
       // The two simple faces of the ball on its own, said to be one of two rings.
       const uint32_t last = hsp::quarter_edge(b.structure().quads.edges - 1);
       const uint32_t kept = b.structure().quads.left(last);
       const uint32_t gone = b.structure().quads.left(sym(last));
       for (uint32_t q = 0; q < 4 * b.structure().quads.edges; q += 2) {
         uint32_t &left = b.structure().quads.start[hsp::inverse_rot(q)];
         if (left == gone) left = kept;
       }
       return std::min(kept, gone);
     }},
    {"an arc with its sides exchanged", TopologyInvariant::sides,
     [](BuiltTopology &b) {
       // Named by its half-edge on its other ball.
       const uint32_t half_edge = b.structure().host_of_arc[2];
       b.structure().host_of_arc[2] = b.boundary().twin(half_edge);
       uint32_t edge = 0;
       while (b.structure().edge_source[edge] != 2) ++edge;
       return hsp::quarter_edge(edge);
     }},
    {"an edge of another arc", TopologyInvariant::sides,
     [](BuiltTopology &b) {
       b.structure().edge_source[0] = b.structure().edge_source[b.structure().first_circle_edge - 1];
       return 0U;
     }},
    {"an edge of another circle", TopologyInvariant::sides,
     [](BuiltTopology &b) {
       const uint32_t first = b.structure().first_circle_edge;
       b.structure().edge_source[first] = b.structure().edge_source[b.structure().first_cut_edge - 1];
       return hsp::quarter_edge(first);
     }},
    {"a cut edge between two faces", TopologyInvariant::sides,
     [](BuiltTopology &b) {
       const uint32_t face = b.structure().quads.left(hsp::quarter_edge(extra_edge(b)));
       b.structure().faces[face].face = b.boundary().face_count() - 1 - b.structure().faces[face].face;
       return anywhere;
     }},
    {"a shell with a vertex too many", TopologyInvariant::euler,
     [](BuiltTopology &b) {
       ++b.structure().shells[1].vertices;
       return 1U;
     }},
    {"a shell with an edge too many", TopologyInvariant::euler,
     [](BuiltTopology &b) {
       ++b.structure().shells[2].edges;
       return 2U;
     }},
    {"a shell with a simple face too few", TopologyInvariant::euler,
     [](BuiltTopology &b) {
       --b.structure().shells[0].simple_faces;
       return 0U;
     }},
    {"two surfaces whose faces are counted for one", TopologyInvariant::euler,
     [](BuiltTopology &b) {
       const uint32_t lonely = lonely_shell(b);
       for (uint32_t f = 0; f < b.boundary().face_count(); ++f) {
         if (b.boundary().face(f).shell == lonely) b.boundary_arrays().faces[f].shell = lonely == 0 ? 1 : 0;
       }
       return std::min(lonely, lonely == 0 ? 1U : 0U);
     }},
    {"a face visited twice", TopologyInvariant::traversal,
     [](BuiltTopology &b) {
       const uint32_t first = b.structure().shells[0].first_traversed;
       b.structure().traversal[first + 1] = b.structure().traversal[first];
       return 0U;
     }},
    {"a face of another shell visited", TopologyInvariant::traversal,
     [](BuiltTopology &b) {
       std::swap(b.structure().traversal[b.structure().shells[0].first_traversed + 1],
                 b.structure().traversal[b.structure().shells[1].first_traversed + 1]);
       return 0U;
     }},
    {"a face visited that is not there", TopologyInvariant::traversal,
     [](BuiltTopology &b) {
       b.structure().traversal[b.structure().shells[1].first_traversed + 1] = b.structure().face_count;
       return 1U;
     }},
    {"a scan that starts elsewhere", TopologyInvariant::traversal,
     [](BuiltTopology &b) {
       const uint32_t first = b.structure().shells[0].first_traversed;
       b.structure().shells[0].start_face = b.structure().traversal[first + 1];
       return 0U;
     }},
    {"a scan that ends beyond the table", TopologyInvariant::traversal,
     [](BuiltTopology &b) {
       const uint32_t last = b.structure().shell_count - 1;
       ++b.structure().shells[last].first_traversed;
       return last;
     }},
    {"a shell of no component", TopologyInvariant::regions,
     [](BuiltTopology &b) {
       b.structure().shells[1].component = b.structure().component_count;
       return 1U;
     }},
    {"a shell of another component", TopologyInvariant::regions,
     [](BuiltTopology &b) {
       const uint32_t lonely = lonely_shell(b);
       uint32_t &component = b.structure().shells[lonely].component;
       component = component == 0 ? 1 : 0;
       return lonely;
     }},
    {"a shell beside no region", TopologyInvariant::regions,
     [](BuiltTopology &b) {
       b.structure().shells[1].region = b.structure().region_count;
       return 1U;
     }},
    {"a void's shell beside another region", TopologyInvariant::regions,
     [](BuiltTopology &b) {
       b.structure().shells[void_shell(b)].region = 0;
       return void_shell(b);
     }},
    {"an outer shell beside another region than its component", TopologyInvariant::regions,
     [](BuiltTopology &b) {
       const uint32_t shell = b.structure().components[0].outer_shell;
       b.structure().shells[shell].region = b.structure().shells[shell].region == 0 ? 1 : 0;
       return shell;
     }},
    {"a component with two outer shells", TopologyInvariant::regions,
     [](BuiltTopology &b) {
       const uint32_t shell = void_shell(b);
       b.structure().shells[shell].is_void = false;
       return shell;
     }},
    {"a region without an enclosing shell", TopologyInvariant::regions,
     [](BuiltTopology &b) {
       ++b.structure().region_count;
       return b.structure().shell_count;
     }},
    {"a component without a shell", TopologyInvariant::regions,
     [](BuiltTopology &b) {
       ++b.structure().component_count;
       return b.structure().shell_count;
     }},
    {"a component in its own void", TopologyInvariant::regions,
     [](BuiltTopology &b) {
       const uint32_t component = b.structure().shells[void_shell(b)].component;
       const uint32_t region = b.structure().shells[void_shell(b)].region;
       b.structure().components[component].region = region;
       b.structure().shells[b.structure().components[component].outer_shell].region = region;
       // The component inside hangs on the same ring; the first of the two is named.
       return std::min(component, inner_component(b));
     }},
};

TEST(TopologyCheck, FindsNothingInACorrectTopology) {
  BuiltTopology built(scene());
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const Topology &topology = built.structure();
  ASSERT_EQ(topology.component_count, 5U);
  ASSERT_EQ(topology.region_count, 3U);
  ASSERT_EQ(topology.shell_count, 7U);
  ASSERT_GT(topology.cut_arcs.size(), 2U);
  ASSERT_GT(topology.first_circle_edge, 100U);
  ASSERT_GE(topology.first_cut_edge - topology.first_circle_edge, 8U);
  ASSERT_EQ(topology.quads.edges - topology.first_sphere_edge, 2U);
  EXPECT_EQ(checked(built).invariant, TopologyInvariant::none);
}

TEST(TopologyCheck, FindsEveryFlaw) {
  for (const Flaw &flaw : flaws) {
    SCOPED_TRACE(flaw.name);
    BuiltTopology built(scene());
    ASSERT_EQ(built.status(), hsp::Status::ok);
    const uint32_t where = flaw.make(built);
    const TopologyViolation violation = checked(built);
    EXPECT_EQ(violation.invariant, flaw.invariant);
    if (where != anywhere) {
      EXPECT_EQ(violation.id, where);
    }
  }
}

// Any single number of the table of steps is needed: whatever stands there instead breaks the algebra.
TEST(TopologyCheck, FindsEveryWrongStep) {
  BuiltTopology built(scene());
  hsp::QuadEdges &quads = built.structure().quads;
  for (uint32_t q = 0; q < 4 * quads.edges; ++q) {
    const uint32_t right = quads.next[q];
    for (const uint32_t wrong : {q, sym(q), right ^ 1U, sym(right), (right + 4) % (4 * quads.edges)}) {
      if (wrong == right) continue;
      quads.next[q] = wrong;
      EXPECT_EQ(checked(built).invariant, TopologyInvariant::algebra) << q << ": " << wrong << " instead of " << right;
      quads.next[q] = right;
    }
  }
  EXPECT_EQ(checked(built).invariant, TopologyInvariant::none);
}

// One number at a time is wrong, of each record in turn: the first and the last ones count, too.
template <class Number>
void expect_flaw(BuiltTopology &built, Number &number, const Number &wrong, TopologyInvariant invariant, uint32_t id) {
  const Number right = std::exchange(number, wrong);
  const TopologyViolation violation = checked(built);
  EXPECT_EQ(violation.invariant, invariant);
  EXPECT_EQ(violation.id, id);
  number = right;
}

TEST(TopologyCheck, FindsEveryEdgeOfAnotherArc) {
  BuiltTopology built({{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}});
  Topology &topology = built.structure();
  const uint32_t edges = topology.quads.edges;
  ASSERT_EQ(topology.first_circle_edge, edges);
  for (uint32_t e = 0; e < edges; ++e) {
    expect_flaw(built, topology.edge_source[e], topology.edge_source[(e + 1) % edges], TopologyInvariant::sides,
                hsp::quarter_edge(e));
  }
}

TEST(TopologyCheck, FindsEveryWrongShell) {
  BuiltTopology built(scene());
  Topology &topology = built.structure();
  for (uint32_t s = 0; s < topology.shell_count; ++s) {
    hsp::ShellRecord &shell = topology.shells[s];
    expect_flaw(built, shell.vertices, shell.vertices + 1, TopologyInvariant::euler, s);
    expect_flaw(built, shell.component, topology.component_count, TopologyInvariant::regions, s);
    for (uint32_t k = 0; k < shell.simple_faces; ++k) {
      expect_flaw(built, topology.traversal[shell.first_traversed + k], topology.face_count,
                  TopologyInvariant::traversal, s);
    }
  }
}

TEST(TopologyCheck, FindsEveryComponentInItsOwnVoid) {
  const oracle::Balls cage = oracle::balls_on_sphere(1, 1000, 850);
  BuiltTopology built(joined(joined(cage, oracle::moved(cage, {0, 0, 20000})), oracle::moved(cage, {0, 0, 40000})));
  Topology &topology = built.structure();
  ASSERT_EQ(topology.region_count, 4U);
  uint32_t voids = 0;
  for (uint32_t s = 0; s < topology.shell_count; ++s) {
    if (!topology.shells[s].is_void) continue;
    ++voids;
    const uint32_t c = topology.shells[s].component, region = topology.shells[s].region;
    topology.components[c].region = region;
    expect_flaw(built, topology.shells[topology.components[c].outer_shell].region, region, TopologyInvariant::regions,
                c);
    topology.components[c].region = 0;
  }
  EXPECT_EQ(voids, 3U);
}

}  // namespace
