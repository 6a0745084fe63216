// Parts that all benchmark programs (bench_*.cpp) share: their main function, and how a case is registered.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "handles.hpp"
#include "paper_molecules.hpp"
#include "query_workload.hpp"

namespace bench {

// Every program defines this; main calls it once.
void register_suite();

// Everything that is computed of a set of balls, one thing after the other.
enum class Stage { model, boundary, topology };

// A model and, as far as it was asked for, boundary and topology of one set of balls.
struct Subject {
  Balls balls;
  std::unique_ptr<Model> model;
  std::unique_ptr<Boundary> boundary;
  std::unique_ptr<Topology> topology;
};

// Makes a subject. It is called when the first benchmark that needs it runs, not when benchmarks are registered.
struct SubjectRecipe {
  std::string key;  // tells recipes apart
  std::function<Balls()> balls;
  double probe = 0;
  Stage last = Stage::model;
};

using Body = std::function<void(benchmark::State &, Subject &)>;

// Register a benchmark over a subject. Benchmarks of the same recipe key that are registered one after the other share
// the subject, with all repetitions; only one subject is alive at a time. Exceptions become the benchmark's error.
benchmark::internal::Benchmark *register_case(const std::string &name, const SubjectRecipe &recipe, Body body);

// The work that is timed, once for each iteration.
template <class Timed>
void iterate(benchmark::State &state, Timed timed) {
  for (auto iteration : state) {
    static_cast<void>(iteration);
    timed();
  }
}

// Register a benchmark that only says why it was skipped.
void register_skipped(const std::string &name, const std::string &reason);

}  // namespace bench
