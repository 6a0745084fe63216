// hsp_boundary_measure and hsp_boundary_get_gradient over size, by turns with hsp_boundary_compute; and frames of a
// trajectory, each set, computed and differentiated in the same memory.
#include "alternation.hpp"
#include "random_numbers.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

constexpr uint64_t seed = 1994;
constexpr size_t distinct_frames = 16;
constexpr double jitter = 0.1;  // Angstrom, largest shift of a coordinate

void boundary_and_gradient(benchmark::State &state, Subject &subject) {
  alternate(state, subject.model->size(),
            {{"boundary", [&] { subject.boundary->compute(); }},
             {"measure", [&] { benchmark::DoNotOptimize(subject.boundary->measure()); }},
             {"gradient", [&] { benchmark::DoNotOptimize(subject.boundary->gradient()); }}});
}

// The balls' centres, every coordinate shifted at random.
std::vector<std::vector<double>> jittered(const Balls &balls) {
  support::Random random(seed);
  std::vector<std::vector<double>> frames(distinct_frames, balls.xyz);
  for (std::vector<double> &frame : frames) {
    for (double &coordinate : frame) coordinate += jitter * (2 * random.fraction() - 1);
  }
  return frames;
}

void frames(benchmark::State &state, const Subject &subject) {
  // A model and boundary of their own, with the default limits: the next frame may need more than this one.
  Model model(subject.balls, subject.model->probe());
  Boundary boundary(model, Room::by_default);
  const std::vector<std::vector<double>> positions = jittered(subject.balls);
  size_t frame = 0;
  iterate(state, [&] {
    model.set(positions[frame]);
    boundary.compute();
    benchmark::DoNotOptimize(boundary.gradient());
    frame = (frame + 1) % positions.size();
  });
  state.counters["boundary_bytes"] = static_cast<double>(boundary.bytes());
}

}  // namespace

void register_suite() {
  for (const Surface &surface : surfaces) {
    const std::string group = std::string("gradients/") + surface.name + '/';
    for (const Size &size : molecule_sizes()) {
      const SubjectRecipe recipe{group + "frames/" + size.name, size.balls, surface.probe};
      register_case(group + "frames/" + size.name, recipe, frames)->Unit(benchmark::kMicrosecond);
    }
    for (const Size &size : all_sizes()) {
      const SubjectRecipe recipe{group + size.name, size.balls, surface.probe, Stage::boundary};
      register_case(group + "compute/" + size.name, recipe, boundary_and_gradient)->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace bench
