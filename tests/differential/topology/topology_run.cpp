#include "topology_run.hpp"

#include <algorithm>

namespace {

template <class Record, class Getter>
std::vector<Record> all_records(Getter getter, const char *call) {
  std::uint32_t needed = 0;
  const std::int32_t status = getter(static_cast<Record *>(nullptr), 0U, &needed);
  if (status != (needed == 0 ? HSP_OK : HSP_E_CAPACITY)) expect_ok(status, call);
  std::vector<Record> records(needed);
  expect_ok(getter(records.data(), needed, &needed), call);
  return records;
}

}  // namespace

LibraryTopology::LibraryTopology(const oracle::Balls &balls, double step) : step_(step), boundary_(balls, step) {
  hsp_topology_limits limits;
  expect_ok(hsp_topology_limits_for(&limits, sizeof limits, boundary_.handle()), "hsp_topology_limits_for");
  // Three enlargements must do.
  for (int attempt = 0; attempt < 4; ++attempt) {
    std::size_t bytes = 0;
    expect_ok(hsp_topology_bytes(&limits, &bytes), "hsp_topology_bytes");
    memory_.assign(bytes, 0);
    expect_ok(hsp_topology_init(memory_.data(), bytes, &limits, &topology_), "hsp_topology_init");
    const std::int32_t status = hsp_topology_compute(topology_, boundary_.handle());
    if (status != HSP_E_CAPACITY || attempt == 3) {
      expect_ok(status, "hsp_topology_compute");
      return;
    }
    hsp_topology_limits needed;
    expect_ok(hsp_topology_get_needed(topology_, &needed), "hsp_topology_get_needed");
    limits.balls = std::max(limits.balls, needed.balls);
    limits.neighbours = std::max(limits.neighbours, needed.neighbours);
    limits.edges = std::max(limits.edges, needed.edges);
    limits.extra_arcs = std::max(limits.extra_arcs, needed.extra_arcs);
  }
}

hsp_topology_counts LibraryTopology::counts() const {
  hsp_topology_counts counts;
  expect_ok(hsp_topology_get_counts(topology_, &counts), "hsp_topology_get_counts");
  return counts;
}

std::vector<hsp_topology_vertex> LibraryTopology::vertices() const {
  return all_records<hsp_topology_vertex>([&](auto... out) { return hsp_topology_get_vertices(topology_, out...); },
                                          "hsp_topology_get_vertices");
}
std::vector<hsp_topology_edge> LibraryTopology::edges() const {
  return all_records<hsp_topology_edge>([&](auto... out) { return hsp_topology_get_edges(topology_, out...); },
                                        "hsp_topology_get_edges");
}
std::vector<hsp_simple_face> LibraryTopology::faces() const {
  return all_records<hsp_simple_face>([&](auto... out) { return hsp_topology_get_faces(topology_, out...); },
                                      "hsp_topology_get_faces");
}
std::vector<hsp_shell> LibraryTopology::shells() const {
  return all_records<hsp_shell>([&](auto... out) { return hsp_topology_get_shells(topology_, out...); },
                                "hsp_topology_get_shells");
}
std::vector<hsp_component> LibraryTopology::components() const {
  return all_records<hsp_component>([&](auto... out) { return hsp_topology_get_components(topology_, out...); },
                                    "hsp_topology_get_components");
}
std::vector<hsp_cell> LibraryTopology::cells() const {
  return all_records<hsp_cell>([&](auto... out) { return hsp_topology_get_cells(topology_, out...); },
                               "hsp_topology_get_cells");
}
std::vector<std::uint32_t> LibraryTopology::cell_shells(std::uint32_t cell) const {
  return all_records<std::uint32_t>([&](auto... out) { return hsp_topology_get_cell_shells(topology_, cell, out...); },
                                    "hsp_topology_get_cell_shells");
}
std::vector<std::uint32_t> LibraryTopology::scan(std::uint32_t shell) const {
  return all_records<std::uint32_t>([&](auto... out) { return hsp_topology_get_scan(topology_, shell, out...); },
                                    "hsp_topology_get_scan");
}

LibraryTopology::QuadEdges LibraryTopology::quad_edges() const {
  std::uint32_t needed = 0;
  const std::int32_t status = hsp_topology_get_quad_edges(topology_, nullptr, nullptr, 0, &needed);
  if (status != (needed == 0 ? HSP_OK : HSP_E_CAPACITY)) expect_ok(status, "hsp_topology_get_quad_edges");
  QuadEdges quads;
  quads.onext.resize(needed);
  quads.origin.resize(needed);
  if (needed == 0) return quads;
  // One array at a time.
  expect_ok(hsp_topology_get_quad_edges(topology_, quads.onext[0].data(), nullptr, needed, &needed),
            "hsp_topology_get_quad_edges for onext");
  expect_ok(hsp_topology_get_quad_edges(topology_, nullptr, quads.origin[0].data(), needed, &needed),
            "hsp_topology_get_quad_edges for origins");
  return quads;
}

std::array<double, 3> LibraryTopology::length(const oracle::LatticePoint &point) const {
  return {static_cast<double>(point[0]) * step_, static_cast<double>(point[1]) * step_,
          static_cast<double>(point[2]) * step_};
}

LibraryTopology::Place LibraryTopology::locate(const oracle::LatticePoint &point) const {
  const std::array<double, 3> xyz = length(point);
  Place place;
  place.balls = all_records<std::uint32_t>(
      [&](auto... out) { return hsp_topology_locate(topology_, xyz.data(), &place.cell, out...); },
      "hsp_topology_locate");
  return place;
}

std::uint32_t LibraryTopology::cell_of(const oracle::LatticePoint &point) const {
  std::uint32_t cell = 0;
  expect_ok(hsp_topology_locate(topology_, length(point).data(), &cell, nullptr, 0, nullptr), "hsp_topology_locate");
  return cell;
}

bool LibraryTopology::same_cell(const oracle::LatticePoint &a, const oracle::LatticePoint &b) const {
  std::int32_t same = -1;
  expect_ok(hsp_topology_same_cell(topology_, length(a).data(), length(b).data(), &same), "hsp_topology_same_cell");
  return same == 1;
}
