// The self-check finds what is wrong: one record of a correct boundary at a time is spoilt, and the invariant that it
// violates is named, with the id where it is violated. Through the interface a boundary is never wrong, so that this is
// the only way to see these answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "boundary/boundary_check.hpp"
#include "built_boundary.hpp"

namespace {

using hsp::BoundaryArrays;
using hsp::BoundaryInvariant;

// Three balls with two common points and a fourth that cuts a free circle out of the first; a pair apart from them; a
// ball on its own; one inside another.
const oracle::Balls scene = {{0, 0, 0, 1000},     {1000, 0, 0, 1000},   {500, 800, 0, 1000},
                             {-1500, 0, 0, 600},  {9000, 0, 0, 500},    {9600, 0, 0, 500},
                             {0, 20000, 0, 1000}, {0, 20000, 100, 300}, {0, 900, 20000, 1000}};

struct Flaw {
  const char *name;
  BoundaryInvariant invariant;
  // Spoils the structure and returns where the invariant is violated.
  std::function<uint32_t(BuiltBoundary &)> make;
};

// The half-edge that starts at the first vertex on the first of its balls.
hsp::HalfEdge &first_visit(BuiltBoundary &boundary) {
  return boundary.arrays().half_edges[boundary.arrays().half_edge_at[0]];
}
uint32_t ball_with_faces(BuiltBoundary &boundary, uint32_t caller) {
  const uint32_t ball = boundary.grid_index(caller);
  EXPECT_LT(boundary.arrays().first[ball].face, boundary.arrays().first[ball + 1].face);
  return ball;
}

constexpr uint32_t anywhere = hsp::no_id;

const std::vector<Flaw> flaws = {
    {"a vertex of equal balls", BoundaryInvariant::vertices,
     [](BuiltBoundary &b) {
       b.arrays().vertices[1].ball[1] = b.arrays().vertices[1].ball[0];
       return 1U;
     }},
    {"a vertex of balls out of order", BoundaryInvariant::vertices,
     [](BuiltBoundary &b) {
       std::swap(b.arrays().vertices[1].ball[1], b.arrays().vertices[1].ball[2]);
       return 1U;
     }},
    {"a vertex of a ball that is not there", BoundaryInvariant::vertices,
     [](BuiltBoundary &b) {
       b.arrays().vertices[0].ball[2] = b.balls().n;
       return 0U;
     }},
    {"a vertex on a contained ball", BoundaryInvariant::vertices,
     [](BuiltBoundary &b) {
       b.arrays().ball_state[b.arrays().vertices[0].ball[2]] |= BoundaryArrays::contained;
       return 0U;
     }},
    {"too few half-edges", BoundaryInvariant::half_edges,
     [](BuiltBoundary &b) {
       --b.arrays().first[b.balls().n].half_edge;
       return 0U;
     }},
    {"a half-edge on another ball", BoundaryInvariant::half_edges,
     [](BuiltBoundary &b) {
       std::swap(b.arrays().half_edge_at[0], b.arrays().half_edge_at[1]);
       return 0U;
     }},
    {"a vertex of the other sign", BoundaryInvariant::half_edges,
     [](BuiltBoundary &b) {
       b.arrays().vertices[1].code ^= hsp::VertexRecord::positive_bit;
       return 1U;
     }},
    {"a half-edge of another vertex", BoundaryInvariant::half_edges,
     [](BuiltBoundary &b) {
       first_visit(b).vertex = 1;
       return 0U;
     }},
    {"a successor on another ball", BoundaryInvariant::successors,
     [](BuiltBoundary &b) {
       first_visit(b).next = b.arrays().half_edge_at[1];
       return b.arrays().half_edge_at[0];
     }},
    {"a successor that arrives along another circle", BoundaryInvariant::successors,
     [](BuiltBoundary &b) {
       first_visit(b).next = b.arrays().half_edge_at[0];
       return b.arrays().half_edge_at[0];
     }},
    {"a half-edge in another loop", BoundaryInvariant::loops,
     [](BuiltBoundary &b) {
       first_visit(b).loop = b.arrays().loop_count - 1;
       return anywhere;
     }},
    {"loops that end before they start", BoundaryInvariant::loops,
     [](BuiltBoundary &b) {
       b.arrays().first[0].loop = b.arrays().loop_count + 1;
       return b.arrays().loop_count + 1;
     }},
    {"loops beyond the last one", BoundaryInvariant::loops,
     [](BuiltBoundary &b) {
       ++b.arrays().first[b.balls().n].loop;
       return b.arrays().first[b.balls().n - 1].loop;
     }},
    {"a circle on a ball that is not there", BoundaryInvariant::loops,
     [](BuiltBoundary &b) {
       b.arrays().circles[0].ball[1] = b.balls().n;
       return b.arrays().circles[0].loop[1];
     }},
    {"a loop that does not start at its first half-edge", BoundaryInvariant::loops,
     [](BuiltBoundary &b) {
       const uint32_t loop = b.arrays().half_edges[0].loop;
       b.arrays().loop_start[loop] = hsp::LoopElement::arc(b.arrays().half_edges[0].next);
       return loop;
     }},
    {"a loop that starts in another one", BoundaryInvariant::loops,
     [](BuiltBoundary &b) {
       const uint32_t last = b.arrays().vertices.size() * 3 - 1;
       b.arrays().loop_start[b.arrays().half_edges[last].loop] = hsp::LoopElement::arc(0);
       return anywhere;
     }},
    {"a loop of half-edges that starts with a circle", BoundaryInvariant::loops,
     [](BuiltBoundary &b) {
       b.arrays().loop_start[b.arrays().half_edges[0].loop] = hsp::LoopElement::circle(hsp::ClosedHalfEdge(0, 0));
       return b.arrays().half_edges[0].loop;
     }},
    {"a circle that starts with another one", BoundaryInvariant::loops,
     [](BuiltBoundary &b) {
       b.arrays().loop_start[b.arrays().circles[0].loop[0]] = hsp::LoopElement::circle(hsp::ClosedHalfEdge(0, 1));
       return b.arrays().circles[0].loop[0];
     }},
    {"a circle's loop on another ball", BoundaryInvariant::loops,
     [](BuiltBoundary &b) {
       std::swap(b.arrays().circles[0].loop[0], b.arrays().circles[0].loop[1]);
       return b.arrays().circles[0].loop[0];
     }},
    {"a loop that bounds another ball's face", BoundaryInvariant::faces,
     [](BuiltBoundary &b) {
       const uint32_t loop = first_visit(b).loop;
       const uint32_t face = b.arrays().loop_face[loop];
       b.arrays().loop_face[loop] = b.arrays().face_count - 1 - face;
       return face;
     }},
    {"a face with a loop of the next face", BoundaryInvariant::faces,
     [](BuiltBoundary &b) {
       ++b.arrays().faces[2].first_loop;
       return 1U;
     }},
    {"a face without loops", BoundaryInvariant::faces,
     [](BuiltBoundary &b) {
       b.arrays().faces[1].first_loop = 0;
       return 0U;
     }},
    {"a loop of no face", BoundaryInvariant::faces,
     [](BuiltBoundary &b) {
       b.arrays().faces[0].first_loop = 1;
       return 0U;
     }},
    {"a face of another ball", BoundaryInvariant::faces,
     [](BuiltBoundary &b) {
       b.arrays().faces[0].ball = b.balls().n;
       return 0U;
     }},
    {"a sphere that is not whole", BoundaryInvariant::faces,
     [](BuiltBoundary &b) {
       const uint32_t lonely = ball_with_faces(b, 8);
       b.arrays().ball_state[lonely] = 0;
       return b.arrays().first[lonely].face;
     }},
    {"faces that end before they start", BoundaryInvariant::faces,
     [](BuiltBoundary &b) {
       b.arrays().first[0].face = b.arrays().face_count + 1;
       return b.arrays().face_count + 1;
     }},
    {"faces beyond the last one", BoundaryInvariant::faces,
     [](BuiltBoundary &b) {
       b.arrays().first[1].face = b.arrays().face_count + 1;
       return b.arrays().first[0].face;
     }},
    {"loops of a face that end before they start", BoundaryInvariant::faces,
     [](BuiltBoundary &b) {
       b.arrays().faces[2].first_loop = 0;
       return 1U;
     }},
    {"a whole sphere with two faces", BoundaryInvariant::faces,
     [](BuiltBoundary &b) {
       const uint32_t lonely = ball_with_faces(b, 6);
       ++b.arrays().first[lonely + 1].face;
       return b.arrays().first[lonely].face;
     }},
    {"one face too many", BoundaryInvariant::faces, [](BuiltBoundary &b) { return ++b.arrays().face_count; }},
    {"shells out of order", BoundaryInvariant::shells,
     [](BuiltBoundary &b) {
       b.arrays().faces[0].shell = 1;
       return 0U;
     }},
    {"a shell without faces", BoundaryInvariant::shells, [](BuiltBoundary &b) { return b.arrays().shell_count++; }},
    {"an arc between two shells", BoundaryInvariant::shells,
     [](BuiltBoundary &b) {
       const uint32_t face = b.arrays().loop_face[first_visit(b).loop];
       const uint32_t own = b.arrays().faces[face].shell;
       // a shell that is known by then, so that the numbering stays without gaps
       b.arrays().faces[face].shell = own == 0 ? 1 : 0;
       return anywhere;
     }},
};

// Numbers left in the memory for checks mean nothing.
hsp::BoundaryViolation checked(BuiltBoundary &boundary) {
  for (uint32_t &number : boundary.scratch()) number = 0xA5A5A5A5U;
  return hsp::check_boundary(boundary.balls(), boundary.boundary(), boundary.scratch());
}

TEST(BoundaryCheck, FindsNothingInACorrectBoundary) {
  BuiltBoundary boundary(scene);
  ASSERT_EQ(boundary.status(), hsp::Status::ok);
  ASSERT_GE(boundary.arrays().vertices.size(), 2U);
  ASSERT_GE(boundary.arrays().circles.size(), 2U);
  ASSERT_GE(boundary.arrays().shell_count, 4U);
  EXPECT_EQ(checked(boundary).invariant, BoundaryInvariant::none);
}

TEST(BoundaryCheck, FindsEveryFlaw) {
  for (const Flaw &flaw : flaws) {
    SCOPED_TRACE(flaw.name);
    BuiltBoundary boundary(scene);
    ASSERT_EQ(boundary.status(), hsp::Status::ok);
    const uint32_t where = flaw.make(boundary);
    const hsp::BoundaryViolation violation = checked(boundary);
    EXPECT_EQ(violation.invariant, flaw.invariant);
    if (where != anywhere) {
      EXPECT_EQ(violation.id, where);
    }
  }
}

// A circle has a shell on either side. Taking one of them for a shell of its own violates the invariant of shells.
TEST(BoundaryCheck, FindsACircleBetweenTwoShells) {
  BuiltBoundary boundary({{0, 0, 0, 500}, {600, 0, 0, 500}});
  BoundaryArrays &arrays = boundary.arrays();
  ASSERT_EQ(arrays.face_count, 2U);
  arrays.faces[1].shell = arrays.shell_count++;
  EXPECT_EQ(checked(boundary).invariant, BoundaryInvariant::shells);
}

// The two loops of a belt that count as one leave an odd Euler characteristic. The belt's ball is the last, and so are
// its loops.
TEST(BoundaryCheck, FindsTwoLoopsThatCountAsOne) {
  BuiltBoundary boundary(
      {{0, 0, 0, 1000}, {-900, -300, -10, 700}, {-900, 300, -20, 700}, {900, -300, -30, 700}, {900, 300, -40, 700}});
  BoundaryArrays &arrays = boundary.arrays();
  ASSERT_EQ(checked(boundary).invariant, BoundaryInvariant::none);
  const uint32_t n = boundary.balls().n;
  const uint32_t last = --arrays.loop_count;
  ASSERT_EQ(boundary.grid_index(0), n - 1);
  ASSERT_EQ(arrays.first[n - 1].loop, last - 1);
  ASSERT_EQ(arrays.first[n - 1].face, arrays.face_count - 1);
  for (hsp::HalfEdge &half_edge : arrays.half_edges) {
    if (half_edge.loop == last) half_edge.loop = last - 1;
  }
  arrays.first[n].loop = last;
  const hsp::BoundaryViolation violation = checked(boundary);
  EXPECT_EQ(violation.invariant, BoundaryInvariant::euler);
  EXPECT_EQ(violation.id, 0U);
}

// Two spheres that count as one closed surface have the Euler characteristic 4.
TEST(BoundaryCheck, FindsTwoSurfacesInOneShell) {
  BuiltBoundary boundary({{0, 0, 0, 500}, {5000, 0, 0, 500}});
  BoundaryArrays &arrays = boundary.arrays();
  ASSERT_EQ(arrays.shell_count, 2U);
  arrays.faces[1].shell = 0;
  arrays.shell_count = 1;
  const hsp::BoundaryViolation violation = checked(boundary);
  EXPECT_EQ(violation.invariant, BoundaryInvariant::euler);
  EXPECT_EQ(violation.id, 0U);
}

// One component cannot have fewer shells than one.
TEST(BoundaryCheck, FindsAComponentWithoutAShell) {
  BuiltBoundary boundary({{0, 0, 0, 500}, {600, 0, 0, 500}});
  BoundaryArrays &arrays = boundary.arrays();
  ASSERT_EQ(arrays.shell_count, 1U);
  arrays.component_origin[1] = 1;
  arrays.component_origin[0] = 0;
  const hsp::BoundaryViolation violation = checked(boundary);
  EXPECT_EQ(violation.invariant, BoundaryInvariant::euler);
  EXPECT_EQ(violation.id, 2U);
}

// On a circle with two free arcs, exchanging where they end leaves successors along the right circle but no twins.
TEST(BoundaryCheck, FindsArcsThatEndElsewhere) {
  // Two large balls whose circle is cut twice by two small ones at opposite ends.
  BuiltBoundary boundary({{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 866, 0, 300}, {500, -866, 0, 300}});
  BoundaryArrays &arrays = boundary.arrays();
  ASSERT_EQ(boundary.status(), hsp::Status::ok);
  ASSERT_EQ(checked(boundary).invariant, BoundaryInvariant::none);
  const uint32_t ball = boundary.grid_index(0);
  const uint32_t other = boundary.grid_index(1);
  std::vector<uint32_t> along;
  for (uint32_t u = arrays.first[ball].half_edge; u < arrays.first[ball + 1].half_edge; ++u) {
    if (arrays.half_edges[u].circle == other) along.push_back(u);
  }
  ASSERT_EQ(along.size(), 2U);
  std::swap(arrays.half_edges[along[0]].next, arrays.half_edges[along[1]].next);
  EXPECT_EQ(checked(boundary).invariant, BoundaryInvariant::twins);
}

// One number at a time is wrong, of each record in turn: the first and the last ones count, too. In sets besides the
// scene all balls are alike, so that also the first and the last ball have vertices, or circles.
class EachInTurn {
 public:
  explicit EachInTurn(const oracle::Balls &balls) : built_(balls) {
    EXPECT_EQ(built_.status(), hsp::Status::ok);
    EXPECT_EQ(checked(built_).invariant, BoundaryInvariant::none);
  }

  template <class Number>
  void expect(Number &number, const Number &wrong, BoundaryInvariant invariant, uint32_t id) {
    const Number right = std::exchange(number, wrong);
    const hsp::BoundaryViolation violation = checked(built_);
    EXPECT_EQ(violation.invariant, invariant);
    if (id != anywhere) {
      EXPECT_EQ(violation.id, id);
    }
    number = right;
  }
  BoundaryArrays &arrays() { return built_.arrays(); }
  const hsp::Boundary &boundary() const { return built_.boundary(); }
  uint32_t balls() const { return built_.balls().n; }

 private:
  BuiltBoundary built_;
};

const oracle::Balls three = {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}};
const oracle::Balls two = {{0, 0, 0, 1000}, {1000, 0, 0, 1000}};
oracle::Balls twice(oracle::Balls balls) {
  for (size_t k = balls.size(); k-- > 0;) balls.push_back({balls[k].x, balls[k].y, 50000, balls[k].radius});
  return balls;
}

TEST(BoundaryCheck, FindsEveryWrongVertex) {
  for (const oracle::Balls &balls : {scene, twice(three)}) {
    EachInTurn each(balls);
    BoundaryArrays &a = each.arrays();
    const auto first_with = [&](uint32_t ball) {
      uint32_t v = 0;
      while (std::count(a.vertices[v].ball, a.vertices[v].ball + 3, ball) == 0) ++v;
      return v;
    };
    for (uint32_t v = 0; v < a.vertices.size(); ++v) {
      for (uint32_t &ball : a.vertices[v].ball) {
        each.expect(ball, each.balls(), BoundaryInvariant::vertices, v);
        uint8_t &state = a.ball_state[ball];
        each.expect(state, static_cast<uint8_t>(state | BoundaryArrays::contained), BoundaryInvariant::vertices,
                    first_with(ball));
      }
      each.expect(a.vertices[v].code, a.vertices[v].code ^ hsp::VertexRecord::positive_bit,
                  BoundaryInvariant::half_edges, v);
      for (uint32_t t = 0; t < 3; ++t) {
        const uint32_t next = v + 1 < a.vertices.size() ? v + 1 : 0;
        each.expect(a.half_edge_at[3 * v + t], a.half_edge_at[3 * next + t], BoundaryInvariant::half_edges, v);
      }
    }
  }
}

TEST(BoundaryCheck, FindsEveryWrongHalfEdge) {
  for (const oracle::Balls &balls : {scene, twice(three)}) {
    EachInTurn each(balls);
    BoundaryArrays &a = each.arrays();
    const uint32_t last = each.boundary().half_edge_count() - 1;
    for (uint32_t u = 0; u <= last; ++u) {
      const uint32_t ball = each.boundary().ball_of(each.boundary().face_of(u));
      const uint32_t elsewhere = each.boundary().half_edges(ball).contains(0) ? last : 0;
      each.expect(a.half_edges[u].next, elsewhere, BoundaryInvariant::successors, u);
      each.expect(a.half_edges[u].loop, a.half_edges[elsewhere].loop, BoundaryInvariant::loops, anywhere);
    }
  }
}

// Of four half-edges that are no twins then the first is named.
TEST(BoundaryCheck, FindsEveryPairOfArcsThatEndElsewhere) {
  EachInTurn each({{0, 0, 800, 1000}, {0, 1000, 800, 1000}, {433, 500, 1550, 300}, {433, 500, 50, 300}});
  BoundaryArrays &a = each.arrays();
  uint32_t lowest = anywhere;
  for (uint32_t u = 0; u < each.boundary().half_edge_count(); ++u) {
    for (uint32_t w = u + 1; w < each.boundary().half_edge_count(); ++w) {
      const bool alike =
          a.half_edges[u].circle == a.half_edges[w].circle && a.half_edges[u].loop == a.half_edges[w].loop;
      if (!alike) continue;
      const uint32_t first = std::min({u, each.boundary().twin(u), each.boundary().twin(w)});
      lowest = std::min(lowest, first);
      const uint32_t next = std::exchange(a.half_edges[u].next, a.half_edges[w].next);
      each.expect(a.half_edges[w].next, next, BoundaryInvariant::twins, first);
      a.half_edges[u].next = next;
    }
  }
  EXPECT_EQ(lowest, 0U);
}

TEST(BoundaryCheck, FindsEveryWrongCircleLoopAndFace) {
  for (const oracle::Balls &balls : {scene, twice(three), twice(two)}) {
    EachInTurn each(balls);
    BoundaryArrays &a = each.arrays();
    for (uint32_t c = 0; c < a.circles.size(); ++c) {
      for (uint32_t side = 0; side < 2; ++side) {
        const uint32_t loop = a.circles[c].loop[side];
        each.expect(a.loop_start[loop], hsp::LoopElement::circle({c, 1 - side}), BoundaryInvariant::loops, loop);
      }
    }
    for (uint32_t loop = 0; loop < a.loop_count; ++loop) {
      const uint32_t face = a.loop_face[loop];
      each.expect(a.loop_face[loop], face == 0 ? 1U : 0U, BoundaryInvariant::faces, face);
    }
    for (uint32_t f = 0; f < a.face_count; ++f) {
      each.expect(a.faces[f].ball, each.balls(), BoundaryInvariant::faces, f);
      each.expect(a.faces[f].shell, a.shell_count, BoundaryInvariant::shells, f);
    }
  }
}

// The face before the first arc between two shells is named.
TEST(BoundaryCheck, FindsEveryFaceInAnotherShell) {
  EachInTurn each(twice(three));
  BoundaryArrays &a = each.arrays();
  ASSERT_EQ(a.shell_count, 2U);
  for (uint32_t f = 1; f < a.face_count; ++f) {
    if (a.faces[f].shell == 1 && a.faces[f - 1].shell == 0) continue;  // no other face would begin the second shell
    uint32_t u = 0;
    while (each.boundary().face_of(u) != f && each.boundary().face_of(each.boundary().twin(u)) != f) ++u;
    each.expect(a.faces[f].shell, 1 - a.faces[f].shell, BoundaryInvariant::shells, each.boundary().face_of(u));
  }
}

}  // namespace
