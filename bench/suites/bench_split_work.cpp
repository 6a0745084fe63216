// Steps 1 and 2 with areas of every ball, split among 1 and 2 threads by hsp_boundary_begin and
// hsp_boundary_measure_range, by turns with hsp_boundary_compute and hsp_boundary_measure. By the clock on the wall, so
// to be run on a quiet machine.
#include <atomic>
#include <barrier>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

#include "alternation.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
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

void alone_and_split(benchmark::State &state, Subject &subject) {
  const Model &model = *subject.model;
  support::OwnedBoundary boundary;
  const auto compute = [&model](hsp_boundary *handle, hsp_boundary_limits *limits) {
    return hsp_boundary_compute(handle, model.get(), limits);
  };
  boundary.take(support::default_boundary_limits(model.size()));
  boundary.compute(compute);
  hsp_boundary_limits limits = boundary.needed();
  limits.workers = 2 * workers_per_thread;
  boundary.take(limits);
  Measures alone(model.size()), by_one(model.size()), by_two(model.size());
  alternate(state, model.size(),
            {{"alone", [&] { compute_alone(boundary.get(), model.get(), alone); }},
             {"by_one", [&] { compute_split(boundary.get(), model.get(), 1, by_one); }},
             {"by_two", [&] { compute_split(boundary.get(), model.get(), 2, by_two); }}},
            Clock::on_the_wall);
  if (!(by_one == alone && by_two == alone)) throw std::runtime_error("other bits when split");
}

}  // namespace

void register_suite() {
  for (const Surface &surface : surfaces) {
    const std::string group = std::string("split_work/") + surface.name + '/';
    for (const Size &size : all_sizes()) {
      register_case(group + size.name, {group + size.name, size.balls, surface.probe}, alone_and_split)
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace bench
