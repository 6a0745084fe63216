#include <algorithm>
#include <cmath>
#include <numbers>

#include "finding.hpp"
#include "structure_laws.hpp"

namespace {

using Real3 = std::array<double, 3>;

Real3 cross(const Real3 &a, const Real3 &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The simple faces of one ball, seen along the upright line through its centre.
class UprightView {
 public:
  UprightView(const LibraryTopology &topology, const oracle::LatticeBall &ball)
      : topology_(topology),
        vertices_(topology.vertices()),
        edges_(topology.edges()),
        faces_(topology.faces()),
        ball_(ball) {}

  /// Is the highest point of the ball on the loop of a face? Extra edges run through it, other edges only by a tie.
  [[nodiscard]] bool has_top_on_loop(const hsp_simple_face &face) const {
    bool found = false;
    for_each_edge(face, [&](const hsp_topology_edge &edge, bool) {
      if (edge.kind != HSP_EDGE_EXTRA) return;
      const Real3 from = offset(edge, vertices_[edge.vertex[0]].xyz);
      const Real3 across = cross({edge.axis[0], edge.axis[1], edge.axis[2]}, from);
      const double angle = std::atan2(across[2], from[2]);  // of the highest point of its circle
      const double turn = angle < -1e-9 ? angle + 2 * std::numbers::pi : angle;
      found = found || turn <= edge.angle + 1e-9;
    });
    return found;
  }

  /// How often the loop of a face winds about the line, counter-clockwise from above. Extra edges are upright; where
  /// they pass the lowest point there is half a turn that is not counted.
  [[nodiscard]] double winding(const hsp_simple_face &face) const {
    constexpr int steps = 128;
    double sum = 0;
    for_each_edge(face, [&](const hsp_topology_edge &edge, bool backwards) {
      if (edge.kind == HSP_EDGE_EXTRA) return;
      const Real3 from = offset(edge, vertices_[edge.vertex[0]].xyz);
      const Real3 across = cross({edge.axis[0], edge.axis[1], edge.axis[2]}, from);
      double last = 0;
      for (int k = 0; k <= steps; ++k) {
        const double angle = edge.angle * k / steps;
        const double x = edge.centre[0] + std::cos(angle) * from[0] + std::sin(angle) * across[0];
        const double y = edge.centre[1] + std::cos(angle) * from[1] + std::sin(angle) * across[1];
        const double longitude = std::atan2(y - static_cast<double>(ball_.y), x - static_cast<double>(ball_.x));
        if (k > 0) sum += (backwards ? -1 : 1) * std::remainder(longitude - last, 2 * std::numbers::pi);
        last = longitude;
      }
    });
    return sum / (2 * std::numbers::pi);
  }

 private:
  static Real3 offset(const hsp_topology_edge &edge, const double *xyz) {
    return {xyz[0] - edge.centre[0], xyz[1] - edge.centre[1], xyz[2] - edge.centre[2]};
  }

  template <class Visit>
  void for_each_edge(const hsp_simple_face &face, Visit visit) const {
    std::uint32_t q = face.q;
    do {
      visit(edges_[q / 4], q % 4 == 2);
      q = hsp_topology_lnext(topology_.handle(), q);
    } while (q != face.q);
  }

  const LibraryTopology &topology_;
  std::vector<hsp_topology_vertex> vertices_;
  std::vector<hsp_topology_edge> edges_;
  std::vector<hsp_simple_face> faces_;
  oracle::LatticeBall ball_;
};

}  // namespace

std::string start_faces_disagree(const LibraryTopology &topology, const oracle::Balls &balls) {
  Finding finding;
  const auto faces = topology.faces();
  const auto shells = topology.shells();
  for (const hsp_component &component : topology.components()) {
    const std::uint32_t start = shells[component.outer_shell].start_face;
    const UprightView view(topology, balls[component.top_ball]);
    bool top_on_loop = false;
    for (const hsp_simple_face &face : faces)
      if (face.ball == component.top_ball) top_on_loop = top_on_loop || view.has_top_on_loop(face);
    if (top_on_loop) {
      finding.require(view.has_top_on_loop(faces[start]), "the start", start, "is not beside the highest point");
      continue;
    }
    // About the highest point but not the lowest: 1, or 1/2 with the lowest point on the loop. The other way round: the
    // negative numbers. About both or neither: 0.
    for (std::uint32_t id = 0; id < faces.size(); ++id) {
      if (faces[id].ball != component.top_ball) continue;
      const double winding = view.winding(faces[id]);
      finding.require(winding < 0.25 || id == start, "simple face", id, "and not the start", start,
                      "holds the highest point");
      finding.require(winding > -0.25 || id != start, "the start", id, "holds the lowest point but not the highest");
    }
  }
  return finding.text();
}
