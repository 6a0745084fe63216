#include "hsp_topology.hpp"
#include "model/queries.hpp"
#include "rounded_point.hpp"
#include "topology/positions.hpp"
#include "topology/shell_volumes.hpp"

using hsp::capi::check_results;
using hsp::capi::LibraryArithmetic;

namespace {

using hsp::capi::check_output;
using hsp::capi::check_request;

// The checks of every list of one region or shell, number `id`, before it counts.
int32_t check_list(const hsp_topology *topology, uint32_t id, uint32_t hsp::Topology::*number, const uint32_t *out,
                   uint32_t capacity) {
  const int32_t status = check_results(topology, out == nullptr && capacity > 0);
  return status == HSP_OK && id >= topology->structure().*number ? HSP_E_ID : status;
}

}  // namespace

int32_t hsp_topology_get_shells(hsp_topology *topology, hsp_shell *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_request(topology, out, capacity, needed,
                                       [](const hsp_topology &handle) { return handle.structure().shell_count; });
  if (status != HSP_OK) return status;
  const hsp::Topology &structure = topology->scanned();
  const hsp::Boundary &boundary = topology->boundary->structure();
  const hsp::BallSet &balls = topology->balls();
  for (uint32_t s = 0; s < structure.shell_count; ++s) {
    const hsp::ShellRecord &shell = structure.shells[s];
    hsp_shell &record = out[s];
    const hsp::BallMeasure measure = hsp::measure_shell(balls, boundary, structure, s);
    record.area = balls.lattice.area(measure.area);
    record.volume = balls.lattice.volume(shell.is_void ? -measure.volume : measure.volume);
    const uint32_t vertex = structure.quads.origin(structure.faces[shell.start_face].q);
    hsp::to_coordinates(balls, hsp::position_of_point(balls, boundary, structure, vertex), record.point);
    record.euler = shell.euler();
    record.genus = shell.genus();
    record.kind = shell.is_void ? HSP_SHELL_VOID : HSP_SHELL_OUTER;
    record.component = shell.component;
    record.region = shell.region;
    record.faces = shell.faces;
    record.simple_faces = shell.simple_faces;
    record.edges = shell.edges;
    record.vertices = shell.vertices;
    record.start_face = shell.start_face;
  }
  return HSP_OK;
}

int32_t hsp_topology_get_components(const hsp_topology *topology, hsp_component *out, uint32_t capacity,
                                    uint32_t *needed) {
  const int32_t status = check_request(topology, out, capacity, needed,
                                       [](const hsp_topology &handle) { return handle.structure().component_count; });
  if (status != HSP_OK) return status;
  const hsp::BallSet &balls = topology->balls();
  const hsp::Topology &structure = topology->structure();
  for (uint32_t c = 0; c < structure.component_count; ++c) {
    const hsp::ComponentRecord &component = structure.components[c];
    out[c] = {component.balls,       balls.caller[component.top_ball],
              component.outer_shell, component.shells,
              component.region,      0};
  }
  return HSP_OK;
}

int32_t hsp_topology_get_regions(hsp_topology *topology, hsp_region *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_request(topology, out, capacity, needed,
                                       [](const hsp_topology &handle) { return handle.structure().region_count; });
  if (status != HSP_OK) return status;
  const hsp::Topology &structure = topology->scanned();
  hsp::measure_regions(topology->balls(), topology->boundary->structure(), structure,
                       hsp::Span<hsp_region>(out, structure.region_count));
  return HSP_OK;
}

int32_t hsp_topology_get_region_shells(const hsp_topology *topology, uint32_t region, uint32_t *shells,
                                       uint32_t capacity, uint32_t *needed) {
  const int32_t status = check_list(topology, region, &hsp::Topology::region_count, shells, capacity);
  if (status != HSP_OK) return status;
  const hsp::Topology &structure = topology->structure();
  uint32_t count = 0;
  for (uint32_t s = 0; s < structure.shell_count; ++s) count += structure.shells[s].region == region ? 1U : 0U;
  if (check_output(shells, capacity, count, needed) != HSP_OK) return HSP_E_CAPACITY;
  uint32_t written = 0;
  for (uint32_t s = 0; s < structure.shell_count; ++s) {
    if (structure.shells[s].region == region) shells[written++] = s;
  }
  return HSP_OK;
}

int32_t hsp_topology_get_region_balls(hsp_topology *topology, uint32_t region, uint32_t *balls, uint32_t capacity,
                                      uint32_t *needed) {
  const int32_t status = check_list(topology, region, &hsp::Topology::region_count, balls, capacity);
  if (status != HSP_OK) return status;
  const hsp::Topology &structure = topology->scanned();
  const hsp::Boundary &boundary = topology->boundary->structure();
  const uint32_t count = hsp::count_balls_of_region(boundary, structure, region);
  if (check_output(balls, capacity, count, needed) != HSP_OK) return HSP_E_CAPACITY;
  hsp::list_balls_of_region(topology->balls(), boundary, structure, region, hsp::Span<uint32_t>(balls, count));
  return HSP_OK;
}

int32_t hsp_topology_get_traversal(hsp_topology *topology, uint32_t shell, uint32_t *faces, uint32_t capacity,
                                   uint32_t *needed) {
  const int32_t status = check_list(topology, shell, &hsp::Topology::shell_count, faces, capacity);
  if (status != HSP_OK) return status;
  const hsp::Topology &structure = topology->scanned();
  const hsp::ShellRecord &record = structure.shells[shell];
  if (check_output(faces, capacity, record.simple_faces, needed) != HSP_OK) return HSP_E_CAPACITY;
  for (uint32_t k = 0; k < record.simple_faces; ++k) faces[k] = structure.traversal[record.first_traversed + k];
  return HSP_OK;
}

int32_t hsp_topology_locate(const hsp_topology *topology, const double *xyz, uint32_t *region) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(topology, xyz == nullptr || region == nullptr); status != HSP_OK)
    return status;
  const hsp::CubeGrid &grid = topology->boundary->model->grid;
  hsp::exact::Vector point;
  if (const int32_t status = hsp::capi::round_point(grid.balls().lattice, xyz, point); status != HSP_OK) return status;
  *region = hsp::any_ball_meets(grid, {point, 0})
                ? HSP_NONE
                : hsp::region_of_point(grid, topology->boundary->structure(), topology->structure(), point);
  return HSP_OK;
}
