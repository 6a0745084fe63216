// Several parts timed by turns, so that the ratios of their times hold on a machine that is busy or changes its clock.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

namespace bench {

struct Part {
  std::string name;
  std::function<void()> run;
};

enum class Clock {
  of_thread,    // CPU time of the calling thread
  on_the_wall,  // for parts that start threads
};

// Every iteration of the state is one round: the parts one after the other, each run once, or several times in a row
// if the set has so few balls that reading the clock would count. Sets the counters <name>_seconds, the median
// over the rounds of the time of one run, and, for all parts but the first, <name>_ratio, the median over the
// rounds of its time divided by the first part's of the same round.
void alternate(benchmark::State &state, size_t balls, const std::vector<Part> &parts, Clock clock = Clock::of_thread);

}  // namespace bench
