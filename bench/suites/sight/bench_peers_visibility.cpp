// The visibility map of crambin by turns with CGAL's envelope of its spheres, the only other program that finds such a
// map; on the same balls, along the z axis. CGAL takes half a minute, so there is one round, in which the library's map
// is made several times so that its time can be measured.
#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "suite.hpp"
#include "view_handle.hpp"
#ifdef BENCH_CGAL_ENVELOPE
#include "peers/cgal_envelope.hpp"
#endif

namespace bench {
namespace {

#ifdef BENCH_CGAL_ENVELOPE

constexpr int maps = 41;

double seconds_of(const std::function<void()> &run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void envelope_of(benchmark::State &state, const Subject &subject) {
  const Direction towards{0, 0, 1};
  VisibleMap map(*subject.model, {towards});
  const uint32_t faces = map.info().faces;
  iterate(state, [&] {
    std::vector<double> seconds;
    for (int k = 0; k < maps; ++k) seconds.push_back(seconds_of([&] { map.compute(towards); }));
    std::nth_element(seconds.begin(), seconds.begin() + maps / 2, seconds.end());
    size_t theirs = 0;
    const double envelope = seconds_of([&] { theirs = cgal_envelope_faces(subject.balls); });
    if (theirs != faces) throw std::runtime_error("CGAL finds other faces");
    state.counters["map_seconds"] = seconds[maps / 2];
    state.counters["cgal_envelope_seconds"] = envelope;
    state.counters["cgal_envelope_ratio"] = envelope / seconds[maps / 2];
    state.counters["faces"] = faces;
  });
}

#endif

}  // namespace

void register_suite() {
#ifdef BENCH_CGAL_ENVELOPE
  for (const Molecule &molecule : paper_molecules()) {
    if (molecule.name != "crambin") continue;
    const SubjectRecipe recipe{molecule.name, [molecule] { return with_radii(molecule, Radii::van_der_waals); }, 0,
                               Stage::model};
    register_case("peers/visibility/" + molecule.name, recipe, envelope_of)
        ->Unit(benchmark::kMicrosecond)
        ->Iterations(1);
  }
  benchmark::AddCustomContext("peer_CGAL", cgal_envelope_release());
#else
  register_skipped("peers/skipped/CGAL_envelope", "libcgal-dev is not installed");
#endif
}

}  // namespace bench
