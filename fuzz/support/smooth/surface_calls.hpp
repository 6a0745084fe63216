// One surface handle in a random sequence of calls, with the status that each call must return.
#pragma once

#include <cmath>

#include "call_checks.hpp"
#include "struct_version.hpp"

namespace fuzz {

class SurfaceCalls {
 public:
  explicit SurfaceCalls(Bytes &bytes) : bytes_(bytes) {}

  // To be called before the boundary's memory goes.
  void drop() { surface_ = nullptr; }

  void init(const hsp_boundary *boundary, bool boundary_complete) {
    hsp_surface_limits limits{};
    const int32_t suited = hsp_surface_limits_init(&limits, sizeof limits, boundary);
    FUZZ_REQUIRE(suited == (boundary == nullptr ? HSP_E_ARGUMENT
                            : boundary_complete ? HSP_OK
                                                : HSP_E_STATE),
                 "hsp_surface_limits_init");
    if (suited != HSP_OK || bytes_.below(3) == 0) {
      const uint32_t n = bytes_.below(28);
      limits = {.struct_size = sizeof limits,
                .vertices = 8 * n,
                .faces = 4 * n + 1,
                .neighbours = n,
                .pieces = 8 * n,
                .arcs = 30 * n,
                .cusped_circles = 2 * n};
    }
    if (bytes_.one_in(16)) limits.arcs = 0xFFFFFFFF;
    StructVersion<hsp_surface_limits> version(limits, bytes_);
    size_t size = 12345;
    const int32_t status = hsp_surface_bytes(version.get(), &size);
    FUZZ_REQUIRE(status == (!version.good()               ? HSP_E_VERSION
                            : limits.arcs > HSP_MAX_BALLS ? HSP_E_RANGE
                                                          : HSP_OK),
                 "hsp_surface_bytes");
    FUZZ_REQUIRE(status == HSP_OK || size == 12345, "bytes written on failure");
    if (status != HSP_OK) {
      size = 4096;
    } else {
      FUZZ_REQUIRE(size <= HSP_SURFACE_BYTES(limits.vertices, limits.faces, limits.neighbours, limits.pieces,
                                             limits.arcs, limits.cusped_circles),
                   "hsp_surface_bytes, property 1");
    }
    const size_t missing = bytes_.one_in(8) ? 1 + bytes_.below(200) : 0;
    const size_t misalignment = bytes_.below(16);
    const size_t given = missing < size ? size - missing : 0;
    surface_ = nullptr;
    memory_ = std::vector<uint8_t>(misalignment + given + 1, 0x3C);
    hsp_surface *made = nullptr;
    const int32_t done = hsp_surface_init(memory_.data() + misalignment, given, version.get(), &made);
    FUZZ_REQUIRE(done == (status != HSP_OK ? status : missing > 0 ? HSP_E_MEMORY : HSP_OK), "hsp_surface_init");
    FUZZ_REQUIRE(memory_.back() == 0x3C, "written past the surface's memory");
    if (done != HSP_OK) {
      FUZZ_REQUIRE(made == nullptr, "a handle after failure");
      return;
    }
    surface_ = made;
    limits_ = limits;
    complete_ = false;
  }

  // Computes the surface of the whole boundary, or of shells with any numbers. `version` changes with the boundary's
  // results.
  void compute(const hsp_boundary *boundary, bool boundary_complete, uint64_t version) {
    hsp_surface *surface = null(bytes_) ? nullptr : surface_;
    hsp_surface_limits needed = limits_;
    uint32_t shells[3];
    for (uint32_t &shell : shells) shell = bytes_.one_in(20) ? HSP_NONE - bytes_.byte() : bytes_.below(2);
    const uint32_t count = bytes_.below(4);
    const bool all = bytes_.below(2) == 0, no_shells = !all && null(bytes_);
    const int32_t status =
        all ? hsp_surface_compute(surface, boundary, &needed)
            : hsp_surface_compute_shells(surface, boundary, no_shells ? nullptr : shells, count, &needed);
    FUZZ_REQUIRE(memory_.empty() || memory_.back() == 0x3C, "written past the surface's memory");
    if (surface == nullptr) {
      FUZZ_REQUIRE(status == HSP_E_ARGUMENT, "hsp_surface_compute, arguments");
      return;
    }
    // Earlier results are gone in any case.
    complete_ = status == HSP_OK;
    if (boundary == nullptr || (no_shells && count > 0) || !boundary_complete) {
      const bool bad = boundary == nullptr || (no_shells && count > 0);
      FUZZ_REQUIRE(status == (bad ? HSP_E_ARGUMENT : HSP_E_STATE), "hsp_surface_compute, refused");
      return;
    }
    hsp_boundary_counts counts{};
    FUZZ_REQUIRE(hsp_boundary_get_counts(boundary, &counts) == HSP_OK, "hsp_boundary_get_counts");
    bool there = true;
    for (uint32_t k = 0; k < count && !all; ++k) there = there && shells[k] < counts.shells;
    if (!there) {
      FUZZ_REQUIRE(status == HSP_E_ID, "a shell that is not there");
      return;
    }
    version_ = version;
    FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_CAPACITY, "a status that hsp_surface_compute does not have");
    const bool more = needed.vertices > limits_.vertices || needed.faces > limits_.faces ||
                      needed.neighbours > limits_.neighbours || needed.pieces > limits_.pieces ||
                      needed.arcs > limits_.arcs || needed.cusped_circles > limits_.cusped_circles;
    FUZZ_REQUIRE(more == (status == HSP_E_CAPACITY), "a limit is raised exactly after HSP_E_CAPACITY");
  }

  void read(uint64_t version) {
    hsp_surface *surface = null(bytes_) ? nullptr : surface_;
    const int32_t expected = surface == nullptr                 ? HSP_E_ARGUMENT
                             : complete_ && version_ == version ? HSP_OK
                                                                : HSP_E_STATE;
    hsp_surface_counts counts{};
    hsp_surface_totals totals{};
    hsp_energy energy{};
    hsp_surface_part_counts map{};
    uint32_t invariant = 12345, id = 12345, needed = 12345, balls = 0;
    FUZZ_REQUIRE(hsp_surface_get_counts(surface, &counts) == expected, "hsp_surface_get_counts");
    const int32_t measured = hsp_surface_measure(surface, &totals, nullptr, 0, &balls);
    FUZZ_REQUIRE(measured == expected, "hsp_surface_measure");
    const double tension = number(bytes_, true);
    std::vector<double> sigma(balls, 1.0);
    uint32_t bad = HSP_NONE;
    if (balls > 0) {
      const uint32_t changed = bytes_.below(balls);
      sigma[changed] = number(bytes_, true);
      if (!std::isfinite(sigma[changed])) bad = changed;
    }
    const uint32_t tangency = bytes_.one_in(20) ? 1 + bytes_.byte() : HSP_TANGENT_OVERLAP;
    const bool finite = bad == HSP_NONE && std::isfinite(tension);
    const int32_t asked = tangency != HSP_TANGENT_OVERLAP ? HSP_E_ARGUMENT : expected;
    hsp_gradient_request request{};
    request.struct_size = sizeof request;
    request.tangency = tangency;
    request.tension = 1;
    request.pressure = tension;
    request.sigma = sigma.data();
    hsp_gradient_outputs outputs{};
    outputs.struct_size = sizeof outputs;
    outputs.needed = 12345;
    outputs.first_bad = 12345;
    outputs.energy = &energy;
    const int32_t gradient = hsp_surface_get_gradient(surface, &request, &outputs);
    const int32_t answer = asked != HSP_OK ? asked : finite ? measured : HSP_E_NOT_FINITE;
    FUZZ_REQUIRE(gradient == answer, "hsp_surface_get_gradient");
    FUZZ_REQUIRE(outputs.first_bad == (asked == HSP_OK ? bad : 12345), "the first weight that is no number");
    FUZZ_REQUIRE(hsp_surface_get_part_counts(surface, &map) == expected, "hsp_surface_get_part_counts");
    FUZZ_REQUIRE(hsp_surface_check(surface, &invariant, &id) == expected, "hsp_surface_check");
    FUZZ_REQUIRE(invariant == (expected == HSP_OK ? 0 : 12345), "invariant");
    const int32_t shells = hsp_surface_get_shells(surface, nullptr, 0, &needed);
    FUZZ_REQUIRE(shells == (expected == HSP_OK && map.shells > 0 ? HSP_E_CAPACITY : expected),
                 "hsp_surface_get_shells");
    FUZZ_REQUIRE(needed == (expected == HSP_OK ? map.shells : 12345), "how many shells");
    const uint32_t patch = bytes_.below(60), h = bytes_.one_in(12) ? HSP_NONE - bytes_.below(5) : bytes_.below(400);
    hsp_surface_patch record{};
    FUZZ_REQUIRE(hsp_surface_get_patches(surface, patch, 1, &record) ==
                     (expected == HSP_OK && patch >= map.patches ? HSP_E_ID : expected),
                 "hsp_surface_get_patches");
    const bool there = expected == HSP_OK && h / 2 < map.edges;
    for (const uint32_t to :
         {hsp_surface_next(surface, h), hsp_surface_previous(surface, h), hsp_surface_next_loop(surface, h)}) {
      FUZZ_REQUIRE(there ? to / 2 < map.edges : to == HSP_NONE, "a step from a directed edge");
    }
    FUZZ_REQUIRE(there ? hsp_surface_left(surface, h) < map.patches : hsp_surface_left(surface, h) == HSP_NONE, "left");
  }

 private:
  Bytes &bytes_;
  std::vector<uint8_t> memory_;
  hsp_surface *surface_ = nullptr;
  hsp_surface_limits limits_{};
  bool complete_ = false;  // whether it has results, from the boundary's results of this version
  uint64_t version_ = 0;
};

}  // namespace fuzz
