#include "smooth_surface_tables.hpp"

#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "markdown.hpp"

namespace report {
namespace {

const std::string computed = "surface/compute/";
const std::string meshed = "surface/mesh/";
const std::string measured = "surface/accuracy/";
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

// Areas and volumes for a probe of 1.4, by the program in doubles that wrote the values that tests hold the library
// against (tests/differential/measure/reference_rows_test.cpp), to all the digits that it knows.
struct KnownSurface {
  const char *molecule;
  double area, volume;
};
constexpr KnownSurface known_surfaces[] = {{"1CRN", 2319.064883323, 4664.897270837},
                                           {"4HHB", 27504.00120672, 66429.91120292}};

// What other programs print for the same balls, with all their digits. The order is that of the known surfaces.
struct PrintedSurfaces {
  const char *program;
  double area[2], volume[2];
};
constexpr PrintedSurfaces printed_surfaces[] = {
    {"MSROLL 3.9.3", {2319.065, 27539.2}, {4664.897, 66425.3}},
    {"BALL 1.5", {2319.02, 27513.5}, {4664.37, 66271.6}},
    {"NanoShaper, 2 per Angstrom", {2302.6, 27255.6}, {4664.75, 66431.7}},
    {"NanoShaper, 5 per Angstrom", {2316.0, 27440.3}, {4665.12, 66430.2}},
};

void write_errors(std::ostream &out, const Run &run) {
  std::vector<std::string> heads{"program"};
  for (const KnownSurface &known : known_surfaces) {
    heads.push_back(std::string(known.molecule) + ": area");
    heads.emplace_back("volume");
  }
  Table table(heads);
  const auto error = [](double value, double right) { return scientific(std::fabs(value / right - 1)); };
  std::vector<std::string> own{"hardsphere"};
  for (const KnownSurface &known : known_surfaces) {
    const Measurement *m = run.find(measured + known.molecule);
    own.push_back(m == nullptr ? "-" : error(m->counter("area"), known.area));
    own.push_back(m == nullptr ? "-" : error(m->counter("volume"), known.volume));
  }
  table.row(own);
  for (const PrintedSurfaces &printed : printed_surfaces) {
    std::vector<std::string> cells{printed.program};
    for (size_t k = 0; k < std::size(known_surfaces); ++k) {
      cells.push_back(error(printed.area[k], known_surfaces[k].area));
      cells.push_back(error(printed.volume[k], known_surfaces[k].volume));
    }
    table.row(cells);
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
  out << R"(### Errors of area and volume

Relative errors for a probe of 1.4, radii of Bondi, the atoms of the proteins alone: of crambin (PDB 1CRN, 327 atoms)
and of haemoglobin (4HHB, 4,384 atoms; other probes cut 1,162 of its 6,440 concave patches; a dash by the library where
the file is not there). The library's are of this run. The other programs were run once, on the same balls, and print
fewer digits: MSROLL (Connolly's molecular surface package) and BALL (its analytical surface, in floats) compute the
surface analytically, NanoShaper triangulates it over a grid of so many points per Angstrom. What is held against is an
independent program in doubles, whose areas and volumes agree with lines through the definition as far as these are
known: 1CRN 2319.062 +- 0.005 and 4664.8985 +- 0.0021, 4HHB 27503.93 +- 0.13 and 66429.88 +- 0.05.

)";
  write_errors(out, run);
  out << R"(### Triangles of the solvent-accessible surface

hsp_mesh_compute with edges of 0.5 Angstrom, in memory of the limits that hsp_mesh_limits_init gives.

)";
  write_meshes(out, run);
}

}  // namespace report
