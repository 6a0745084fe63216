#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "finding.hpp"
#include "structure_laws.hpp"

namespace {

using Real = long double;
using Real3 = std::array<Real, 3>;

Real3 difference(const double *to, const double *from) {
  return {Real{to[0]} - from[0], Real{to[1]} - from[1], Real{to[2]} - from[2]};
}

Real dot(const Real3 &a, const Real3 &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Real3 cross(const Real3 &a, const Real3 &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real3 plus(const Real3 &a, Real factor, const Real3 &b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Real length(const Real3 &a) {
  return std::sqrt(dot(a, a));
}

struct Sphere {
  std::array<double, 3> centre;
  Real radius;
};

class Geometry {
 public:
  Geometry(const LibraryTopology &topology, const oracle::Balls &balls)
      : topology_(topology), vertices_(topology.vertices()), edges_(topology.edges()) {
    Real farthest = 0;
    Real largest = 1;
    for (const oracle::LatticeBall &ball : balls) {
      spheres_.push_back({{static_cast<double>(ball.x), static_cast<double>(ball.y), static_cast<double>(ball.z)},
                          static_cast<Real>(ball.radius)});
      for (const double x : spheres_.back().centre) farthest = std::max(farthest, std::abs(Real{x}));
      largest = std::max(largest, spheres_.back().radius);
    }
    // Positions are doubles of full coordinates, computed in doubles from the balls.
    tolerance_ = 1e-9L * largest + 8 * Real{std::numeric_limits<double>::epsilon()} * farthest;
  }

  std::string first_broken() {
    for (std::uint32_t id = 0; id < vertices_.size(); ++id) check_vertex(id);
    for (std::uint32_t id = 0; id < edges_.size(); ++id) check_edge(id);
    const std::vector<hsp_shell> shells = topology_.shells();
    for (std::uint32_t id = 0; id < shells.size(); ++id) check_point_of_shell(shells[id], id);
    const std::vector<hsp_circle> circles = topology_.boundary().circles();
    for (std::uint32_t id = 0; id < circles.size(); ++id) check_upright_points(circles[id], id);
    return finding_.text();
  }

 private:
  void check_vertex(std::uint32_t id) {
    const hsp_topology_vertex &v = vertices_[id];
    for (const std::uint32_t ball : v.ball) {
      if (ball == HSP_NONE) continue;
      const Sphere &sphere = spheres_[ball];
      const Real3 radial = difference(v.xyz, sphere.centre.data());
      finding_.require(std::abs(length(radial) - sphere.radius) <= tolerance_, "vertex", id, "is not on ball", ball);
      if (v.kind == HSP_POINT_POLE)
        finding_.require(std::abs(radial[0]) <= tolerance_ && std::abs(radial[1]) <= tolerance_, "pole", id);
    }
  }

  void check_edge(std::uint32_t id) {
    const hsp_topology_edge &edge = edges_[id];
    const Real3 axis = {edge.axis[0], edge.axis[1], edge.axis[2]};
    finding_.require(std::abs(length(axis) - 1) < 1e-12L, "axis of edge", id);
    finding_.require(edge.angle >= 0 && edge.angle <= 2 * std::numbers::pi, "angle of edge", id, ":", edge.angle);
    for (std::uint32_t side = 0; side < 2; ++side) {
      const Sphere &sphere = spheres_[edge.ball[side]];
      const Real3 offset = difference(edge.centre, sphere.centre.data());
      // The circle lies on both spheres: its axis passes through their centres.
      finding_.require(length(cross(offset, axis)) <= tolerance_, "the axis of edge", id, "misses ball", side);
      finding_.require(std::abs(dot(offset, offset) + Real{edge.radius} * edge.radius -
                                sphere.radius * sphere.radius) <= 2 * tolerance_ * std::max<Real>(1, sphere.radius),
                       "the circle of edge", id, "is not on the sphere of its side", side);
      const Real3 end = difference(vertices_[edge.vertex[side]].xyz, edge.centre);
      finding_.require(std::abs(dot(end, axis)) <= tolerance_ && std::abs(length(end) - edge.radius) <= tolerance_,
                       "end", side, "of edge", id, "is off its circle");
    }
    const Real3 from = difference(vertices_[edge.vertex[0]].xyz, edge.centre);
    const Real3 to = difference(vertices_[edge.vertex[1]].xyz, edge.centre);
    const Real3 turned = plus({0, 0, 0}, std::cos(Real{edge.angle}), from);
    const Real3 gap = plus(plus(turned, std::sin(Real{edge.angle}), cross(axis, from)), -1, to);
    finding_.require(length(gap) <= 4 * tolerance_, "edge", id, "ends", static_cast<double>(length(gap)),
                     "from where its angle says");
    if (edge.kind == HSP_EDGE_EXTRA) {
      const Sphere &sphere = spheres_[edge.ball[0]];
      finding_.require(edge.ball[0] == edge.ball[1], "two balls beside the extra edge", id);
      finding_.require(length(difference(edge.centre, sphere.centre.data())) <= tolerance_ &&
                           std::abs(edge.radius - sphere.radius) <= tolerance_,
                       "the extra edge", id, "is on no great circle");
      finding_.require(std::abs(axis[2]) <= 1e-12L, "the plane of the extra edge", id, "is not upright");
      return;
    }
    const Real3 across = difference(spheres_[edge.ball[0]].centre.data(), spheres_[edge.ball[1]].centre.data());
    finding_.require(dot(across, axis) > 0, "the axis of edge", id, "points away from its left face");
  }

  /// In no ball, and on one with a face of the shell.
  void check_point_of_shell(const hsp_shell &shell, std::uint32_t id) {
    std::vector<bool> of_shell(spheres_.size(), false);
    for (const hsp_face &face : topology_.boundary().faces())
      if (face.shell == id) of_shell[face.ball] = true;
    bool on_shell = false;
    for (std::size_t i = 0; i < spheres_.size(); ++i) {
      const Real height = length(difference(shell.point, spheres_[i].centre.data())) - spheres_[i].radius;
      finding_.require(height >= -tolerance_, "the point of shell", id, "lies in ball", i);
      on_shell = on_shell || (of_shell[i] && height <= tolerance_);
    }
    finding_.require(on_shell, "the point of shell", id, "is not on it");
  }

  void check_upright_points(const hsp_circle &circle, std::uint32_t id) {
    const Real3 axis = {circle.axis[0], circle.axis[1], circle.axis[2]};
    const bool above_each_other = spheres_[circle.ball[0]].centre[0] == spheres_[circle.ball[1]].centre[0] &&
                                  spheres_[circle.ball[0]].centre[1] == spheres_[circle.ball[1]].centre[1];
    // Highest and lowest points of the circle; of a level circle those in the plane across x.
    Real3 upward = above_each_other ? Real3{0, 1, 0} : plus({0, 0, 1}, -axis[2], axis);
    const Real scale = 1 / length(upward);
    for (Real &x : upward) x *= scale;
    for (const int sign : {-1, 1}) {
      bool found = false;
      for (const hsp_topology_vertex &v : vertices_) {
        if (v.kind != HSP_POINT_CIRCLE || v.ball[0] != circle.ball[0] || v.ball[1] != circle.ball[1]) continue;
        found = found ||
                length(plus(difference(v.xyz, circle.centre), -sign * Real{circle.radius}, upward)) <= 100 * tolerance_;
      }
      finding_.require(found, "circle", id, "lacks one of its two points in the upright plane");
    }
  }

  const LibraryTopology &topology_;
  std::vector<hsp_topology_vertex> vertices_;
  std::vector<hsp_topology_edge> edges_;
  std::vector<Sphere> spheres_;
  Real tolerance_ = 0;
  Finding finding_;
};

}  // namespace

std::string geometry_broken(const LibraryTopology &topology, const oracle::Balls &balls) {
  return Geometry(topology, balls).first_broken();
}
