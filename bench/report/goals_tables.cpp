#include "goals_tables.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"
#include "surfaces.hpp"

namespace report {
namespace {

constexpr const char *parts[] = {"build", "lists", "pairs", "boundary", "measure", "everything"};

std::string prefix_of(const std::string &surface, const std::string &part) {
  return "scaling/" + surface + '/' + part + '/';
}

double median_seconds(const Measurement &m) {
  return m.median();
}

void write_surface(std::ostream &out, const Run &run, const std::string &surface) {
  Table table({"molecule", "n", "build", "lists", "pairs", "boundary", "measure", "everything", "vertices per atom",
               "exposed", "bytes per atom"});
  std::string remarks;
  for (const std::string &molecule : molecules_by_size(run, prefix_of(surface, "everything"))) {
    const auto whole = run.benchmarks.find(prefix_of(surface, "everything") + molecule);
    if (!whole->second.measured()) {
      table.row({molecule, "skipped", "-", "-", "-", "-", "-", "-", "-", "-", "-"});
      remarks += "- " + molecule + ": " + whole->second.error + '\n';
      continue;
    }
    std::vector<std::string> cells{molecule, grouped(whole->second.counter("atoms"))};
    for (const char *part : parts) {
      const Measurement *m = run.find(prefix_of(surface, part) + molecule);
      cells.push_back(m != nullptr ? three_digits(m->per_atom() * 1e6) : "-");
    }
    const Measurement *boundary = run.find(prefix_of(surface, "boundary") + molecule);
    cells.push_back(boundary != nullptr ? fixed(boundary->counter("vertices_per_atom"), 2) : "-");
    cells.push_back(boundary != nullptr ? fixed(100 * boundary->counter("exposed_share"), 0) + " %" : "-");
    cells.push_back(boundary != nullptr ? fixed(boundary->counter("bytes_per_atom"), 0) : "-");
    table.row(cells);
  }
  std::vector<std::string> exponents{"fitted exponent of n", "from " + grouped(large_set)};
  for (const char *part : parts) {
    const double exponent = growth_exponent(run, prefix_of(surface, part), large_set, median_seconds);
    exponents.push_back(std::isnan(exponent) ? "-" : fixed(exponent, 3));
  }
  exponents.insert(exponents.end(), {"", "", ""});
  table.row(exponents);
  table.write(out);
  if (!remarks.empty()) out << remarks << '\n';
}

struct Limit {
  double must, goal, stretch;
};

// "stretch", "goal", "must" or "missed", by the tightest limit that is kept.
std::string grade(double value, const Limit &limit) {
  if (value <= limit.stretch) return "stretch";
  if (value <= limit.goal) return "goal";
  return value <= limit.must ? "must" : "**missed**";
}

// The median and the least time per atom of the stand-in's parts together, in nanoseconds.
struct PerAtom {
  double median = 0;
  double least = 0;
  bool complete = true;
};

PerAtom per_atom(const Run &run, const std::vector<std::string> &benchmarks, const std::string &divisor) {
  PerAtom sum;
  for (const std::string &name : benchmarks) {
    const Measurement *m = run.find(name);
    if (m == nullptr) {
      sum.complete = false;
      continue;
    }
    const double count = m->counter(divisor);
    sum.median += m->median() / count * 1e9;
    sum.least += m->least() / count * 1e9;
  }
  return sum;
}

// A figure for each surface, none of which may be larger than the goal.
struct GrowthGoal {
  const char *what;
  const char *suite;
  const char *counter;
  double from;  // balls
  bool exponent;
  double goal;
};

void write_growth_goals(std::ostream &out, const Run &run) {
  const GrowthGoal goals[] = {
      {"Step 3 / Steps 1 + 2, largest ratio", "topology", "topology_ratio", large_set, false, 0.6},
      {"exponent of Step 3's time", "topology", "topology_seconds", 0, true, 1.05},
      {"exponent of Step 3's time", "topology", "topology_seconds", large_set, true, 1.05},
      {"exponent of Step 3's memory", "topology", "bytes", 0, true, 1.05},
      {"gradient / Steps 1 + 2, largest ratio", "gradients", "gradient_ratio", large_set, false, 0.35},
  };
  out << "Step 3 and gradients, one figure for all sets from so many balls on, up to a million:\n\n";
  Table table({"what", "n", "goal, at most", "van der Waals", "solvent-accessible", "verdict"});
  for (const GrowthGoal &goal : goals) {
    std::vector<std::string> cells{goal.what, goal.from > 0 ? "from " + grouped(goal.from) : "all",
                                   fixed(goal.goal, 2)};
    bool known = true;
    bool kept = true;
    for (const Surface &surface : surfaces) {
      const std::string prefix = std::string(goal.suite) + '/' + surface.name + "/compute/";
      const Amount amount = counter_of(goal.counter);
      const double value = goal.exponent ? growth_exponent(run, prefix, goal.from, amount)
                                         : largest_amount(run, prefix, goal.from, amount);
      known = known && !std::isnan(value);
      kept = kept && value <= goal.goal;
      cells.push_back(std::isnan(value) ? "-" : fixed(value, 3));
    }
    cells.emplace_back(!known ? "not measured" : kept ? "goal" : "**missed**");
    table.row(cells);
  }
  table.write(out);
}

}  // namespace

void write_scaling(std::ostream &out, const Run &run) {
  out << "## Time over size\n\n"
         "Microseconds per atom. build: hsp_model_set; lists: hsp_query_neighbours for every ball; pairs: the same by\n"
         "hsp_query_pairs; boundary: hsp_boundary_compute; measure: hsp_boundary_measure with areas and volumes of\n"
         "every ball; everything: build, boundary and measure. bytes per atom: the boundary's memory at the limits\n"
         "this molecule needs. An exponent of 1 is linear time.\n\n";
  for (const Surface &surface : surfaces) {
    out << "### " << surface.heading << "\n\n";
    write_surface(out, run, surface.name);
  }
}

void write_queries(std::ostream &out, const Run &run) {
  out << "## Queries one by one\n\n"
         "Nanoseconds per query and, in brackets, hits per query: van der Waals balls, 100,000 distinct centres. box:\n"
         "uniform in the box around the balls; atom: within 1 Angstrom of an atom. Query balls have radius r_max.\n\n";
  Table table({"molecule", "n", "point, box", "point, atom", "ball, box", "ball, atom"});
  const std::string first = "queries/point_box/";
  for (const std::string &name : run.order) {
    if (!name.starts_with(first)) continue;
    const std::string molecule = name.substr(first.size());
    std::vector<std::string> cells{molecule, grouped(run.benchmarks.at(name).counter("atoms"))};
    for (const char *kind : {"point_box", "point_atom", "ball_box", "ball_atom"}) {
      const Measurement *m = run.find(std::string("queries/") + kind + '/' + molecule);
      cells.push_back(m == nullptr ? "-"
                                   : three_digits(m->median() / m->counter("queries") * 1e9) + " (" +
                                         fixed(m->counter("hits_per_query"), 1) + ")");
    }
    table.row(cells);
  }
  table.write(out);
}

void write_goals(std::ostream &out, const Run &run) {
  out << "## Goals\n\n"
         "Nanoseconds per atom (per query) of the stand-in for SOD, 4392 balls, one thread; v: van der Waals, s:\n"
         "solvent-accessible. The limits were set for the least of several runs; the verdict is about that column.\n"
         "The house limit is what a release has to keep, with areas and volumes; the other three come from\n"
         "prototypes with vector instructions on one particular machine.\n\n";
  struct Goal {
    const char *what;
    std::vector<std::string> benchmarks;
    Limit limit;
    double house;         // 0: none
    const char *divisor;  // the counter that holds how many atoms or queries one iteration is for
  };
  const std::string v = "scaling/van_der_waals/";
  const std::string s = "scaling/solvent_accessible/";
  const std::string m = "/sod_stand_in";
  const Goal goals[] = {
      {"neighbour lists, v", {v + "lists" + m}, {150, 60, 40}, 0, "atoms"},
      {"neighbour lists, s", {s + "lists" + m}, {300, 150, 110}, 0, "atoms"},
      {"neighbour lists in one call, v", {v + "pairs" + m}, {150, 60, 40}, 0, "atoms"},
      {"neighbour lists in one call, s", {s + "pairs" + m}, {300, 150, 110}, 0, "atoms"},
      {"Steps 1 + 2, v", {v + "build" + m, v + "boundary" + m}, {600, 350, 220}, 0, "atoms"},
      {"Steps 1 + 2, s", {s + "build" + m, s + "boundary" + m}, {2500, 1200, 850}, 0, "atoms"},
      {"with area and volume, v", {v + "everything" + m}, {900, 500, 330}, 3000, "atoms"},
      {"with area and volume, s", {s + "everything" + m}, {3000, 1400, 1000}, 20000, "atoms"},
      {"point query near atoms, v", {"queries/point_atom" + m}, {60, 35, 20}, 0, "queries"},
      {"ball query near atoms, v", {"queries/ball_atom" + m}, {150, 90, 60}, 0, "queries"},
  };
  Table table({"what", "median", "least", "house limit", "kept", "must", "goal", "stretch", "verdict"});
  for (const Goal &goal : goals) {
    const PerAtom sum = per_atom(run, goal.benchmarks, goal.divisor);
    const bool known = sum.complete;
    table.row({goal.what, known ? three_digits(sum.median) : "-", known ? three_digits(sum.least) : "-",
               goal.house > 0 ? grouped(goal.house) : "",
               goal.house > 0 && known ? (sum.median <= goal.house ? "yes" : "**no**") : "", grouped(goal.limit.must),
               grouped(goal.limit.goal), grouped(goal.limit.stretch),
               known ? grade(sum.least, goal.limit) : "not measured"});
  }
  table.write(out);
  const auto exponent = [&](const char *surface) {
    const double fitted = growth_exponent(run, prefix_of(surface, "everything"), large_set, median_seconds);
    return std::isnan(fitted) ? std::string("not measured") : fixed(fitted, 3);
  };
  out << "Linear time: everything, from " << grouped(large_set) << " balls, grows as n to the power "
      << exponent("van_der_waals") << " (v) and " << exponent("solvent_accessible") << " (s).\n\n";
  write_growth_goals(out, run);
}

}  // namespace report
