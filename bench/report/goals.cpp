#include "goals.hpp"

#include <cmath>
#include <stdexcept>

#include "figure.hpp"
#include "markdown.hpp"

namespace report {
namespace {

double number(const std::string &text) {
  return text == "-" ? std::nan("") : std::stod(text);
}

std::string shown(double value) {
  return std::isnan(value) ? "-" : three_digits(value);
}

}  // namespace

void write_goals(std::ostream &out, const std::vector<std::string> &goals, const Run &run, const Turns *turns,
                 const Lists &lists) {
  Table table({"what", "0.1.0 there", "0.1.0 here", "now", "must", "goal", "verdict"});
  for (const std::string &goal : goals) {
    const std::vector<std::string> cells = split(goal, " | ");
    if (cells.size() < 6) throw std::runtime_error("'" + goal + "' is no goal");
    const std::string &kind = cells[1], &figure = cells[5];
    const bool is_new = kind == "new_time", is_share = kind == "share", scales = is_new || kind == "time";
    const double there = number(cells[2]);
    const double here = turns != nullptr ? amount(cells.back(), {turns->old, lists}) : std::nan("");
    double now = amount(figure, {scales && turns != nullptr ? turns->now : run, lists});
    if (is_share) now /= here;
    const double scale = scales && !std::isnan(here) ? here / there : 1;
    const double must = number(cells[3]) * scale, best = number(cells[4]) * scale;
    const auto kept = [&](double limit) { return kind == "at_least" ? now >= limit : now <= limit; };
    table.row({cells[0], is_new ? "-" : shown(there), is_new || is_share ? "-" : shown(here), shown(now), shown(must),
               shown(best),
               std::isnan(now)              ? "not measured"
               : scales && std::isnan(here) ? "-"
               : kept(best)                 ? "goal"
               : kept(must)                 ? "must"
                                            : "**missed**"});
  }
  table.write(out);
}

}  // namespace report
