#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "cell_laws.hpp"
#include "finding.hpp"
#include "random_balls.hpp"

namespace {

using Double3 = std::array<double, 3>;

/// Adding zero turns a negative zero into the other one.
Double3 three(const double *x, double sign = 1) {
  return {sign * x[0] + 0.0, sign * x[1] + 0.0, sign * x[2] + 0.0};
}

using VertexKey = std::tuple<std::uint32_t, std::array<std::uint32_t, 3>, Double3>;
using EdgeKey = std::tuple<std::uint32_t, std::array<std::uint32_t, 2>, Double3, Double3, double, Double3, Double3>;
using FaceKey = std::tuple<std::uint32_t, std::uint32_t>;  // ball, edges
using ShellKey = std::tuple<std::uint32_t, std::uint32_t, std::int32_t, std::uint32_t, std::uint32_t, std::uint32_t,
                            std::uint32_t, std::uint32_t>;
using CellKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

/// A topology by the ranks of its balls in the tie rule, without any other id.
struct Canonical {
  std::vector<VertexKey> vertices;
  std::vector<std::pair<EdgeKey, double>> edges;  // with their angles
  std::vector<FaceKey> faces;
  std::vector<ShellKey> shells;
  std::vector<CellKey> cells;
  std::vector<std::vector<FaceKey>> scans;
  std::vector<std::uint32_t> top_balls;
  std::array<std::uint32_t, 2> start = {HSP_NONE, 0};
  std::vector<double> measures;  // areas and volumes of shells, ascending
};

EdgeKey edge_key(const hsp_topology_edge &edge, const std::vector<hsp_topology_vertex> &vertices,
                 const std::vector<std::uint32_t> &rank) {
  const auto key = [&](std::size_t first, double sign) {
    return EdgeKey{edge.kind,
                   {rank[edge.ball[first]], rank[edge.ball[1 - first]]},
                   three(edge.centre),
                   three(edge.axis, sign),
                   edge.radius,
                   three(vertices[edge.vertex[first]].xyz),
                   three(vertices[edge.vertex[1 - first]].xyz)};
  };
  return std::min(key(0, 1), key(1, -1));
}

Canonical canonical(const oracle::Balls &balls) {
  const LibraryTopology topology(balls);
  const std::vector<std::uint32_t> rank = oracle::tie_ranks(balls);
  const auto faces = topology.faces();
  const auto shells = topology.shells();
  const auto vertices = topology.vertices();
  const auto components = topology.components();
  Canonical result;
  for (const hsp_topology_vertex &v : vertices) {
    std::array<std::uint32_t, 3> ranks{};
    for (std::size_t k = 0; k < 3; ++k) ranks[k] = v.ball[k] == HSP_NONE ? HSP_NONE : rank[v.ball[k]];
    std::sort(ranks.begin(), ranks.end());
    result.vertices.emplace_back(v.kind, ranks, three(v.xyz));
  }
  for (const hsp_topology_edge &edge : topology.edges())
    result.edges.emplace_back(edge_key(edge, vertices, rank), edge.angle);
  for (const hsp_simple_face &face : faces) result.faces.emplace_back(rank[face.ball], face.edges);
  for (std::uint32_t shell = 0; shell < shells.size(); ++shell) {
    result.scans.emplace_back();
    for (const std::uint32_t face : topology.scan(shell))
      result.scans.back().emplace_back(rank[faces[face].ball], faces[face].edges);
  }
  for (const hsp_shell &shell : shells) {
    const std::uint32_t top = rank[components[shell.component].top_ball];
    result.shells.emplace_back(top, shell.kind, shell.euler, shell.genus, shell.faces, shell.simple_faces, shell.edges,
                               shell.vertices);
    result.measures.insert(result.measures.end(), {shell.area, shell.volume});
  }
  for (const hsp_cell &cell : topology.cells()) {
    const std::uint32_t around =
        cell.wall == HSP_NONE ? HSP_NONE : rank[components[shells[cell.wall].component].top_ball];
    result.cells.emplace_back(around, cell.components, cell.shells);
  }
  for (const hsp_component &component : components) result.top_balls.push_back(rank[component.top_ball]);
  if (const std::uint32_t start = topology.counts().start_face; start != HSP_NONE)
    result.start = {rank[faces[start].ball], faces[start].edges};
  std::sort(result.vertices.begin(), result.vertices.end());
  std::sort(result.edges.begin(), result.edges.end());
  std::sort(result.faces.begin(), result.faces.end());
  std::sort(result.shells.begin(), result.shells.end());
  std::sort(result.scans.begin(), result.scans.end());
  std::sort(result.cells.begin(), result.cells.end());
  std::sort(result.top_balls.begin(), result.top_balls.end());
  std::sort(result.measures.begin(), result.measures.end());
  return result;
}

std::string difference(const Canonical &found, const Canonical &expected) {
  Finding finding;
  finding.require(found.vertices == expected.vertices, "vertices", found.vertices.size(), expected.vertices.size());
  finding.require(found.edges.size() == expected.edges.size(), "edges", found.edges.size(), expected.edges.size());
  for (std::size_t k = 0; k < expected.edges.size() && !finding.any(); ++k)
    finding.require(found.edges[k].first == expected.edges[k].first, "edges");
  finding.require(found.faces == expected.faces, "simple faces", found.faces.size(), expected.faces.size());
  finding.require(found.shells == expected.shells, "shells");
  finding.require(found.scans == expected.scans, "scans");
  finding.require(found.cells == expected.cells, "cells");
  finding.require(found.top_balls == expected.top_balls, "top balls");
  finding.require(found.start == expected.start, "start face");
  if (finding.any()) return finding.text();
  double scale = 0;
  for (const double measure : expected.measures) scale = std::max(scale, std::abs(measure));
  for (std::size_t k = 0; k < expected.measures.size(); ++k)
    finding.require(std::abs(found.measures[k] - expected.measures[k]) <= 1e-11 * scale, "area or volume of a shell");
  return finding.text();
}

std::array<oracle::Balls, 3> other_orders(const oracle::Balls &balls) {
  oracle::RandomSource random(balls.size() + 1);
  oracle::Balls sorted = balls;
  std::sort(sorted.begin(), sorted.end());
  return {oracle::Balls(balls.rbegin(), balls.rend()), sorted,
          oracle::permuted(balls, random.permutation(balls.size()))};
}

}  // namespace

std::string topology_orders_disagree(const oracle::Balls &balls) {
  const Canonical expected = canonical(balls);
  for (const oracle::Balls &order : other_orders(balls))
    if (const std::string what = difference(canonical(order), expected); !what.empty())
      return what + "depend on the order, e.g. " + oracle::to_text(order);
  return "";
}

std::string angles_of_orders_disagree(const oracle::Balls &balls) {
  const Canonical expected = canonical(balls);
  for (const oracle::Balls &order : other_orders(balls))
    if (canonical(order).edges != expected.edges)
      return "angles of edges depend on the order, e.g. " + oracle::to_text(order);
  return "";
}
