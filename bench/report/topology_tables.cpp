#include "topology_tables.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"
#include "surfaces.hpp"

namespace report {
namespace {

std::string prefix_of(const Surface &surface, const char *part) {
  return std::string("topology/") + surface.name + '/' + part + '/';
}

std::string microseconds_per_atom(const Measurement &m, const char *counter) {
  return three_digits(m.counter(counter) / m.counter("atoms") * 1e6);
}

std::string exponent(const Run &run, const std::string &prefix, double from, const Amount &amount) {
  const double fitted = growth_exponent(run, prefix, from, amount);
  return std::isnan(fitted) ? "-" : fixed(fitted, 3);
}

void write_times(std::ostream &out, const Run &run, const Surface &surface) {
  const std::string prefix = prefix_of(surface, "compute");
  Table table({"molecule", "n", "Steps 1 + 2", "Step 3", "ratio", "faces", "simple faces", "edges", "cut edges",
               "components", "voids"});
  for (const std::string &molecule : molecules_by_size(run, prefix)) {
    const Measurement *m = run.find(prefix + molecule);
    if (m == nullptr) {
      table.row({molecule, run.benchmarks.at(prefix + molecule).error, "-", "-", "-", "-", "-", "-", "-", "-", "-"});
      continue;
    }
    table.row({molecule, grouped(m->counter("atoms")), microseconds_per_atom(*m, "boundary_seconds"),
               microseconds_per_atom(*m, "topology_seconds"), fixed(m->counter("topology_ratio"), 3),
               fixed(m->counter("faces_per_atom"), 2), fixed(m->counter("simple_faces_per_atom"), 2),
               fixed(m->counter("edges_per_atom"), 2), fixed(m->counter("cut_edges_per_atom"), 2),
               grouped(m->counter("components")), grouped(m->counter("voids"))});
  }
  for (const double from : {0.0, large_set}) {
    table.row({"fitted exponent of n", from > 0 ? "from " + grouped(from) : "all",
               exponent(run, prefix, from, counter_of("boundary_seconds")),
               exponent(run, prefix, from, counter_of("topology_seconds")), "", "", "", "", "", "", ""});
  }
  table.write(out);
}

// Nanoseconds a query, and the share of one kind of answer.
std::vector<std::string> location_cells(const Measurement *m) {
  if (m == nullptr) return {"-", "-", "-"};
  return {three_digits(m->median() / m->counter("queries") * 1e9), fixed(100 * m->counter("inside_share"), 0) + " %",
          fixed(100 * m->counter("void_share"), 2) + " %"};
}

void write_memory_and_location(std::ostream &out, const Run &run, const Surface &surface) {
  const std::string prefix = prefix_of(surface, "compute");
  Table table(
      {"molecule", "n", "bytes needed", "by default", "box, ns", "in balls", "in voids", "surface, ns", "in voids"});
  for (const std::string &molecule : molecules_by_size(run, prefix)) {
    const Measurement *m = run.find(prefix + molecule);
    if (m == nullptr) continue;
    const double atoms = m->counter("atoms");
    std::vector<std::string> cells{molecule, grouped(atoms), grouped(m->counter("bytes") / atoms),
                                   grouped(m->counter("bytes_by_default") / atoms)};
    const std::vector<std::string> box = location_cells(run.find(prefix_of(surface, "locate_box") + molecule));
    const std::vector<std::string> near = location_cells(run.find(prefix_of(surface, "locate_surface") + molecule));
    cells.insert(cells.end(), {box[0], box[1], box[2], near[0], near[2]});
    table.row(cells);
  }
  for (const double from : {0.0, large_set}) {
    table.row({"fitted exponent of n", from > 0 ? "from " + grouped(from) : "all",
               exponent(run, prefix, from, counter_of("bytes")),
               exponent(run, prefix, from, counter_of("bytes_by_default")), "", "", "", "", ""});
  }
  table.write(out);
}

}  // namespace

void write_topology(std::ostream &out, const Run &run) {
  out << R"(## Section 4.2, Step 3: simple faces, shells and cells

The paper gives no figures for Step 3, so there are none to stand beside ours. Step 3 is hsp_topology_compute: extra
arcs, simple faces, quad-edges, cells and the scan of every shell. Steps 1 + 2 is hsp_boundary_compute, which contains
the gathering of loops, faces and shells as well: that cannot be timed apart from outside. Both are timed by turns in
one process; times are microseconds per atom, and ratio is the median over the turns of Step 3 over Steps 1 + 2.
Counted are maximal faces, simple faces, edges, and those edges that cut a face or a whole sphere, all per atom;
components of the union and voids as they are. The exponent over all sizes contains that small molecules have fewer
neighbours per atom, and that the branch predictor learns a small set by heart.

)";
  for (const Surface &surface : surfaces) {
    out << "### " << surface.heading << "\n\n";
    write_times(out, run, surface);
  }
  out << R"(### Memory of the topology, and which cell a point lies in

Bytes per atom at the limits that the set needs, and at the default limits. Then nanoseconds per hsp_topology_locate,
100,000 distinct points, and how many of the points lie in balls and in voids. box: uniform in the box around the balls;
surface: outside all balls, within 1 Angstrom of one. Without voids no ray is needed: a query then costs what
hsp_query_point costs.

)";
  for (const Surface &surface : surfaces) {
    out << surface.heading << ":\n\n";
    write_memory_and_location(out, run, surface);
  }
}

}  // namespace report
