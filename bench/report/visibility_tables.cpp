#include "visibility_tables.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "growth.hpp"
#include "markdown.hpp"

namespace report {
namespace {

const std::string molecules = "maps/molecules/";
const std::string random = "maps/random/";
const std::string families = "maps/families/";
const std::string envelope = "peers/visibility/crambin";

void write_maps(std::ostream &out, const Run &run) {
  Table table({"set", "n", "edges", "balls seen", "map, ms", "z-buffer, ms", "map / z-buffer", "ns per ball",
               "ns per edge", "bytes per ball"});
  for (const std::string &prefix : {molecules, random, families}) {
    for (const std::string &name : molecules_by_size(run, prefix)) {
      const std::string heading = prefix == random ? "random" : name;
      const Measurement *m = run.find(prefix + name);
      if (m == nullptr) {
        std::vector<std::string> cells{heading, run.benchmarks.at(prefix + name).error};
        cells.insert(cells.end(), 8, "-");
        table.row(cells);
        continue;
      }
      const double seconds = m->counter("map_seconds");
      table.row({heading, grouped(m->counter("atoms")), grouped(m->counter("edges")), grouped(m->counter("balls_seen")),
                 three_digits(seconds * 1e3), three_digits(m->counter("analytic_seconds") * 1e3),
                 fixed(m->counter("map_ratio"), 3), three_digits(seconds / m->counter("atoms") * 1e9),
                 three_digits(seconds / m->counter("edges") * 1e9),
                 three_digits(m->counter("bytes") / m->counter("atoms"))});
    }
  }
  table.write(out);
}

struct MapGoal {
  const char *what;
  double limit;
  bool at_least;
  std::optional<double> value;
};

std::optional<double> counter(const Run &run, const std::string &benchmark, const std::string &name, double scale) {
  const Measurement *m = run.find(benchmark);
  if (m == nullptr || !m->counters.contains(name)) return std::nullopt;
  return m->counter(name) * scale;
}

void write_goals_of_maps(std::ostream &out, const Run &run) {
  const double exponent = growth_exponent(run, random, 1000, counter_of("map_seconds"));
  const MapGoal goals[] = {
      {"map / analytic z-buffer, the stand-in for SOD", 3, false,
       counter(run, molecules + "sod_stand_in", "map_ratio", 1)},
      {"map of crambin, ms", 2.5, false, counter(run, molecules + "crambin", "map_seconds", 1e3)},
      {"exponent of time, 1,000 to 256,000 random balls", 1.15, false,
       std::isnan(exponent) ? std::nullopt : std::optional(exponent)},
      {"CGAL's envelope of crambin over the map", 1e4, true, counter(run, envelope, "cgal_envelope_ratio", 1)},
  };
  Table table({"what", "goal", "now", "verdict"});
  for (const MapGoal &goal : goals) {
    const bool kept = goal.value && (goal.at_least ? *goal.value >= goal.limit : *goal.value <= goal.limit);
    table.row({goal.what, std::string(goal.at_least ? "at least " : "at most ") + three_digits(goal.limit),
               goal.value ? three_digits(*goal.value) : "-",
               !goal.value ? "not measured"
               : kept      ? "goal"
                           : "**missed**"});
  }
  table.write(out);
}

}  // namespace

void write_visibility(std::ostream &out, const Run &run) {
  out << R"(## Section 5.2: the visibility map

hsp_map_compute for a new direction in every frame: all that is seen as faces, edges and vertices, linked and checked,
by turns with the analytic z-buffer above, which says as much as its 1000 x 1000 pixels can. Molecules from 16
directions, van der Waals balls. random: balls with radii from 1 to 2, one in 10 cubic units, from 4 directions.
crossing_rows: two layers of rows, one behind the other, several edges for each ball. deep_stack: one ball before the
other, all silhouettes seen, every ball near every disc. Katz, Overmars and Sharir's divide and conquer has the better
bound, see lib/sight/maps/THEORY.md.

)";
  write_maps(out, run);
  write_goals_of_maps(out, run);
}

}  // namespace report
