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

double dot(const Real3 &a, const Real3 &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// An edge as it is walked with the face on its left.
struct Side {
  Real3 start_direction;
  Real3 end_direction;
  double turning;  // the integral of its geodesic curvature
};

Side side_of(const hsp_topology_edge &edge, bool backwards, const std::vector<hsp_topology_vertex> &vertices,
             const oracle::LatticeBall &ball) {
  const double sign = backwards ? -1 : 1;
  const Real3 axis = {sign * edge.axis[0], sign * edge.axis[1], sign * edge.axis[2]};
  const auto direction = [&](std::uint32_t vertex) {
    const double *xyz = vertices[vertex].xyz;
    return cross(axis, {xyz[0] - edge.centre[0], xyz[1] - edge.centre[1], xyz[2] - edge.centre[2]});
  };
  const Real3 offset = {edge.centre[0] - static_cast<double>(ball.x), edge.centre[1] - static_cast<double>(ball.y),
                        edge.centre[2] - static_cast<double>(ball.z)};
  return {direction(edge.vertex[backwards ? 1 : 0]), direction(edge.vertex[backwards ? 0 : 1]),
          dot(offset, axis) / static_cast<double>(ball.radius) * edge.angle};
}

/// From one direction to another, seen along the outward normal, counter-clockwise, in (-pi, pi].
double turn(const Real3 &from, const Real3 &to, const Real3 &normal) {
  const double length = std::sqrt(dot(normal, normal));
  return std::atan2(dot(cross(from, to), normal) / length, dot(from, to));
}

}  // namespace

std::string face_areas_disagree(const LibraryTopology &topology, const oracle::Balls &balls) {
  Finding finding;
  const auto vertices = topology.vertices();
  const auto edges = topology.edges();
  const auto faces = topology.faces();
  std::vector<double> expected(topology.boundary().faces().size());
  std::vector<double> sums(expected.size(), 0);
  std::vector<double> tolerance(expected.size(), 0);
  expect_ok(hsp_boundary_measure_faces(topology.boundary().handle(), expected.data(), nullptr,
                                       static_cast<std::uint32_t>(expected.size())),
            "hsp_boundary_measure_faces");
  for (std::uint32_t id = 0; id < faces.size(); ++id) {
    const oracle::LatticeBall &ball = balls[faces[id].ball];
    double turned = 0;
    std::uint32_t q = faces[id].q;
    do {
      const std::uint32_t next = hsp_topology_lnext(topology.handle(), q);
      const Side side = side_of(edges[q / 4], q % 4 == 2, vertices, ball);
      const Side after = side_of(edges[next / 4], next % 4 == 2, vertices, ball);
      const double *corner = vertices[hsp_topology_origin(topology.handle(), next)].xyz;
      const Real3 normal = {corner[0] - static_cast<double>(ball.x), corner[1] - static_cast<double>(ball.y),
                            corner[2] - static_cast<double>(ball.z)};
      turned += side.turning + turn(side.end_direction, after.start_direction, normal);
      q = next;
    } while (q != faces[id].q);
    const double radius = static_cast<double>(ball.radius);
    // Gauss and Bonnet for a disc on the unit sphere: area = 2 pi - turning, below a whole sphere.
    const double area = 2 * std::numbers::pi - turned;
    finding.require(area > -1e-7 && area < 4 * std::numbers::pi + 1e-7, "simple face", id, "has the solid angle", area);
    sums[faces[id].face] += area * radius * radius;
    tolerance[faces[id].face] = 1e-7 * radius * radius;
  }
  for (std::size_t f = 0; f < sums.size(); ++f)
    finding.require(std::abs(sums[f] - expected[f]) <= tolerance[f], "maximal face", f, "has the area", expected[f],
                    "and simple faces of", sums[f]);
  return finding.text();
}
