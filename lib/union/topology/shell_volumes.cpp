#include "topology/shell_volumes.hpp"

#include "core/summation.hpp"

namespace hsp {
namespace {

// Whether a simple face is the first of those that its maximal face is cut into.
bool is_first_part(const Boundary &boundary, const Topology &topology, uint32_t simple) {
  const SimpleFace &part = topology.faces[simple];
  const IdRange loops = boundary.loops_of_face(part.face);
  if (loops.size() == 1) return true;
  if (loops.empty()) return simple < topology.quads.left(sym(part.q));  // one half of a whole sphere
  return simple == topology.quads.left(topology.start_of_loop(boundary, loops.first));
}

// Calls visit(face) for the maximal faces of a shell in the order of its scan.
template <class Visit>
void visit_faces(const Boundary &boundary, const Topology &topology, uint32_t shell, Visit visit) {
  const ShellRecord &record = topology.shells[shell];
  for (uint32_t k = 0; k < record.simple_faces; ++k) {
    const uint32_t simple = topology.traversal[record.first_traversed + k];
    if (is_first_part(boundary, topology, simple)) visit(topology.faces[simple].face);
  }
}

}  // namespace

BallMeasure measure_shell(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t shell) {
  TreeSum area;
  TreeSum volume;
  visit_faces(boundary, topology, shell, [&](uint32_t face) {
    const BallMeasure measure = measure_face(balls, boundary, face);
    area.add(measure.area);
    volume.add(measure.volume);
  });
  return {area.total(), volume.total()};
}

TopologyViolation check_enclosed_volumes(const BallSet &balls, const Boundary &boundary, const Topology &topology) {
  for (uint32_t s = 0; s < topology.shell_count; ++s) {
    // Every term has an error of some units in the last place of r^2 times the distance to the origin of the terms.
    double scale = 0.0;
    visit_faces(boundary, topology, s, [&](uint32_t face) {
      const uint32_t i = boundary.face(face).ball;
      const Vec3 arm = offset_from_origin(balls, boundary, i);
      const double r = balls.r[i];
      scale += r * r * (r + std::sqrt(dot(arm, arm)));
    });
    constexpr double tolerance = 0x1p-40;
    const double volume = measure_shell(balls, boundary, topology, s).volume;
    const double enclosed = topology.shells[s].is_void ? -volume : volume;
    if (!(enclosed >= -tolerance * scale)) return {TopologyInvariant::volumes, s};
  }
  return {};
}

}  // namespace hsp
