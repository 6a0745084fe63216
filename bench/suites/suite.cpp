#include "suite.hpp"

#include <cstdio>
#include <exception>
#include <fstream>
#include <utility>

namespace bench {
namespace {

std::unique_ptr<Subject> alive;
std::string alive_key;

Subject &subject_of(const SubjectRecipe &recipe) {
  if (alive == nullptr || alive_key != recipe.key) {
    alive.reset();
    auto subject = std::make_unique<Subject>();
    subject->balls = recipe.balls();
    subject->model = std::make_unique<Model>(subject->balls, recipe.probe);
    if (recipe.last >= Stage::boundary) subject->boundary = std::make_unique<Boundary>(*subject->model);
    if (recipe.last >= Stage::topology) subject->topology = std::make_unique<Topology>(*subject->boundary);
    alive = std::move(subject);
    alive_key = recipe.key;
  }
  return *alive;
}

std::string cpu_model() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

benchmark::internal::Benchmark *register_case(const std::string &name, const SubjectRecipe &recipe, Body body) {
  auto run = [recipe, body = std::move(body)](benchmark::State &state) {
    try {
      Subject &subject = subject_of(recipe);
      state.counters["atoms"] = static_cast<double>(subject.model->size());
      body(state, subject);
    } catch (const std::exception &error) {
      state.SkipWithError(error.what());
    }
  };
  return benchmark::RegisterBenchmark(name.c_str(), run);
}

void register_skipped(const std::string &name, const std::string &reason) {
  benchmark::RegisterBenchmark(
      name.c_str(), [reason](benchmark::State &state) { state.SkipWithError(("skipped: " + reason).c_str()); });
}

}  // namespace bench

int main(int argc, char **argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::AddCustomContext("cpu_model", bench::cpu_model());
  benchmark::AddCustomContext("compiler", BENCH_COMPILER);
  benchmark::AddCustomContext("flags", BENCH_FLAGS);
  benchmark::AddCustomContext("wide_code", BENCH_WIDE_CODE);
  benchmark::AddCustomContext("radii_paper", std::string(support::describe(bench::Radii::paper)));
  benchmark::AddCustomContext("radii_van_der_waals", std::string(support::describe(bench::Radii::van_der_waals)));
  benchmark::AddCustomContext("hardsphere_version", std::to_string(hsp_version()));
  try {
    bench::register_suite();
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
