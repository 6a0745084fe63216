#include "contact_tables.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"
#include "surfaces.hpp"

namespace report {
namespace {

constexpr const char *parts[] = {"boundary", "contacts", "curvature", "curvature_gradient"};

void write_times(std::ostream &out, const Run &run, const Surface &surface) {
  const std::string prefix = std::string("contacts/") + surface.name + "/compute/";
  Table table({"molecule", "n", "Steps 1 + 2", "contacts", "curvature", "and gradient", "contacts, ratio",
               "curvature, ratio", "and gradient, ratio", "contacts per atom", "triangles per atom", "bytes"});
  for (const std::string &molecule : molecules_by_size(run, prefix)) {
    const Measurement *m = run.find(prefix + molecule);
    if (m == nullptr) {
      table.row(
          {molecule, run.benchmarks.at(prefix + molecule).error, "-", "-", "-", "-", "-", "-", "-", "-", "-", "-"});
      continue;
    }
    const double atoms = m->counter("atoms");
    std::vector<std::string> cells{molecule, grouped(atoms)};
    for (const char *part : parts) {
      cells.push_back(three_digits(m->counter(std::string(part) + "_seconds") / atoms * 1e6));
    }
    for (const char *ratio : {"contacts_ratio", "curvature_ratio", "curvature_gradient_ratio"}) {
      cells.push_back(fixed(m->counter(ratio), 3));
    }
    for (const char *count : {"contacts_per_atom", "triangles_per_atom"}) {
      cells.push_back(fixed(m->counter(count), 2));
    }
    cells.push_back(fixed(m->counter("bytes") / atoms, 0));
    table.row(cells);
  }
  for (const double from : {0.0, large_set}) {
    std::vector<std::string> cells{"fitted exponent of n", from > 0 ? "from " + grouped(from) : "all"};
    for (const char *part : parts) {
      const double fitted = growth_exponent(run, prefix, from, counter_of(std::string(part) + "_seconds"));
      cells.push_back(std::isnan(fitted) ? "-" : fixed(fitted, 3));
    }
    cells.insert(cells.end(), {"", "", "", "", "", ""});
    table.row(cells);
  }
  table.write(out);
}

}  // namespace

void write_contacts(std::ostream &out, const Run &run) {
  out << R"(## Contacts, cells and curvature

contacts: hsp_contacts_compute, with cells and the counts of the dual complex; curvature: hsp_boundary_curvature with
the mean curvature of every ball; and gradient: hsp_boundary_morphometry of the mean curvature, by every centre and
radius. All are timed by turns with hsp_boundary_compute (Steps 1 + 2) in one process; times are microseconds per atom,
the ratios medians over the turns, of each over Steps 1 + 2. bytes: per atom, of the contacts at the limits that the set
needs.

)";
  for (const Surface &surface : surfaces) {
    out << "### " << surface.heading << "\n\n";
    write_times(out, run, surface);
  }
}

}  // namespace report
