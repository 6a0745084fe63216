// Places on the page, in px (1/96 inch) from its lower left corner, y up.
#pragma once

#include "picture/picture.hpp"

namespace hsp {

constexpr double points_per_px = 0.75;
constexpr double px_per_millimetre = 480.0 / 127.0;

// The share of a contour's width outside its ball.
constexpr double outer_share_of_ink = 0.62;

struct PagePoint {
  double x, y;
};

// The points centre + cos t major + sin t minor for t from `from` to `to`, which is less if the arc runs clockwise.
struct PageArc {
  PagePoint centre, major, minor;
  double semi_axis[2];
  double from, to;
  PagePoint start, end;
  bool circle;

  PagePoint at(double t) const;
  double span() const { return to > from ? to - from : from - to; }
};

struct Page {
  double width, height;
  double unit;               // px per unit of the options
  double scale;              // px per lattice step
  double middle[2];          // the point in the middle of the page, in view coordinates
  double line;               // width of the lines, px
  double ink[3];             // largest width of contours, px, by InkLevel
  double mean_radius;        // of all balls of the model, lattice steps
  double narrowest_ellipse;  // least semi-axis of an arc that is drawn as an ellipse, px
  double farthest, nearest;  // depths between which fog grows, lattice steps; all centres are within
  int decimals;              // the decimals of numbers: steps are at most width / 10 000
  bool possible;             // no point is so far from the middle that numbers in files cannot tell it
  bool cut;                  // whether balls lie beyond the edges

  PagePoint to_page(const double point[2]) const {
    return {(point[0] - middle[0]) * scale + width / 2, (point[1] - middle[1]) * scale + height / 2};
  }
  PageArc to_page(const ProjectedArc &arc) const;
  // Whether an arc is drawn as a line, see visit_line: many renderers break the stroke of such a flat ellipse, or lose
  // half of its width.
  bool is_line(const PageArc &arc) const { return arc.semi_axis[1] < narrowest_ellipse; }
  PagePoint centre_of(const PictureInput &input, uint32_t path) const {
    const Vec3 centre = input.paths.frame().centre_of(input.balls, input.paths.ball_of(path));
    const double point[2] = {centre.x, centre.y};
    return to_page(point);
  }
};

Page lay_out(const PictureInput &input, const PictureOptions &options);

// The number of equal parts of a span that are no longer than `most`.
inline uint32_t parts_of(double span, double most) {
  uint32_t parts = 1;
  while (span > most * parts) ++parts;
  return parts;
}

// The smallest number of decimals, at least `decimals`, whose unit is at most `step`.
inline int decimals_for(double step, int decimals, int most) {
  while (decimals < most && 1.0 > step * power_of_ten[decimals]) ++decimals;
  return decimals;
}

// Calls visit(point) for the corners of the line as which an arc of a flat ellipse is drawn: the ends of the major axis
// that the arc passes, so that the line has its full length, then the end of the arc.
template <class Visit>
void visit_line(const PageArc &arc, Visit visit) {
  const bool forward = arc.to > arc.from;
  // Parameters are within two turns.
  for (int k = -4; k <= 4; ++k) {
    const int half_turns = forward ? k : -k;
    const double t = half_turns * pi;
    if (forward ? t <= arc.from || t >= arc.to : t >= arc.from || t <= arc.to) continue;
    const double side = half_turns % 2 == 0 ? 1.0 : -1.0;
    visit(PagePoint{arc.centre.x + side * arc.major.x, arc.centre.y + side * arc.major.y});
  }
  visit(arc.end);
}

}  // namespace hsp
