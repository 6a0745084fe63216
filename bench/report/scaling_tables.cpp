#include "scaling_tables.hpp"

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

void write_split_work(std::ostream &out, const Run &run) {
  out << R"(## Work split among threads

Boundary and areas and volumes of every ball, by the clock on the wall: microseconds per atom. alone:
hsp_boundary_compute and hsp_boundary_measure; one thread, two threads: hsp_boundary_begin, _work, _end and
hsp_boundary_measure_range by threads of the program that are started anew each time, 8 workers for each. The ratios are
medians over the turns: how many times as fast as alone. All give the same bits.

)";
  for (const Surface &surface : surfaces) {
    out << "### " << surface.heading << "\n\n";
    const std::string prefix = std::string("split_work/") + surface.name + '/';
    Table table({"molecule", "n", "alone", "one thread", "two threads", "one, ratio", "two, ratio"});
    for (const std::string &molecule : molecules_by_size(run, prefix)) {
      const Measurement *m = run.find(prefix + molecule);
      if (m == nullptr) {
        table.row({molecule, run.benchmarks.at(prefix + molecule).error, "-", "-", "-", "-", "-"});
        continue;
      }
      std::vector<std::string> cells{molecule, grouped(m->counter("atoms"))};
      for (const char *part : {"alone", "by_one", "by_two"}) {
        cells.push_back(three_digits(m->counter(std::string(part) + "_seconds") / m->counter("atoms") * 1e6));
      }
      for (const char *ratio : {"by_one_ratio", "by_two_ratio"}) cells.push_back(fixed(1 / m->counter(ratio), 2));
      table.row(cells);
    }
    table.write(out);
  }
}

}  // namespace report
