#include "hsp_topology.hpp"

#include "compute_from.hpp"
#include "model/queries.hpp"
#include "topology/positions.hpp"
#include "topology/shell_volumes.hpp"

using namespace hsp::capi;

namespace {

// The checks of every list of one region, before anything is counted.
int32_t check_list(const hsp_topology *topology, uint32_t region, const uint32_t *out, uint32_t capacity) {
  const int32_t status = check_results(topology, out == nullptr && capacity > 0);
  return status == HSP_OK && region >= topology->structure().region_count ? HSP_E_ID : status;
}

}  // namespace

int32_t hsp_topology_limits_init(hsp_topology_limits *limits, uint32_t struct_size, const hsp_boundary *boundary) {
  if (const int32_t status = first_failure(check_handle(boundary), check_struct(limits, struct_size)); status != HSP_OK)
    return status;
  if (!boundary->has_results()) return HSP_E_STATE;
  const uint32_t neighbours = boundary->builder.needed().neighbours;
  return hsp_topology::Limits::write(hsp::limits_for(boundary->balls(), boundary->structure(), neighbours), limits,
                                     struct_size);
}

HSP_HANDLE_MEMORY(hsp_topology);

int32_t hsp_topology_compute(hsp_topology *topology, const hsp_boundary *boundary, hsp_topology_limits *limits) {
  return hsp_topology_compute_with(topology, boundary, nullptr, limits);
}

int32_t hsp_topology_compute_with(hsp_topology *topology, const hsp_boundary *boundary,
                                  const hsp_topology_request *request, hsp_topology_limits *limits) {
  return compute_from_boundary(topology, boundary, request, limits);
}

int32_t hsp_topology_get_counts(const hsp_topology *topology, hsp_topology_counts *counts) {
  if (const int32_t status = check_results(topology, counts == nullptr); status != HSP_OK) return status;
  const hsp::Topology &structure = topology->structure();
  *counts = {structure.vertex_count,
             structure.quads.edges,
             structure.face_count,
             structure.quads.edges - structure.first_cut_edge,
             structure.shell_count,
             structure.component_count,
             structure.region_count,
             structure.start_face,
             {0, 0, 0, 0}};
  return HSP_OK;
}

int32_t hsp_topology_get_shells(const hsp_topology *topology, hsp_shell *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_request(topology, out, capacity, needed,
                                       [](const hsp_topology &handle) { return handle.structure().shell_count; });
  if (status != HSP_OK) return status;
  const hsp::Topology &structure = topology->structure();
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
    record.reserved = 0;
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

int32_t hsp_topology_get_regions(const hsp_topology *topology, hsp_region *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_request(topology, out, capacity, needed,
                                       [](const hsp_topology &handle) { return handle.structure().region_count; });
  if (status != HSP_OK) return status;
  const hsp::Topology &structure = topology->structure();
  hsp::measure_regions(topology->balls(), topology->boundary->structure(), structure,
                       hsp::Span<hsp_region>(out, structure.region_count));
  return HSP_OK;
}

int32_t hsp_topology_get_region_shells(const hsp_topology *topology, uint32_t region, uint32_t *shells,
                                       uint32_t capacity, uint32_t *needed) {
  const int32_t status = check_list(topology, region, shells, capacity);
  if (status != HSP_OK) return status;
  const hsp::Topology &structure = topology->structure();
  uint32_t count = 0;
  for (uint32_t s = 0; s < structure.shell_count; ++s) count += structure.shells[s].region == region ? 1U : 0U;
  if (check_output(capacity, count, needed) != HSP_OK) return HSP_E_CAPACITY;
  uint32_t written = 0;
  for (uint32_t s = 0; s < structure.shell_count; ++s) {
    if (structure.shells[s].region == region) shells[written++] = s;
  }
  return HSP_OK;
}

int32_t hsp_topology_get_region_balls(const hsp_topology *topology, uint32_t region, uint32_t *balls, uint32_t capacity,
                                      uint32_t *needed) {
  const int32_t status = check_list(topology, region, balls, capacity);
  if (status != HSP_OK) return status;
  const hsp::Topology &structure = topology->structure();
  const hsp::Boundary &boundary = topology->boundary->structure();
  const uint32_t count = hsp::count_balls_of_region(boundary, structure, region);
  if (check_output(capacity, count, needed) != HSP_OK) return HSP_E_CAPACITY;
  hsp::list_balls_of_region(topology->balls(), boundary, structure, region, hsp::Span<uint32_t>(balls, count));
  return HSP_OK;
}

int32_t hsp_topology_locate(const hsp_topology *topology, const double *xyz, uint32_t *region) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(topology, xyz == nullptr || region == nullptr); status != HSP_OK)
    return status;
  const hsp::CubeGrid &grid = topology->boundary->model->grid;
  // Rounded as a query of radius 0, as that code is there: on microcontrollers round_point() would be additional code.
  hsp::LatticeQuery point;
  const hsp::Status status = hsp::round_query(grid.balls(), xyz, 0.0, point);
  if (status != hsp::Status::ok) return to_c(status);
  *region = hsp::any_ball_meets(grid, point)
                ? HSP_NONE
                : hsp::region_of_point(grid, topology->boundary->structure(), topology->structure(), point.centre);
  return HSP_OK;
}
