// The triangles of any boundary and of the smooth surface over it, with edges of any length. They must be a closed
// surface with the Euler characteristic of the boundary or surface that they are made from; the vertices of a
// boundary's triangles must lie on it; the same bytes twice; limits that are too small. HSP_E_DEGENERATE is allowed
// where borders lie on each other.
#include <mesh_invariants.h>

#include <cmath>
#include <vector>

#include "computed_set.hpp"
#include "owned_surfaces.hpp"
#include "required_limits.hpp"

namespace {

using fuzz::same;

class Result {
 public:
  Result(const computed &base, double edge) : status_(mesh_result_make(&base, edge, &mesh_)) {
    FUZZ_REQUIRE(status_ == HSP_OK || status_ == HSP_E_DEGENERATE, hsp_status_text(status_));
  }
  Result(const surface_result &base, double edge) : status_(mesh_result_make_surface(&base, edge, &mesh_)) {
    FUZZ_REQUIRE(status_ == HSP_OK || status_ == HSP_E_DEGENERATE, hsp_status_text(status_));
  }
  ~Result() { mesh_result_release(&mesh_); }
  Result(const Result &) = delete;
  Result &operator=(const Result &) = delete;

  int32_t status() const { return status_; }
  const mesh_result &get() const { return mesh_; }

 private:
  mesh_result mesh_{};
  int32_t status_;
};

class Surface {
 public:
  explicit Surface(const computed &base) {
    const int32_t status = surface_result_make(&base, &surface_);
    FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
  }
  ~Surface() { surface_result_release(&surface_); }
  Surface(const Surface &) = delete;
  Surface &operator=(const Surface &) = delete;

  const surface_result &get() const { return surface_; }
  int64_t euler() const {
    hsp_surface_part_counts map{};
    FUZZ_REQUIRE(hsp_surface_get_part_counts(surface_.surface, &map) == HSP_OK, "counts of the map");
    std::vector<hsp_surface_shell> shells(map.shells);
    uint32_t needed = 0;
    const int32_t status = hsp_surface_get_shells(surface_.surface, shells.data(), map.shells, &needed);
    FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
    int64_t sum = 0;
    for (const hsp_surface_shell &shell : shells) sum += shell.euler;
    return sum;
  }

 private:
  surface_result surface_{};
};

void require_sound(const mesh_result &mesh, int64_t expected_euler) {
  const char *const fault = mesh_fault(&mesh);
  FUZZ_REQUIRE(fault == nullptr, fault);
  const char *const broken = mesh.surface == nullptr ? broken_mesh_vertices(&mesh) : nullptr;
  FUZZ_REQUIRE(broken == nullptr, broken);
  const int64_t euler = static_cast<int64_t>(mesh.counts.vertices) - mesh.counts.triangles / 2;
  FUZZ_REQUIRE(euler == expected_euler, "another Euler characteristic");
  uint32_t next = 0;
  while (next < mesh.counts.triangles) {
    uint32_t first = 0;
    uint32_t count = 0;
    const int32_t status = hsp_mesh_get_patch(mesh.mesh, mesh.patches[next], &first, &count);
    FUZZ_REQUIRE(status == HSP_OK && first == next && count > 0, "triangles of a patch");
    next += count;
  }
}

// With an area of 1 for each patch the weights of the vertices must sum to the number of patches that have triangles.
void require_weights(const mesh_result &mesh) {
  uint32_t patches = 0;
  uint32_t last = 0;
  for (uint32_t t = 0; t < mesh.counts.triangles; ++t) {
    patches += t == 0 || mesh.patches[t] != last ? 1 : 0;
    last = mesh.patches[t];
  }
  const std::vector<double> area(size_t{last} + 1, 1.0);
  std::vector<double> weights(mesh.counts.vertices);
  FUZZ_REQUIRE(
      hsp_mesh_get_weights(mesh.mesh, area.data(), last + 1, weights.data(), mesh.counts.vertices, nullptr) == HSP_OK,
      "hsp_mesh_get_weights");
  double sum = 0;
  for (const double weight : weights) {
    FUZZ_REQUIRE(weight >= 0, "a negative weight");
    sum += weight;
  }
  FUZZ_REQUIRE(std::abs(sum - patches) <= 1e-10 * patches, "the sum of weights");
}

void require_capacities(const mesh_result &reference, fuzz::Bytes &bytes) {
  const auto compute = [&](hsp_mesh *mesh, hsp_mesh_limits *limits) {
    return reference.surface == nullptr ? hsp_mesh_compute(mesh, reference.base->boundary, reference.edge, limits)
                                        : hsp_mesh_compute_surface(mesh, reference.surface, reference.edge, limits);
  };
  const auto read = [&](const hsp_mesh *mesh) {
    hsp_mesh_counts counts{};
    const int32_t status = hsp_mesh_get_counts(mesh, &counts);
    FUZZ_REQUIRE(hsp_mesh_get_vertices(mesh, nullptr, nullptr, nullptr, nullptr, 0, nullptr) == status, "vertices");
    FUZZ_REQUIRE(hsp_mesh_get_triangles(mesh, nullptr, nullptr, nullptr, nullptr, 0, nullptr) == status, "triangles");
    if (status == HSP_OK) FUZZ_REQUIRE(same(&counts, &reference.counts, 1), "counts differ with more room");
    return status;
  };
  fuzz::require_limits<support::MeshKind>(reference.needed, bytes, compute, read);
}

// Checks the mesh of a boundary, or of a surface.
template <class Base>
void require_mesh(const Base &base, double edge, int64_t euler, fuzz::Bytes &bytes) {
  const Result reference(base, edge);
  if (reference.status() != HSP_OK) return;
  require_sound(reference.get(), euler);
  const Result again(base, edge);
  FUZZ_REQUIRE(same(reference.get().xyz, again.get().xyz, reference.get().counts.vertices), "other positions");
  FUZZ_REQUIRE(same(reference.get().corners, again.get().corners, reference.get().counts.triangles), "other triangles");
  require_weights(reference.get());
  require_capacities(reference.get(), bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const fuzz::ScaledBalls set = fuzz::ball_set(bytes, 16);
  const fuzz::ComputedSet computed_set(set);
  const computed &base = computed_set.get();
  double largest = 0.0;
  for (uint32_t i = 0; i < base.n; ++i) largest = std::max(largest, base.radius[i]);
  const double edge = (largest > 0.0 ? largest : 1.0) * (0.25 + 0.125 * bytes.below(32));
  hsp_mesh_limits expected;
  const int32_t fits = hsp_mesh_limits_init(&expected, sizeof expected, base.boundary, edge);
  FUZZ_REQUIRE(fits == HSP_OK, hsp_status_text(fits));
  require_mesh(base, edge, base.counts.euler, bytes);
  const Surface surface(base);
  const int32_t fits_surface = hsp_mesh_limits_init_surface(&expected, sizeof expected, surface.get().surface, edge);
  hsp_model_info info{};
  FUZZ_REQUIRE(hsp_model_get_info(base.model, &info) == HSP_OK, "info");
  FUZZ_REQUIRE(fits_surface == HSP_OK, hsp_status_text(fits_surface));
  require_mesh(surface.get(), edge, info.probe > 0.0 ? surface.euler() : base.counts.euler, bytes);
  return 0;
}
