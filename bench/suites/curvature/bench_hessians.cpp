// hsp_boundary_get_hessian_rows and hsp_boundary_get_hessian_product over size, by turns with the gradient.
#include "alternation.hpp"
#include "second_derivatives.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

void gradient_and_second_derivatives(benchmark::State &state, Subject &subject) {
  SecondDerivatives second(*subject.boundary);
  alternate(state, subject.model->size(),
            {{"gradient", [&] { benchmark::DoNotOptimize(subject.boundary->gradient()); }},
             {"rows_of_area", [&] { second.find_rows_of_area(); }},
             {"rows_of_volume", [&] { second.find_rows_of_volume(); }},
             {"product", [&] { second.multiply(); }}});
  state.counters["blocks_per_atom"] = second.blocks() / static_cast<double>(subject.model->size());
}

}  // namespace

void register_suite() {
  for (const Surface &surface : surfaces) {
    for (const Size &size : all_sizes()) {
      const std::string name = std::string("hessians/") + surface.name + '/' + size.name;
      const SubjectRecipe recipe{name, size.balls, surface.probe, Stage::boundary};
      register_case(name, recipe, gradient_and_second_derivatives)->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace bench
