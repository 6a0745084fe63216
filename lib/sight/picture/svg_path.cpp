#include "picture/svg_path.hpp"

#include "core/elementary.hpp"

namespace hsp {
namespace {

// A renderer finds an arc's centre from its ends. That is badly conditioned if the ends are nearly opposite, and if
// they are nearly the same.
constexpr double nearly_half_a_turn = 0.9 * pi;
constexpr double longest_span = 1.75 * pi;

// The fraction of its span at which an arc is cut so that no part is badly conditioned; 1 if it need not be cut.
double cut_of(double span) {
  if (span <= nearly_half_a_turn) return 1.0;
  if (span < 2 * pi - nearly_half_a_turn) return 0.5;
  return span <= longest_span ? 1.0 : 1.0 / 3;
}

int64_t magnitude(int64_t n) {
  return n < 0 ? -n : n;
}

}  // namespace

void SvgPath::begin(const PagePoint &point) {
  put_command('M');
  pen_ = {0, 0};
  move_to(written(point));
}

void SvgPath::line_to(const PagePoint &point) {
  put_command('l');
  move_to(written(point));
}

// Counter-clockwise with y up is sweep 0 with y down.
void SvgPath::follow(const PageArc &arc, int circle_decimals) {
  double rotation = 0.0;
  if (!arc.circle) {
    rotation = arc_tangent(-arc.major.y, arc.major.x) * (180.0 / pi);
    rotation += rotation > 90.0 ? -180.0 : rotation <= -90.0 ? 180.0 : 0.0;
  }
  const int axis_decimals = arc.circle ? circle_decimals : decimals_;
  // The rounded rotation shall move the ends of the major axis by no more than the rounding of points.
  const double step = 60.0 * frame_.unit / (arc.semi_axis[0] * power_of_ten[decimals_]);
  const int rotation_decimals = decimals_for(step, 0, finest_svg_decimals);
  const double cut = cut_of(arc.span());
  for (double from = 0.0, to = cut; from < 1.0; from = to, to = 1.0) {
    put_command('a');
    for (const double axis : arc.semi_axis) put_number(scaled(axis / frame_.unit, axis_decimals), axis_decimals);
    put_number(scaled(rotation, rotation_decimals), rotation_decimals);
    put_number((to - from) * arc.span() > pi ? 1 : 0, 0);
    put_number(arc.to > arc.from ? 0 : 1, 0);
    move_to(written(to < 1.0 ? arc.at(arc.from + (arc.to - arc.from) * to) : arc.end));
  }
}

void SvgPath::follow(const InkCurve &curve) {
  const WrittenPoint control = written(curve.control), end = written(curve.end);
  // The curve's middle is halfway between the line's middle and the control point.
  const bool straight =
      magnitude(2 * control.x - pen_.x - end.x) <= 4 && magnitude(2 * control.y - pen_.y - end.y) <= 4;
  if (straight && end.x == pen_.x && end.y == pen_.y) return;
  put_command(straight ? 'l' : 'q');
  if (!straight) put_step_to(control);
  move_to(end);
}

void SvgPath::close() {
  put_command('Z');
}

void SvgPath::put_command(char command) {
  if (command == last_ && command != 'M') return;
  sink_.put(command);
  last_ = command;
  apart_ = true;
}

void SvgPath::put_number(int64_t n, int decimals) {
  const auto one = static_cast<int64_t>(power_of_ten[decimals]);
  const bool point_first = 0 < n && n < one;
  if (!apart_ && n >= 0 && !(point_first && fraction_)) sink_.put(' ');
  put_scaled(sink_, n, decimals);
  apart_ = false;
  fraction_ = n % one != 0;
}

void SvgPath::put_step_to(const WrittenPoint &to) {
  put_number(to.x - pen_.x, decimals_);
  put_number(to.y - pen_.y, decimals_);
}

void SvgPath::move_to(const WrittenPoint &to) {
  put_step_to(to);
  pen_ = to;
}

}  // namespace hsp
