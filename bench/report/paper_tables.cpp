#include "paper_tables.hpp"

#include <string>

#include "growth.hpp"
#include "markdown.hpp"

namespace report {
namespace {

// The paper's figures for one molecule: Sections 2, 3 and 4.2; times in seconds on an Indigo R3000.
struct PaperRow {
  const char *name;       // in the paper
  const char *benchmark;  // in our benchmarks
  int balls;
  double k, rho;
  int max;
  double mean;
  double build, point_queries, ball_queries;
  double step_1, step_2;
};

constexpr PaperRow paper[] = {
    {"caffeine", "caffeine", 24, 2.17, 0.71, 10, 4.5, 0.01, 0.13, 0.18, 0.01, 0.08},
    {"acetyl", "acetyl", 85, 3.11, 0.67, 16, 5.4, 0.01, 0.08, 0.12, 0.03, 0.32},
    {"crambin", "crambin", 327, 1.64, 0.78, 10, 5.5, 0.08, 0.13, 0.21, 0.17, 1.55},
    {"felix (our model)", "felix_model", 613, 1.64, 0.81, 9, 4.9, 0.08, 0.13, 0.24, 0.30, 2.40},
    {"SOD (our stand-in)", "sod_stand_in", 4392, 1.95, 0.76, 16, 5.5, 0.58, 0.14, 0.23, 2.40, 22.0},
};

std::string factor(double paper_seconds, double our_seconds) {
  return three_digits(paper_seconds / our_seconds);
}

// Three cells: the paper's seconds, ours, the factor; dashes where there is no measurement.
void append(std::vector<std::string> &cells, double paper_seconds, const Measurement *measurement) {
  cells.push_back(fixed(paper_seconds, 2));
  cells.push_back(measurement != nullptr ? scientific(measurement->median()) : "-");
  cells.push_back(measurement != nullptr ? factor(paper_seconds, measurement->median()) : "-");
}

}  // namespace

void write_section_2(std::ostream &out, const Run &run) {
  out << "## Section 2: how well molecules behave\n\nThe paper's figure, then ours with three decimals.\n\n";
  Table table({"molecule", "n", "k", "ours", "rho", "ours", "max", "ours", "aver.", "ours", "µs"});
  for (const PaperRow &row : paper) {
    const Measurement *m = run.find(std::string("section_2/figures/") + row.benchmark);
    if (m == nullptr) continue;
    table.row({row.name, grouped(m->counter("atoms")), fixed(row.k, 2), fixed(m->counter("k"), 3), fixed(row.rho, 2),
               fixed(m->counter("rho"), 3), std::to_string(row.max), fixed(m->counter("max"), 0), fixed(row.mean, 1),
               fixed(m->counter("mean"), 3), three_digits(m->median() * 1e6)});
  }
  table.write(out);
}

void write_figure_4(std::ostream &out, const Run &run) {
  out << "## Figure 4: decompositions in space and in cubes\n\n"
         "Cells of the vertical decomposition of the arrangement of all spheres (Theorem 2.3), of the same cube by "
         "cube\n"
         "(Theorem 2.4), and of what the library makes instead, parts of power cells in cubes that no ball covers\n"
         "(hsp_cells_compute), with the pairs of these that are adjacent. Figure 4 is the paper's: unit balls one "
         "below\n"
         "the other, and as many above and across. Its spheres are disjoint, and its cells in space are counted "
         "exactly;\n"
         "those of the molecules, with van der Waals radii, are counted by bisection and approximate.\n\n";
  Table table({"set", "n", "in space", "in cubes", "free power cells", "adjacent"});
  const auto add = [&](const std::string &set, const Measurement &m) {
    table.row({set, grouped(m.counter("atoms")), grouped(m.counter("space")), grouped(m.counter("cubes")),
               grouped(m.counter("cells")), grouped(m.counter("adjacencies"))});
  };
  const std::string figure = "section_2/figure_4/", molecules = "section_2/decompositions/";
  for (const std::string &n : molecules_by_size(run, figure)) {
    if (const Measurement *m = run.find(figure + n); m != nullptr) add("Figure 4", *m);
  }
  for (const std::string &molecule : molecules_by_size(run, molecules)) {
    if (const Measurement *m = run.find(molecules + molecule); m != nullptr) add(molecule, *m);
  }
  table.write(out);
  const Measurement *half = run.find(figure + "100"), *whole = run.find(figure + "200");
  if (half == nullptr || whole == nullptr) return;
  const auto ratio = [&](const char *counter) { return fixed(whole->counter(counter) / half->counter(counter), 3); };
  out << "From 100 to 200 spheres of Figure 4: " << ratio("space")
      << " times the cells in space (quadratic: above 3.7), " << ratio("cubes")
      << " times those in cubes (linear: below 2.05), " << ratio("cells") << " times the free power cells.\n\n";
}

void write_free_space(std::ostream &out, const Run &run) {
  out << "## Cells of free space, paths and the widest probe\n\n"
         "By turns with Steps 1 and 2: free space as cells (hsp_cells_compute), in which cell points lie that\n"
         "are uniform in the box (hsp_cells_locate), and, of molecules, paths between points outside near the "
         "surface,\n"
         "once the cells are built (hsp_paths_find). How often free space was cut for the widest probe from one of "
         "four of\n"
         "these points to the outside, at most, is counted for small sets; so is that out of a void, and timed.\n"
         "The goals are, where version 0.1.0 takes 1.77 µs a ball for Steps 1 and 2, or 6.32 with a probe: cells\n"
         "8 µs a ball or 15 with a probe, a point 150 ns, a path 5 ms, 40 cuts.\n\n";
  Table table({"surface", "molecule", "n", "Steps 1 + 2, µs a ball", "cells, µs a ball", "by turns", "a point, ns",
               "a path, ms", "cuts", "cuts out of a void", "ms"});
  for (const std::string surface : {"van_der_waals", "solvent_accessible"}) {
    const std::string prefix = "section_2/free_space/" + surface + '/';
    for (const std::string &molecule : molecules_by_size(run, prefix)) {
      const Measurement *m = run.find(prefix + molecule);
      if (m == nullptr) continue;
      const double n = m->counter("atoms");
      const double path = m->counter("path_each");
      const double cuts = m->counter("gate_builds"), void_cuts = m->counter("void_builds");
      table.row({surface, molecule, grouped(n), three_digits(m->counter("boundary_seconds") / n * 1e6),
                 three_digits(m->counter("cells_seconds") / n * 1e6), three_digits(m->counter("cells_ratio")),
                 three_digits(m->counter("locate_each") * 1e9), path > 0 ? three_digits(path * 1e3) : "-",
                 cuts > 0 ? fixed(cuts, 0) : "-", void_cuts > 0 ? fixed(void_cuts, 0) : "-",
                 void_cuts > 0 ? three_digits(m->counter("void_seconds") * 1e3) : "-"});
    }
  }
  table.write(out);
  for (const std::string surface : {"van_der_waals", "solvent_accessible"}) {
    const double e =
        growth_exponent(run, "section_2/free_space/" + surface + '/', large_set, counter_of("cells_seconds"));
    if (e == e) {
      out << "Time of cells from 4,000 balls, " << surface << ": n^" << fixed(e, 3) << " (goal: at most 1.05).\n\n";
    }
  }
}

void write_section_3(std::ostream &out, const Run &run) {
  out << "## Section 3: the structure and its queries\n\n"
         "Seconds: the paper's (Indigo R3000), ours, and the factor between. Queries: 1000 centres uniform in the box\n"
         "around the balls, the same 1000 in every iteration; the balls that are asked about have radius r_max.\n\n";
  Table table({"molecule", "n", "build", "ours", "factor", "1000 points", "ours", "factor", "1000 balls", "ours",
               "factor", "hits per ball"});
  for (const PaperRow &row : paper) {
    const Measurement *balls = run.find(std::string("section_3/ball_queries_1000/") + row.benchmark);
    std::vector<std::string> cells{row.name, grouped(row.balls)};
    append(cells, row.build, run.find(std::string("section_3/build/") + row.benchmark));
    append(cells, row.point_queries, run.find(std::string("section_3/point_queries_1000/") + row.benchmark));
    append(cells, row.ball_queries, balls);
    cells.push_back(balls != nullptr ? fixed(balls->counter("hits_per_query"), 2) : "-");
    table.row(cells);
  }
  table.write(out);
}

void write_section_4_2(std::ostream &out, const Run &run) {
  out << "## Section 4.2: the boundary of the union\n\n"
         "Seconds. Step 1 is hsp_query_neighbours for every ball, with the paper's Step 1 beside it. Steps 1 and 2 "
         "are\n"
         "hsp_boundary_compute, which finds the neighbours itself and also gathers faces and shells, beside the sum "
         "of the\n"
         "paper's two steps, which did not. Step 3 is hsp_topology_compute; the paper has no figures for it. The last "
         "of the\n"
         "times is that of Steps 1 and 2 with areas and volumes of every ball.\n\n";
  Table table({"molecule", "n", "Step 1", "ours", "factor", "Steps 1 + 2", "ours", "factor", "Step 3, ours",
               "with areas, volumes", "vertices", "faces"});
  for (const PaperRow &row : paper) {
    const Measurement *boundary = run.find(std::string("section_4_2/boundary/") + row.benchmark);
    const Measurement *step_3 = run.find(std::string("section_4_2/step_3/") + row.benchmark);
    const Measurement *measure = run.find(std::string("section_4_2/boundary_and_measure/") + row.benchmark);
    std::vector<std::string> cells{row.name, grouped(row.balls)};
    append(cells, row.step_1, run.find(std::string("section_4_2/step_1/") + row.benchmark));
    append(cells, row.step_1 + row.step_2, boundary);
    cells.push_back(step_3 != nullptr ? scientific(step_3->median()) : "-");
    cells.push_back(measure != nullptr ? scientific(measure->median()) : "-");
    cells.push_back(boundary != nullptr ? grouped(boundary->counter("vertices")) : "-");
    cells.push_back(boundary != nullptr ? grouped(boundary->counter("faces")) : "-");
    table.row(cells);
  }
  table.write(out);
}

}  // namespace report
