// Steps 1 and 2 with areas of every ball, split among 1 and 2 threads by an executor, by turns with
// hsp_boundary_compute and hsp_boundary_measure. Times are wall-clock times: to be run on a machine that does nothing
// else.
#include <atomic>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

#include "alternation.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

constexpr uint32_t parts = 16;

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

// An executor whose threads are started anew each time.
int32_t run_tasks(void *context, uint32_t tasks, hsp_task *task, void *data) {
  const uint32_t threads = *static_cast<const uint32_t *>(context);
  std::atomic<uint32_t> next = 0;
  const auto take_part = [&] {
    for (uint32_t k; (k = next++) < tasks;) task(data, k);
  };
  std::vector<std::thread> others;
  for (uint32_t t = 1; t < threads; ++t) others.emplace_back(take_part);
  take_part();
  for (std::thread &other : others) other.join();
  return 0;
}

// The work is split for two workers; `threads` of them, one or two, do it.
void compute_split(hsp_boundary *boundary, const hsp_model *model, uint32_t threads, Measures &out) {
  const hsp_executor executor{sizeof executor, 2, &threads, run_tasks, nullptr};
  hsp_boundary_request request{};
  request.struct_size = sizeof request;
  request.executor = &executor;
  support::expect_ok(hsp_boundary_compute_with(boundary, model, &request, nullptr), "hsp_boundary_compute_with");
  hsp_measure_request measuring{};
  measuring.struct_size = sizeof measuring;
  measuring.executor = &executor;
  hsp_measure_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = static_cast<uint32_t>(out.area.size());
  outputs.totals = &out.totals;
  outputs.area = out.area.data();
  outputs.volume_term = out.volume.data();
  support::expect_ok(hsp_boundary_get_measures(boundary, &measuring, &outputs), "hsp_boundary_get_measures");
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
  limits.workers = parts;
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
