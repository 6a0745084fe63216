#include "plots.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"
#include "surfaces.hpp"

namespace report {
namespace {

// One line of a plot: a value for every set that a kind of benchmark was run for.
struct Line {
  std::string title;
  std::string prefix;
  Amount value;  // not positive: none
};

constexpr double nearly_the_same_size = 1.1;

// A value for every number of balls; sets of nearly the same size are averaged.
std::map<double, double> values_of(const Run &run, const Line &line) {
  std::map<double, std::vector<double>> found;
  for (const std::string &molecule : molecules_by_size(run, line.prefix)) {
    const Measurement *m = run.find(line.prefix + molecule);
    if (m == nullptr || !(line.value(*m) > 0)) continue;
    const double n = m->counter("atoms");
    const bool joins = !found.empty() && n <= nearly_the_same_size * found.rbegin()->first;
    found[joins ? found.rbegin()->first : n].push_back(line.value(*m));
  }
  std::map<double, double> values;
  for (const auto &[n, all] : found) {
    double total = 0;
    for (const double value : all) total += value;
    values[n] = total / static_cast<double>(all.size());
  }
  return values;
}

// A column for n and one for each line, with titles on top and ? for what is missing, as gnuplot reads it.
void write_table(const std::filesystem::path &file, const Run &run, const std::vector<Line> &lines) {
  std::ofstream out(file);
  std::vector<std::map<double, double>> columns;
  std::map<double, bool> rows;
  out << "n";
  for (const Line &line : lines) {
    columns.push_back(values_of(run, line));
    if (columns.back().empty()) {
      columns.pop_back();
      continue;
    }
    out << " \"" << line.title << '"';
    for (const auto &[n, value] : columns.back()) rows[n] = true;
  }
  out << '\n';
  for (const auto &[n, there] : rows) {
    out << fixed(n, 0);
    for (const auto &column : columns) {
      const auto value = column.find(n);
      out << ' ' << (value == column.end() ? "?" : fixed(value->second, 4));
    }
    out << '\n';
  }
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

double nanoseconds(const Measurement &m, double seconds, const char *divisor) {
  return seconds / m.counter(divisor) * 1e9;
}

Amount time_per_atom() {
  return [](const Measurement &m) { return nanoseconds(m, m.median(), "atoms"); };
}

Amount part(const std::string &counter, const char *divisor = "atoms") {
  return [=](const Measurement &m) { return nanoseconds(m, m.counter(counter), divisor); };
}

std::vector<Line> stages(const std::string &surface) {
  const auto scaling = [&](const char *stage) { return "scaling/" + surface + '/' + stage + '/'; };
  return {{"everything", scaling("everything"), time_per_atom()},
          {"Steps 1 + 2", scaling("boundary"), time_per_atom()},
          {"Step 3", "topology/" + surface + "/compute/", part("topology_seconds")},
          {"areas, volumes", scaling("measure"), time_per_atom()},
          {"gradient", "gradients/" + surface + "/compute/", part("gradient_seconds")},
          {"neighbour lists", scaling("pairs"), time_per_atom()},
          {"model", scaling("build"), time_per_atom()}};
}

std::vector<Line> surface_peers(const std::string &surface) {
  const std::string prefix = "peers/surfaces/" + surface + '/';
  return {{"FreeSASA L&R 20", prefix, counter_of("freesasa_lr20_ratio")},
          {"CGAL alpha complex", prefix, counter_of("cgal_alpha_ratio")},
          {"CGAL triangulation", prefix, counter_of("cgal_regular_ratio")},
          {"FreeSASA S&R 100", prefix, counter_of("freesasa_sr100_ratio")}};
}

std::vector<Line> searches(const std::string &kind) {
  const std::string prefix = "peers/queries/" + kind + '/';
  return {{"library", prefix, part("library_seconds", "queries")},
          {"gemmi", prefix, part("gemmi_seconds", "queries")},
          {"nanoflann", prefix, part("nanoflann_seconds", "queries")}};
}

std::vector<Line> alternatives(const std::string &what, const std::function<Amount(const std::string &)> &value) {
  const std::string prefix = "alternatives/" + what + '/';
  std::vector<Line> lines;
  for (const auto &[name, title] : {std::pair{"library", "library"},
                                    {"tree", "range tree"},
                                    {"paper", "paper's grid"},
                                    {"perfect", "perfect hashing"},
                                    {"hashed", "double hashing"},
                                    {"sorted", "sorted cubes"},
                                    {"dense", "dense cubes"}}) {
    lines.push_back({title, prefix, value(name)});
  }
  return lines;
}

std::vector<Line> decompositions(const std::string &kind) {
  const std::string prefix = "section_2/" + kind + '/';
  return {{"in space", prefix, counter_of("space")},
          {"in cubes", prefix, counter_of("cubes")},
          {"free power cells", prefix, counter_of("cells")}};
}

}  // namespace

void write_plot_data(const std::filesystem::path &folder, const Run &run) {
  for (const Surface &surface : surfaces) {
    write_table(folder / (std::string("scaling_") + surface.name + ".dat"), run, stages(surface.name));
    write_table(folder / (std::string("peers_") + surface.name + ".dat"), run, surface_peers(surface.name));
  }
  for (const char *kind : {"figure_4", "decompositions"}) {
    write_table(folder / (std::string("section_2_") + kind + ".dat"), run, decompositions(kind));
  }
  for (const char *kind : {"point_atom", "ball_atom"}) {
    write_table(folder / (std::string("searches_") + kind + ".dat"), run, searches(kind));
  }
  write_table(folder / "alternatives_ball_atom.dat", run,
              alternatives("ball_atom", [](const std::string &name) { return part(name + "_seconds", "queries"); }));
  write_table(folder / "alternatives_memory.dat", run, alternatives("build", [](const std::string &name) -> Amount {
                return [=](const Measurement &m) { return m.counter(name + "_bytes") / m.counter("atoms"); };
              }));
}

void show_plot(std::ostream &out, const std::filesystem::path &run_folder, const std::string &name,
               const std::string &caption) {
  const std::string file = "plots/" + name + ".svg";
  if (std::filesystem::exists(run_folder / file)) out << "![" << caption << "](" << file << ")\n\n";
}

}  // namespace report
