#include "picture/ink.hpp"

#include "core/elementary.hpp"
#include "core/extremes.hpp"
#include "picture/depth_shares.hpp"

namespace hsp {
namespace {

// The shares of a contour's width on the outer and the inner side of the silhouette.
constexpr double outer_share = outer_share_of_ink;
constexpr double shares_of_sides[] = {outer_share, outer_share - 1.0};

// px: by so much a contour of one level begins under the end of another one; else the background would shine through.
constexpr double overlap = 0.3;
constexpr double most_overlap = 0.01;  // an angle

// The largest skew (Knot) of a corner of a contour that is cut at a flat angle.
constexpr double most_skew = 2.0;

// Before another group a contour has its full width with a gap of so many mean radii.
constexpr double full_group = 0.5;

// In largest widths: a visible part of a silhouette between two nearer bodies that is shorter has thinner contours.
constexpr double short_length = 8.0;

// In largest widths: the length along which a contour falls off that ends in a crease; and the same if another
// silhouette crosses it there.
constexpr double taper_length = 4.0;
constexpr double crossed_taper_length = 2.0;

// px: a contour that is nowhere wider is left out.
constexpr double thinnest_ink = 0.02;

// How far a contour may be from its exact border: px; or, if that is more, a fraction of the largest width.
constexpr double most_off = 0.1;
constexpr double most_off_of_width = 0.04;

// px: a lune that is no longer than this need not follow the exact width.
constexpr double shortest_lune = 2.0;

// Points of a silhouette that are closer to each other than this angle count as one.
constexpr double least_angle = 1e-12;

// The largest angle at the ball's centre that one lune spans. At the joint of two lunes there is a corner, of an angle
// that grows with the cube of this one; here it is a degree.
constexpr double longest_lune = 0.7;

PagePoint along(const PagePoint &from, const SinCos &direction, double length) {
  return {from.x + length * direction.cosine, from.y + length * direction.sine};
}
double px_between(const PagePoint &a, const PagePoint &b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

// The curve from `start` to `end` that is at `middle` halfway.
InkCurve curve_through(const PagePoint &start, const PagePoint &middle, const PagePoint &end) {
  return {start, {2 * middle.x - (start.x + end.x) / 2, 2 * middle.y - (start.y + end.y) / 2}, end, false};
}

// The width of a contour at an angle, and `middle`, the width halfway to the next knot.
struct Knot {
  double angle, width, middle;
  double skew;  // how far the inner corner lies aside, clockwise, for one px inwards
};

// The contours of one level of one body: along the circle of a ball, or along the straight sides of another body.
class BodyInk {
 public:
  BodyInk(const PictureInput &input, const Page &page, double clear, uint32_t path, InkLevel level,
          const InkVisitor &visitor)
      : input_(input),
        page_(page),
        visitor_(visitor),
        clear_(clear),
        body_(input.paths.body_of(input.balls, path)),
        ball_(input.paths.ball_of(path)),
        level_(level),
        at_(input.paths.frame().centre_of(input.balls, ball_)),
        centre_(page.centre_of(input, path)),
        radius_(input.balls.r[ball_] * page.scale),
        unit_(radius_),
        straight_(!SeenSilhouettes::is_ball(input.balls, body_)) {
    if (!straight_) set_widths();
  }

  // Is called with all arcs, before any arc is taken.
  void measure(const SilhouetteArc &arc, bool first) {
    if (first) ++runs_;
    if (runs_ > most_runs) return;
    Run &run = run_[runs_ - 1];
    if (first) run = {0.0, 0.0, 0.0, arc.start.goes_under, false, true, fades(arc, arc.start), false, false};
    const double near = taper(false);
    if (!first && arc.start.crossed != no_id) {
      if (run.length < near) run.crossed_at_start = true;
      run.last_crossing = run.length;
    }
    if (arc.behind == no_id && run.length < near) run.fades_from_start = false;
    run.length += (arc.to - arc.from) * unit_;
    if (arc.behind == no_id) {
      run.last_background = run.length;
      run.before_bodies = false;
    }
    run.ends_under = arc.end.goes_under;
    run.fades_to_end = fades(arc, arc.end) && (run.before_bodies || run.length - run.last_background >= near);
  }

  void take(const SilhouetteArc &arc, bool first) {
    if (first) begin_run();
    if (first || level_of(arc.behind) != level_) finish();
    if (first && straight_) set_side(input_.silhouettes.side_with(body_, arc.from));
    if (level_of(arc.behind) == level_ && unit_ > 0.0 && largest_ > 0.0) put_knots(arc);
    before_ += (arc.to - arc.from) * unit_;
  }

  // Hands on the contour of the arcs taken so far, as one loop: forth along the outer side, back along the inner side.
  void finish() {
    const uint32_t knots = knots_;
    knots_ = 0;
    double widest = 0.0;
    for (uint32_t k = 0; k < knots; ++k) widest = larger_of(widest, larger_of(knot_[k].width, knot_[k].middle));
    if (knots < 2 || widest < thinnest_ink) return;
    for (uint32_t k = 0; k + 1 < knots; ++k) visitor_(side(knots, k, true), k == 0, false);
    for (uint32_t k = knots - 1; k-- > 0;) visitor_(side(knots, k, false), false, k == 0);
  }

 private:
  // Consecutive arcs, each of which goes on as the next. Runs beyond the first most_runs count as long.
  struct Run {
    double length;                          // px
    double last_crossing, last_background;  // px from the start to the last crossing silhouette, to the end of a border
    bool begins_under, ends_under, before_bodies;
    bool fades_from_start, fades_to_end, crossed_at_start;
  };
  static constexpr uint32_t most_runs = 16;
  static constexpr uint32_t most_lunes = 64, most_knots = most_lunes + 32;

  // No contour is wider than its body.
  void set_widths() {
    for (int k = 0; k < 3; ++k) width_[k] = smaller_of(page_.ink[k] * clear_, radius_);
    largest_ = larger_of(larger_of(width_[0], width_[1]), width_[2]);
  }
  void set_side(const StraightSilhouette &side) {
    side_ = side;
    const double start[2] = {side.start.x, side.start.y};
    centre_ = page_.to_page(start);
    radius_ = side.radius * page_.scale;
    unit_ = std::sqrt(side.step.x * side.step.x + side.step.y * side.step.y) * page_.scale;
    set_widths();
  }

  InkLevel level_of(uint32_t behind) const {
    if (behind == no_id) return InkLevel::border;
    const uint32_t other = input_.silhouettes.ball_of(input_.balls, behind);
    return input_.group_of(other) == input_.group_of(ball_) ? InkLevel::depth : InkLevel::group;
  }

  // The gap from the silhouette at a parameter to the body behind it, in lattice steps.
  double gap_before(uint32_t behind, double angle) const {
    const double r = input_.balls.r[ball_];
    const SinCos direction = straight_ ? SinCos{} : sin_cos(angle);
    const Vec3 at = straight_ ? combine(1.0, side_.start, angle, side_.step)
                              : Vec3{at_.x + r * direction.cosine, at_.y + r * direction.sine, at_.z};
    if (!SeenSilhouettes::is_ball(input_.balls, behind)) {
      return at.z - input_.silhouettes.front_at(behind, at.x, at.y);
    }
    const Vec3 other = input_.paths.frame().centre_of(input_.balls, behind);
    const double s = input_.balls.r[behind];
    const double x = at.x - other.x, y = at.y - other.y;
    const double squared = s * s - x * x - y * y;
    return at.z - other.z - std::sqrt(larger_of(squared, 0.0));
  }

  // The width in front of a body, or of the background.
  double width_before(uint32_t behind, double angle) const {
    if (behind == no_id) return width_[0];
    const double gap = gap_before(behind, angle) / page_.mean_radius;
    if (!(gap > 0.0)) return 0.0;
    const double depth = width_before_gap(width_[2], gap);
    return level_of(behind) == InkLevel::depth ? depth
                                               : larger_of(depth, width_[1] * smaller_of(gap / full_group, 1.0));
  }

  // Whether a contour falls off to an end of an arc, because the silhouette goes over into a crease with a ball there.
  bool fades(const SilhouetteArc &arc, const SilhouetteArc::End &end) const {
    return !straight_ && !end.goes_on && !end.goes_under && arc.behind != no_id &&
           SeenSilhouettes::is_ball(input_.balls, arc.behind);
  }

  void begin_run() {
    const uint32_t number = taken_++;
    const bool measured = !straight_ && number < most_runs && number < runs_;
    before_ = 0.0;
    share_ = 1.0;
    taper_[0] = taper_[1] = 0.0;
    if (!measured) return;
    const Run &run = run_[number];
    length_ = run.length;
    if (run.begins_under && run.ends_under && run.before_bodies) {
      share_ = smaller_of(length_ / (short_length * largest_), 1.0);
      share_ *= share_;
    }
    const bool crossed_at_end = run.last_crossing > 0.0 && length_ - run.last_crossing < taper(false);
    if (run.fades_from_start) taper_[0] = taper(run.crossed_at_start);
    if (run.fades_to_end) taper_[1] = taper(crossed_at_end);
  }
  double taper(bool crossed) const { return (crossed ? crossed_taper_length : taper_length) * largest_; }

  // The factor of the width at an angle, by what makes it thinner.
  double share_at(const SilhouetteArc &arc, double angle) const {
    double share = share_, px = before_ + (angle - arc.from) * unit_;
    for (const double taper : taper_) {
      if (px < taper) {
        const double part = px / taper;
        share *= part * (2.0 - part);
      }
      px = larger_of(length_ - px, 0.0);
    }
    return share;
  }

  // One arc: its widths by the body behind, the widths added at its ends, and the angles along which these fall off.
  struct Stretch {
    const SilhouetteArc &arc;
    double added[2];
    double near;
  };
  double width_at(const Stretch &stretch, double angle) const {
    const SilhouetteArc &arc = stretch.arc;
    const bool start_creases = angle == arc.from && !arc.start.goes_on && !arc.start.goes_under;
    const bool end_creases = angle == arc.to && !arc.end.goes_on && !arc.end.goes_under;
    const bool creases = arc.behind != no_id && (start_creases || end_creases);
    double width = creases ? 0.0 : width_before(arc.behind, angle), away = angle - arc.from;
    for (const double added : stretch.added) {
      const double part = 1.0 - away / stretch.near;
      // The slope is 0 at both ends, so that a contour does not bend there.
      if (part > 0.0) width += added * part * part * (3.0 - 2.0 * part);
      away = arc.to - angle;
    }
    return share_at(arc, angle) * width;
  }
  // The width to be added at one end to reach the width of the arc that goes on there.
  double missing(const SilhouetteArc &arc, const SilhouetteArc::End &end, double angle) const {
    if (!end.goes_on) return 0.0;
    return larger_of(width_before(end.other, angle) - width_before(arc.behind, angle), 0.0);
  }

  void put_knots(const SilhouetteArc &arc) {
    const double span = arc.to - arc.from;
    if (!(span > 0.0)) return;
    if (knots_ + most_lunes + 2 > most_knots) finish();
    const double near = smaller_of(2 * largest_ / unit_, span);
    const Stretch stretch{arc, {missing(arc, arc.start, arc.from), missing(arc, arc.end, arc.to)}, near};
    // The angles at which the added widths end.
    const double ends[2] = {stretch.added[0] > 0.0 ? arc.from + near : arc.from,
                            stretch.added[1] > 0.0 ? arc.to - near : arc.to};
    put_lunes(stretch, {smaller_of(ends[0], ends[1]), larger_of(ends[0], ends[1])});
  }

  // Puts a few lunes that follow the widths. Each is as long as it can be: halved until it is close enough.
  void put_lunes(const Stretch &stretch, const double (&corner)[2]) {
    const double to = stretch.arc.to;
    double from = stretch.arc.from;
    if (knots_ == 0 && stretch.arc.start.goes_on) {
      const double width = width_at(stretch, from);
      put_knot({from - smaller_of(overlap / unit_, most_overlap), width, width, skew(stretch.arc.start, from)});
    }
    for (uint32_t k = 0; from < to && k < most_lunes; ++k) {
      double end = to;
      while (!follow(stretch, from, end)) {
        const double before = corner[1] < end ? corner[1] : corner[0];
        end = from < before && before < end ? before : (from + end) / 2;
      }
      const bool starts = from == stretch.arc.from && knots_ == 0;
      put_knot({from, width_at(stretch, from), width_at(stretch, (from + end) / 2),
                starts ? skew(stretch.arc.start, from) : 0.0});
      from = end;
    }
    put_knot({to, width_at(stretch, to), 0.0, skew(stretch.arc.end, to)});
  }
  bool follow(const Stretch &stretch, double from, double to) const {
    const double length = to - from;
    const double off = larger_of(most_off, most_off_of_width * largest_);
    if (length * unit_ <= shortest_lune) return true;
    if (!straight_ && length > longest_lune) return false;
    const double width[3] = {width_at(stretch, from), width_at(stretch, from + length / 2), width_at(stretch, to)};
    for (const double share : shares_of_sides) {
      const InkCurve curve = curve_through(place(from, share * width[0]), place(from + length / 2, share * width[1]),
                                           place(to, share * width[2]));
      for (int eighth = 1; eighth < 8; eighth += 2) {
        const double wanted = share * width_at(stretch, from + length * eighth / 8);
        const double drawn = beyond(curve.at(eighth / 8.0));
        if (std::fabs(wanted - drawn) > off) return false;
      }
    }
    return true;
  }

  // How far the inner corner of a contour lies aside, clockwise, for one px inwards. If two silhouettes cross, a
  // contour is cut at the point at which the inner sides of both contours meet, or along the line through both
  // crossings of the circles, whichever leaves less of it. The cut is in both balls, so under the nearer one. As no
  // contour passes that line, beyond which it might be hidden, the picture is the same whichever ball is nearer. A
  // straight side has no such line: there the inner sides decide.
  double skew(const SilhouetteArc::End &end, double angle) const {
    if (end.crossed == no_id) return 0.0;
    const SinCos normal = normal_at(angle);
    const PagePoint crossing = place(angle, 0.0);
    if (!SeenSilhouettes::is_ball(input_.balls, end.crossed)) {
      const double x = (crossing.x - page_.width / 2) / page_.scale + page_.middle[0];
      const double y = (crossing.y - page_.height / 2) / page_.scale + page_.middle[1];
      const StraightSilhouette side = input_.silhouettes.side_near(end.crossed, x, y);
      return aside({side.outward[0], side.outward[1]}, normal, 1.0);
    }
    if (input_.balls.r[end.crossed] == 0.0) return 0.0;
    const Vec3 at = input_.paths.frame().centre_of(input_.balls, end.crossed);
    const double point[2] = {at.x, at.y};
    const PagePoint other = page_.to_page(point);
    const double r = input_.balls.r[end.crossed] * page_.scale;
    const PagePoint other_normal{(crossing.x - other.x) / r, (crossing.y - other.y) / r};
    const PagePoint line{centre_.y - other.y, other.x - centre_.x};
    const double meet = aside(other_normal, normal, 1.0);
    if (straight_) return meet;
    const double cut = aside(line, normal, 0.0);
    return meet > 0.0 ? smaller_of(meet, cut) : larger_of(meet, cut);
  }
  // The tangential part of a direction, for a part of 1 along the normal.
  static double aside(const PagePoint &direction, const SinCos &normal, double more) {
    const double tangential = direction.y * normal.cosine - direction.x * normal.sine;
    const double along_normal = more + direction.x * normal.cosine + direction.y * normal.sine;
    const double sign = (tangential > 0.0) == (along_normal > 0.0) ? 1.0 : -1.0;
    const double most = most_skew * std::fabs(along_normal);
    if (std::fabs(tangential) > most) return sign * most_skew;
    return most > 0.0 ? tangential / along_normal : 0.0;  // circles around one centre have no direction
  }

  // Puts a knot. If it is at the angle of the last one it takes its place.
  void put_knot(const Knot &knot) {
    if (knots_ > 0 && !(knot_[knots_ - 1].angle < knot.angle - least_angle)) --knots_;
    knot_[knots_++] = knot;
  }

  SinCos normal_at(double angle) const {
    return straight_ ? SinCos{side_.outward[0], side_.outward[1]} : sin_cos(angle);
  }
  PagePoint place(double angle, double beyond) const {
    const SinCos normal = normal_at(angle);
    if (!straight_) return along(centre_, normal, radius_ + beyond);
    const double step = angle * page_.scale;
    return along({centre_.x + step * side_.step.x, centre_.y + step * side_.step.y}, normal, beyond);
  }
  // How far a point of the page is outside the body.
  double beyond(const PagePoint &point) const {
    if (!straight_) return px_between(point, centre_) - radius_;
    return (point.x - centre_.x) * side_.outward[0] + (point.y - centre_.y) * side_.outward[1];
  }
  PagePoint corner(const Knot &knot, double share) const {
    const double beyond = share * knot.width;
    return place(beyond < 0.0 ? knot.angle + knot.skew * beyond / unit_ : knot.angle, beyond);
  }
  // The curve from a knot to the next one on the outer side, or back on the inner side.
  InkCurve side(uint32_t knots, uint32_t k, bool outer) const {
    const Knot &a = knot_[k], &b = knot_[k + 1];
    const double share = outer ? outer_share : outer_share - 1.0;
    const PagePoint start = corner(a, share), end = corner(b, share);
    const PagePoint middle = place((a.angle + b.angle) / 2, share * a.middle);
    InkCurve curve = outer ? curve_through(start, middle, end) : curve_through(end, middle, start);
    curve.behind_line = !outer && k + 2 == knots && b.width > 0.0;
    return curve;
  }

  const PictureInput &input_;
  const Page &page_;
  const InkVisitor &visitor_;
  double clear_;
  uint32_t body_, ball_;
  InkLevel level_;
  Vec3 at_;           // view coordinates
  PagePoint centre_;  // or the start of a straight side
  double radius_;     // px
  double unit_;       // px along the silhouette for a step of 1 of its parameter
  bool straight_;
  StraightSilhouette side_{};
  double width_[3] = {}, largest_ = 0.0;
  // Of the run that is being taken: its length in px and the px before the arc, the factor of all its widths, and the
  // px along which the widths fall off to its two ends, 0 if they do not.
  double length_ = 0.0, before_ = 0.0, share_ = 1.0, taper_[2] = {};
  Run run_[most_runs];
  uint32_t runs_ = 0, taken_ = 0;
  Knot knot_[most_knots];
  uint32_t knots_ = 0;
};

}  // namespace

void Ink::visit_contours(uint32_t path, InkLevel level, const InkVisitor &visitor) const {
  BodyInk ink(input_, page_, 1.0 - paint_.fog(path), path, level, visitor);
  const SilhouetteVisitor measurer{&ink, [](void *context, const SilhouetteArc &arc, bool first) {
                                     static_cast<BodyInk *>(context)->measure(arc, first);
                                   }};
  const SilhouetteVisitor taker{&ink, [](void *context, const SilhouetteArc &arc, bool first) {
                                  static_cast<BodyInk *>(context)->take(arc, first);
                                }};
  const uint32_t body = input_.paths.body_of(input_.balls, path);
  if (level != InkLevel::border) input_.silhouettes.visit(body, measurer);
  input_.silhouettes.visit(body, taker);
  ink.finish();
}

}  // namespace hsp
