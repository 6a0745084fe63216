// Plots of curves as SVG text, the same bytes on every machine.
#pragma once

#include <string>
#include <vector>

struct PlotPoint {
  double x = 0;
  double y = 0;
};

// From first to last, with a number at every multiple of step.
struct PlotAxis {
  double first = 0;
  double last = 1;
  double step = 1;
  std::string label;
};

// Where a panel's frame lies in the picture, in pixels.
struct PlotFrame {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
};

enum class PlotStroke { thick, thin, dashed };

// One pair of axes with what is drawn between them.
class PlotPanel {
 public:
  PlotPanel(PlotFrame frame, PlotAxis x, PlotAxis y);

  void title(const std::string &text);
  // A vertical line over the whole panel, with words on its left at the bottom or on its right at the top.
  void mark(double x, const std::string &at_bottom, const std::string &at_top);
  void curve(const std::vector<PlotPoint> &points, const std::string &colour, PlotStroke stroke);
  // A value that belongs to the curve, or one that does not (an open dot).
  void dot(PlotPoint point, const std::string &colour, bool filled);
  // The meaning of a stroke; rows count from the top, from a position in the panel's own numbers on.
  void legend(PlotPoint place, int row, const std::string &text, const std::string &colour, PlotStroke stroke);

  [[nodiscard]] const std::string &svg() const { return svg_; }

 private:
  [[nodiscard]] std::string pixel_x(double x) const;
  [[nodiscard]] std::string pixel_y(double y) const;
  void draw_axes();

  PlotFrame frame_;
  PlotAxis x_;
  PlotAxis y_;
  std::string svg_;
};

// The panels as one SVG file.
std::string svg_file(double width, double height, const std::string &description, const std::vector<PlotPanel> &panels);
