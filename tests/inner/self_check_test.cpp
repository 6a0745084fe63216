// The self-check finds what is wrong: a sound boundary passes, and each law is reported by its number when a record is
// falsified.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "boundary/boundary.hpp"
#include "measure/metric_check.hpp"
#include "topology/shells.hpp"

namespace {

using hsp::BoundaryLaw;

// A computed boundary in memory of its own.
class Computed {
 public:
  Computed(const std::vector<double> &xyz, const std::vector<double> &radius) {
    const uint32_t n = static_cast<uint32_t>(radius.size());
    hsp::Workspace measure;
    grid.carve(measure, n);
    const hsp::BoundaryLimits limits{n, n, 30 * n + 10, 4 * n + 4};
    builder.carve(measure, limits);
    memory.resize(measure.bytes());
    hsp::Workspace workspace(memory.data(), memory.size());
    grid.carve(workspace, n);
    builder.carve(workspace, limits);
    hsp::BallInput input;
    input.n = n;
    input.xyz = xyz.data();
    input.radius = radius.data();
    input.step = 0.001;
    uint32_t first_bad = 0;
    EXPECT_EQ(grid.build(input, first_bad), hsp::Status::ok);
    EXPECT_EQ(builder.build(grid), hsp::Status::ok);
    hsp::gather_shells(builder.structure());
  }
  hsp::BoundaryStructure &structure() { return builder.structure(); }
  BoundaryLaw violated() {
    const hsp::Violation violation = hsp::check_structure(grid.balls(), structure());
    return violation.law != BoundaryLaw::none ? violation.law : hsp::check_metric(grid.balls(), structure()).law;
  }

 private:
  std::vector<unsigned char> memory;
  hsp::CubeGrid grid;
  hsp::BoundaryBuilder builder;
};

// Loosely overlapping balls, a ball inside one of them, a pair with a free circle, and a ball on its own.
Computed sample() {
  std::mt19937_64 random(12);
  std::vector<double> xyz;
  std::vector<double> radius;
  const auto uniform = [&random]() { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int k = 0; k < 40; ++k) {
    for (int axis = 0; axis < 3; ++axis) xyz.push_back(9.0 * uniform());
    radius.push_back(1.0 + uniform());
  }
  const double more[][4] = {{4, 4, 4, 0.1}, {30, 0, 0, 2}, {32, 0, 0, 1}, {50, 0, 0, 1}};
  for (const auto &ball : more) {
    xyz.insert(xyz.end(), ball, ball + 3);
    radius.push_back(ball[3]);
  }
  return Computed(xyz, radius);
}

TEST(SelfCheck, PassesWhatIsSound) {
  EXPECT_EQ(sample().violated(), BoundaryLaw::none);
  EXPECT_EQ(Computed({}, {}).violated(), BoundaryLaw::none);
  EXPECT_EQ(Computed({0, 0, 0}, {1}).violated(), BoundaryLaw::none);
  EXPECT_EQ(Computed({0, 0, 0}, {0}).violated(), BoundaryLaw::none);
}

TEST(SelfCheck, FindsFalseVertices) {
  Computed computed = sample();
  hsp::VertexRecord &vertex = computed.structure().vertices[3];
  std::swap(vertex.ball[0], vertex.ball[1]);
  EXPECT_EQ(computed.violated(), BoundaryLaw::vertices);
}

TEST(SelfCheck, FindsVerticesOnContainedBalls) {
  Computed computed = sample();
  computed.structure().ball_state[computed.structure().vertices[0].ball[2]] |= hsp::BoundaryStructure::contained;
  EXPECT_EQ(computed.violated(), BoundaryLaw::vertices);
}

TEST(SelfCheck, FindsFalseUses) {
  {
    Computed computed = sample();
    computed.structure().vertices[5].code ^= hsp::VertexRecord::positive_bit;
    EXPECT_EQ(computed.violated(), BoundaryLaw::uses);
  }
  {
    Computed computed = sample();
    std::swap(computed.structure().use_at[6], computed.structure().use_at[7]);
    EXPECT_EQ(computed.violated(), BoundaryLaw::uses);
  }
  {
    Computed computed = sample();
    --computed.structure().first_use[44];
    EXPECT_EQ(computed.violated(), BoundaryLaw::uses);
  }
}

TEST(SelfCheck, FindsFalseSuccessors) {
  Computed computed = sample();
  hsp::VertexUse &use = computed.structure().uses[10];
  use.next = 0;
  EXPECT_EQ(computed.violated(), BoundaryLaw::successors);
}

// Two arcs on one circle of one ball exchange their ends: each still arrives on its circle, but the other ball
// disagrees.
TEST(SelfCheck, FindsArcsThatTheOtherBallSeesDifferently) {
  // A ring of four balls around a pair, so that the pair's circle has several free arcs.
  Computed computed({0, 0, -1, 0, 0, 1, 2.2, 0, 0, -2.2, 0, 0, 0, 2.2, 0, 0, -2.2, 0}, {2, 2, 0.9, 0.9, 0.9, 0.9});
  hsp::BoundaryStructure &structure = computed.structure();
  ASSERT_EQ(computed.violated(), BoundaryLaw::none);
  bool exchanged = false;
  for (uint32_t i = 0; i < 6 && !exchanged; ++i) {
    for (uint32_t u = structure.first_use[i]; u < structure.first_use[i + 1] && !exchanged; ++u) {
      for (uint32_t w = u + 1; w < structure.first_use[i + 1] && !exchanged; ++w) {
        if (structure.uses[u].out != structure.uses[w].out) continue;
        std::swap(structure.uses[u].next, structure.uses[w].next);
        exchanged = true;
      }
    }
  }
  ASSERT_TRUE(exchanged);
  EXPECT_EQ(computed.violated(), BoundaryLaw::twins);
}

TEST(SelfCheck, FindsFalseLoops) {
  {
    Computed computed = sample();
    computed.structure().uses[4].loop += 1;
    EXPECT_EQ(computed.violated(), BoundaryLaw::loops);
  }
  {
    Computed computed = sample();
    ASSERT_GT(computed.structure().circles.size(), 0U);
    computed.structure().circles[0].loop[1] += 1;
    EXPECT_EQ(computed.violated(), BoundaryLaw::loops);
  }
}

TEST(SelfCheck, FindsFalseFaces) {
  {
    Computed computed = sample();
    ++computed.structure().faces[2].loops;
    EXPECT_EQ(computed.violated(), BoundaryLaw::faces);
  }
  {
    Computed computed = sample();
    computed.structure().faces[2].ball += 1;
    EXPECT_EQ(computed.violated(), BoundaryLaw::faces);
  }
  {
    Computed computed = sample();
    computed.structure().loop_face[0] = computed.structure().face_count - 1;
    EXPECT_EQ(computed.violated(), BoundaryLaw::faces);
  }
}

TEST(SelfCheck, FindsFalseShells) {
  {
    Computed computed = sample();
    computed.structure().faces[0].shell = 1;
    EXPECT_EQ(computed.violated(), BoundaryLaw::shells);
  }
  {
    // The last face of the big component handed to the lone ball's shell.
    Computed computed = sample();
    hsp::BoundaryStructure &structure = computed.structure();
    uint32_t face = structure.loop_face[structure.uses[0].loop];
    for (uint32_t u = 0; u < 3 * structure.vertices.size(); ++u) {
      face = std::max(face, structure.loop_face[structure.uses[u].loop]);
    }
    structure.faces[face].shell = structure.faces[face].shell == 0 ? 1 : 0;
    EXPECT_EQ(computed.violated(), BoundaryLaw::shells);
  }
}

TEST(SelfCheck, FindsTooManyComponents) {
  Computed computed = sample();
  for (uint32_t i = 0; i < 44; ++i) computed.structure().component_parent[i] = i;
  EXPECT_EQ(computed.violated(), BoundaryLaw::euler);
}

// A face too few on one ball leaves the characteristic even, but takes 4 pi off its area.
TEST(SelfCheck, FindsFalseAreas) {
  Computed computed = sample();
  hsp::BoundaryStructure &structure = computed.structure();
  // Two faces of one ball and one shell are called one.
  for (uint32_t i = 0; i < 44; ++i) {
    const uint32_t first = structure.first_face[i];
    if (structure.first_face[i + 1] != first + 2 || structure.faces[first].shell != structure.faces[first + 1].shell)
      continue;
    structure.faces[first].loops += structure.faces[first + 1].loops;
    for (uint32_t loop = structure.first_loop[i]; loop < structure.first_loop[i + 1]; ++loop) {
      structure.loop_face[loop] = first;
    }
    for (uint32_t f = first + 1; f + 1 < structure.face_count; ++f) structure.faces[f] = structure.faces[f + 1];
    --structure.face_count;
    for (uint32_t k = i + 1; k <= 44; ++k) --structure.first_face[k];
    for (uint32_t loop = 0; loop < structure.loop_count; ++loop) {
      if (structure.loop_face[loop] > first) --structure.loop_face[loop];
    }
    EXPECT_EQ(computed.violated(), BoundaryLaw::areas);
    return;
  }
  FAIL() << "the sample has no ball with two faces";
}

TEST(SelfCheck, FindsFalsePositions) {
  Computed computed = sample();
  computed.structure().root_discriminant[2] *= 1.001;
  EXPECT_EQ(computed.violated(), BoundaryLaw::positions);
}

}  // namespace
