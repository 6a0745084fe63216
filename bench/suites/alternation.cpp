#include "alternation.hpp"

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <stdexcept>

namespace bench {
namespace {

// A round repeats a part until it has treated at least this many balls altogether, which takes some hundred
// microseconds.
constexpr size_t balls_per_round = 1000;

double seconds_of(Clock clock) {
  std::timespec now{};
  if (clock_gettime(clock == Clock::of_thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &now) != 0) {
    throw std::runtime_error("no such clock");
  }
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace

void alternate(benchmark::State &state, size_t balls, const std::vector<Part> &parts, Clock clock) {
  const size_t runs = std::max<size_t>(1, balls_per_round / std::max<size_t>(1, balls));
  std::vector<std::vector<double>> seconds(parts.size());
  std::vector<std::vector<double>> ratios(parts.size());
  for (auto iteration : state) {
    static_cast<void>(iteration);
    double begin = seconds_of(clock);
    for (size_t part = 0; part < parts.size(); ++part) {
      for (size_t run = 0; run < runs; ++run) parts[part].run();
      const double end = seconds_of(clock);
      seconds[part].push_back((end - begin) / static_cast<double>(runs));
      ratios[part].push_back(seconds[part].back() / seconds.front().back());
      begin = end;
    }
  }
  for (size_t part = 0; part < parts.size(); ++part) {
    if (seconds[part].empty()) continue;
    state.counters[parts[part].name + "_seconds"] = median(seconds[part]);
    if (part > 0) state.counters[parts[part].name + "_ratio"] = median(ratios[part]);
  }
}

}  // namespace bench
