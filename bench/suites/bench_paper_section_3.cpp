// The table of the paper's Section 3: the times of building the structure (hsp_model_set), of 1000 point queries and of
// 1000 ball queries of radius r_max, with centres uniform in the surrounding box, for the paper's molecules and radii.
#include "suite.hpp"

namespace bench {
namespace {

constexpr size_t queries = 1000;

void build(benchmark::State &state, Subject &subject) {
  iterate(state, [&] { subject.model->set(); });
  hsp_model_info info{};
  expect_ok(hsp_model_get_info(subject.model->get(), &info), "hsp_model_get_info");
  state.counters["cubes"] = info.cubes;
  state.counters["longest_probe"] = info.longest_probe;
}

void point_queries(benchmark::State &state, Subject &subject) {
  const std::vector<double> points = random_points_in_box(*subject.model, queries);
  size_t hits = 0;
  iterate(state, [&] { hits = query_points(*subject.model, points); });
  state.counters["hits_per_query"] = static_cast<double>(hits) / queries;
}

void ball_queries(benchmark::State &state, Subject &subject) {
  const std::vector<double> points = random_points_in_box(*subject.model, queries);
  const double radius = subject.model->largest_radius();
  size_t hits = 0;
  iterate(state, [&] { hits = query_balls(*subject.model, points, radius); });
  state.counters["hits_per_query"] = static_cast<double>(hits) / queries;
}

}  // namespace

void register_suite() {
  for (const Molecule &molecule : paper_molecules()) {
    const SubjectRecipe recipe{molecule.name, [molecule] { return with_radii(molecule, Radii::paper); }};
    register_case("section_3/build/" + molecule.name, recipe, build)->Unit(benchmark::kMicrosecond);
    register_case("section_3/point_queries_1000/" + molecule.name, recipe, point_queries)
        ->Unit(benchmark::kMicrosecond);
    register_case("section_3/ball_queries_1000/" + molecule.name, recipe, ball_queries)->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace bench
