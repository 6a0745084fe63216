#include "gradient_tables.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"
#include "surfaces.hpp"

namespace report {
namespace {

constexpr const char *parts[] = {"boundary", "measure", "gradient"};

void write_times(std::ostream &out, const Run &run, const Surface &surface) {
  const std::string prefix = std::string("gradients/") + surface.name + "/compute/";
  Table table({"molecule", "n", "Steps 1 + 2", "measure", "gradient", "measure, ratio", "gradient, ratio"});
  for (const std::string &molecule : molecules_by_size(run, prefix)) {
    const Measurement *m = run.find(prefix + molecule);
    if (m == nullptr) {
      table.row({molecule, run.benchmarks.at(prefix + molecule).error, "-", "-", "-", "-", "-"});
      continue;
    }
    std::vector<std::string> cells{molecule, grouped(m->counter("atoms"))};
    for (const char *part : parts) {
      cells.push_back(three_digits(m->counter(std::string(part) + "_seconds") / m->counter("atoms") * 1e6));
    }
    for (const char *ratio : {"measure_ratio", "gradient_ratio"}) cells.push_back(fixed(m->counter(ratio), 3));
    table.row(cells);
  }
  for (const double from : {0.0, large_set}) {
    std::vector<std::string> cells{"fitted exponent of n", from > 0 ? "from " + grouped(from) : "all"};
    for (const char *part : parts) {
      const double fitted = growth_exponent(run, prefix, from, counter_of(std::string(part) + "_seconds"));
      cells.push_back(std::isnan(fitted) ? "-" : fixed(fitted, 3));
    }
    cells.insert(cells.end(), {"", ""});
    table.row(cells);
  }
  table.write(out);
}

void write_frames(std::ostream &out, const Run &run) {
  out << R"(### Frames of a trajectory

hsp_model_set, hsp_boundary_compute and hsp_boundary_gradient for one frame after the other, in the same memory at the
default limits: 16 frames, every coordinate shifted by up to 0.1 Angstrom at random. Microseconds per frame,
microseconds per frame and atom, and frames in a second; v: van der Waals, s: solvent-accessible.

)";
  const auto prefix = [](const Surface &surface) { return std::string("gradients/") + surface.name + "/frames/"; };
  Table table({"molecule", "n", "frame, v", "per atom", "frames/s", "frame, s", "per atom", "frames/s"});
  for (const std::string &molecule : molecules_by_size(run, prefix(surfaces[0]))) {
    std::vector<std::string> cells{molecule, "-"};
    for (const Surface &surface : surfaces) {
      const Measurement *m = run.find(prefix(surface) + molecule);
      if (m == nullptr) {
        cells.insert(cells.end(), {"-", "-", "-"});
        continue;
      }
      cells[1] = grouped(m->counter("atoms"));
      cells.insert(cells.end(),
                   {three_digits(m->median() * 1e6), three_digits(m->per_atom() * 1e6), three_digits(1 / m->median())});
    }
    table.row(cells);
  }
  table.write(out);
}

}  // namespace

void write_gradients(std::ostream &out, const Run &run) {
  out << R"(## Areas, volumes and their gradients

The paper has none. measure: hsp_boundary_measure with area and volume of every ball; gradient: hsp_boundary_gradient
of a weighted sum of areas plus the volume, by every centre and radius. Both are timed by turns with
hsp_boundary_compute (Steps 1 + 2) in one process; times are microseconds per atom, the ratios medians over the turns
of measure and gradient over Steps 1 + 2.

)";
  for (const Surface &surface : surfaces) {
    out << "### " << surface.heading << "\n\n";
    write_times(out, run, surface);
  }
  write_frames(out, run);
}

}  // namespace report
