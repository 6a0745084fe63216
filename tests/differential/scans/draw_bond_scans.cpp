// Prints bond_scans.svg: areas of two balls, and the derivative of their sum, over the bond length.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "hardsphere.h"
#include "pair_scan.hpp"
#include "svg_plot.hpp"

namespace {

constexpr const char *black = "#000000";
constexpr const char *first_colour = "#d55e00";  // vermilion and blue differ for all eyes
constexpr const char *second_colour = "#0072b2";

// One column: areas above, the derivative below.
struct Column {
  PairOfBalls pair;
  const char *title;
  const char *first_name;
  const char *second_name;  // empty where the two areas are the same
  PlotAxis bond_length;
  PlotAxis area;
  PlotAxis slope;
  PlotPoint legend;
};

double length_of(int64_t distance) {
  return in_angstrom(static_cast<double>(distance));
}

// Distances from one to the other, both included, a fiftieth of an angstrom apart but at the end.
std::vector<int64_t> between(int64_t first, int64_t last) {
  constexpr int64_t fiftieth = units_per_angstrom / 50;
  std::vector<int64_t> distances;
  for (int64_t d = first; d < last; d += fiftieth) distances.push_back(d);
  distances.push_back(last);
  return distances;
}

std::vector<PlotPanel> panels_of(const Column &column, double left) {
  const PairOfBalls &pair = column.pair;
  const auto end = static_cast<int64_t>(column.bond_length.last * static_cast<double>(units_per_angstrom));
  const int64_t inside = pair.touching_from_inside();
  const int64_t touching = pair.touching();

  PlotPanel areas({left, 50, 240, 190}, column.bond_length, column.area);
  areas.title(column.title);
  PlotPanel slopes({left, 310, 240, 130}, column.bond_length, column.slope);
  for (PlotPanel *panel : {&areas, &slopes}) {
    const bool is_upper = panel == &areas;
    if (inside > 0) panel->mark(length_of(inside), "", is_upper ? "touch inside" : "");
    panel->mark(length_of(touching), is_upper ? "touch" : "", "");
  }

  std::vector<PlotPoint> total;
  std::vector<PlotPoint> first;
  std::vector<PlotPoint> second;
  for (const int64_t d : between(0, end)) {
    const PairResults at = pair_at(pair, d, HSP_TANGENT_OVERLAP);
    // At length 0 equal balls have the area of one, and which of them has it is nobody's business.
    if (d > 0 || inside > 0) {
      first.push_back({length_of(d), in_square_angstrom(at.area[0])});
      second.push_back({length_of(d), in_square_angstrom(at.area[1])});
    }
    total.push_back({length_of(d), in_square_angstrom(at.area[0] + at.area[1])});
  }
  areas.curve(first, first_colour, PlotStroke::thin);
  const bool two_names = column.second_name[0] != '\0';
  if (two_names) areas.curve(second, second_colour, PlotStroke::dashed);
  areas.curve(total, black, PlotStroke::thick);
  areas.legend(column.legend, 0, "both", black, PlotStroke::thick);
  areas.legend(column.legend, 1, column.first_name, first_colour, PlotStroke::thin);
  if (two_names) areas.legend(column.legend, 2, column.second_name, second_colour, PlotStroke::dashed);

  // The pieces apart from each other: at their ends the derivative is the one-sided one of that piece.
  const auto slope_piece = [&](int64_t from, int64_t to, uint32_t tangency) {
    std::vector<PlotPoint> points;
    for (const int64_t d : between(from, to))
      points.push_back({length_of(d), in_angstrom(pair_at(pair, d, tangency).total_by_distance)});
    slopes.curve(points, black, PlotStroke::thick);
  };
  if (inside > 0) slope_piece(0, inside, HSP_TANGENT_OVERLAP);
  slope_piece(inside > 0 ? inside : shortest_change, touching, HSP_TANGENT_OVERLAP);
  slope_piece(touching, end, HSP_TANGENT_DISJOINT);
  for (const uint32_t tangency : {HSP_TANGENT_OVERLAP, HSP_TANGENT_DISJOINT})
    slopes.dot({length_of(touching), in_angstrom(pair_at(pair, touching, tangency).total_by_distance)}, black,
               tangency == HSP_TANGENT_OVERLAP);
  return {areas, slopes};
}

std::string picture() {
  const std::vector<PairOfBalls> pairs = scanned_pairs();
  const std::string length = "bond length d, \xC3\x85";
  const std::string area = "area A, \xC3\x85\xC2\xB2";
  const std::string slope = "dA/dd, \xC3\x85";
  const std::vector<Column> columns = {
      {pairs[0], "O\xE2\x80\x93O", "each O", "", {0, 4, 1, length}, {0, 70, 10, area}, {0, 12, 4, slope}, {1.4, 13}},
      {pairs[2], "O\xE2\x80\x93H", "O", "H", {0, 4, 1, length}, {0, 70, 10, area}, {0, 12, 4, slope}, {1.2, 64}},
      {pairs[3],
       "O\xE2\x80\x93H, probe 1.4 \xC3\x85",
       "O",
       "H",
       {0, 8, 2, length},
       {0, 210, 30, area},
       {0, 24, 8, slope},
       {2.0, 192}}};
  std::vector<PlotPanel> panels;
  for (size_t k = 0; k < columns.size(); ++k)
    for (const PlotPanel &panel : panels_of(columns[k], 60 + 315 * static_cast<double>(k))) panels.push_back(panel);
  return svg_file(960, 490, "Area of two balls and its derivative over the bond length", panels);
}

}  // namespace

int main() {
  try {
    const std::string svg = picture();
    return std::fwrite(svg.data(), 1, svg.size(), stdout) == svg.size() && std::fflush(stdout) == 0 ? 0 : 1;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "draw_bond_scans: %s\n", error.what());
    return 1;
  }
}
