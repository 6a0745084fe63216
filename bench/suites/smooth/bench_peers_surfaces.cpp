// Areas and volumes by turns with other programs: FreeSASA (areas, approximate) and CGAL (combinatorics, no areas), on
// the same balls with the same radii and probe. Nothing is read or written meanwhile. Programs that are not installed
// are skipped.
#include <cmath>
#include <stdexcept>

#include "alternation.hpp"
#include "sizes.hpp"
#include "suite.hpp"
#include "tiling.hpp"
#ifdef BENCH_CGAL
#include "peers/cgal_alpha_complex.hpp"
#endif
#ifdef BENCH_FREESASA
#include "peers/freesasa_areas.hpp"
#endif

namespace bench {
namespace {

constexpr int turns = 5;
constexpr int turns_of_largest = 3;  // seconds each

// Areas and volumes of some sets by a program that shares no code with the library: free angles of circles in slices,
// summed over the heights, as tests/oracle/slice_quadrature.hpp does. This takes minutes, so the results are kept here.
struct Reference {
  const char *key;
  double area, volume;  // square and cubic angstrom
};
constexpr Reference references[] = {
    {"van_der_waals/crambin", 4247.6562115516, 3571.7031090322},
    {"solvent_accessible/crambin", 2971.3230159967, 8357.3215455062},
    {"van_der_waals/sod_model", 54707.431825958, 46963.926065318},
    {"solvent_accessible/sod_model", 27797.577444215, 102677.04158677},
};

const Reference *reference_of(const std::string &key) {
  for (const Reference &reference : references) {
    if (key == reference.key) return &reference;
  }
  return nullptr;
}

double relative_error(double value, double right) {
  return std::fabs(value / right - 1);
}

#ifdef BENCH_FREESASA
// Reports the error of the total area, in which errors cancel, and the mean error of a ball in units of the mean area.
void report_areas(benchmark::State &state, const std::string &name, const std::vector<double> &areas,
                  const std::vector<double> &right, double total_right) {
  double total = 0;
  double errors = 0;
  for (size_t i = 0; i < areas.size(); ++i) {
    total += areas[i];
    errors += std::fabs(areas[i] - right[i]);
  }
  state.counters[name + "_area_error"] = relative_error(total, total_right);
  state.counters[name + "_ball_error"] = errors / total_right;
}
#endif

// FreeSASA 2.1.2 crashes by points on a ball that meets no other.
[[maybe_unused]] bool has_lone_ball(const Model &model) {
  std::vector<uint32_t> first, ids;
  query_all_pairs(model, first, ids);
  for (size_t i = 0; i + 1 < first.size(); ++i) {
    if (first[i] == first[i + 1]) return true;
  }
  return false;
}

void surfaces_by_turns(benchmark::State &state, Subject &subject, const std::string &key) {
  [[maybe_unused]] const double probe = subject.model->probe();
  hsp_totals totals{};
  std::vector<Part> parts{{"library", [&] {
                             subject.model->set();
                             subject.boundary->compute();
                             totals = subject.boundary->measure();
                           }}};
  parts.front().run();
  const Reference *reference = reference_of(key);
  if (reference != nullptr) {
    state.counters["library_area_error"] = relative_error(totals.area, reference->area);
    state.counters["library_volume_error"] = relative_error(totals.volume, reference->volume);
  }
#ifdef BENCH_FREESASA
  const double area = reference != nullptr ? reference->area : totals.area;
  const std::pair<const char *, FreesasaMethod> methods[] = {{"freesasa_lr20", FreesasaMethod::lee_richards_20},
                                                             {"freesasa_sr100", FreesasaMethod::shrake_rupley_100}};
  for (const auto &[name, method] : methods) {
    if (method == FreesasaMethod::shrake_rupley_100 && has_lone_ball(*subject.model)) continue;
    report_areas(state, name, freesasa_areas(subject.balls, probe, method), subject.boundary->areas(), area);
    parts.push_back({name, [&subject, probe, method = method] {
                       benchmark::DoNotOptimize(freesasa_areas(subject.balls, probe, method));
                     }});
  }
#endif
#ifdef BENCH_CGAL
  const size_t vertices = cgal_alpha_complex(subject.balls, probe).boundary_vertices;
  if (vertices != subject.boundary->counts().vertices) throw std::runtime_error("CGAL finds other vertices");
  state.counters["vertices"] = static_cast<double>(vertices);
  parts.push_back(
      {"cgal_regular", [&] { benchmark::DoNotOptimize(cgal_regular_triangulation(subject.balls, probe)); }});
  parts.push_back({"cgal_alpha", [&] { benchmark::DoNotOptimize(cgal_alpha_complex(subject.balls, probe)); }});
#endif
  alternate(state, subject.model->size(), parts);
}

}  // namespace

void register_suite() {
  std::vector<Size> sizes = all_sizes();
  // CGAL takes half a minute for a million balls.
  std::erase_if(sizes, [](const Size &size) { return size.name.ends_with("_x216"); });
  if (const auto path = support::further_molecule("sod_model_4392.pdb")) {
    // With the radii that its reference was computed with.
    const Molecule molecule{"sod_model", support::read_atoms(*path)};
    sizes.push_back({molecule.name, [molecule] { return with_radii(molecule, Radii::metals_as_sulfur); }});
  } else {
    register_skipped("peers/skipped/sod_model", "no sod_model_4392.pdb in HSP_MOLECULES");
  }
  for (const Surface &surface : surfaces) {
    for (const Size &size : sizes) {
      const std::string key = std::string(surface.name) + '/' + size.name;
      const SubjectRecipe recipe{key, size.balls, surface.probe, Stage::boundary};
      register_case("peers/surfaces/" + key, recipe,
                    [key](benchmark::State &state, Subject &subject) { surfaces_by_turns(state, subject, key); })
          ->Unit(benchmark::kMicrosecond)
          ->Iterations(size.name.ends_with("_x27") ? turns_of_largest : turns);
    }
  }
#ifdef BENCH_CGAL
  benchmark::AddCustomContext("peer_CGAL", cgal_release());
#else
  register_skipped("peers/skipped/CGAL", "libcgal-dev is not installed");
#endif
#ifdef BENCH_FREESASA
  benchmark::AddCustomContext("peer_FreeSASA", freesasa_release());
#else
  register_skipped("peers/skipped/FreeSASA", "freesasa, libxml2-dev or libjson-c-dev is not installed");
#endif
}

}  // namespace bench
