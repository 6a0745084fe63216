// The visibility map (Section 5.2, hsp_map_compute) by turns with the analytic z-buffer, which answers the same
// question for 1000 x 1000 pixels. The sets are molecules from directions spread over the sphere, random balls over
// size, and sets whose maps are large or hard to find.
#include "alternation.hpp"
#include "sizes.hpp"
#include "suite.hpp"
#include "view_handle.hpp"
#include "visible_families.hpp"
#include "z_buffer/analytic_z_buffer.hpp"
#include "z_buffer/placement.hpp"

namespace bench {
namespace {

using Directions = std::vector<Direction>;

constexpr size_t many_directions = 16;
constexpr size_t few_directions = 4;

void maps(benchmark::State &state, const Subject &subject, const Directions &directions) {
  VisibleMap map(*subject.model, directions);
  double edges = 0;
  double balls = 0;
  double moved = 0;
  for (const Direction &direction : directions) {
    map.compute(direction);
    const hsp_map_info info = map.info();
    edges += info.edges;
    balls += info.balls;
    moved += info.perturbation > 0 ? 1 : 0;
  }
  const double number = static_cast<double>(directions.size());
  state.counters["edges"] = edges / number;
  state.counters["balls_seen"] = balls / number;
  state.counters["moved"] = moved;
  state.counters["bytes"] = static_cast<double>(map.bytes());

  Placement placement(subject.balls.xyz, subject.balls.radius);
  AnalyticZBuffer z_buffer;
  size_t drawn = 0;
  size_t mapped = 0;
  alternate(
      state, subject.model->size(),
      {{"analytic", [&] { z_buffer.draw(placement.place(axes_towards(directions[drawn++ % directions.size()]))); }},
       {"map", [&] { map.compute(directions[mapped++ % directions.size()]); }}});
  benchmark::DoNotOptimize(z_buffer.owner(image_side / 2, image_side / 2));
}

void register_maps(const std::string &group, const std::string &name, const std::function<Balls()> &balls,
                   const Directions &directions) {
  const std::string full = "maps/" + group + '/' + name;
  const SubjectRecipe recipe{full, balls, 0, Stage::model};
  register_case(full, recipe,
                [=](benchmark::State &state, const Subject &subject) { maps(state, subject, directions); })
      ->Unit(benchmark::kMicrosecond)
      ->Iterations(static_cast<benchmark::IterationCount>(directions.size()));
}

}  // namespace

void register_suite() {
  for (const Size &size : molecule_sizes()) {
    register_maps("molecules", size.name, size.balls, spread_directions(many_directions));
  }
  for (const uint32_t count : {1000U, 4000U, 16000U, 64000U, 256000U}) {
    register_maps(
        "random", std::to_string(count), [count] { return random_balls(count); }, spread_directions(few_directions));
  }
  const Directions ahead(few_directions, {0.003, 0.002, 1});
  register_maps(
      "families", "crossing_rows", [] { return crossing_rows(120); }, ahead);
  register_maps(
      "families", "deep_stack", [] { return deep_stack(2000); }, Directions(few_directions, {0, 0, 1}));
}

}  // namespace bench
