// The self-check finds what is wrong: one record of a correct boundary at a time is spoilt, and the law that it breaks
// is named, with the place where it fails. Through the interface a boundary is never wrong, so that this is the only
// way to see these answers.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <utility>

#include "built_boundary.hpp"
#include "measure/boundary_metric_check.hpp"
#include "boundary/shells.hpp"
#include "boundary/boundary_check.hpp"

namespace {

using hsp::BoundaryLaw;
using hsp::BoundaryStructure;

// Three balls with two common points and a fourth that cuts a free circle out of the first; a pair apart from them; a
// ball on its own; one inside another.
const std::vector<TestBall> scene = {{0, 0, 0, 1000},     {1000, 0, 0, 1000},   {500, 800, 0, 1000},
                                     {-1500, 0, 0, 600},  {9000, 0, 0, 500},    {9600, 0, 0, 500},
                                     {0, 20000, 0, 1000}, {0, 20000, 100, 300}, {0, 900, 20000, 1000}};

struct Flaw {
  const char *name;
  BoundaryLaw law;
  // Spoils the structure and returns where the law fails.
  std::function<uint32_t(BuiltBoundary &)> make;
};

// The use by which the first ball of the first vertex visits it.
hsp::VertexUse &first_visit(BuiltBoundary &boundary) {
  return boundary.structure().uses[boundary.structure().use_at[0]];
}
uint32_t ball_with_faces(BuiltBoundary &boundary, uint32_t caller) {
  const uint32_t ball = boundary.place(caller);
  EXPECT_LT(boundary.structure().first_face[ball], boundary.structure().first_face[ball + 1]);
  return ball;
}

constexpr uint32_t anywhere = hsp::no_id;

const std::vector<Flaw> flaws = {
    {"a vertex of equal balls", BoundaryLaw::vertices,
     [](BuiltBoundary &b) {
       b.structure().vertices[1].ball[1] = b.structure().vertices[1].ball[0];
       return 1U;
     }},
    {"a vertex of balls out of order", BoundaryLaw::vertices,
     [](BuiltBoundary &b) {
       std::swap(b.structure().vertices[1].ball[1], b.structure().vertices[1].ball[2]);
       return 1U;
     }},
    {"a vertex of a ball that is not there", BoundaryLaw::vertices,
     [](BuiltBoundary &b) {
       b.structure().vertices[0].ball[2] = b.balls().n;
       return 0U;
     }},
    {"a vertex on a contained ball", BoundaryLaw::vertices,
     [](BuiltBoundary &b) {
       b.structure().ball_state[b.structure().vertices[0].ball[2]] |= BoundaryStructure::contained;
       return 0U;
     }},
    {"too few uses", BoundaryLaw::uses,
     [](BuiltBoundary &b) {
       --b.structure().first_use[b.balls().n];
       return 0U;
     }},
    {"a use on another ball", BoundaryLaw::uses,
     [](BuiltBoundary &b) {
       std::swap(b.structure().use_at[0], b.structure().use_at[1]);
       return 0U;
     }},
    {"a vertex of the other sign", BoundaryLaw::uses,
     [](BuiltBoundary &b) {
       b.structure().vertices[1].code ^= hsp::VertexRecord::positive_bit;
       return 1U;
     }},
    {"a use of another vertex", BoundaryLaw::uses,
     [](BuiltBoundary &b) {
       first_visit(b).vertex = 1;
       return 0U;
     }},
    {"a successor on another ball", BoundaryLaw::successors,
     [](BuiltBoundary &b) {
       first_visit(b).next = b.structure().use_at[1];
       return b.structure().use_at[0];
     }},
    {"a successor that arrives along another circle", BoundaryLaw::successors,
     [](BuiltBoundary &b) {
       first_visit(b).next = b.structure().use_at[0];
       return b.structure().use_at[0];
     }},
    {"a use in another loop", BoundaryLaw::loops,
     [](BuiltBoundary &b) {
       first_visit(b).loop = b.structure().loop_count - 1;
       return anywhere;
     }},
    {"loops that end before they start", BoundaryLaw::loops,
     [](BuiltBoundary &b) {
       b.structure().first_loop[0] = b.structure().loop_count + 1;
       return b.structure().loop_count + 1;
     }},
    {"a circle's loop on another ball", BoundaryLaw::loops,
     [](BuiltBoundary &b) {
       std::swap(b.structure().circles[0].loop[0], b.structure().circles[0].loop[1]);
       return b.structure().circles[0].loop[0];
     }},
    {"a loop that bounds another ball's face", BoundaryLaw::faces,
     [](BuiltBoundary &b) {
       const uint32_t loop = first_visit(b).loop;
       b.structure().loop_face[loop] = b.structure().face_count - 1 - b.structure().loop_face[loop];
       return b.structure().loop_face[loop];
     }},
    {"a face that miscounts its loops", BoundaryLaw::faces,
     [](BuiltBoundary &b) {
       ++b.structure().faces[2].loops;
       return 2U;
     }},
    {"a face of another ball", BoundaryLaw::faces,
     [](BuiltBoundary &b) {
       b.structure().faces[0].ball = b.balls().n;
       return 0U;
     }},
    {"a sphere that is not whole", BoundaryLaw::faces,
     [](BuiltBoundary &b) {
       const uint32_t lonely = ball_with_faces(b, 8);
       b.structure().ball_state[lonely] = 0;
       return b.structure().first_face[lonely];
     }},
    {"faces that end before they start", BoundaryLaw::faces,
     [](BuiltBoundary &b) {
       b.structure().first_face[0] = b.structure().face_count + 1;
       return b.structure().face_count + 1;
     }},
    {"one face too many", BoundaryLaw::faces, [](BuiltBoundary &b) { return ++b.structure().face_count; }},
    {"shells out of order", BoundaryLaw::shells,
     [](BuiltBoundary &b) {
       b.structure().faces[0].shell = 1;
       return 0U;
     }},
    {"a shell without faces", BoundaryLaw::shells, [](BuiltBoundary &b) { return b.structure().shell_count++; }},
    {"an arc between two shells", BoundaryLaw::shells,
     [](BuiltBoundary &b) {
       const uint32_t face = b.structure().loop_face[first_visit(b).loop];
       const uint32_t own = b.structure().faces[face].shell;
       // a shell that is known by then, so that the numbering stays without gaps
       b.structure().faces[face].shell = own == 0 ? 1 : 0;
       return anywhere;
     }},
    {"a vertex off its spheres", BoundaryLaw::positions,
     [](BuiltBoundary &b) {
       b.structure().root_discriminant[1] *= 1.001;
       return 1U;
     }},
    {"a vertex without a position", BoundaryLaw::positions,
     [](BuiltBoundary &b) {
       b.structure().root_discriminant[1] = std::numeric_limits<double>::quiet_NaN();
       return 1U;
     }},
};

hsp::Violation checked(BuiltBoundary &boundary) {
  const hsp::Violation violation = hsp::check_structure(boundary.balls(), boundary.structure());
  return violation.law != BoundaryLaw::none ? violation : hsp::check_metric(boundary.balls(), boundary.structure());
}

TEST(StructureCheck, FindsNothingInACorrectBoundary) {
  BuiltBoundary boundary(scene);
  ASSERT_EQ(boundary.status(), hsp::Status::ok);
  ASSERT_GE(boundary.structure().vertices.size(), 2U);
  ASSERT_GE(boundary.structure().circles.size(), 2U);
  ASSERT_GE(boundary.structure().shell_count, 4U);
  EXPECT_EQ(checked(boundary).law, BoundaryLaw::none);
}

TEST(StructureCheck, FindsEveryFlaw) {
  for (const Flaw &flaw : flaws) {
    SCOPED_TRACE(flaw.name);
    BuiltBoundary boundary(scene);
    ASSERT_EQ(boundary.status(), hsp::Status::ok);
    const uint32_t where = flaw.make(boundary);
    const hsp::Violation violation = checked(boundary);
    EXPECT_EQ(violation.law, flaw.law);
    if (where != anywhere) {
      EXPECT_EQ(violation.where, where);
    }
  }
}

// A circle has a shell on either side. Taking one of them for a shell of its own breaks the law of shells.
TEST(StructureCheck, FindsACircleBetweenTwoShells) {
  BuiltBoundary boundary({{0, 0, 0, 500}, {600, 0, 0, 500}});
  BoundaryStructure &structure = boundary.structure();
  ASSERT_EQ(structure.face_count, 2U);
  structure.faces[1].shell = structure.shell_count++;
  EXPECT_EQ(checked(boundary).law, BoundaryLaw::shells);
}

// Two spheres that count as one closed surface have the Euler characteristic 4.
TEST(StructureCheck, FindsTwoSurfacesInOneShell) {
  BuiltBoundary boundary({{0, 0, 0, 500}, {5000, 0, 0, 500}});
  BoundaryStructure &structure = boundary.structure();
  ASSERT_EQ(structure.shell_count, 2U);
  structure.faces[1].shell = 0;
  structure.shell_count = 1;
  const hsp::Violation violation = checked(boundary);
  EXPECT_EQ(violation.law, BoundaryLaw::euler);
  EXPECT_EQ(violation.where, 0U);
}

// One component cannot have fewer shells than one.
TEST(StructureCheck, FindsAComponentWithoutAShell) {
  BuiltBoundary boundary({{0, 0, 0, 500}, {600, 0, 0, 500}});
  BoundaryStructure &structure = boundary.structure();
  ASSERT_EQ(structure.shell_count, 1U);
  structure.component_parent[1] = 1;
  structure.component_parent[0] = 0;
  const hsp::Violation violation = checked(boundary);
  EXPECT_EQ(violation.law, BoundaryLaw::euler);
  EXPECT_EQ(violation.where, 2U);
}

// On a circle with two free arcs, exchanging where they end leaves successors along the right circle but no twins.
TEST(StructureCheck, FindsArcsThatEndElsewhere) {
  // Two large balls whose circle is cut twice by two small ones at opposite ends.
  BuiltBoundary boundary({{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 866, 0, 300}, {500, -866, 0, 300}});
  BoundaryStructure &structure = boundary.structure();
  ASSERT_EQ(boundary.status(), hsp::Status::ok);
  ASSERT_EQ(checked(boundary).law, BoundaryLaw::none);
  const uint32_t ball = boundary.place(0);
  const uint32_t other = boundary.place(1);
  std::vector<uint32_t> along;
  for (uint32_t u = structure.first_use[ball]; u < structure.first_use[ball + 1]; ++u) {
    if (structure.uses[u].out == other) along.push_back(u);
  }
  ASSERT_EQ(along.size(), 2U);
  std::swap(structure.uses[along[0]].next, structure.uses[along[1]].next);
  EXPECT_EQ(checked(boundary).law, BoundaryLaw::twins);
}

// A capsule of three balls in a row. Its middle face is a band between two circles.
const std::vector<TestBall> capsule = {{0, 0, 0, 500}, {600, 0, 0, 500}, {1200, 0, 0, 500}};

// The band taken for two faces makes two closed surfaces of it, of which no law of the structure knows better; but then
// it has more area than its sphere.
TEST(StructureCheck, FindsAFaceCutInTwo) {
  BuiltBoundary boundary(capsule);
  BoundaryStructure &structure = boundary.structure();
  ASSERT_EQ(checked(boundary).law, BoundaryLaw::none);
  ASSERT_EQ(structure.face_count, 3U);
  const uint32_t middle = boundary.place(1);
  const uint32_t band = structure.first_face[middle];
  ASSERT_EQ(structure.faces[band].loops, 2U);
  const uint32_t cut = structure.first_loop[middle] + 1;
  // The new face follows the band; later faces move up by one.
  for (uint32_t face = structure.face_count++; face > band + 1; --face)
    structure.faces[face] = structure.faces[face - 1];
  for (uint32_t ball = middle + 1; ball <= boundary.balls().n; ++ball) ++structure.first_face[ball];
  for (uint32_t loop = cut + 1; loop < structure.loop_count; ++loop) {
    if (structure.loop_face[loop] > band) ++structure.loop_face[loop];
  }
  structure.loop_face[cut] = band + 1;
  structure.faces[band].loops = 1;
  structure.faces[band + 1] = {middle, 1, hsp::no_id};
  hsp::gather_shells(structure);
  ASSERT_EQ(structure.shell_count, 2U);
  const hsp::Violation violation = checked(boundary);
  EXPECT_EQ(violation.law, BoundaryLaw::areas);
  EXPECT_EQ(violation.where, middle);
}

// One of the band's circles counted twice and the other not at all leaves its area, but the surface does not close.
TEST(StructureCheck, FindsASurfaceThatDoesNotClose) {
  BuiltBoundary boundary(capsule);
  BoundaryStructure &structure = boundary.structure();
  const uint32_t first = structure.first_circle_side[boundary.place(1)];
  ASSERT_EQ(structure.first_circle_side[boundary.place(1) + 1], first + 2);
  structure.circle_side[first] = structure.circle_side[first + 1];
  EXPECT_EQ(checked(boundary).law, BoundaryLaw::closure);
}

}  // namespace
