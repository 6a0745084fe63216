#include "hsp_cells.hpp"

#include <limits>

#include "cells/arrangement.hpp"
#include "cells/cell_location.hpp"
#include "compute_from.hpp"
#include "conversion.hpp"
#include "handle_memory.hpp"
#include "hsp_topology.hpp"
#include "rounded_point.hpp"

using namespace hsp::capi;

namespace {

static_assert(static_cast<uint32_t>(hsp::CellKind::run) == HSP_CELL_RUN &&
              static_cast<uint32_t>(hsp::CellKind::at_ball) == HSP_CELL_AT_BALL &&
              static_cast<uint32_t>(hsp::CellKind::apart) == HSP_CELL_APART);

constexpr uint32_t number_of(hsp::FreeSpaceInvariant invariant) {
  return static_cast<uint32_t>(invariant);
}

// The numbers that the header gives the invariants of hsp_cells_check.
using hsp::FreeSpaceInvariant;
static_assert(number_of(FreeSpaceInvariant::none) == 0);
static_assert(number_of(FreeSpaceInvariant::records) == 1 && number_of(FreeSpaceInvariant::neighbours) == 2);
static_assert(number_of(FreeSpaceInvariant::regions) == 3 && number_of(FreeSpaceInvariant::power_cells) == 4);
static_assert(number_of(FreeSpaceInvariant::facets) == 5 && number_of(FreeSpaceInvariant::complement) == 6);

// The coordinate of a corner of a cube along one axis, as a length.
double corner(const hsp_cells &cells, int64_t cube) {
  if (cube <= -hsp::EmptyRuns::infinity) return -std::numeric_limits<double>::infinity();
  if (cube >= hsp::EmptyRuns::infinity) return std::numeric_limits<double>::infinity();
  return cells.balls().lattice.length(static_cast<double>(cube * cells.structure().side));
}

void put_box(const hsp_cells &cells, const hsp::CubeCoordinates &low, const hsp::CubeCoordinates &high,
             hsp_free_cell &record) {
  to_array({corner(cells, low.x), corner(cells, low.y), corner(cells, low.z)}, record.low);
  to_array({corner(cells, high.x), corner(cells, high.y), corner(cells, high.z)}, record.high);
}

}  // namespace

HSP_HANDLE_BY_BALLS(hsp_cells);

int32_t hsp_cells_compute(hsp_cells *cells, const hsp_model *model, hsp_cells_limits *limits) {
  return hsp_cells_compute_with(cells, model, nullptr, limits);
}

int32_t hsp_cells_compute_with(hsp_cells *cells, const hsp_model *model, const hsp_cells_request *request,
                               hsp_cells_limits *limits) {
  return compute_from_model(cells, model, request, limits);
}

int32_t hsp_cells_get_counts(const hsp_cells *cells, hsp_cells_counts *counts) {
  if (const int32_t status = check_results(cells, counts == nullptr); status != HSP_OK) return status;
  const hsp::FreeSpace &space = cells->structure();
  *counts = {space.cube_count(), space.power_cells,       space.cell_count(),
             space.run_count(),  space.adjacency_count(), space.region_count()};
  return HSP_OK;
}

int32_t hsp_cells_get_cells(const hsp_cells *cells, uint32_t first, uint32_t count, hsp_free_cell *out) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_range(cells, first, count, out, [](const hsp_cells &handle) { return handle.structure().cell_count(); });
  if (status != HSP_OK) return status;
  const hsp::FreeSpace &space = cells->structure();
  for (uint32_t k = 0; k < count; ++k) {
    const uint32_t c = first + k;
    const hsp::FreeCell &cell = space.cell(c);
    hsp_free_cell &record = out[k];
    record.cube = cell.cube;
    record.kind = static_cast<uint32_t>(cell.kind);
    record.region = cell.region;
    record.neighbours = space.neighbours(c).size();
    record.reserved = 0;
    record.ball = HSP_NONE;
    if (cell.kind == hsp::CellKind::run) continue;
    record.ball = cells->balls().caller[cell.ball];
    const hsp::CubeCoordinates &cube = space.cover.cube(cell.cube);
    put_box(*cells, cube, {cube.x + 1, cube.y + 1, cube.z + 1}, record);
  }
  if (first >= space.run_count() || count == 0) return HSP_OK;
  space.runs.for_each_run(space.cover,
                          [&](uint32_t run, const hsp::CubeCoordinates &low, const hsp::CubeCoordinates &high) {
                            if (run >= first && run - first < count) put_box(*cells, low, high, out[run - first]);
                          });
  return HSP_OK;
}

int32_t hsp_cells_get_neighbours(const hsp_cells *cells, uint32_t cell, uint32_t *neighbours, uint32_t capacity,
                                 uint32_t *needed) {
  if (const int32_t status = check_results(cells, neighbours == nullptr && capacity > 0); status != HSP_OK)
    return status;
  const hsp::FreeSpace &space = cells->structure();
  if (cell >= space.cell_count()) return HSP_E_ID;
  const hsp::Span<const uint32_t> list = space.neighbours(cell);
  if (const int32_t status = check_output(capacity, list.size(), needed); status != HSP_OK) return status;
  for (uint32_t k = 0; k < list.size(); ++k) neighbours[k] = list[k];
  return HSP_OK;
}

int32_t hsp_cells_get_pairs(const hsp_cells *cells, uint32_t first, uint32_t count, hsp_cell_pair *out) {
  const int32_t status = check_range(cells, first, count, out,
                                     [](const hsp_cells &handle) { return handle.structure().adjacency_count(); });
  if (status != HSP_OK) return status;
  for (uint32_t k = 0; k < count; ++k) {
    const hsp::AdjacentCells &pair = cells->structure().contacts[first + k];
    const bool in_order = pair.cell[0] < pair.cell[1];
    out[k] = {{pair.cell[in_order ? 0 : 1], pair.cell[in_order ? 1 : 0]}};
  }
  return HSP_OK;
}

int32_t hsp_cells_locate(const hsp_cells *cells, const double *xyz, uint32_t *cell) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(cells, xyz == nullptr || cell == nullptr); status != HSP_OK) return status;
  hsp::exact::Vector point;
  if (const int32_t status = round_point(cells->balls().lattice, xyz, point); status != HSP_OK) return status;
  *cell = hsp::cell_at(cells->balls(), cells->structure(), point);
  return HSP_OK;
}

int32_t hsp_cells_check(hsp_cells *cells, const hsp_topology *topology, uint32_t *invariant, uint32_t *id) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(cells); status != HSP_OK) return status;
  if (topology != nullptr && !is_live(topology)) return HSP_E_HANDLE;
  if (invariant == nullptr || id == nullptr) return HSP_E_ARGUMENT;
  if (!cells->has_results() || (topology != nullptr && !topology->has_results())) return HSP_E_STATE;
  if (topology != nullptr && !topology->boundary->model.is(&*cells->model)) return HSP_E_ARGUMENT;
  const hsp::FreeSpace &space = cells->structure();
  hsp::FreeSpaceViolation violation = hsp::check_free_space(cells->balls(), space, cells->builder.scratch());
  if (violation.invariant == FreeSpaceInvariant::none && topology != nullptr &&
      space.region_count() != topology->structure().region_count) {
    violation.invariant = FreeSpaceInvariant::complement;
  }
  return report(violation, invariant, id);
}

int32_t hsp_model_arrangement(const hsp_model *model, hsp_arrangement *totals, hsp_arrangement *of_ball,
                              uint32_t *scratch, uint32_t words, uint32_t *words_needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(model, scratch == nullptr && words > 0); status != HSP_OK) return status;
  const hsp::CubeGrid &grid = model->grid;
  // At first only neighbours are counted: nothing is written to `of_ball` unless the scratch memory suffices for all
  // balls.
  uint64_t needed = 0;
  for (uint32_t i = 0; i < grid.balls().n; ++i) {
    uint64_t own = 0;
    static_cast<void>(hsp::arrangement_on_sphere(grid, i, {}, own));
    needed = own > needed ? own : needed;
  }
  if (needed > UINT32_MAX) return HSP_E_RANGE;
  if (words_needed != nullptr) *words_needed = static_cast<uint32_t>(needed);
  if (needed > words) return HSP_E_CAPACITY;
  hsp::Arrangement sum;
  for (uint32_t i = 0; i < grid.balls().n; ++i) {
    const hsp::Arrangement own = hsp::arrangement_on_sphere(grid, i, {scratch, words}, needed);
    sum.vertices += own.vertices;
    sum.edges += own.edges;
    sum.faces += own.faces;
    if (of_ball != nullptr) of_ball[grid.balls().caller[i]] = {own.vertices, own.edges, own.faces};
  }
  // Each vertex is counted on three spheres, each edge on two.
  if (totals != nullptr) *totals = {sum.vertices / 3, sum.edges / 2, sum.faces};
  return HSP_OK;
}
