// Bricks over size: the summary of half of a set with the balls around it, by turns with the half's model and boundary;
// and the merge of the summaries of both halves.
#include "alternation.hpp"
#include "halved_set.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

void boundary_and_summary(benchmark::State &state, Subject &subject) {
  HalvedSet halves(subject.balls, subject.model->probe());
  alternate(state, halves.owned(),
            {{"boundary", [&] { halves.compute_first(); }},
             {"summary", [&] { halves.summarise_first(); }},
             {"merge", [&] { halves.merge(); }}});
  state.counters["owned"] = halves.owned();
  state.counters["halo_share"] = halves.halo_share();
  state.counters["bytes_per_atom"] = halves.bytes() / halves.owned();
}

}  // namespace

void register_suite() {
  for (const Surface &surface : surfaces) {
    for (const Size &size : all_sizes()) {
      const std::string name = std::string("bricks/") + surface.name + '/' + size.name;
      register_case(name, {name, size.balls, surface.probe, Stage::model}, boundary_and_summary)
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace bench
