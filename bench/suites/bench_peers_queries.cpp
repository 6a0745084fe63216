// Point and ball queries and neighbour lists by turns with other programs: nanoflann (a k-d tree) and gemmi (cell
// lists), on the same van der Waals balls and for the same query centres. Neither knows radii of balls: both search for
// centres within reach of the largest radius, and the test with each ball's own radius follows. All must find as many
// hits as the library. Programs that are not installed are skipped.
#include <memory>
#include <stdexcept>

#include "alternation.hpp"
#include "section_3/grouped_balls.hpp"
#include "sizes.hpp"
#include "suite.hpp"
#ifdef BENCH_GEMMI
#include "peers/gemmi_search.hpp"
#endif
#ifdef BENCH_NANOFLANN
#include "peers/nanoflann_search.hpp"
#endif

namespace bench {
namespace {

constexpr int turns = 7;
constexpr size_t queries = 20000;
constexpr uint32_t most_hits = 4096;

// The questions: balls of this radius around these centres; a point is a ball of radius 0.
struct Workload {
  std::vector<double> centres;
  double largest_radius = 0;
  std::vector<double> radius;  // of each, or one for all

  size_t size() const { return centres.size() / 3; }
  double radius_of(size_t i) const { return radius.size() == 1 ? radius.front() : radius[i]; }
};

template <class Search>
[[maybe_unused]] size_t ask(const Search &search, const Workload &workload) {
  std::vector<uint32_t> ids(most_hits);
  size_t found = 0;
  for (size_t i = 0; i < workload.size(); ++i) {
    Hits hits{ids.data(), most_hits};
    search.meeting(&workload.centres[3 * i], workload.radius_of(i), hits);
    found += hits.count;
  }
  benchmark::DoNotOptimize(ids);
  return found;
}

// The parts of the other programs for a workload. `hits`: the number of hits that they must find.
class Peers {
 public:
  Peers(const Balls &balls, const Workload &workload, size_t hits) {
    static_cast<void>(balls);
    static_cast<void>(workload);
    static_cast<void>(hits);
#ifdef BENCH_NANOFLANN
    nanoflann_.build(balls);
    add("nanoflann", nanoflann_, workload, hits);
#endif
#ifdef BENCH_GEMMI
    gemmi_.prepare(balls);
    gemmi_.build(workload.largest_radius);
    add("gemmi", gemmi_, workload, hits);
#endif
  }

  void append_to(std::vector<Part> &parts) const {
    parts.insert(parts.end(), parts_.begin(), parts_.end());
  }

 private:
  template <class Search>
  [[maybe_unused]] void add(const char *name, const Search &search, const Workload &workload, size_t hits) {
    if (ask(search, workload) != hits) throw std::runtime_error(std::string(name) + " finds other balls");
    parts_.push_back({name, [&] { benchmark::DoNotOptimize(ask(search, workload)); }});
  }

#ifdef BENCH_NANOFLANN
  NanoflannSearch nanoflann_;
#endif
#ifdef BENCH_GEMMI
  GemmiSearch gemmi_;
#endif
  std::vector<Part> parts_;
};

void build(benchmark::State &state, Subject &subject) {
  std::vector<Part> parts{{"library", [&] { subject.model->set(); }}};
#ifdef BENCH_NANOFLANN
  NanoflannSearch nanoflann;
  parts.push_back({"nanoflann", [&] { nanoflann.build(subject.balls); }});
#endif
#ifdef BENCH_GEMMI
  GemmiSearch gemmi;
  gemmi.prepare(subject.balls);
  parts.push_back({"gemmi", [&] { gemmi.build(subject.model->largest_radius()); }});
#endif
  alternate(state, subject.model->size(), parts);
}

using Centres = std::vector<double> (*)(const Model &, size_t);

void search(benchmark::State &state, Subject &subject, Centres centres, bool balls) {
  const Model &model = *subject.model;
  const double radius = balls ? model.largest_radius() : 0;
  const Workload workload{centres(model, queries), radius, {radius}};
  const auto ask_library = [&] {
    return balls ? query_balls(model, workload.centres, radius) : query_points(model, workload.centres);
  };
  const Peers peers(subject.balls, workload, ask_library());
  std::vector<Part> parts{{"library", [&] { benchmark::DoNotOptimize(ask_library()); }}};
  peers.append_to(parts);
  state.counters["queries"] = queries;
  alternate(state, queries, parts);
}

// The balls that meet each ball: all at once by the library, one by one by the peers, which count the ball itself too.
void lists(benchmark::State &state, Subject &subject) {
  const Model &model = *subject.model;
  std::vector<uint32_t> first, ids;
  const size_t pairs = query_all_pairs(model, first, ids);
  const Workload workload{subject.balls.xyz, model.largest_radius(), subject.balls.radius};
  const Peers peers(subject.balls, workload, pairs + model.size());
  std::vector<Part> parts{{"library", [&] { query_all_pairs(model, first, ids); }}};
  peers.append_to(parts);
  state.counters["queries"] = model.size();
  alternate(state, model.size(), parts);
}

}  // namespace

void register_suite() {
  for (const Size &size : all_sizes()) {
    const SubjectRecipe recipe{size.name, size.balls};
    const auto add = [&](const std::string &what, Body body) {
      register_case("peers/queries/" + what + '/' + size.name, recipe, std::move(body))
          ->Unit(benchmark::kMicrosecond)
          ->Iterations(turns);
    };
    add("build", build);
    const std::pair<const char *, Centres> places[] = {{"box", random_points_in_box},
                                                       {"atom", random_points_near_atoms}};
    for (const auto &[where, centres] : places) {
      for (const bool balls : {false, true}) {
        add(std::string(balls ? "ball_" : "point_") + where,
            [=, centre = centres](auto &state, auto &subject) { search(state, subject, centre, balls); });
      }
    }
    add("lists", lists);
  }
#ifdef BENCH_GEMMI
  benchmark::AddCustomContext("peer_gemmi", gemmi_release());
#else
  register_skipped("peers/skipped/gemmi", "gemmi-dev is not installed");
#endif
#ifdef BENCH_NANOFLANN
  benchmark::AddCustomContext("peer_nanoflann", nanoflann_release());
#else
  register_skipped("peers/skipped/nanoflann", "libnanoflann-dev is not installed");
#endif
}

}  // namespace bench
