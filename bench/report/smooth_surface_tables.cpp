#include "smooth_surface_tables.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "markdown.hpp"

namespace report {
namespace {

const std::string computed = "surface/compute/";
const std::string meshed = "surface/mesh/";
constexpr const char *parts[] = {"boundary", "surface", "measure", "gradient"};

std::string microseconds_per_atom(const Measurement &m, double seconds) {
  return three_digits(seconds / m.counter("atoms") * 1e6);
}

void write_times(std::ostream &out, const Run &run) {
  Table table({"molecule", "n", "Steps 1 + 2", "surface", "measure", "gradient", "beyond", "gradient, more", "bytes",
               "concave", "cut"});
  for (const std::string &molecule : molecules_by_size(run, computed)) {
    const Measurement *m = run.find(computed + molecule);
    if (m == nullptr) {
      table.row({molecule, run.benchmarks.at(computed + molecule).error, "-", "-", "-", "-", "-", "-", "-", "-", "-"});
      continue;
    }
    std::vector<std::string> cells{molecule, grouped(m->counter("atoms"))};
    for (const char *part : parts) {
      cells.push_back(microseconds_per_atom(*m, m->counter(std::string(part) + "_seconds")));
    }
    cells.insert(cells.end(),
                 {microseconds_per_atom(*m, seconds_beyond_boundary(*m)), fixed(per_cent_for_gradient(*m), 1) + " %",
                  fixed(m->counter("bytes") / m->counter("atoms"), 0), fixed(m->counter("concave_per_atom"), 2),
                  fixed(100 * m->counter("cut_share"), 1) + " %"});
    table.row(cells);
  }
  const auto exponent = [&run](double from, const Amount &amount) {
    const double fitted = growth_exponent(run, computed, from, amount);
    return std::isnan(fitted) ? std::string("-") : fixed(fitted, 3);
  };
  for (const double from : {0.0, large_set}) {
    std::vector<std::string> cells{"fitted exponent of n", from > 0 ? "from " + grouped(from) : "all"};
    for (const char *part : parts) cells.push_back(exponent(from, counter_of(std::string(part) + "_seconds")));
    cells.insert(cells.end(),
                 {exponent(from, seconds_beyond_boundary), "", exponent(from, counter_of("bytes")), "", ""});
    table.row(cells);
  }
  table.write(out);
}

void write_meshes(std::ostream &out, const Run &run) {
  Table table({"molecule", "n", "triangles", "microseconds per atom", "triangles/s", "bytes per triangle"});
  for (const std::string &molecule : molecules_by_size(run, meshed)) {
    const Measurement *m = run.find(meshed + molecule);
    if (m == nullptr) {
      table.row({molecule, run.benchmarks.at(meshed + molecule).error, "-", "-", "-", "-"});
      continue;
    }
    const double triangles = m->counter("triangles");
    table.row({molecule, grouped(m->counter("atoms")), grouped(triangles), three_digits(m->per_atom() * 1e6),
               three_digits(triangles / m->median()), fixed(m->counter("bytes") / triangles, 0)});
  }
  table.write(out);
}

}  // namespace

double seconds_beyond_boundary(const Measurement &m) {
  return m.counter("surface_seconds") + m.counter("measure_seconds");
}

double per_cent_for_gradient(const Measurement &m) {
  return 100 * ((m.counter("surface_seconds") + m.counter("gradient_seconds")) / seconds_beyond_boundary(m) - 1);
}

void write_smooth_surface(std::ostream &out, const Run &run) {
  out << R"(## The smooth surface

The solvent-excluded surface for a probe of 1.4. surface: hsp_surface_compute; measure: hsp_surface_measure with areas
and volume of every ball; gradient: hsp_surface_gradient of the sum of area and volume, by every centre and radius. All
are timed by turns with hsp_boundary_compute (Steps 1 + 2) of the solvent-accessible balls in one process; microseconds
per atom. beyond: surface and measure together; gradient, more: by how much that grows with gradient in place of
measure; bytes: per atom, of the surface at the limits that the set needs; concave patches per atom, and the share of
them that others cut.

)";
  write_times(out, run);
  out << R"(### Triangles of the solvent-accessible surface

hsp_mesh_compute with edges of 0.5 Angstrom, in memory of the limits that hsp_mesh_limits_init gives.

)";
  write_meshes(out, run);
}

}  // namespace report
