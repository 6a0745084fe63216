#include "topology/regions.hpp"

#include "core/first_index.hpp"
#include "core/sorting.hpp"
#include "model/vertical_ray.hpp"

namespace hsp {
namespace {

// Whether ball a reaches higher than ball b. Of two balls with equally high tops the one of lower rank counts as
// higher. If their tops are one point, this ball is larger and contains the other one, or they are equal and it
// contains the other one, too.
bool reaches_higher(const exact::LatticeBall &a, const exact::LatticeBall &b) {
  const int64_t top_a = a.centre.z + a.radius;
  const int64_t top_b = b.centre.z + b.radius;
  return top_a != top_b ? top_a > top_b : exact::ranks_before(a, b);
}

// The simple face that holds the highest point of a ball. face: the maximal face that holds it. Every great circle that
// cuts this face passes the highest point inside it.
uint32_t simple_face_of_top(const Boundary &boundary, const Topology &topology, uint32_t ball, uint32_t face) {
  const FixedVector<CutArc> &arcs = topology.cut_arcs;
  uint32_t k = first_index(0, arcs.size(), [&](uint32_t arc) { return arcs[arc].ball >= ball; });
  for (; k < arcs.size() && arcs[k].ball == ball; ++k) {
    const uint32_t poles = arcs[k].poles;
    if ((poles & CutArc::passes_north) == 0) continue;
    const bool behind_south = (poles & CutArc::south_first) != 0 && (poles & CutArc::vertex_at_south) != 0;
    return topology.quads.left(quarter_edge(topology.cut_first_edge[k] + (behind_south ? 1U : 0U)));
  }
  uint32_t simple = first_index(0, topology.face_count,
                                [&](uint32_t candidate) { return topology.ball_of(boundary, candidate) >= ball; });
  while (topology.faces[simple].face != face) ++simple;
  return simple;
}

// The traversal of a void starts at the first face on its ball of lowest rank.
void start_void_scans(const BallSet &balls, const Boundary &boundary, Topology &topology) {
  if (topology.shell_count == topology.component_count) return;
  for (uint32_t f = 0; f < topology.face_count; ++f) {
    ShellRecord &shell = topology.shells[topology.shell_of(boundary, f)];
    if (!shell.is_void) continue;
    const uint32_t ball = topology.ball_of(boundary, f);
    if (shell.start_face != no_id) {
      const uint32_t start_ball = topology.ball_of(boundary, shell.start_face);
      if (!exact::ranks_before(balls.ball(ball), balls.ball(start_ball))) continue;
    }
    shell.start_face = f;
  }
}

// Whether a simple face is the first of its ball on its region. The simple faces of a ball are consecutive.
bool is_first_on_ball(const Boundary &boundary, const Topology &topology, uint32_t simple) {
  const uint32_t ball = topology.ball_of(boundary, simple);
  const uint32_t region = topology.shells[topology.shell_of(boundary, simple)].region;
  while (simple > 0 && topology.ball_of(boundary, --simple) == ball) {
    if (topology.shells[topology.shell_of(boundary, simple)].region == region) return false;
  }
  return true;
}

// Calls visit(ball) once for every ball with a face on a region.
template <class Visit>
void visit_balls_of_region(const Boundary &boundary, const Topology &topology, uint32_t region, Visit visit) {
  for (uint32_t s = 0; s < topology.shell_count; ++s) {
    const ShellRecord &shell = topology.shells[s];
    if (shell.region != region) continue;
    for (const uint32_t simple :
         topology.traversal.part(shell.first_traversed, shell.first_traversed + shell.simple_faces)) {
      if (is_first_on_ball(boundary, topology, simple)) visit(topology.ball_of(boundary, simple));
    }
  }
}

// The shell that the ray upwards from a point enters first; no_id if it enters none.
uint32_t shell_above(const CubeGrid &grid, const Boundary &boundary, const Topology &topology,
                     const exact::Vector &point) {
  const uint32_t ball = first_ball_above(grid, point, topology.highest_centre);
  if (ball == no_id) return no_id;
  return boundary.face(face_of_entry(grid.balls(), boundary, ball, point.x, point.y)).shell;
}

// Finds the region that contains each component. One ray for each component finds the shell above it. A chain of
// components, each below the next one, ends in a void or in the outer region.
bool nest_components(const CubeGrid &grid, const Boundary &boundary, Patience &patience, Topology &topology) {
  for (uint32_t c = 0; c < topology.component_count; ++c) topology.components[c].region = no_id;
  for (uint32_t c = 0; c < topology.component_count; ++c) {
    if (!patience.allows(10000)) return false;
    ComponentRecord &component = topology.components[c];
    const exact::LatticeBall top = grid.balls().ball(component.top_ball);
    const uint32_t shell =
        shell_above(grid, boundary, topology, {top.centre.x, top.centre.y, top.centre.z + top.radius});
    component.above = no_id;
    if (shell == no_id) {
      component.region = 0;
    } else if (topology.shells[shell].is_void) {
      component.region = topology.shells[shell].region;
    } else {
      component.above = topology.shells[shell].component;
    }
  }
  for (uint32_t c = 0; c < topology.component_count; ++c) {
    uint32_t end = c;
    while (topology.components[end].region == no_id) end = topology.components[end].above;
    const uint32_t region = topology.components[end].region;
    for (uint32_t along = c; topology.components[along].region == no_id; along = topology.components[along].above) {
      topology.components[along].region = region;
    }
  }
  return true;
}

}  // namespace

void gather_components(const CubeGrid &grid, const Boundary &boundary, Topology &topology) {
  const BallSet &balls = grid.balls();
  topology.component_count = boundary.component_count();
  for (uint32_t c = 0; c < topology.component_count; ++c) topology.components[c] = {0, no_id, no_id, 0, 0, no_id};
  topology.highest_centre = balls.n > 0 ? balls.ball(0).centre.z : 0;
  for (uint32_t i = 0; i < balls.n; ++i) {
    const exact::LatticeBall ball = balls.ball(i);
    ComponentRecord &component = topology.components[boundary.component(i)];
    ++component.balls;
    if (component.top_ball == no_id || reaches_higher(ball, balls.ball(component.top_ball))) component.top_ball = i;
    if (ball.centre.z > topology.highest_centre) topology.highest_centre = ball.centre.z;
  }
}

bool gather_regions(const CubeGrid &grid, const Boundary &boundary, Patience &patience, Topology &topology) {
  topology.shell_count = boundary.shell_count();
  for (uint32_t s = 0; s < topology.shell_count; ++s) {
    topology.shells[s] = {no_id, 0, true, 0, 0, 0, 0, no_id, 0};
  }
  for (uint32_t f = 0; f < boundary.face_count(); ++f) {
    topology.shells[boundary.face(f).shell].component = boundary.component(boundary.face(f).ball);
  }
  if (!patience.allows(50 * uint64_t{boundary.face_count()})) return false;
  for (uint32_t c = 0; c < topology.component_count; ++c) {
    ComponentRecord &component = topology.components[c];
    const uint32_t face = face_of_top(grid.balls(), boundary, component.top_ball);
    component.outer_shell = boundary.face(face).shell;
    ShellRecord &shell = topology.shells[component.outer_shell];
    shell.is_void = false;
    shell.start_face = simple_face_of_top(boundary, topology, component.top_ball, face);
  }
  start_void_scans(grid.balls(), boundary, topology);
  topology.start_face = no_id;
  uint32_t highest = no_id;
  for (uint32_t c = 0; c < topology.component_count; ++c) {
    const ComponentRecord &component = topology.components[c];
    const exact::LatticeBall top = grid.balls().ball(component.top_ball);
    if (highest != no_id && !reaches_higher(top, grid.balls().ball(highest))) continue;
    highest = component.top_ball;
    topology.start_face = topology.shells[component.outer_shell].start_face;
  }
  topology.region_count = 1;
  for (uint32_t s = 0; s < topology.shell_count; ++s) {
    ShellRecord &shell = topology.shells[s];
    ++topology.components[shell.component].shells;
    if (shell.is_void) shell.region = topology.region_count++;
  }
  // Without voids there is only one region.
  if (topology.region_count > 1 && !nest_components(grid, boundary, patience, topology)) return false;
  for (uint32_t c = 0; c < topology.component_count; ++c) {
    topology.shells[topology.components[c].outer_shell].region = topology.components[c].region;
  }
  return true;
}

uint32_t count_balls_of_region(const Boundary &boundary, const Topology &topology, uint32_t region) {
  uint32_t count = 0;
  visit_balls_of_region(boundary, topology, region, [&count](uint32_t) { ++count; });
  return count;
}

void list_balls_of_region(const BallSet &balls, const Boundary &boundary, const Topology &topology, uint32_t region,
                          Span<uint32_t> ids) {
  uint32_t listed = 0;
  visit_balls_of_region(boundary, topology, region, [&](uint32_t ball) { ids[listed++] = balls.caller[ball]; });
  sort_ascending(ids);
}

uint32_t region_of_point(const CubeGrid &grid, const Boundary &boundary, const Topology &topology,
                         const exact::Vector &point) {
  if (topology.region_count == 1) return 0;
  const uint32_t shell = shell_above(grid, boundary, topology, point);
  return shell == no_id ? 0 : topology.shells[shell].region;
}

}  // namespace hsp
