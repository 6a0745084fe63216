// The triangles of any boundary, with edges of any length: a closed surface with the boundary's Euler characteristic,
// the same bytes twice, and limits that are too small. HSP_E_CHECK is right where borders come together.
#include <mesh_result.h>

#include "computed_set.hpp"
#include "required_limits.hpp"

namespace {

using fuzz::same;

class Result {
 public:
  Result(const computed &base, double edge) : status_(mesh_result_make(&base, edge, &mesh_)) {
    FUZZ_REQUIRE(status_ == HSP_OK || status_ == HSP_E_CHECK, hsp_status_text(status_));
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

void require_sound(const computed &base, const mesh_result &mesh) {
  const char *const fault = mesh_fault(&mesh);
  FUZZ_REQUIRE(fault == nullptr, fault);
  const int64_t euler = static_cast<int64_t>(mesh.counts.vertices) - mesh.counts.triangles / 2;
  FUZZ_REQUIRE(euler == base.counts.euler, "another Euler characteristic");
}

void require_capacities(const computed &base, const mesh_result &reference, fuzz::Bytes &bytes) {
  const auto compute = [&](hsp_mesh *mesh, hsp_mesh_limits *limits) {
    return hsp_mesh_compute(mesh, base.boundary, reference.edge, limits);
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
  const Result reference(base, edge);
  if (reference.status() != HSP_OK) return 0;
  require_sound(base, reference.get());
  const Result again(base, edge);
  FUZZ_REQUIRE(same(reference.get().xyz, again.get().xyz, reference.get().counts.vertices), "other positions");
  FUZZ_REQUIRE(same(reference.get().corners, again.get().corners, reference.get().counts.triangles), "other triangles");
  require_capacities(base, reference.get(), bytes);
  return 0;
}
