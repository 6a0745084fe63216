#include "plot_data.hpp"

#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include "figure.hpp"
#include "growth.hpp"
#include "markdown.hpp"

namespace report {
namespace {

constexpr double nearly_the_same_size = 1.1;

// A value for every number of balls, or of what else is counted.
std::map<double, double> values_of(const Run &run, const Lists &lists, const std::string &prefix,
                                   const std::string &figure, const std::string &counted) {
  std::map<double, std::vector<double>> found;
  for (const std::string &molecule : molecules_by_size(run, prefix)) {
    const Measurement *m = run.find(prefix + molecule);
    const double value = m == nullptr ? 0 : amount(figure, {run, lists, prefix + molecule});
    if (!(value > 0)) continue;
    const double n = m->counter(counted);
    const bool joins = !found.empty() && n <= nearly_the_same_size * found.rbegin()->first;
    found[joins ? found.rbegin()->first : n].push_back(value);
  }
  std::map<double, double> values;
  for (const auto &[n, all] : found) {
    double total = 0;
    for (const double value : all) total += value;
    values[n] = total / static_cast<double>(all.size());
  }
  return values;
}

}  // namespace

// Titles on top and ? for what is missing, as gnuplot reads it.
void write_plot_table(const std::filesystem::path &file, const std::vector<std::string> &lines, const Run &run,
                      const Lists &lists) {
  std::ofstream out(file);
  std::vector<std::map<double, double>> columns;
  std::set<double> sizes;
  out << "n";
  for (const std::string &line : lines) {
    const std::vector<std::string> parts = split(line, " | ");
    if (parts.size() < 3 || parts.size() > 4 || !parts[1].ends_with('*')) {
      throw std::runtime_error(line + "\n  is no line of a plot");
    }
    const std::map<double, double> column = values_of(run, lists, parts[1].substr(0, parts[1].size() - 1), parts[2],
                                                      parts.size() == 4 ? parts[3] : "atoms");
    if (column.empty()) continue;
    out << " \"" << parts[0] << '"';
    for (const auto &[n, value] : column) sizes.insert(n);
    columns.push_back(column);
  }
  out << '\n';
  for (const double n : sizes) {
    out << fixed(n, 0);
    for (const auto &column : columns) {
      const auto value = column.find(n);
      out << ' ' << (value == column.end() ? "?" : fixed(value->second, 4));
    }
    out << '\n';
  }
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace report
