// Prints window_scans.svg: slope and bend of volume, area and its mean over a window of radii, over a bond length.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "moved_ball.hpp"
#include "svg_plot.hpp"

namespace {

constexpr const char *black = "#000000";
constexpr double oxygen = 1.52, hydrogen = 1.10, window = 0.1, shortest = 1.5, longest = 3.5;

// Between two places at which something breaks, and as near to them as matters.
std::vector<double> lengths_between(double from, double to) {
  constexpr double fiftieth = 0.02, little = 1e-6;
  std::vector<double> lengths;
  for (double d = from + little; d < to - little; d += fiftieth) lengths.push_back(d);
  lengths.push_back(to - little);
  return lengths;
}

struct Column {
  Quantity quantity;
  const char *title;
  PlotAxis slope, bend;
  std::vector<double> breaks;
};

std::vector<PlotPanel> panels_of(const Column &column, double left) {
  const MovedBall bond{{ball_of(0, 0, 0, oxygen), ball_of(0, 0, 0, hydrogen)}, 1, {1, 0, 0}, {1, 1}, window};
  const PlotAxis length{shortest, longest, 0.5, "bond length d, \xC3\x85"};
  PlotPanel slopes({left, 50, 240, 150}, length, column.slope), bends({left, 270, 240, 150}, length, column.bend);
  slopes.title(column.title);
  slopes.mark(oxygen + hydrogen, "touch", "");
  bends.mark(oxygen + hydrogen, "", "");
  std::vector<double> ends = {shortest};
  ends.insert(ends.end(), column.breaks.begin(), column.breaks.end());
  ends.push_back(longest);
  for (size_t piece = 0; piece + 1 < ends.size(); ++piece) {
    std::vector<PlotPoint> slope, bend;
    for (const double d : lengths_between(ends[piece], ends[piece + 1])) {
      const SlopeAndBend at = derivatives(bond, column.quantity, d);
      slope.push_back({d, at.slope});
      bend.push_back({d, at.bend});
    }
    slopes.curve(slope, black, PlotStroke::thick);
    bends.curve(bend, black, PlotStroke::thick);
  }
  return {slopes, bends};
}

std::string picture() {
  const double touch = oxygen + hydrogen;
  const std::string square = "\xC3\x85\xC2\xB2", angstrom = "\xC3\x85";
  const std::vector<Column> columns = {
      {Quantity::volume, "volume V", {0, 4, 1, "slope, " + square}, {-6, 2, 2, "bend, " + angstrom}, {touch}},
      {Quantity::area, "area S", {0, 9, 3, "slope, " + angstrom}, {-24, 8, 8, "bend"}, {touch}},
      {Quantity::mean,
       "mean W of S, radii \xC2\xB1 0.1 \xC3\x85",
       {0, 9, 3, "slope, " + angstrom},
       {-24, 8, 8, "bend"},
       {touch - 2 * window, touch + 2 * window}}};
  std::vector<PlotPanel> panels;
  for (size_t k = 0; k < columns.size(); ++k)
    for (const PlotPanel &panel : panels_of(columns[k], 60 + 315 * static_cast<double>(k))) panels.push_back(panel);
  return svg_file(960, 470, "Slope and bend of volume, area and windowed area over the bond length", panels);
}

}  // namespace

int main() {
  try {
    const std::string svg = picture();
    return std::fwrite(svg.data(), 1, svg.size(), stdout) == svg.size() && std::fflush(stdout) == 0 ? 0 : 1;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "draw_window_scans: %s\n", error.what());
    return 1;
  }
}
