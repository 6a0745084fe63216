#include "frame_tables.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"

namespace report {
namespace {

// The paper's seconds: Steps 1 and 2 of Section 4.2, and a frame by z-buffer and by the new method on two machines.
struct PaperRow {
  const char *name;
  const char *benchmark;
  double boundary;
  double entry_z_buffer, entry_new;
  double xs24_z_buffer, xs24_new;
};

constexpr PaperRow paper[] = {
    {"caffeine", "caffeine", 0.09, 0.40, 0.12, 0.08, 0.06},
    {"acetyl", "acetyl", 0.35, 0.90, 0.40, 0.25, 0.25},
    {"crambin", "crambin", 1.72, 3.4, 1.4, 0.85, 1.1},
    {"felix (our model)", "felix_model", 2.70, 6.3, 2.7, 1.6, 1.7},
    {"SOD (our stand-in)", "sod_stand_in", 24.40, 24.5, 14.5, 8.2, 9.0},
};

const std::string table_prefix = "section_5_1/";
const std::string sizes_prefix = "frames/";

// The ways to a frame that are timed, as their counters are called.
constexpr const char *ways[] = {"h", "g", "g_alone"};
constexpr const char *headings[] = {"H", "G", "G alone"};

std::string milliseconds(const Measurement &m, const std::string &part) {
  return three_digits(m.counter(part + "_seconds") * 1e3);
}

// A frame over the analytic z-buffer, by which it is timed in turns.
double over_analytic(const Measurement &m, const std::string &way) {
  return m.counter(way + "_ratio");
}

// A frame over the z-buffer of triangles.
double over_triangles(const Measurement &m, const std::string &way) {
  return m.counter(way + "_ratio") / m.counter("triangle_ratio");
}

void write_seconds(std::ostream &out, const Run &run) {
  Table table({"molecule", "n", "boundary", "entry: Z-buf", "new", "XS-24: Z-buf", "new", "H, ms", "G, ms",
               "G alone, ms", "picture, ms", "analytic, ms", "triangles, ms"});
  for (const PaperRow &row : paper) {
    const Measurement *m = run.find(table_prefix + row.benchmark);
    std::vector<std::string> cells{row.name,
                                   m != nullptr ? grouped(m->counter("atoms")) : "-",
                                   fixed(row.boundary, 2),
                                   fixed(row.entry_z_buffer, 2),
                                   fixed(row.entry_new, 2),
                                   fixed(row.xs24_z_buffer, 2),
                                   fixed(row.xs24_new, 2)};
    for (const char *part : {"h", "g", "g_alone", "picture", "analytic", "triangle"}) {
      cells.push_back(m != nullptr ? milliseconds(*m, part) : "-");
    }
    table.row(cells);
  }
  table.write(out);
}

void write_ratios(std::ostream &out, const Run &run) {
  Table table({"molecule", "paper: new / Z-buf", "H / triangles", "G / triangles", "G + picture / triangles",
               "H / analytic", "G / analytic", "pieces, H", "arcs, H", "pieces, G", "arcs, G", "SVG bytes"});
  for (const PaperRow &row : paper) {
    const Measurement *m = run.find(table_prefix + row.benchmark);
    std::vector<std::string> cells{row.name, fixed(row.entry_new / row.entry_z_buffer, 3)};
    if (m == nullptr) {
      cells.insert(cells.end(), 10, "-");
    } else {
      cells.push_back(fixed(over_triangles(*m, "h"), 3));
      cells.push_back(fixed(over_triangles(*m, "g"), 3));
      cells.push_back(fixed(over_triangles(*m, "g") + over_triangles(*m, "picture"), 3));
      cells.push_back(fixed(over_analytic(*m, "h"), 3));
      cells.push_back(fixed(over_analytic(*m, "g"), 3));
      for (const char *counter : {"h_pieces", "h_arcs", "g_pieces", "g_arcs", "picture_bytes"}) {
        cells.push_back(grouped(m->counter(counter)));
      }
    }
    table.row(cells);
  }
  table.write(out);
}

void write_sizes(std::ostream &out, const Run &run) {
  Table table({"molecule", "n", "analytic, ms", "H, ms", "G, ms", "G alone, ms", "H / analytic", "G / analytic",
               "G alone / analytic", "pieces, G", "arcs, G", "SVG bytes"});
  for (const std::string &molecule : molecules_by_size(run, sizes_prefix)) {
    const Measurement *m = run.find(sizes_prefix + molecule);
    if (m == nullptr) {
      std::vector<std::string> cells{molecule, run.benchmarks.at(sizes_prefix + molecule).error};
      cells.insert(cells.end(), 10, "-");
      table.row(cells);
      continue;
    }
    std::vector<std::string> cells{molecule, grouped(m->counter("atoms")), milliseconds(*m, "analytic")};
    for (const char *way : ways) cells.push_back(milliseconds(*m, way));
    for (const char *way : ways) cells.push_back(fixed(over_analytic(*m, way), 3));
    for (const char *counter : {"g_pieces", "g_arcs", "picture_bytes"}) cells.push_back(grouped(m->counter(counter)));
    table.row(cells);
  }
  for (const double from : {0.0, large_set}) {
    std::vector<std::string> cells{"fitted exponent of n", from > 0 ? "from " + grouped(from) : "all"};
    for (const char *part : {"analytic", "h", "g", "g_alone"}) {
      const double fitted = growth_exponent(run, sizes_prefix, from, counter_of(std::string(part) + "_seconds"));
      cells.push_back(std::isnan(fitted) ? "-" : fixed(fitted, 3));
    }
    cells.insert(cells.end(), 6, "");
    table.row(cells);
  }
  table.write(out);
}

// What a frame may cost at most, over all sets of one suite.
struct FrameGoal {
  const char *what;
  const std::string &prefix;
  double (*ratio)(const Measurement &, const std::string &way);
  double goal;
};

void write_goals_of_frames(std::ostream &out, const Run &run) {
  const FrameGoal goals[] = {
      {"frame / z-buffer of triangles, the five molecules", table_prefix, over_triangles, 1},
      {"frame / analytic z-buffer, the five molecules", table_prefix, over_analytic, 3},
      {"frame / analytic z-buffer, every size", sizes_prefix, over_analytic, 3},
  };
  out << "Goals: the largest ratio of all sets.\n\n";
  Table table({"what", "goal, at most", headings[0], headings[1], headings[2], "verdict"});
  for (const FrameGoal &goal : goals) {
    std::vector<std::string> cells{goal.what, fixed(goal.goal, 2)};
    bool known = true;
    bool kept = true;
    for (const char *way : ways) {
      const double value =
          largest_amount(run, goal.prefix, 0, [&](const Measurement &m) { return goal.ratio(m, way); });
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

void write_frames(std::ostream &out, const Run &run) {
  out << R"(## Section 5.1: frames

The paper's seconds first: boundary is Steps 1 and 2, its preprocessing; then a frame by a z-buffer of about 100
triangles a ball and by its new method, on two machines, the second of which has its z-buffer in hardware. The paper's
frames contain the drawing. Ours: hsp_view_compute for a new direction in every frame, with the boundary computed
before; H and G are the pieces, G alone comes from the model without the boundary. picture: hsp_picture_write of the
flat SVG of the G-pieces into a sink that counts. The z-buffers are this project's own, of 1000 x 1000 pixels, turning
and scaling of the centres included: analytic has the depth of each ball in each pixel, without triangles and
without light, four pixels at a time; triangles has 100 a ball, those that face away left out, with Gouraud's shading.
All are timed by turns in one process for the same 16 directions (4 for the two largest sets); medians over the turns,
ratios within a turn.

)";
  write_seconds(out, run);
  out << "Ratios, and means over the directions of what is drawn. G + picture / triangles counts the writing of the "
         "file.\n\n";
  write_ratios(out, run);
  out << "### Frames over size\n\nVan der Waals balls.\n\n";
  write_sizes(out, run);
  write_goals_of_frames(out, run);
}

}  // namespace report
