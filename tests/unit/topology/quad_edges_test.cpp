// The algebra of quad-edges on polyhedra that are written down as cycles of vertices: what each step means follows from
// the cycles alone.
#include "topology/quad_edges.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using hsp::QuadEdges;

// The faces of a closed surface, each counter-clockwise as seen from outside. Two vertices may be joined by several
// edges: an edge is named by the two faces it lies between.
struct Polyhedron {
  std::string name;
  std::vector<std::vector<uint32_t>> faces;
};

const std::vector<Polyhedron> polyhedra = {
    {"tetrahedron", {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}},
    {"cube", {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
    {"three digons", {{0, 1}, {0, 1}, {0, 1}}},
    {"lens", {{0, 1}, {1, 0}}},
    {"two triangles", {{0, 1, 2}, {2, 1, 0}}},
    {"pyramid", {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}},
    // A torus of 3 x 3 squares.
    {"torus",
     {{0, 1, 4, 3},
      {1, 2, 5, 4},
      {2, 0, 3, 5},
      {3, 4, 7, 6},
      {4, 5, 8, 7},
      {5, 3, 6, 8},
      {6, 7, 1, 0},
      {7, 8, 2, 1},
      {8, 6, 0, 2}}},
};

// A place on the cycle of a face: from its vertex `at` to the next one.
struct Step {
  uint32_t face, at;
  friend bool operator<(const Step &a, const Step &b) { return std::pair(a.face, a.at) < std::pair(b.face, b.at); }
};

class Built {
 public:
  explicit Built(const Polyhedron &polyhedron) : faces_(polyhedron.faces) {
    // The other side of a step is the one that goes back; of several digons, that of the next face upwards and of the
    // previous one downwards.
    for (uint32_t f = 0; f < faces_.size(); ++f) {
      for (uint32_t k = 0; k < faces_[f].size(); ++k) {
        if (quarter_.count({f, k}) > 0) continue;
        const uint32_t q = hsp::quarter_edge(edges_++);
        quarter_[{f, k}] = q;
        step_.push_back({f, k});
        for (uint32_t turn = 1; turn < faces_.size(); ++turn) {
          const uint32_t n = faces();
          const uint32_t other = (from({f, k}) > to({f, k}) ? f + turn : f + n - turn) % n;
          const int back = step_back(other, from({f, k}), to({f, k}));
          if (back < 0) continue;
          quarter_[{other, static_cast<uint32_t>(back)}] = hsp::sym(q);
          step_.push_back({other, static_cast<uint32_t>(back)});
          break;
        }
      }
    }
    memory_.resize(QuadEdges::numbers_per_edge * edges_, hsp::no_id);
    quads_.bind({memory_.data(), QuadEdges::numbers_per_edge * edges_});
    quads_.edges = edges_;
    for (const auto &[step, q] : quarter_) {
      quads_.start[q] = from(step);
      quads_.start[hsp::inverse_rot(q)] = step.face;
      quads_.link_lnext(q, quarter_.at(after(step)));
    }
  }
  const QuadEdges &quads() const { return quads_; }
  uint32_t edges() const { return edges_; }
  uint32_t vertices() const {
    std::set<uint32_t> all;
    for (const auto &face : faces_) all.insert(face.begin(), face.end());
    return static_cast<uint32_t>(all.size());
  }
  uint32_t faces() const { return static_cast<uint32_t>(faces_.size()); }

  const std::map<Step, uint32_t> &quarters() const { return quarter_; }
  uint32_t quarter(const Step &step) const { return quarter_.at(step); }
  // The step on the other side of the edge.
  Step across(const Step &step) const {
    const uint32_t q = hsp::sym(quarter(step));
    return step_[2 * (q / 4) + (q % 4) / 2];
  }
  Step after(const Step &step) const {
    return {step.face, (step.at + 1) % static_cast<uint32_t>(faces_[step.face].size())};
  }
  Step before(const Step &step) const {
    const uint32_t n = static_cast<uint32_t>(faces_[step.face].size());
    return {step.face, (step.at + n - 1) % n};
  }
  uint32_t from(const Step &step) const { return faces_[step.face][step.at]; }
  uint32_t to(const Step &step) const { return from(after(step)); }

 private:
  // Where a face goes from `destination` to `origin` along an edge that has no name yet; -1 if nowhere.
  int step_back(uint32_t face, uint32_t origin, uint32_t destination) const {
    for (uint32_t k = 0; k < faces_[face].size(); ++k) {
      const Step step{face, k};
      if (from(step) == destination && to(step) == origin && quarter_.count(step) == 0) return static_cast<int>(k);
    }
    return -1;
  }

  std::vector<std::vector<uint32_t>> faces_;
  std::map<Step, uint32_t> quarter_;
  std::vector<Step> step_;  // of quarter-edges 0 and 2 of every edge
  std::vector<uint32_t> memory_;
  QuadEdges quads_;
  uint32_t edges_ = 0;
};

TEST(QuadEdges, RotationsOfOneEdge) {
  for (const uint32_t q : {0U, 1U, 2U, 3U, 400U, 403U, 0x3FFFFFFCU}) {
    EXPECT_EQ(hsp::rot(hsp::rot(q)), hsp::sym(q));
    EXPECT_EQ(hsp::rot(hsp::inverse_rot(q)), q);
    EXPECT_EQ(hsp::inverse_rot(hsp::rot(q)), q);
    EXPECT_EQ(hsp::sym(hsp::sym(q)), q);
    EXPECT_NE(hsp::sym(q), q);
    for (const uint32_t to_view : {hsp::rot(q), hsp::sym(q), hsp::inverse_rot(q)}) {
      EXPECT_EQ(hsp::edge_of(to_view), hsp::edge_of(q));
      EXPECT_NE(to_view, q);
    }
    EXPECT_NE(hsp::rot(q) % 2, q % 2);
    EXPECT_EQ(hsp::dual_on_left(q), q % 2 == 0 ? hsp::inverse_rot(q) : hsp::rot(q));
  }
  EXPECT_EQ(hsp::quarter_edge(7), 28U);
  EXPECT_EQ(hsp::edge_of(hsp::quarter_edge(7)), 7U);
}

// Every quarter-edge has a place of its own in either table.
TEST(QuadEdges, NumbersDoNotOverlap) {
  constexpr uint32_t edges = 9;
  std::vector<uint32_t> memory(QuadEdges::numbers_per_edge * edges);
  QuadEdges quads;
  quads.bind({memory.data(), QuadEdges::numbers_per_edge * edges});
  ASSERT_EQ(quads.next.size(), 4 * edges);
  ASSERT_EQ(quads.start.size(), 4 * edges);
  for (uint32_t q = 0; q < 4 * edges; ++q) {
    quads.next[q] = q;
    quads.start[q] = 1000 + q;
  }
  for (uint32_t q = 0; q < 4 * edges; ++q) {
    EXPECT_EQ(quads.next[q], q);
    EXPECT_EQ(quads.start[q], 1000 + q);
  }
  // And nothing else is touched: all numbers are there once.
  const std::set<uint32_t> all(memory.begin(), memory.end());
  EXPECT_EQ(all.size(), memory.size());
}

TEST(QuadEdges, EverySurfaceIsClosed) {
  for (const Polyhedron &polyhedron : polyhedra) {
    SCOPED_TRACE(polyhedron.name);
    const Built built(polyhedron);
    // Every step has another side: no place is left without a successor.
    EXPECT_EQ(built.quarters().size(), 2 * built.edges());
    for (uint32_t q = 0; q < 4 * built.edges(); ++q) {
      EXPECT_LT(built.quads().onext(q), 4 * built.edges());
      EXPECT_NE(built.quads().origin(q), hsp::no_id);
    }
    const int euler = static_cast<int>(built.vertices() + built.faces()) - static_cast<int>(built.edges());
    EXPECT_EQ(euler, polyhedron.name == "torus" ? 0 : 2);
  }
}

// About a face: its cycle. About a vertex, counter-clockwise: the edge after q has q's left face on its right, so that
// it is the edge by which that face comes to q's origin, taken the other way.
TEST(QuadEdges, StepsFollowTheCycles) {
  for (const Polyhedron &polyhedron : polyhedra) {
    SCOPED_TRACE(polyhedron.name);
    const Built built(polyhedron);
    const QuadEdges &quads = built.quads();
    for (const auto &[step, q] : built.quarters()) {
      SCOPED_TRACE(q);
      EXPECT_EQ(quads.origin(q), built.from(step));
      EXPECT_EQ(quads.origin(hsp::sym(q)), built.to(step));
      EXPECT_EQ(quads.left(q), step.face);
      EXPECT_EQ(quads.lnext(q), built.quarter(built.after(step)));
      EXPECT_EQ(quads.onext(q), hsp::sym(built.quarter(built.before(step))));
      EXPECT_EQ(quads.lnext(hsp::sym(q)), built.quarter(built.after(built.across(step))));
    }
  }
}

// The dual edges: rot runs from the face on the right to that on the left, and the dual surface is a surface as well,
// whose faces are the vertices.
TEST(QuadEdges, DualsAreASurface) {
  for (const Polyhedron &polyhedron : polyhedra) {
    SCOPED_TRACE(polyhedron.name);
    const Built built(polyhedron);
    const QuadEdges &quads = built.quads();
    for (uint32_t q = 0; q < 4 * built.edges(); ++q) {
      SCOPED_TRACE(q);
      EXPECT_EQ(quads.origin(hsp::rot(q)), quads.left(hsp::sym(q)));
      EXPECT_EQ(quads.origin(hsp::inverse_rot(q)), quads.left(q));
      EXPECT_EQ(quads.left(hsp::rot(q)), quads.origin(q));
      EXPECT_EQ(quads.onext(hsp::rot(quads.onext(hsp::rot(q)))), q);
      EXPECT_EQ(quads.lnext(hsp::sym(quads.onext(q))), q);
      EXPECT_EQ(hsp::sym(quads.onext(quads.lnext(q))), q);
      EXPECT_EQ(quads.lnext(q), hsp::rot(quads.onext(hsp::inverse_rot(q))));
      EXPECT_EQ(quads.origin(quads.onext(q)), quads.origin(q));
      EXPECT_EQ(quads.left(quads.lnext(q)), quads.left(q));
      EXPECT_EQ(quads.origin(quads.lnext(q)), quads.origin(hsp::sym(q)));
    }
  }
}

// Rings about vertices are as long as the vertex has edges, each once.
TEST(QuadEdges, RingsAboutVerticesAreWhole) {
  const std::map<std::string, uint32_t> degree = {
      {"tetrahedron", 3}, {"cube", 3}, {"lens", 2}, {"two triangles", 2}, {"torus", 4}};
  for (const Polyhedron &polyhedron : polyhedra) {
    const auto expected = degree.find(polyhedron.name);
    if (expected == degree.end()) continue;
    SCOPED_TRACE(polyhedron.name);
    const Built built(polyhedron);
    for (const auto &[step, q] : built.quarters()) {
      std::set<uint32_t> ring;
      uint32_t at = q;
      do {
        ring.insert(at);
        at = built.quads().onext(at);
      } while (at != q && ring.size() <= 4 * built.edges());
      EXPECT_EQ(ring.size(), expected->second);
    }
  }
}

// An edge that ends in the middle of a face has it on both sides: rings may visit an edge twice.
TEST(QuadEdges, AnEdgeThatEndsInsideAFace) {
  // A lens of edges 0 and 1 between vertices 0 and 1, and edge 2 from vertex 1 to vertex 2 in the face on the left.
  std::vector<uint32_t> memory(3 * QuadEdges::numbers_per_edge);
  QuadEdges quads;
  quads.bind({memory.data(), 3 * QuadEdges::numbers_per_edge});
  quads.edges = 3;
  quads.link_lnext(0, 8);   // to vertex 1, out along the spike,
  quads.link_lnext(8, 10);  // back,
  quads.link_lnext(10, 4);  // and on along edge 1 to vertex 0
  quads.link_lnext(4, 0);
  quads.link_lnext(2, 6);  // the face on the right
  quads.link_lnext(6, 2);
  EXPECT_EQ(quads.onext(10), 10U);  // alone at its end
  // About vertex 1, counter-clockwise: edge 0 back, the spike, edge 1.
  EXPECT_EQ(quads.onext(8), 2U);
  EXPECT_EQ(quads.onext(2), 4U);
  EXPECT_EQ(quads.onext(4), 8U);
  for (uint32_t q = 0; q < 12; ++q) EXPECT_EQ(quads.onext(hsp::rot(quads.onext(hsp::rot(q)))), q);
  for (uint32_t q = 0; q < 12; q += 2) EXPECT_EQ(quads.next_on_face(q), quads.lnext(q));
}

}  // namespace
