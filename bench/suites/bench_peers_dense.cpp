// Boundaries with areas of sets with more and more neighbours for each ball, by turns with CGAL (alpha complexes) and
// FreeSASA (areas). The sets are balls at random places; copies of one molecule with each atom moved a little, as in
// the models of an ensemble, or hardly at all; a swept ball; balls of one centre; and a large ball in its solvent.
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "alternation.hpp"
#include "suite.hpp"
#ifdef BENCH_CGAL
#include "peers/cgal_alpha_complex.hpp"
#endif
#ifdef BENCH_FREESASA
#include "peers/freesasa_areas.hpp"
#endif

namespace bench {
namespace {

constexpr int turns = 3;

// Balls of radius 1 at random places in a cube of such a size that a ball far from its sides has so many neighbours.
Balls random_balls(uint32_t n, double neighbours) {
  constexpr double pi = 3.14159265358979323846;
  const double side = std::cbrt(n * 8 * (4 * pi / 3) / neighbours);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(0, side);
  Balls balls;
  for (uint32_t k = 0; k < n; ++k) {
    const double x = coordinate(random), y = coordinate(random);
    balls.add(x, y, coordinate(random), 1);
  }
  return balls;
}

// Copies of the first 60 atoms of crambin, each coordinate moved by a normally distributed number.
Balls ensemble(uint32_t models, double deviation) {
  constexpr uint32_t atoms = 60;
  const std::vector<Molecule> molecules = paper_molecules();
  const auto crambin =
      std::find_if(molecules.begin(), molecules.end(), [](const Molecule &one) { return one.name == "crambin"; });
  const Balls whole = with_radii(*crambin, Radii::van_der_waals);
  std::mt19937_64 random(7);
  std::normal_distribution<double> moved(0, deviation);
  Balls balls;
  for (uint32_t k = 0; k < models * atoms; ++k) {
    const double *const xyz = &whole.xyz[3 * size_t{k % atoms}];
    const double x = xyz[0] + moved(random), y = xyz[1] + moved(random);
    balls.add(x, y, xyz[2] + moved(random), whole.radius[k % atoms]);
  }
  return balls;
}

// Balls of radius 1 on a line, 1e-4 apart.
Balls swept_ball(uint32_t n) {
  Balls balls;
  for (uint32_t k = 0; k < n; ++k) balls.add(k * 1e-4, 0, 0, 1);
  return balls;
}

Balls of_one_centre(uint32_t n) {
  Balls balls;
  for (uint32_t k = 0; k < n; ++k) balls.add(0, 0, 0, 1 + 1e-4 * k);
  return balls;
}

// Balls of radius 1.6 on a lattice of 27 a side, each moved a little. In the middle is a large ball in place of all
// those that it meets, or none if its radius is 0.
Balls solvent(double large) {
  constexpr uint32_t side = 27;
  constexpr double step = 3.1, middle = side * step / 2;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> moved(-0.4, 0.4);
  Balls balls;
  if (large > 0) balls.add(middle, middle, middle, large);
  for (uint32_t k = 0; k < side * side * side; ++k) {
    const double x = step * (k % side) + moved(random), y = step * (k / side % side) + moved(random);
    const double z = step * (k / side / side) + moved(random);
    if (large == 0 || std::hypot(x - middle, y - middle, z - middle) > large + 1.4) balls.add(x, y, z, 1.6);
  }
  return balls;
}

double neighbours_a_ball(const Model &model) {
  std::vector<uint32_t> first, ids;
  query_all_pairs(model, first, ids);
  return static_cast<double>(first.back()) / model.size();
}

// FreeSASA is left out of sets with more pairs than this, as it would take minutes.
[[maybe_unused]] constexpr double most_pairs_of_freesasa = 6e6;

void dense_by_turns(benchmark::State &state, Subject &subject) {
  const double neighbours = neighbours_a_ball(*subject.model);
  state.counters["neighbours"] = neighbours;
  std::vector<Part> parts{{"library", [&] {
                             subject.model->set();
                             subject.boundary->compute();
                             benchmark::DoNotOptimize(subject.boundary->measure());
                           }}};
  parts.front().run();
#ifdef BENCH_CGAL
  if (cgal_alpha_complex(subject.balls, 0).boundary_vertices != subject.boundary->counts().vertices) {
    throw std::runtime_error("CGAL finds other vertices");
  }
  parts.push_back({"cgal_alpha", [&] { benchmark::DoNotOptimize(cgal_alpha_complex(subject.balls, 0)); }});
#endif
#ifdef BENCH_FREESASA
  if (neighbours * subject.model->size() < most_pairs_of_freesasa) {
    parts.push_back({"freesasa_lr20", [&] {
                       benchmark::DoNotOptimize(freesasa_areas(subject.balls, 0, FreesasaMethod::lee_richards_20));
                     }});
  }
#endif
  alternate(state, subject.model->size(), parts);
}

void register_set(const std::string &kind, uint32_t size, std::function<Balls()> balls) {
  const std::string key = kind + '/' + std::to_string(size);
  register_case("peers/dense/" + key, {key, std::move(balls), 0, Stage::boundary}, dense_by_turns)
      ->Unit(benchmark::kMillisecond)
      ->Iterations(turns);
}

}  // namespace

void register_suite() {
  for (const uint32_t neighbours : {10, 30, 100, 300, 1000, 3000, 10000, 25000}) {
    const uint32_t n = neighbours < 5000 ? 5000 : 20000;
    register_set("random", neighbours, [n, neighbours] { return random_balls(n, neighbours); });
  }
  for (const uint32_t models : {1, 3, 10, 30, 80, 250}) {
    register_set("ensemble", models, [models] { return ensemble(models, 0.5); });
  }
  register_set("copies", 80, [] { return ensemble(80, 0.001); });
  for (const uint32_t n : {400, 4000}) register_set("line", n, [n] { return swept_ball(n); });
  for (const uint32_t n : {2000, 8000}) register_set("centre", n, [n] { return of_one_centre(n); });
  for (const uint32_t large : {0, 20}) register_set("solvent", large, [large] { return solvent(large); });
}

}  // namespace bench
