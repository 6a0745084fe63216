#include "goals_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "markdown.hpp"

namespace report {
namespace {

constexpr double large = 4000;  // balls: below that a repeated input trains the branch predictor

constexpr const char *parts[] = {"build", "lists", "boundary", "measure", "everything"};

/// Names of the molecules of "scaling/<surface>/everything/", by size; those that were skipped come last.
std::vector<std::string> molecules_of(const Run &run, const std::string &surface) {
  const std::string prefix = "scaling/" + surface + "/everything/";
  std::vector<std::string> names;
  for (const std::string &name : run.order) {
    if (name.starts_with(prefix)) names.push_back(name.substr(prefix.size()));
  }
  const auto size = [&](const std::string &name) {
    const Measurement *m = run.find(prefix + name);
    return m != nullptr ? m->counter("atoms") : std::numeric_limits<double>::infinity();
  };
  std::stable_sort(names.begin(), names.end(),
                   [&](const std::string &a, const std::string &b) { return size(a) < size(b); });
  return names;
}

std::string name_of(const std::string &surface, const std::string &part, const std::string &molecule) {
  return "scaling/" + surface + '/' + part + '/' + molecule;
}

/// The slope of log(time) over log(n) by least squares; NaN with fewer than three sizes.
double fitted_exponent(const Run &run, const std::string &surface, const std::string &part) {
  std::vector<double> x;
  std::vector<double> y;
  for (const std::string &molecule : molecules_of(run, surface)) {
    const Measurement *m = run.find(name_of(surface, part, molecule));
    if (m == nullptr || m->counter("atoms") < large) continue;
    x.push_back(std::log(m->counter("atoms")));
    y.push_back(std::log(m->median()));
  }
  if (x.size() < 3) return std::nan("");
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / static_cast<double>(x.size());
    mean_y += y[i] / static_cast<double>(x.size());
  }
  double products = 0;
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    products += (x[i] - mean_x) * (y[i] - mean_y);
    squares += (x[i] - mean_x) * (x[i] - mean_x);
  }
  return products / squares;
}

void write_surface(std::ostream &out, const Run &run, const std::string &surface) {
  Table table({"molecule", "n", "build", "lists", "boundary", "measure", "everything", "vertices per atom", "exposed",
               "bytes per atom"});
  std::string remarks;
  for (const std::string &molecule : molecules_of(run, surface)) {
    const auto whole = run.benchmarks.find(name_of(surface, "everything", molecule));
    if (!whole->second.measured()) {
      table.row({molecule, "skipped", "-", "-", "-", "-", "-", "-", "-", "-"});
      remarks += "- " + molecule + ": " + whole->second.error + '\n';
      continue;
    }
    std::vector<std::string> cells{molecule, grouped(whole->second.counter("atoms"))};
    for (const char *part : parts) {
      const Measurement *m = run.find(name_of(surface, part, molecule));
      cells.push_back(m != nullptr ? three_digits(m->per_atom() * 1e6) : "-");
    }
    const Measurement *boundary = run.find(name_of(surface, "boundary", molecule));
    cells.push_back(boundary != nullptr ? fixed(boundary->counter("vertices_per_atom"), 2) : "-");
    cells.push_back(boundary != nullptr ? fixed(100 * boundary->counter("exposed_share"), 0) + " %" : "-");
    cells.push_back(boundary != nullptr ? fixed(boundary->counter("bytes_per_atom"), 0) : "-");
    table.row(cells);
  }
  std::vector<std::string> exponents{"fitted exponent of n", "from " + grouped(large)};
  for (const char *part : parts) {
    const double exponent = fitted_exponent(run, surface, part);
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

/// "stretch", "goal", "must" or "missed", by the tightest limit that is kept.
std::string grade(double value, const Limit &limit) {
  if (value <= limit.stretch) return "stretch";
  if (value <= limit.goal) return "goal";
  return value <= limit.must ? "must" : "**missed**";
}

/// The median and the least time per atom of the stand-in's parts together, in nanoseconds.
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

}  // namespace

void write_scaling(std::ostream &out, const Run &run) {
  out << "## Time over size\n\n"
         "Microseconds per atom. build: hsp_model_set; lists: hsp_query_neighbours for every ball; boundary:\n"
         "hsp_boundary_compute; measure: hsp_boundary_measure with areas and volumes of every ball; everything: "
         "build,\n"
         "boundary and measure. bytes per atom: the boundary's memory at the limits this molecule needs. An exponent\n"
         "of 1 is linear time.\n\n### Van der Waals balls\n\n";
  write_surface(out, run, "van_der_waals");
  out << "### Solvent-accessible balls (probe 1.4)\n\n";
  write_surface(out, run, "solvent_accessible");
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
    const double fitted = fitted_exponent(run, surface, "everything");
    return std::isnan(fitted) ? std::string("not measured") : fixed(fitted, 3);
  };
  out << "Linear time: everything, from " << grouped(large) << " balls, grows as n to the power "
      << exponent("van_der_waals") << " (v) and " << exponent("solvent_accessible") << " (s).\n\n";
}

}  // namespace report
