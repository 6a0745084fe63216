// Each computation, stopped at a question (hsp_executor.proceed) that the input chooses: it must return HSP_E_STOPPED
// and hold no results, and computed again it must give the same counts as without a stop.
#include <hardsphere.h>
#include <hardsphere_workspace.h>

#include <cstring>
#include <vector>

#include "computed_set.hpp"
#include "random_stop.hpp"
#include "topology_input.hpp"

namespace {

using fuzz::Bytes;

class Stopped {
 public:
  explicit Stopped(const fuzz::ScaledBalls &set) {
    const support::BallList list = set.in_lengths();
    const hsp_model_options options = fuzz::options_of(set);
    const int32_t status =
        hsp_workspace_set(&work_, list.size(), list.xyz.data(), list.radius.data(), &options, nullptr);
    FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
  }
  ~Stopped() { hsp_workspace_free(&work_); }
  Stopped(const Stopped &) = delete;
  Stopped &operator=(const Stopped &) = delete;

  // compute(): computes in the workspace. read(counts): reads the counts of the result into a record of zeros.
  template <class Counts, class Compute, class Read>
  void check(Bytes &bytes, Compute compute, Read read) {
    Counts before{}, after{};
    work_.executor = nullptr;
    const int32_t first = compute();
    if (first == HSP_OK) FUZZ_REQUIRE(read(&before) == HSP_OK, "counts");
    {
      const fuzz::RandomStop stop(bytes);
      work_.executor = stop.executor();
      const int32_t status = compute();
      work_.executor = nullptr;
      if (stop.stopped()) {
        FUZZ_REQUIRE(status == HSP_E_STOPPED, hsp_status_text(status));
        FUZZ_REQUIRE(read(&after) == HSP_E_STATE, "results after a stop");
      } else {
        FUZZ_REQUIRE(status == first, hsp_status_text(status));
      }
    }
    const int32_t again = compute();
    FUZZ_REQUIRE(again == first, hsp_status_text(again));
    if (again != HSP_OK) return;
    FUZZ_REQUIRE(read(&after) == HSP_OK, "counts");
    FUZZ_REQUIRE(std::memcmp(&before, &after, sizeof before) == 0, "other counts after a stop");
  }

  hsp_workspace &work() { return work_; }

 private:
  hsp_workspace work_{};
};

// Where many balls tie pores take long.
constexpr uint32_t most_balls_with_pores = 12;

void check_all(Stopped &of, bool with_pores, Bytes &bytes) {
  hsp_workspace &work = of.work();
  of.check<hsp_boundary_counts>(
      bytes, [&] { return hsp_workspace_boundary(&work); },
      [&](hsp_boundary_counts *counts) { return hsp_boundary_get_counts(work.boundary, counts); });
  of.check<hsp_complex>(
      bytes, [&] { return hsp_workspace_contacts(&work); },
      [&](hsp_complex *counts) { return hsp_contacts_get_complex(work.contacts, counts); });
  of.check<hsp_topology_counts>(
      bytes, [&] { return hsp_workspace_topology(&work); },
      [&](hsp_topology_counts *counts) { return hsp_topology_get_counts(work.topology, counts); });
  of.check<hsp_surface_counts>(
      bytes, [&] { return hsp_workspace_surface(&work); },
      [&](hsp_surface_counts *counts) { return hsp_surface_get_counts(work.surface, counts); });
  of.check<hsp_cells_counts>(
      bytes, [&] { return hsp_workspace_cells(&work); },
      [&](hsp_cells_counts *counts) { return hsp_cells_get_counts(work.cells, counts); });
  of.check<hsp_map_info>(
      bytes,
      [&] {
        hsp_view_options options;
        hsp_view_options_init(&options, sizeof options);
        options.executor = work.executor;
        return hsp_workspace_map(&work, &options);
      },
      [&](hsp_map_info *info) { return hsp_map_get_info(work.map, info); });
  of.check<hsp_moving_info>(
      bytes, [&] { return hsp_workspace_moving(&work, nullptr, 1.0, 0.5, HSP_TANGENT_OVERLAP, nullptr); },
      [&](hsp_moving_info *info) { return hsp_moving_get_info(work.moving, info); });
  if (!with_pores) return;
  of.check<hsp_pores_counts>(
      bytes,
      [&] {
        hsp_pores_options options{sizeof options, 0, 0.0, work.executor, nullptr};
        return hsp_workspace_pores(&work, &options);
      },
      [&](hsp_pores_counts *counts) { return hsp_pores_get_counts(work.pores, counts); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  Bytes bytes(data, size);
  const fuzz::ScaledBalls set = fuzz::topology_set(bytes);
  Stopped of(set);
  check_all(of, set.n() <= most_balls_with_pores, bytes);
  return 0;
}
