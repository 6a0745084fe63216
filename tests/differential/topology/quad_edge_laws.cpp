#include <algorithm>
#include <cstring>

#include "finding.hpp"
#include "structure_laws.hpp"

namespace {

/// The orbit of a quarter-edge under onext; empty if it is longer than there are quarter-edges.
std::vector<std::uint32_t> ring_of(const hsp_topology *topology, std::uint32_t q, std::uint32_t quarters) {
  std::vector<std::uint32_t> ring;
  std::uint32_t next = q;
  do {
    ring.push_back(next);
    next = hsp_topology_onext(topology, next);
    if (ring.size() > quarters) return {};
  } while (next != q);
  return ring;
}

void check_properties(const hsp_topology *topology, std::uint32_t q, Finding &finding) {
  const std::uint32_t rot = hsp_quad_rot(q);
  finding.require(q / 4 == rot / 4, "rot leaves the edge of", q);
  finding.require(hsp_quad_sym(q) == hsp_quad_rot(rot), "rot rot is not sym at", q);
  finding.require(hsp_quad_sym(hsp_quad_sym(q)) == q && hsp_quad_sym(q) != q, "sym sym at", q);
  finding.require(hsp_quad_inverse_rot(rot) == q, "inverse rot at", q);

  const std::uint32_t onext = hsp_topology_onext(topology, q);
  const std::uint32_t lnext = hsp_topology_lnext(topology, q);
  finding.require(onext % 2 == q % 2, "onext leads from vertices to faces at", q);
  finding.require(hsp_quad_rot(hsp_topology_onext(topology, hsp_quad_rot(onext))) == q, "rot onext rot onext at", q);
  finding.require(hsp_topology_oprev(topology, onext) == q, "oprev at", q);
  finding.require(hsp_topology_lprev(topology, lnext) == q, "lprev at", q);
  finding.require(lnext == hsp_quad_rot(hsp_topology_onext(topology, hsp_quad_inverse_rot(q))), "lnext at", q);
  finding.require(hsp_topology_origin(topology, onext) == hsp_topology_origin(topology, q), "origin of onext at", q);
  finding.require(hsp_topology_left(topology, lnext) == hsp_topology_left(topology, q), "left of lnext at", q);
  finding.require(hsp_topology_origin(topology, lnext) == hsp_topology_origin(topology, hsp_quad_sym(q)),
                  "origin of lnext at", q);
  // rot runs from the right to the left.
  finding.require(hsp_topology_left(topology, q) == hsp_topology_origin(topology, hsp_quad_inverse_rot(q)),
                  "left is not where inverse rot starts at", q);
}

void check_nothing_beyond(const hsp_topology *topology, std::uint32_t quarters, Finding &finding) {
  for (const std::uint32_t q : {quarters, quarters + 5, HSP_NONE - 1, HSP_NONE})
    for (const auto step : {hsp_topology_onext, hsp_topology_oprev, hsp_topology_lnext, hsp_topology_lprev,
                            hsp_topology_origin, hsp_topology_left, hsp_topology_ball})
      finding.require(step(topology, q) == HSP_NONE, "a step from the quarter-edge", q, "that does not exist");
  for (const auto step : {hsp_quad_rot, hsp_quad_inverse_rot, hsp_quad_sym})
    finding.require(step(HSP_NONE) == HSP_NONE, "a quarter-edge from none");
}

template <class Record>
bool same_bytes(const Record &a, const Record &b) {
  return std::memcmp(&a, &b, sizeof(Record)) == 0;
}

template <class Record, class Getter>
void check_single_records(const std::vector<Record> &all, Getter get, const char *name, Finding &finding) {
  const auto n = static_cast<std::uint32_t>(all.size());
  for (std::uint32_t id = 0; id < n; ++id) {
    Record one;
    std::memset(&one, 0xA5, sizeof one);
    finding.require(get(id, &one) == HSP_OK && same_bytes(one, all[id]), name, id, "differs from the array's");
  }
  Record untouched;
  std::memset(&untouched, 0xA5, sizeof untouched);
  const Record before = untouched;
  for (const std::uint32_t id : {n, HSP_NONE})
    finding.require(get(id, &untouched) == HSP_E_ID && same_bytes(untouched, before), name, id, "does not exist");
}

}  // namespace

std::string algebra_broken(const LibraryTopology &topology) {
  Finding finding;
  const hsp_topology *handle = topology.handle();
  const hsp_topology_counts counts = topology.counts();
  const std::uint32_t quarters = 4 * counts.edges;
  const LibraryTopology::QuadEdges quads = topology.quad_edges();
  finding.require(quads.onext.size() == counts.edges && quads.origin.size() == counts.edges, "number of edges");

  for (std::uint32_t q = 0; q < quarters; ++q) {
    const std::uint32_t onext = hsp_topology_onext(handle, q);
    const std::uint32_t origin = hsp_topology_origin(handle, q);
    if (!finding.require(onext < quarters, "onext of", q, "is", onext)) return finding.text();
    if (!finding.require(origin < (q % 2 == 0 ? counts.vertices : counts.simple_faces), "origin of", q, "is", origin))
      return finding.text();
    finding.require(quads.onext[q / 4][q % 4] == onext, "onext in the array at", q);
    finding.require(quads.origin[q / 4][q % 4] == origin, "origin in the array at", q);
  }
  for (std::uint32_t q = 0; q < quarters; ++q) check_properties(handle, q, finding);
  check_nothing_beyond(handle, quarters, finding);
  if (finding.any()) return finding.text();

  // Quarter-edges fall into as many rings as there are vertices (even ones) and simple faces (odd ones).
  std::vector<bool> seen(quarters, false);
  std::array<std::uint32_t, 2> rings = {0, 0};
  for (std::uint32_t q = 0; q < quarters; ++q) {
    if (seen[q]) continue;
    const std::vector<std::uint32_t> ring = ring_of(handle, q, quarters);
    finding.require(ring.size() >= 2, "a ring of one, or an endless one, at", q);
    for (const std::uint32_t other : ring) seen[other] = true;
    ++rings[q % 2];
  }
  std::vector<bool> starts(counts.vertices, false);
  for (std::uint32_t q = 0; q < quarters; q += 2) starts[hsp_topology_origin(handle, q)] = true;
  finding.require(std::find(starts.begin(), starts.end(), false) == starts.end(), "a vertex without edges");
  finding.require(rings[0] == counts.vertices, rings[0], "rings of edges around", counts.vertices, "vertices");
  finding.require(rings[1] == counts.simple_faces, rings[1], "rings of edges around", counts.simple_faces, "faces");
  for (std::uint32_t q = 0; q < quarters; q += 4)
    finding.require(hsp_topology_left(handle, q) != hsp_topology_left(handle, hsp_quad_sym(q)),
                    "one face on both sides of", q);
  return finding.text();
}

std::string records_disagree(const LibraryTopology &topology) {
  Finding finding;
  const hsp_topology *handle = topology.handle();
  const hsp_topology_counts counts = topology.counts();
  const auto vertices = topology.vertices();
  const auto edges = topology.edges();
  const auto faces = topology.faces();
  finding.require(vertices.size() == counts.vertices, "number of vertices");
  finding.require(edges.size() == counts.edges, "number of edges");
  finding.require(faces.size() == counts.simple_faces, "number of simple faces");
  finding.require(topology.shells().size() == counts.shells, "number of shells");
  finding.require(topology.components().size() == counts.components, "number of components");
  finding.require(topology.cells().size() == counts.cells, "number of cells");
  const hsp_boundary_counts boundary = topology.boundary().counts();
  finding.require(counts.shells == boundary.shells, "shells of the boundary");
  finding.require(counts.components == boundary.components, "components of the boundary");
  finding.require(counts.cells == 1 + boundary.voids, "voids of the boundary");
  finding.require(std::int64_t{counts.vertices} - counts.edges + counts.simple_faces == boundary.euler,
                  "Euler characteristic of the boundary");
  check_single_records(
      vertices, [&](auto... a) { return hsp_topology_get_vertex(handle, a...); }, "vertex", finding);
  check_single_records(
      edges, [&](auto... a) { return hsp_topology_get_edge(handle, a...); }, "edge", finding);
  check_single_records(
      faces, [&](auto... a) { return hsp_topology_get_face(handle, a...); }, "face", finding);
  return finding.text();
}
