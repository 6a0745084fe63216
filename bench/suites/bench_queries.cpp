// Point, ball and ray queries with van der Waals balls, as users ask them: the centres are many and distinct, so that
// neither caches nor branch prediction can learn them. "box": centres uniform in the surrounding box, mostly empty
// space for long molecules; "atom": centres within 1 Angstrom of an atom. Rays go from one of these points towards the
// next.
#include <functional>

#include "suite.hpp"
#include "tiling.hpp"

namespace bench {
namespace {

constexpr size_t queries = 100000;

using Centres = std::vector<double> (*)(const Model &, size_t);

// There are `more` centres than queries. `ask` makes all queries and returns the number of their hits.
void register_kind(const std::string &kind, const SubjectRecipe &recipe, Centres centres, size_t more,
                   const std::function<size_t(const Model &, const std::vector<double> &)> &ask) {
  register_case("queries/" + kind + '/' + recipe.key, recipe, [=](benchmark::State &state, Subject &subject) {
    const std::vector<double> points = centres(*subject.model, queries + more);
    size_t hits = 0;
    iterate(state, [&] { hits = ask(*subject.model, points); });
    state.counters["queries"] = queries;
    state.counters["hits_per_query"] = static_cast<double>(hits) / queries;
  })->Unit(benchmark::kMicrosecond);
}

void register_queries(const SubjectRecipe &recipe, const std::string &where, Centres centres) {
  register_kind("point_" + where, recipe, centres, 0, query_points);
  register_kind("ball_" + where, recipe, centres, 0, [](const Model &model, const std::vector<double> &points) {
    return query_balls(model, points, model.largest_radius());
  });
  register_kind("ray_" + where, recipe, centres, 1, query_rays);
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
