// One topology handle in a random sequence of calls, with the status that each call must return.
#pragma once

#include <algorithm>
#include <cmath>

#include "call_checks.hpp"
#include "struct_version.hpp"

namespace fuzz {

class TopologyCalls {
 public:
  explicit TopologyCalls(Bytes &bytes) : bytes_(bytes) {}

  // To be called before the boundary's memory goes.
  void drop() { topology_ = nullptr; }

  void init(const hsp_boundary *boundary, bool boundary_complete) {
    hsp_topology_limits limits{};
    const bool suited = bytes_.below(2) == 0;
    if (suited) {
      const int32_t status = hsp_topology_limits_init(&limits, sizeof limits, boundary);
      FUZZ_REQUIRE(status == (boundary == nullptr ? HSP_E_ARGUMENT
                              : boundary_complete ? HSP_OK
                                                  : HSP_E_STATE),
                   "hsp_topology_limits_init");
    }
    if (!suited || boundary == nullptr || !boundary_complete) {
      const uint32_t n = bytes_.below(28);
      limits = {.struct_size = sizeof limits,
                .balls = n,
                .neighbours = n,
                .edges = 16 * n + 96,
                .cut_arcs = 2 * n + 16,
                .shells = 0};
    }
    if (bytes_.below(3) == 0) {
      limits.neighbours = bytes_.below(28);
      limits.edges = bytes_.below(200);
      limits.cut_arcs = bytes_.below(40);
    }
    if (bytes_.one_in(4)) limits.shells = bytes_.below(5);
    if (bytes_.one_in(40)) limits.shells = 0xFFFFFFFF;
    if (bytes_.one_in(16)) limits.edges = 0xFFFFFFFF;
    StructVersion<hsp_topology_limits> version(limits, bytes_);
    size_t size = 12345;
    const int32_t status = hsp_topology_bytes(version.get(), &size);
    const bool too_many = limits.edges > HSP_MAX_BALLS || limits.shells > HSP_MAX_BALLS;
    const int32_t expected = !version.good() ? HSP_E_VERSION : too_many ? HSP_E_RANGE : HSP_OK;
    FUZZ_REQUIRE(status == expected, "hsp_topology_bytes");
    FUZZ_REQUIRE(status == HSP_OK || size == 12345, "bytes written on failure");
    if (status != HSP_OK) {
      size = 4096;
    } else {
      FUZZ_REQUIRE(size <= HSP_TOPOLOGY_BYTES(limits.balls, limits.neighbours, limits.edges, limits.cut_arcs),
                   "hsp_topology_bytes, property 1");
    }
    const size_t missing = bytes_.one_in(8) ? 1 + bytes_.below(200) : 0;
    const size_t misalignment = bytes_.below(16);
    const size_t given = missing < size ? size - missing : 0;
    topology_ = nullptr;
    memory_ = std::vector<uint8_t>(misalignment + given + 1, 0x3C);
    hsp_topology *made = nullptr;
    const int32_t done = hsp_topology_init(memory_.data() + misalignment, given, version.get(), &made);
    FUZZ_REQUIRE(done == (status != HSP_OK ? status : missing > 0 ? HSP_E_MEMORY : HSP_OK), "hsp_topology_init");
    FUZZ_REQUIRE(memory_.back() == 0x3C, "written past the topology's memory");
    if (done != HSP_OK) {
      FUZZ_REQUIRE(made == nullptr, "a handle after failure");
      return;
    }
    topology_ = made;
    limits_ = limits;
    complete_ = false;
  }

  // `version` changes with the boundary's results.
  void compute(const hsp_boundary *boundary, bool boundary_complete, uint64_t version) {
    hsp_topology *topology = null(bytes_) ? nullptr : topology_;
    hsp_topology_limits needed = limits_;
    const int32_t status = hsp_topology_compute(topology, boundary, &needed);
    FUZZ_REQUIRE(memory_.empty() || memory_.back() == 0x3C, "written past the topology's memory");
    if (topology == nullptr) {
      FUZZ_REQUIRE(status == HSP_E_ARGUMENT, "hsp_topology_compute, arguments");
      return;
    }
    // Earlier results are gone in any case.
    complete_ = status == HSP_OK;
    if (boundary == nullptr || !boundary_complete) {
      FUZZ_REQUIRE(status == (boundary == nullptr ? HSP_E_ARGUMENT : HSP_E_STATE), "hsp_topology_compute, refused");
      return;
    }
    version_ = version;
    FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_CAPACITY, "a status that hsp_topology_compute does not have");
    const bool more = needed.balls > limits_.balls || needed.neighbours > limits_.neighbours ||
                      needed.edges > limits_.edges || needed.cut_arcs > limits_.cut_arcs ||
                      (limits_.shells > 0 && needed.shells > limits_.shells);
    FUZZ_REQUIRE(more == (status == HSP_E_CAPACITY), "a limit is raised exactly after HSP_E_CAPACITY");
  }

  void read(uint64_t version) {
    hsp_topology *topology = null(bytes_) ? nullptr : topology_;
    const int32_t expected = status_of(topology, version);
    hsp_topology_counts counts{};
    FUZZ_REQUIRE(hsp_topology_get_counts(topology, &counts) == expected, "hsp_topology_get_counts");
    uint32_t invariant = 12345, id = 12345;
    FUZZ_REQUIRE(hsp_topology_check(topology, &invariant, &id) == expected, "hsp_topology_check");
    FUZZ_REQUIRE(invariant == (expected == HSP_OK ? 0U : 12345U), "invariant");
    FUZZ_REQUIRE(id == (expected == HSP_OK ? HSP_NONE : 12345U), "id");
    read_arrays(topology, expected, counts);
    read_steps(topology, expected, counts);
  }

  void locate(uint64_t version) {
    const hsp_topology *topology = null(bytes_) ? nullptr : topology_;
    const bool odd = bytes_.one_in(3);
    double xyz[3];
    for (double &x : xyz) x = number(bytes_, odd);
    int32_t expected = status_of(topology, version);
    if (expected == HSP_OK) {
      for (const double x : xyz) {
        if (!std::isfinite(x)) expected = HSP_E_NOT_FINITE;
      }
    }
    uint32_t region = 12345;
    const int32_t status = hsp_topology_locate(topology, xyz, &region);
    // The lattice of small balls ends near them.
    FUZZ_REQUIRE(status == expected || (expected == HSP_OK && status == HSP_E_RANGE), "hsp_topology_locate");
    FUZZ_REQUIRE(status == HSP_OK || region == 12345, "region written on failure");
  }

 private:
  int32_t status_of(const hsp_topology *topology, uint64_t version) const {
    return topology == nullptr ? HSP_E_ARGUMENT : complete_ && version_ == version ? HSP_OK : HSP_E_STATE;
  }

  void read_arrays(hsp_topology *topology, int32_t expected, const hsp_topology_counts &counts) {
    check_range<hsp_topology_vertex>(bytes_, 60, expected, counts.vertices,
                                     [&](uint32_t first, uint32_t count, hsp_topology_vertex *out) {
                                       return hsp_topology_get_vertices(topology, first, count, out);
                                     });
    check_range<hsp_topology_edge>(bytes_, 90, expected, counts.edges,
                                   [&](uint32_t first, uint32_t count, hsp_topology_edge *out) {
                                     return hsp_topology_get_edges(topology, first, count, out);
                                   });
    check_range<hsp_simple_face>(bytes_, 60, expected, counts.simple_faces,
                                 [&](uint32_t first, uint32_t count, hsp_simple_face *out) {
                                   return hsp_topology_get_simple_faces(topology, first, count, out);
                                 });
    check_array<hsp_shell>(bytes_, 8, expected, [&](hsp_shell *out, uint32_t capacity, uint32_t *count) {
      return hsp_topology_get_shells(topology, out, capacity, count);
    });
    check_array<hsp_component>(bytes_, 8, expected, [&](hsp_component *out, uint32_t capacity, uint32_t *count) {
      return hsp_topology_get_components(topology, out, capacity, count);
    });
    check_array<hsp_region>(bytes_, 4, expected, [&](hsp_region *out, uint32_t capacity, uint32_t *count) {
      return hsp_topology_get_regions(topology, out, capacity, count);
    });
    const uint32_t region = bytes_.below(4), shell = bytes_.below(6);
    check_array<uint32_t>(bytes_, 8, with_id(expected, region, counts.regions),
                          [&](uint32_t *out, uint32_t capacity, uint32_t *count) {
                            return hsp_topology_get_region_shells(topology, region, out, capacity, count);
                          });
    check_array<uint32_t>(bytes_, 20, with_id(expected, region, counts.regions),
                          [&](uint32_t *out, uint32_t capacity, uint32_t *count) {
                            return hsp_topology_get_region_balls(topology, region, out, capacity, count);
                          });
    check_array<uint32_t>(bytes_, 60, with_id(expected, shell, counts.shells),
                          [&](uint32_t *out, uint32_t capacity, uint32_t *count) {
                            return hsp_topology_get_traversal(topology, shell, out, capacity, count);
                          });
    // records of four numbers an edge; either array may be left out
    using FourNumbers = std::array<uint32_t, 4>;
    check_range<FourNumbers>(bytes_, 90, expected, counts.edges, [&](uint32_t first, uint32_t count, FourNumbers *out) {
      uint32_t *const onext = out != nullptr ? out->data() : nullptr;
      return hsp_topology_get_quad_edges(topology, first, count, onext, nullptr);
    });
    check_range<FourNumbers>(bytes_, 90, expected, counts.edges, [&](uint32_t first, uint32_t count, FourNumbers *out) {
      uint32_t *const origin = out != nullptr ? out->data() : nullptr;
      return hsp_topology_get_quad_edges(topology, first, count, nullptr, origin);
    });
  }

  void read_steps(const hsp_topology *topology, int32_t expected, const hsp_topology_counts &counts) {
    const uint32_t q = bytes_.one_in(12) ? HSP_NONE - bytes_.below(5) : bytes_.below(400);
    const bool there = expected == HSP_OK && q / 4 < counts.edges;
    for (const uint32_t to : {hsp_topology_onext(topology, q), HSP_TOPOLOGY_OPREV(topology, q),
                              hsp_topology_lnext(topology, q), HSP_TOPOLOGY_LPREV(topology, q)}) {
      FUZZ_REQUIRE(there ? to < 4 * counts.edges : to == HSP_NONE, "a step from a quarter-edge");
    }
    const uint32_t most = std::max(counts.vertices, counts.simple_faces);
    for (const uint32_t to : {hsp_topology_origin(topology, q), hsp_topology_left(topology, q)}) {
      FUZZ_REQUIRE(there ? to < most : to == HSP_NONE, "where a quarter-edge starts");
    }
    const uint32_t turned = HSP_QUAD_ROT(q);
    FUZZ_REQUIRE(HSP_QUAD_ROT(turned) == HSP_QUAD_SYM(q) || q == HSP_NONE - 1, "rot twice is sym");
    FUZZ_REQUIRE(HSP_QUAD_INVERSE_ROT(turned) == q || q == HSP_NONE - 1, "rot there and back");
  }

  static int32_t with_id(int32_t expected, uint32_t id, uint32_t count) {
    return expected == HSP_OK && id >= count ? HSP_E_ID : expected;
  }

  Bytes &bytes_;
  std::vector<uint8_t> memory_;
  hsp_topology *topology_ = nullptr;
  hsp_topology_limits limits_{};
  bool complete_ = false;  // whether it has results, from the boundary's results of this version
  uint64_t version_ = 0;
};

}  // namespace fuzz
