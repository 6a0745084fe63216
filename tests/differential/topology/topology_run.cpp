#include "topology_run.hpp"

using support::all_records;

LibraryTopology::LibraryTopology(const oracle::Balls &balls, double step) : step_(step), boundary_(balls, step) {
  topology_.take(support::topology_limits_for(boundary_.handle()));
  topology_.compute([&](hsp_topology *topology, hsp_topology_limits *limits) {
    return hsp_topology_compute(topology, boundary_.handle(), limits);
  });
}

hsp_topology_counts LibraryTopology::counts() const {
  hsp_topology_counts counts;
  expect_ok(hsp_topology_get_counts(handle(), &counts), "hsp_topology_get_counts");
  return counts;
}

std::vector<hsp_topology_vertex> LibraryTopology::vertices() const {
  return all_records<hsp_topology_vertex>([&](auto... out) { return hsp_topology_get_vertices(handle(), out...); },
                                          "hsp_topology_get_vertices");
}
std::vector<hsp_topology_edge> LibraryTopology::edges() const {
  return all_records<hsp_topology_edge>([&](auto... out) { return hsp_topology_get_edges(handle(), out...); },
                                        "hsp_topology_get_edges");
}
std::vector<hsp_simple_face> LibraryTopology::faces() const {
  return all_records<hsp_simple_face>([&](auto... out) { return hsp_topology_get_faces(handle(), out...); },
                                      "hsp_topology_get_faces");
}
std::vector<hsp_shell> LibraryTopology::shells() const {
  return all_records<hsp_shell>([&](auto... out) { return hsp_topology_get_shells(handle(), out...); },
                                "hsp_topology_get_shells");
}
std::vector<hsp_component> LibraryTopology::components() const {
  return all_records<hsp_component>([&](auto... out) { return hsp_topology_get_components(handle(), out...); },
                                    "hsp_topology_get_components");
}
std::vector<hsp_cell> LibraryTopology::cells() const {
  return all_records<hsp_cell>([&](auto... out) { return hsp_topology_get_cells(handle(), out...); },
                               "hsp_topology_get_cells");
}
std::vector<uint32_t> LibraryTopology::cell_shells(uint32_t cell) const {
  return all_records<uint32_t>([&](auto... out) { return hsp_topology_get_cell_shells(handle(), cell, out...); },
                               "hsp_topology_get_cell_shells");
}
std::vector<uint32_t> LibraryTopology::scan(uint32_t shell) const {
  return all_records<uint32_t>([&](auto... out) { return hsp_topology_get_traversal(handle(), shell, out...); },
                               "hsp_topology_get_traversal");
}

LibraryTopology::QuadEdges LibraryTopology::quad_edges() const {
  uint32_t needed = 0;
  const int32_t status = hsp_topology_get_quad_edges(handle(), nullptr, nullptr, 0, &needed);
  if (status != (needed == 0 ? HSP_OK : HSP_E_CAPACITY)) expect_ok(status, "hsp_topology_get_quad_edges");
  QuadEdges quads;
  quads.onext.resize(needed);
  quads.origin.resize(needed);
  if (needed == 0) return quads;
  // One array at a time.
  expect_ok(hsp_topology_get_quad_edges(handle(), quads.onext[0].data(), nullptr, needed, &needed),
            "hsp_topology_get_quad_edges for onext");
  expect_ok(hsp_topology_get_quad_edges(handle(), nullptr, quads.origin[0].data(), needed, &needed),
            "hsp_topology_get_quad_edges for origins");
  return quads;
}

uint32_t LibraryTopology::cell_of(const oracle::LatticePoint &point) const {
  const std::array<double, 3> xyz = {static_cast<double>(point[0]) * step_, static_cast<double>(point[1]) * step_,
                                     static_cast<double>(point[2]) * step_};
  uint32_t cell = 0;
  expect_ok(hsp_topology_locate(handle(), xyz.data(), &cell), "hsp_topology_locate");
  return cell;
}
