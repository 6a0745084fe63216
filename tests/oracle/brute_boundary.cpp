#include "brute_boundary.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "disjoint_sets.hpp"
#include "loop_nesting.hpp"
#include "sphere_predicates.hpp"

namespace oracle {
namespace {

class BruteBoundary {
 public:
  explicit BruteBoundary(const Balls &balls) : set_(balls), spheres_(balls.size()) {}

  BoundaryRecord build() {
    relate_pairs();
    find_vertices();
    for (uint32_t a = 0; a < set_.size(); ++a) find_loops(a);
    find_faces();
    find_edges();
    find_shells();
    return record_;
  }

 private:
  void relate_pairs();
  void find_vertices();
  [[nodiscard]] bool is_free(uint32_t a, uint32_t b, uint32_t c, int side, const std::vector<uint32_t> &others,
                             bool *tied) const;
  void find_loops(uint32_t a);
  void find_faces();
  void find_edges();
  void find_shells();

  [[nodiscard]] uint32_t vertex(uint32_t a, uint32_t b, uint32_t c, int side) const {
    const auto found = vertex_of_name_.find(vertex_name(a, b, c, side));
    return found == vertex_of_name_.end() ? no_ball : found->second;
  }
  [[nodiscard]] uint32_t face(uint32_t a, size_t circle, size_t arc) const {
    return first_face_[a] + face_of_loop_[a][spheres_[a].loop_of_arc[circle].at(arc)];
  }
  [[noreturn]] void contradiction(const char *what) const {
    throw std::logic_error(what + (": " + to_text(set_.balls())));
  }

  TiedBalls set_;
  BoundaryRecord record_;
  std::vector<std::vector<uint32_t>> partners_;  // balls with a common circle
  std::map<VertexName, uint32_t> vertex_of_name_;
  std::vector<SphereLoops> spheres_;
  std::vector<std::vector<uint32_t>> face_of_loop_;
  std::vector<uint32_t> first_face_;
};

void BruteBoundary::relate_pairs() {
  const uint32_t n = set_.size();
  partners_.resize(n);
  record_.balls.assign(n, {false, 0});
  DisjointSets components(n);
  for (uint32_t a = 0; a < n; ++a)
    for (uint32_t b = a + 1; b < n; ++b) {
      const PairRelation relation = set_.pair(a, b);
      if (relation == PairRelation::disjoint) continue;
      components.join(a, b);
      if (relation == PairRelation::first_inside_second) record_.balls[a].contained = true;
      if (relation == PairRelation::second_inside_first) record_.balls[b].contained = true;
      if (relation == PairRelation::circle) {
        partners_[a].push_back(b);
        partners_[b].push_back(a);
      }
    }
  const std::vector<uint32_t> number = components.numbers();
  for (uint32_t a = 0; a < n; ++a) {
    record_.balls[a].component = number[a];
    record_.counts.contained_balls += record_.balls[a].contained ? 1U : 0U;
  }
  record_.counts.components = components.count();
}

bool BruteBoundary::is_free(uint32_t a, uint32_t b, uint32_t c, int side, const std::vector<uint32_t> &others,
                            bool *tied) const {
  const Crossing point = {set_.cap(a, b), set_.cap(a, c), side};
  std::vector<uint32_t> undecided;
  for (const uint32_t d : others) {
    const int inside = set_.crossing_inside_as_given(a, point, set_.cap(a, d));
    if (inside > 0) return false;
    if (inside == 0) undecided.push_back(d);
  }
  for (const uint32_t d : undecided)
    if (set_.crossing_inside(a, point, set_.cap(a, d))) return false;
  *tied = !undecided.empty() || set_.circles_cross_as_given(a, point.first, point.second) == 0;
  return true;
}

void BruteBoundary::find_vertices() {
  for (uint32_t a = 0; a < set_.size(); ++a) {
    if (record_.balls[a].contained) continue;
    for (const uint32_t b : partners_[a])
      for (const uint32_t c : partners_[b]) {
        const auto &of_a = partners_[a];
        if (b <= a || c <= b || std::find(of_a.begin(), of_a.end(), c) == of_a.end()) continue;
        if (record_.balls[b].contained || record_.balls[c].contained) continue;
        if (!set_.circles_cross(a, set_.cap(a, b), set_.cap(a, c))) continue;
        // A ball that holds a point of a sphere but not the whole sphere has a circle on it: only such balls matter.
        // Contained balls hold nothing that their containers do not hold.
        std::vector<uint32_t> others;
        for (const uint32_t d : of_a)
          if (d != b && d != c && !record_.balls[d].contained) others.push_back(d);
        for (const int side : {+1, -1}) {
          bool tied = false;
          if (!is_free(a, b, c, side, others, &tied)) continue;
          vertex_of_name_[{{a, b, c}, side}] = static_cast<uint32_t>(record_.vertices.size());
          record_.vertices.push_back({{a, b, c}, side, tied});
          record_.counts.tied_vertices += tied ? 1U : 0U;
        }
      }
  }
}

void BruteBoundary::find_loops(uint32_t a) {
  SphereLoops &sphere = spheres_[a];
  sphere.ball = a;
  if (record_.balls[a].contained) return;

  struct Place {
    size_t circle;
    size_t arc;
  };
  std::map<uint32_t, Place> arc_that_enters_at;  // by the vertex at which the arc ends
  for (const uint32_t b : partners_[a]) {
    std::vector<Cap> others;
    for (const uint32_t c : partners_[a])
      if (c != b) others.push_back(set_.cap(a, c));
    sphere.circles.emplace_back(set_, a, set_.cap(a, b), others,
                                [&](const Cap &cap, int side) { return vertex(a, b, cap.ball, side) != no_ball; });
    const FreePieces &circle = sphere.circles.back();
    const bool whole = circle.kind() == FreePieces::Kind::whole;
    sphere.loop_of_arc.emplace_back(whole ? 1 : circle.arcs().size(), no_ball);
    if (whole) sphere.loop_of_arc.back()[0] = sphere.loops++;
    for (size_t k = 0; k < circle.arcs().size(); ++k) {
      const Place place = {sphere.circles.size() - 1, k};
      const uint32_t end = vertex(a, b, circle.arcs()[k].entry.ball, -1);
      if (!arc_that_enters_at.try_emplace(end, place).second) contradiction("two arcs end at one vertex");
    }
  }
  // With the face on the left an arc is run clockwise about the cap's axis: from its entry back to its exit, where the
  // arc of the exit's cap takes over.
  for (const auto &[start, first] : arc_that_enters_at) {
    if (sphere.loop_of_arc[first.circle][first.arc] != no_ball) continue;
    uint32_t at = start;
    do {
      const Place place = arc_that_enters_at.at(at);
      const FreePieces &circle = sphere.circles[place.circle];
      sphere.loop_of_arc[place.circle][place.arc] = sphere.loops;
      at = vertex(a, circle.circle().ball, circle.arcs()[place.arc].exit.ball, +1);
      if (!arc_that_enters_at.contains(at)) contradiction("a loop ends");
    } while (at != start);
    ++sphere.loops;
  }
}

void BruteBoundary::find_faces() {
  const uint32_t n = set_.size();
  face_of_loop_.resize(n);
  first_face_.resize(n);
  for (uint32_t a = 0; a < n; ++a) {
    first_face_[a] = static_cast<uint32_t>(record_.faces.size());
    if (record_.balls[a].contained) continue;
    if (partners_[a].empty()) {
      record_.faces.push_back({a, 0, 0});
    } else {
      face_of_loop_[a] = faces_of_loops(set_, spheres_[a]);
      for (const uint32_t face : face_of_loop_[a]) {
        if (first_face_[a] + face >= record_.faces.size()) record_.faces.push_back({a, 0, 0});
        ++record_.faces[first_face_[a] + face].loops;
      }
    }
    record_.counts.loops += spheres_[a].loops;
    record_.counts.exposed_balls += record_.faces.size() > first_face_[a] ? 1U : 0U;
  }
}

void BruteBoundary::find_edges() {
  std::vector<uint32_t> ends(record_.vertices.size(), 0);
  for (uint32_t a = 0; a < set_.size(); ++a)
    for (size_t p = 0; p < spheres_[a].circles.size(); ++p) {
      const FreePieces &circle = spheres_[a].circles[p];
      const uint32_t b = circle.circle().ball;
      const SphereLoops &opposite = spheres_[b];
      if (b < a || circle.kind() == FreePieces::Kind::covered) continue;
      size_t q = 0;
      while (q < opposite.circles.size() && opposite.circles[q].circle().ball != a) ++q;
      if (q == opposite.circles.size() || opposite.circles[q].kind() != circle.kind())
        contradiction("a circle seen from one ball only");
      const FreePieces &twin = opposite.circles[q];
      if (circle.kind() == FreePieces::Kind::whole) {
        record_.circles.push_back({{a, b}, {face(a, p, 0), face(b, q, 0)}});
        continue;
      }
      if (twin.arcs().size() != circle.arcs().size()) contradiction("circles with different numbers of arcs");
      for (size_t k = 0; k < circle.arcs().size(); ++k) {
        const FreeArc &arc = circle.arcs()[k];
        // From the other ball the axis points the other way: exit and entry change places.
        size_t m = 0;
        while (m < twin.arcs().size() &&
               (twin.arcs()[m].exit.ball != arc.entry.ball || twin.arcs()[m].entry.ball != arc.exit.ball))
          ++m;
        if (m == twin.arcs().size()) contradiction("an arc seen from one ball only");
        const uint32_t from = vertex(a, b, arc.exit.ball, +1);
        const uint32_t to = vertex(a, b, arc.entry.ball, -1);
        ++ends[from];
        ++ends[to];
        record_.arcs.push_back({{a, b}, {from, to}, {face(a, p, k), face(b, q, m)}});
      }
    }
  for (const uint32_t count : ends)
    if (count != 3) contradiction("a vertex without three arcs");
}

void BruteBoundary::find_shells() {
  DisjointSets shells(record_.faces.size());
  for (const auto &arc : record_.arcs) shells.join(arc.face[0], arc.face[1]);
  for (const auto &circle : record_.circles) shells.join(circle.face[0], circle.face[1]);
  const std::vector<uint32_t> number = shells.numbers();
  auto &counts = record_.counts;
  counts.euler = static_cast<int64_t>(record_.vertices.size()) - static_cast<int64_t>(record_.arcs.size());
  for (size_t f = 0; f < record_.faces.size(); ++f) {
    record_.faces[f].shell = number[f];
    counts.euler += 2 - static_cast<int64_t>(record_.faces[f].loops);
  }
  counts.shells = shells.count();
  if (counts.shells < counts.components) contradiction("a component without a shell");
  counts.voids = counts.shells - counts.components;
}

}  // namespace

BoundaryRecord brute_boundary(const Balls &balls) {
  return BruteBoundary(balls).build();
}

}  // namespace oracle
