// Point, ball and ray queries with van der Waals balls, as users ask them: many distinct centres, so that neither
// caches nor branch prediction can learn them. "box": uniform in the surrounding box, mostly empty space for long
// molecules; "atom": within 1 Angstrom of an atom. Rays go from one of these points towards the next.
#include "suite.hpp"
#include "tiling.hpp"

namespace bench {
namespace {

constexpr size_t queries = 100000;

using Centres = std::vector<double> (*)(const Model &, size_t);

void register_queries(const SubjectRecipe &recipe, const std::string &where, Centres centres) {
  register_case("queries/point_" + where + '/' + recipe.key, recipe,
                [centres](benchmark::State &state, Subject &subject) {
                  const std::vector<double> points = centres(*subject.model, queries);
                  size_t hits = 0;
                  for (auto iteration : state) {
                    static_cast<void>(iteration);
                    hits = query_points(*subject.model, points);
                  }
                  state.counters["queries"] = queries;
                  state.counters["hits_per_query"] = static_cast<double>(hits) / queries;
                })
      ->Unit(benchmark::kMicrosecond);
  register_case("queries/ball_" + where + '/' + recipe.key, recipe,
                [centres](benchmark::State &state, Subject &subject) {
                  const std::vector<double> points = centres(*subject.model, queries);
                  const double radius = subject.model->largest_radius();
                  size_t hits = 0;
                  for (auto iteration : state) {
                    static_cast<void>(iteration);
                    hits = query_balls(*subject.model, points, radius);
                  }
                  state.counters["queries"] = queries;
                  state.counters["hits_per_query"] = static_cast<double>(hits) / queries;
                })
      ->Unit(benchmark::kMicrosecond);
  register_case("queries/ray_" + where + '/' + recipe.key, recipe,
                [centres](benchmark::State &state, Subject &subject) {
                  const std::vector<double> points = centres(*subject.model, queries + 1);
                  size_t hits = 0;
                  for (auto iteration : state) {
                    static_cast<void>(iteration);
                    hits = query_rays(*subject.model, points);
                  }
                  state.counters["queries"] = queries;
                  state.counters["hits_per_query"] = static_cast<double>(hits) / queries;
                })
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_suite() {
  const std::vector<Molecule> molecules = paper_molecules();
  std::vector<SubjectRecipe> recipes;
  for (const Molecule &molecule : molecules) {
    recipes.push_back({molecule.name, [molecule] { return with_radii(molecule, Radii::van_der_waals); }});
  }
  const Molecule &stand_in = molecules.back();
  recipes.push_back(
      {stand_in.name + "_x27", [stand_in] { return tiled(with_radii(stand_in, Radii::van_der_waals), 3); }});
  for (const SubjectRecipe &recipe : recipes) {
    register_queries(recipe, "box", random_points_in_box);
    register_queries(recipe, "atom", random_points_near_atoms);
  }
}

}  // namespace bench
