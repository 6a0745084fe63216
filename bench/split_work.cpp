// split_work: Steps 1 and 2 with areas of every ball, split among 1, 2 and 4 threads by hsp_boundary_begin and
// hsp_boundary_measure_range, beside hsp_boundary_compute and hsp_boundary_measure. Wall time, the least of some runs
// that take turns, in milliseconds, and how many times faster than the latter. To be run on a quiet machine:
//   split_work [COPIES [RUNS]]     copies^3 of the stand-in for SOD, 3 unless given; 7 runs
#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "handles.hpp"
#include "sizes.hpp"
#include "tiling.hpp"

namespace {

constexpr uint32_t workers_per_thread = 8;

struct Measures {
  hsp_totals totals{};
  std::vector<double> area, volume;

  explicit Measures(uint32_t n) : area(n), volume(n) {}
  bool operator==(const Measures &other) const {
    return std::memcmp(&totals, &other.totals, sizeof totals) == 0 && area == other.area && volume == other.volume;
  }
};

void compute_alone(hsp_boundary *boundary, const hsp_model *model, Measures &out) {
  const auto n = static_cast<uint32_t>(out.area.size());
  support::expect_ok(hsp_boundary_compute(boundary, model, nullptr), "hsp_boundary_compute");
  support::expect_ok(
      hsp_boundary_measure(boundary, nullptr, &out.totals, out.area.data(), out.volume.data(), n, nullptr),
      "hsp_boundary_measure");
}

// The threads are started anew each time.
void compute_split(hsp_boundary *boundary, const hsp_model *model, uint32_t threads, Measures &out) {
  const auto n = static_cast<uint32_t>(out.area.size());
  const uint32_t workers = threads * workers_per_thread;
  uint32_t stages = 0;
  support::expect_ok(hsp_boundary_begin(boundary, model, workers, &stages), "hsp_boundary_begin");
  std::vector<std::atomic<uint32_t>> next(stages + 1);
  std::barrier meeting(threads);
  int32_t ended = HSP_E_STATE;
  const auto take_part = [&](uint32_t thread) {
    for (uint32_t stage = 0; stage < stages; ++stage) {
      for (uint32_t w; (w = next[stage]++) < workers;) hsp_boundary_work(boundary, stage, w);
      meeting.arrive_and_wait();
    }
    if (thread == 0) ended = hsp_boundary_end(boundary, nullptr);
    meeting.arrive_and_wait();
    for (uint32_t w; (w = next[stages]++) < workers;) {
      const auto first_of = [&](uint32_t part) { return static_cast<uint32_t>(uint64_t{n} * part / workers); };
      hsp_boundary_measure_range(boundary, nullptr, first_of(w), first_of(w + 1) - first_of(w), out.area.data(),
                                 out.volume.data());
    }
  };
  std::vector<std::thread> others;
  for (uint32_t t = 1; t < threads; ++t) others.emplace_back(take_part, t);
  take_part(0);
  for (std::thread &other : others) other.join();
  support::expect_ok(ended, "hsp_boundary_end");
  support::expect_ok(hsp_boundary_measure_end(boundary, &out.totals, out.area.data(), out.volume.data()),
                     "hsp_boundary_measure_end");
}

double milliseconds(const std::function<void()> &run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void time_surface(const bench::Balls &balls, const bench::Surface &surface, int runs) {
  constexpr uint32_t threads[] = {1, 2, 4};
  bench::Model model(balls, surface.probe);
  support::OwnedBoundary boundary;
  const auto compute = [&model](hsp_boundary *handle, hsp_boundary_limits *limits) {
    return hsp_boundary_compute(handle, model.get(), limits);
  };
  boundary.take(support::default_boundary_limits(model.size()));
  boundary.compute(compute);
  hsp_boundary_limits limits = boundary.needed();
  limits.workers = 4 * workers_per_thread;
  boundary.take(limits);
  Measures expected(model.size()), found(model.size());
  double least[4] = {1e30, 1e30, 1e30, 1e30};
  for (int run = 0; run < runs; ++run) {
    least[0] = std::min(least[0], milliseconds([&] { compute_alone(boundary.get(), model.get(), expected); }));
    for (int k = 0; k < 3; ++k) {
      least[k + 1] =
          std::min(least[k + 1], milliseconds([&] { compute_split(boundary.get(), model.get(), threads[k], found); }));
      if (!(found == expected)) throw std::runtime_error("other bits when split");
    }
  }
  std::printf("%s %s %u balls: not split %.1f ms", balls.name.c_str(), surface.name, model.size(), least[0]);
  for (int k = 0; k < 3; ++k)
    std::printf(", %u threads %.1f ms (%.2f)", threads[k], least[k + 1], least[0] / least[k + 1]);
  std::printf("\n");
}

}  // namespace

int main(int argc, char **argv) {
  const int copies = argc > 1 ? std::atoi(argv[1]) : 3;
  const int runs = argc > 2 ? std::atoi(argv[2]) : 7;
  try {
    for (const bench::Molecule &molecule : bench::paper_molecules()) {
      if (molecule.name != "sod_stand_in") continue;
      const bench::Balls balls = bench::tiled(with_radii(molecule, bench::Radii::van_der_waals), copies);
      for (const bench::Surface &surface : bench::surfaces) time_surface(balls, surface, runs);
    }
  } catch (const std::exception &error) {
    std::fprintf(stderr, "split_work: %s\n", error.what());
    return 1;
  }
  return 0;
}
