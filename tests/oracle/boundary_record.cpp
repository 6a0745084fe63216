#include "boundary_record.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace oracle {
namespace {

EdgeName arc_name(const BoundaryRecord::Arc &arc, const std::vector<VertexName> &vertices,
                  const std::vector<uint32_t> &label) {
  EdgeName name = {{label[arc.ball[0]], label[arc.ball[1]]}, vertices[arc.vertex[0]], vertices[arc.vertex[1]]};
  if (name.ball[0] > name.ball[1]) {
    // The axis turns round, and with it the sense in which the arc is run.
    std::swap(name.ball[0], name.ball[1]);
    std::swap(name.from, name.to);
  }
  return name;
}

EdgeName circle_name(const BoundaryRecord::Circle &circle, const std::vector<uint32_t> &label) {
  return {
      {std::min(label[circle.ball[0]], label[circle.ball[1]]), std::max(label[circle.ball[0]], label[circle.ball[1]])},
      {},
      {}};
}

}  // namespace

VertexName vertex_name(uint32_t a, uint32_t b, uint32_t c, int sign) {
  VertexName name = {{a, b, c}, sign};
  const auto exchange = [&](size_t i, size_t k) {
    if (name.ball[i] < name.ball[k]) return;
    std::swap(name.ball[i], name.ball[k]);
    name.sign = -name.sign;
  };
  exchange(0, 1);
  exchange(1, 2);
  exchange(0, 1);
  return name;
}

CanonicalBoundary canonical(const BoundaryRecord &record, const std::vector<uint32_t> &label) {
  CanonicalBoundary result;
  result.counts = record.counts;

  const size_t n = record.balls.size();
  result.contained.resize(n);
  result.smallest_of_component.resize(n);
  std::map<uint32_t, uint32_t> smallest;
  for (size_t i = 0; i < n; ++i) {
    result.contained[label[i]] = record.balls[i].contained ? 1 : 0;
    const auto [entry, is_new] = smallest.try_emplace(record.balls[i].component, label[i]);
    if (!is_new) entry->second = std::min(entry->second, label[i]);
  }
  for (size_t i = 0; i < n; ++i) result.smallest_of_component[label[i]] = smallest.at(record.balls[i].component);

  std::vector<VertexName> vertices;
  for (const auto &vertex : record.vertices) {
    vertices.push_back(vertex_name(label[vertex.ball[0]], label[vertex.ball[1]], label[vertex.ball[2]], vertex.sign));
    result.vertices.push_back({vertices.back(), vertex.tied});
  }
  std::sort(result.vertices.begin(), result.vertices.end());

  std::vector<CanonicalBoundary::Face> faces(record.faces.size());
  for (size_t f = 0; f < faces.size(); ++f) {
    faces[f].ball = label[record.faces[f].ball];
    faces[f].loops = record.faces[f].loops;
  }
  const auto put_edge = [&](const EdgeName &name, const auto &edge) {
    for (size_t side = 0; side < 2; ++side) {
      if (record.faces.at(edge.face[side]).ball != edge.ball[side])
        throw std::logic_error("an edge names a face of another ball");
      faces[edge.face[side]].edges.push_back(name);
    }
  };
  for (const auto &arc : record.arcs) {
    result.arcs.push_back(arc_name(arc, vertices, label));
    put_edge(result.arcs.back(), arc);
  }
  for (const auto &circle : record.circles) {
    result.circles.push_back(circle_name(circle, label));
    put_edge(result.circles.back(), circle);
  }
  std::sort(result.arcs.begin(), result.arcs.end());
  std::sort(result.circles.begin(), result.circles.end());

  for (auto &face : faces) std::sort(face.edges.begin(), face.edges.end());
  std::vector<size_t> order(faces.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return faces[a] < faces[b]; });
  std::map<uint32_t, uint32_t> first;
  for (const size_t f : order) {
    const auto place = static_cast<uint32_t>(result.faces.size());
    result.first_of_shell.push_back(first.try_emplace(record.faces[f].shell, place).first->second);
    result.faces.push_back(faces[f]);
  }
  return result;
}

std::string differences(const CanonicalBoundary &a, const CanonicalBoundary &b) {
  std::ostringstream text;
  const auto compare = [&](const char *name, const auto &x, const auto &y) {
    if (x != y) text << name << " (" << x.size() << " and " << y.size() << "), ";
  };
  const auto compare_count = [&](const char *name, int64_t x, int64_t y) {
    if (x != y) text << name << " " << x << " and " << y << ", ";
  };
  compare_count("exposed balls", a.counts.exposed_balls, b.counts.exposed_balls);
  compare_count("contained balls", a.counts.contained_balls, b.counts.contained_balls);
  compare_count("loops", a.counts.loops, b.counts.loops);
  compare_count("number of shells", a.counts.shells, b.counts.shells);
  compare_count("number of components", a.counts.components, b.counts.components);
  compare_count("voids", a.counts.voids, b.counts.voids);
  compare_count("tied vertices", a.counts.tied_vertices, b.counts.tied_vertices);
  compare_count("euler", a.counts.euler, b.counts.euler);
  compare("contained flags", a.contained, b.contained);
  compare("components", a.smallest_of_component, b.smallest_of_component);
  compare("vertices", a.vertices, b.vertices);
  compare("arcs", a.arcs, b.arcs);
  compare("circles", a.circles, b.circles);
  compare("faces", a.faces, b.faces);
  compare("shells", a.first_of_shell, b.first_of_shell);
  return text.str();
}

}  // namespace oracle
