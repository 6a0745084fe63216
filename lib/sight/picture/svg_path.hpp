// Path data of SVG, as short as possible: steps from point to point, the letter of a command once for several in a row,
// and nothing between numbers that a sign or a second decimal point separates.
//
// Points are rounded before steps are taken. However long a path is, each point is off by its own rounding alone, and
// loops end where they begin.
#pragma once

#include "picture/ink.hpp"
#include "picture/number_text.hpp"

namespace hsp {

// Numbers in a file never have more decimals.
constexpr int finest_svg_decimals = 10;

// The coordinates of a path, y down: their unit is `unit` px of the page.
struct SvgFrame {
  PagePoint origin;
  double unit;
};

class SvgPath {
 public:
  SvgPath(ByteSink &sink, const SvgFrame &frame, int decimals) : sink_(sink), frame_(frame), decimals_(decimals) {}

  void begin(const PagePoint &point);
  void line_to(const PagePoint &point);
  // Draws an arc from its start, where the pen is. A circle's radius has `circle_decimals`, the axes of ellipses have
  // the decimals of points.
  void follow(const PageArc &arc, int circle_decimals);
  // Draws a curve; as a line if that is the same; nothing if it is shorter than a step.
  void follow(const InkCurve &curve);
  void close();

 private:
  // In units of the last decimal.
  struct WrittenPoint {
    int64_t x, y;
  };
  WrittenPoint written(const PagePoint &point) const {
    return {scaled((point.x - frame_.origin.x) / frame_.unit, decimals_),
            scaled((frame_.origin.y - point.y) / frame_.unit, decimals_)};
  }
  void put_command(char command);
  void put_number(int64_t n, int decimals);
  void put_step_to(const WrittenPoint &to);
  void move_to(const WrittenPoint &to);

  ByteSink &sink_;
  SvgFrame frame_;
  int decimals_;
  WrittenPoint pen_{0, 0};
  char last_ = '\0';       // the last command
  bool apart_ = true;      // whether a number can follow as it is
  bool fraction_ = false;  // whether the last number has a decimal point
};

}  // namespace hsp
