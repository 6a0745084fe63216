// The search structures that the paper's Section 3 names (section_3/) by turns with the library: building, point and
// ball queries, all pairs, memory. Sets are the paper's molecules with its radii, and a tiling of a million balls.
#include <memory>
#include <stdexcept>

#include "alternation.hpp"
#include "section_3/centre_grid.hpp"
#include "section_3/dense_cubes.hpp"
#include "section_3/double_hashing.hpp"
#include "section_3/paper_grid.hpp"
#include "section_3/perfect_hashing.hpp"
#include "section_3/range_tree.hpp"
#include "section_3/sorted_cubes.hpp"
#include "suite.hpp"
#include "tiling.hpp"

namespace bench {
namespace {

constexpr uint32_t most_hits = 4096;

// The structures of one subject. Their names in the report are those of the parts below.
struct Alternatives {
  CentreGrid<DenseCubes> dense;
  CentreGrid<SortedCubes> sorted;
  CentreGrid<DoubleHashing> hashed;
  CentreGrid<PerfectHashing> perfect;
  PaperGrid paper;
  RangeTree tree;
};

// Calls visit(name, structure) for each.
template <class Visit>
void visit_grids(Alternatives &all, Visit visit) {
  visit("dense", all.dense);
  visit("sorted", all.sorted);
  visit("hashed", all.hashed);
  visit("perfect", all.perfect);
}
template <class Visit>
void visit_structures(Alternatives &all, Visit visit) {
  visit_grids(all, visit);
  visit("paper", all.paper);
  visit("tree", all.tree);
}

// The structures of a subject. Those of the subject that was asked for last are kept.
Alternatives &alternatives_of(const Subject &subject) {
  static std::unique_ptr<Alternatives> kept;
  static std::string kept_for;
  if (kept == nullptr || kept_for != subject.balls.name) {
    kept = std::make_unique<Alternatives>();
    kept_for = subject.balls.name;
    visit_structures(*kept, [&](const char *, auto &structure) { structure.build(subject.balls); });
  }
  return *kept;
}

template <class Structure>
size_t query(const Structure &structure, const std::vector<double> &points, double radius) {
  std::vector<uint32_t> ids(most_hits);
  size_t found = 0;
  for (size_t i = 0; i < points.size(); i += 3) {
    Hits hits{ids.data(), most_hits};
    structure.meeting(&points[i], radius, hits);
    found += hits.count;
  }
  benchmark::DoNotOptimize(ids);
  return found;
}

void require_equal(size_t found, size_t expected, const char *name) {
  if (found != expected) throw std::runtime_error(std::string(name) + " finds other balls than the library");
}

void build(benchmark::State &state, Subject &subject) {
  Alternatives &all = alternatives_of(subject);
  std::vector<Part> parts{{"library", [&] { subject.model->set(); }}};
  visit_structures(all, [&](const char *name, auto &structure) {
    parts.push_back({name, [&] { structure.build(subject.balls); }});
    state.counters[std::string(name) + "_bytes"] = static_cast<double>(structure.bytes());
  });
  size_t bytes = 0;
  expect_ok(hsp_model_bytes(subject.model->size(), &bytes), "hsp_model_bytes");
  state.counters["library_bytes"] = static_cast<double>(bytes);
  state.counters["hash_trials"] = all.perfect.directory().trials_per_function();
  state.counters["non_empty_cubes"] = all.sorted.directory().count();
  state.counters["box_cubes"] = all.dense.directory().count();
  state.counters["paper_cubes_per_ball"] = all.paper.cubes_per_ball(subject.balls);
  alternate(state, subject.model->size(), parts);
}

using Centres = std::vector<double> (*)(const Model &, size_t);

// Radius 0: a point.
void queries(benchmark::State &state, Subject &subject, Centres centres, size_t count, bool balls) {
  Alternatives &all = alternatives_of(subject);
  const std::vector<double> points = centres(*subject.model, count);
  const double radius = balls ? subject.model->largest_radius() : 0;
  const auto ask_library = [&] {
    return balls ? query_balls(*subject.model, points, radius) : query_points(*subject.model, points);
  };
  const size_t hits = ask_library();
  std::vector<Part> parts{{"library", [&] { benchmark::DoNotOptimize(ask_library()); }}};
  visit_structures(all, [&](const char *name, auto &structure) {
    require_equal(query(structure, points, radius), hits, name);
    parts.push_back({name, [&] { benchmark::DoNotOptimize(query(structure, points, radius)); }});
  });
  alternate(state, count, parts);
  size_t empty = 0;
  std::vector<uint32_t> ids(most_hits);
  for (size_t i = 0; i < points.size(); i += 3) {
    Hits found{ids.data(), most_hits};
    all.hashed.meeting(&points[i], radius, found);
    empty += found.count == 0 ? 1 : 0;
  }
  state.counters["queries"] = static_cast<double>(count);
  state.counters["hits_per_query"] = static_cast<double>(hits) / static_cast<double>(count);
  state.counters["empty_share"] = static_cast<double>(empty) / static_cast<double>(count);
}

// The library lists the pairs; the grids count them, which leaves more of the time to the search for cubes.
void pairs(benchmark::State &state, Subject &subject) {
  Alternatives &all = alternatives_of(subject);
  std::vector<uint32_t> first, ids;
  const size_t found = query_all_pairs(*subject.model, first, ids);
  std::vector<Part> parts{{"library", [&] { query_all_pairs(*subject.model, first, ids); }}};
  visit_grids(all, [&](const char *name, auto &grid) {
    require_equal(grid.count_pairs(), found, name);
    parts.push_back({name, [&] { benchmark::DoNotOptimize(grid.count_pairs()); }});
  });
  alternate(state, subject.model->size(), parts);
}

void register_set(const SubjectRecipe &recipe) {
  const std::string group = "alternatives/";
  const auto add = [&](const char *what, Body body) {
    register_case(group + what + '/' + recipe.key, recipe, std::move(body))->Unit(benchmark::kMicrosecond);
  };
  add("build", build);
  const std::pair<const char *, Centres> places[] = {{"box", random_points_in_box}, {"atom", random_points_near_atoms}};
  for (const auto &[where, centres] : places) {
    for (const bool balls : {false, true}) {
      add((std::string(balls ? "ball_" : "point_") + where).c_str(),
          [=, centre = centres](auto &state, auto &subject) { queries(state, subject, centre, 20000, balls); });
    }
  }
  add("pairs", pairs);
}

}  // namespace

void register_suite() {
  const std::vector<Molecule> molecules = paper_molecules();
  for (const Molecule &molecule : molecules) {
    register_set({molecule.name, [molecule] { return with_radii(molecule, Radii::paper); }});
  }
  const Molecule &largest = molecules.back();
  register_set({largest.name + "_x216", [largest] { return tiled(with_radii(largest, Radii::paper), 6); }});
}

}  // namespace bench
