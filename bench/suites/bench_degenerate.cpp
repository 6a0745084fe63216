// Model, boundary and measures (hsp_model_set, hsp_boundary_compute, hsp_boundary_measure) of sets in which nothing is
// in general position: cubic lattices of spacing 1 with four spheres through every vertex (radius 0.8), where doubles
// cannot answer any question. run.sh compiles this file with version 0.1.0, too, so it uses only the parts of suite.hpp
// that this version has.
#include "suite.hpp"

namespace bench {
namespace {

Balls cubic_lattice(uint32_t side, double radius) {
  Balls balls;
  balls.name = "cubic_lattice";
  for (uint32_t z = 0; z < side; ++z) {
    for (uint32_t y = 0; y < side; ++y) {
      for (uint32_t x = 0; x < side; ++x) {
        balls.xyz.insert(balls.xyz.end(), {double{1} * x, double{1} * y, double{1} * z});
        balls.radius.push_back(radius);
      }
    }
  }
  return balls;
}

void boundary_and_measure(benchmark::State &state, Subject &subject) {
  for (auto iteration : state) {
    static_cast<void>(iteration);
    subject.model->set();
    subject.boundary->compute();
    benchmark::DoNotOptimize(subject.boundary->measure());
  }
}

}  // namespace

void register_suite() {
  const SubjectRecipe recipe{"cubic_lattice", [] { return cubic_lattice(20, 0.8); }, 0, Stage::boundary};
  register_case("degenerate/everything/cubic_lattice", recipe, boundary_and_measure)->Unit(benchmark::kMicrosecond);
}

}  // namespace bench
