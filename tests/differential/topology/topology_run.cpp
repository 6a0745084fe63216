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
  std::vector<hsp_topology_vertex> all(counts().vertices);
  expect_ok(hsp_topology_get_vertices(handle(), 0, counts().vertices, all.data()), "hsp_topology_get_vertices");
  return all;
}
std::vector<hsp_topology_edge> LibraryTopology::edges() const {
  std::vector<hsp_topology_edge> all(counts().edges);
  expect_ok(hsp_topology_get_edges(handle(), 0, counts().edges, all.data()), "hsp_topology_get_edges");
  return all;
}
std::vector<hsp_simple_face> LibraryTopology::faces() const {
  std::vector<hsp_simple_face> all(counts().simple_faces);
  expect_ok(hsp_topology_get_simple_faces(handle(), 0, counts().simple_faces, all.data()),
            "hsp_topology_get_simple_faces");
  return all;
}
std::vector<hsp_shell> LibraryTopology::shells() const {
  return all_records<hsp_shell>([&](auto... out) { return hsp_topology_get_shells(handle(), out...); },
                                "hsp_topology_get_shells");
}
std::vector<hsp_component> LibraryTopology::components() const {
  return all_records<hsp_component>([&](auto... out) { return hsp_topology_get_components(handle(), out...); },
                                    "hsp_topology_get_components");
}
std::vector<hsp_region> LibraryTopology::cells() const {
  return all_records<hsp_region>([&](auto... out) { return hsp_topology_get_regions(handle(), out...); },
                                 "hsp_topology_get_regions");
}
std::vector<uint32_t> LibraryTopology::cell_shells(uint32_t cell) const {
  return all_records<uint32_t>([&](auto... out) { return hsp_topology_get_region_shells(handle(), cell, out...); },
                               "hsp_topology_get_region_shells");
}
std::vector<uint32_t> LibraryTopology::cell_balls(uint32_t cell) const {
  return all_records<uint32_t>([&](auto... out) { return hsp_topology_get_region_balls(handle(), cell, out...); },
                               "hsp_topology_get_region_balls");
}
std::vector<uint32_t> LibraryTopology::scan(uint32_t shell) const {
  return all_records<uint32_t>([&](auto... out) { return hsp_topology_get_traversal(handle(), shell, out...); },
                               "hsp_topology_get_traversal");
}

LibraryTopology::QuadEdges LibraryTopology::quad_edges() const {
  const uint32_t edges = counts().edges;
  QuadEdges quads;
  quads.onext.resize(edges);
  quads.origin.resize(edges);
  if (edges == 0) return quads;
  // One array at a time.
  expect_ok(hsp_topology_get_quad_edges(handle(), 0, edges, quads.onext[0].data(), nullptr),
            "hsp_topology_get_quad_edges for onext");
  expect_ok(hsp_topology_get_quad_edges(handle(), 0, edges, nullptr, quads.origin[0].data()),
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
