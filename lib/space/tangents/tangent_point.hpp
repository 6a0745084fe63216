// Points that are equally far from several balls, and questions about them, each the sign of a number decided by
// integers.
//
//        a           x has the distance t from the spheres of a, b and c. Such points of three balls are a curve, a
//         \  t       branch of a conic. The plane of the centres cuts it in one point x, a fourth ball in two points.
//          x         Is a ball d nearer to x than these three are? Is x inside their triangle, so that it is a gate?
//       t / \ t      Which of two such points has the larger t? Each answer is the sign of a form at the root of a
//        b   c       quadratic polynomial.
//
// One ball is the base, with centre c and radius r. A point x at the distance t from all balls of a set has the
// coordinates y = 2 (x - c), z = 2 (r + t). For another ball let C and e be the differences of centre and radius from
// the base, and w = |C|^2 - e^2. That ball is as near as the base if and only if
//   C.y + e z = w,       and nearer, tied or farther by the sign of  w - C.y - e z .
// These equations, the rows, are linear; the base gives |y|^2 = z^2. They hold if no ball lies inside another one,
// touching from within included. Then z > 0 makes the distances from all centres positive, too.
//
// Two such rows, or one and a plane through the base's centre, leave a curve; a third row leaves a line in (y, z):
//   y = (P + Q l) / D,  z = (p + q l) / D,   on which  |y|^2 - z^2 = 0  is  W(l) = A l^2 + 2 b l + c = 0 .
// As a rule l is z. If the rows fix z, as those of four centres in one plane do, l is the height over that plane. One
// of the two roots has W' < 0, the other W' > 0. Only a root with W' < 0 can be a maximum or a gate: these need no
// other roots, but ways up do. The sign of a form F + G l at the root with W' < 0 follows from W and W' at its zero
// -F/G, never from a square root.
//
// The filter stage computes all of this in doubles with error bounds, the exact stage in integers. Lengths are below
// 2^52, as between any points of the lattice: they give polynomials of degree 44 and below, of less than 2330 bits:
//            D       P       Q       A, b, c       forms of degree       at the root
//   4 balls  3       4       3       6, 7, 8       1 .. 5                up to 22
//   3 balls  4       5       4       8, 9, 10      1 .. 5                up to 26
//   flat     7 + 6   14      3       6, -, 28      1 .. 5                up to 42
// and the order of two roots has degree 44.
#pragma once

#include "model/ball_set.hpp"
#include "numbers/bounded_double.hpp"
#include "numbers/long_integer.hpp"

namespace hsp {

inline double longest_part(const Vec3 &v) {
  const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
  return x > y ? (x > z ? x : z) : y > z ? y : z;
}

// The curve of points that are equally far from three balls; or from two, in the plane of three centres.
struct TangentCurve {
  uint32_t base = no_id, second = no_id, third = no_id;
  bool in_plane = false;  // the third ball only gives the plane
};

template <class Number>
struct NumberTriple {
  Number x, y, z;
};

// The form a.y + c z + k, for y and z with the ball `origin` as base.
template <class Number>
struct AffineForm {
  NumberTriple<Number> a;
  Number c, k;
  uint32_t origin;
};

// Memory of the exact stage, which is too large for a stack: the lines of the two points that were used last.
class TangentLines {
 public:
  // Integer: for rows, lines and forms, of degree 18 and below. Long: for products of these at a root.
  using Integer = LongInteger<1024>;
  using Long = LongInteger<2368>;
  struct Line {
    uint64_t point = 0;  // the number of the point whose line this is
    NumberTriple<Integer> P, Q;
    Integer p, q, D;
    Long A, b, c;
    bool there = false, flat = false;
  };

  // A new number for each point, so that none is taken for another one.
  uint64_t next_point() { return ++points_; }
  // How many questions about points the exact stage has answered, for measurements.
  void count_question() { ++questions_; }
  uint64_t questions() const { return questions_; }
  // The line of a point; if it is not here, the place for it, which has another number. The line used before stays.
  Line &line_of(uint64_t point) {
    if (line_[last_].point != point) last_ ^= 1;
    return line_[last_];
  }

 private:
  Line line_[2];
  uint32_t last_ = 0;
  uint64_t points_ = 0, questions_ = 0;
};

class TangentPoint {
 public:
  using Integer = TangentLines::Integer;
  using Long = TangentLines::Long;

  TangentPoint() = default;
  explicit TangentPoint(TangentLines &lines) : lines_(&lines) {}

  // Finds a point of a curve: the one as near to a further ball `last`; or, for a curve of three balls and last =
  // no_id, the one in the plane of their centres. rising: the root with W' > 0. False if there is no such point with z
  // > 0.
  bool find(const BallSet &balls, const TangentCurve &curve, uint32_t last, bool rising);
  // Finds both such points, the one with W' > 0 second.
  static void find_both(const BallSet &balls, const TangentCurve &curve, uint32_t last, TangentPoint (&points)[2],
                        bool (&there)[2]);

  // The same point, computed in doubles from four other balls that tie there and whose centres are not in one plane. If
  // doubles do not know which of the two points of these balls it is, returns this point.
  TangentPoint found_by(const uint32_t *four) const;
  // The same point, as a rule with smaller error bounds.
  TangentPoint sharpened() const;

  // The sign of the distance of a ball less that of the point's balls: -1 nearer, 0 tied, +1 farther.
  int nearness(uint32_t ball) const;
  // The side of the plane through three centres: +1 if they are seen counter-clockwise from the point, 0 in the plane.
  int side_of_plane(uint32_t i, uint32_t j, uint32_t k) const;
  // For a point in the plane of three centres, and two centres in it: +1 if i, j and the point turn as the three do.
  int side_of_edge(const TangentCurve &plane, uint32_t i, uint32_t j) const;
  // The side of a point of a curve: of the plane of its three centres, or of the line of its two in their plane.
  int side_of_curve(const TangentCurve &curve) const;
  // The way goes up a curve from this point of it. side: the one that the point is on, not 0. Whether a tied ball gets
  // farther (+1) or nearer (-1) at once, or neither at once (0).
  int departure(const TangentCurve &curve, int side, uint32_t ball) const;
  // The sign of x - bound - part along an axis. part: below 2^40, a multiple of 2^-10 of a step.
  int against(uint32_t axis, int64_t bound, double part = 0.0) const;
  // The sign of t - bound; the sign of t less the t of another point.
  int level_against(int64_t bound) const { return level_against_half(2.0 * static_cast<double>(bound), 1.0); }
  int compare_levels(const TangentPoint &other) const;

  // Estimates of the filter stage, in steps, with their errors; an error is infinite if nothing is known.
  double level_estimate() const { return 0.5 * z_.value - balls_->r[curve_.base]; }
  double level_error() const { return 0.5 * z_.error + unit_roundoff * std::fabs(level_estimate()); }
  Vec3 position_estimate() const;
  double position_error() const;
  // Position and level with smaller errors: by sharper bounds, or by the exact stage if the filter's error is large.
  // Returns how far the level may be off. The level is rounded to a multiple of a power of two that depends on the
  // largest radius alone; integers decide if it is near the middle between two multiples. So symmetric points have the
  // same level, whatever balls they are computed from. The rounded level is 0 if and only if the level is, and has its
  // sign.
  double refine(Vec3 &position, double &level);
  // The same with the position relative to the first ball of the curve.
  double refine_from_base(Vec3 &off, double &level);

  // Whether four balls, whose centres are not in one plane, certainly define the point; and which of their two points
  // it is.
  bool is_of_four() const { return is_steep_ && last_ != no_id && !curve_.in_plane; }
  bool is_rising() const { return rising_; }

 private:
  using Line = TangentLines::Line;
  double estimate_closely(Vec3 &off, double &level);
  double rounded_level(double level, double error, double unit) const;
  int level_against_half(double halves, double unit) const;
  void begin(const BallSet &balls, const TangentCurve &curve, uint32_t last, bool rising);
  bool is_there(int known);
  template <class RoughLines>
  int estimate(const RoughLines &line);
  bool is_of_equal_balls_in_plane() const;
  template <class Make>
  int sign_of(const Make &make) const;
  const Line &exact_line() const;
  void fill(Line &line) const;

  TangentLines *lines_ = nullptr;
  const BallSet *balls_ = nullptr;
  TangentCurve curve_;
  uint32_t last_ = no_id;
  bool rising_ = false, is_steep_ = false;
  NumberTriple<BoundedDouble> y_;
  BoundedDouble z_;
  uint64_t number_ = 0;  // the number of its line
};

// Whether the centres of three balls are on one line; or, with four, in one plane.
bool are_collinear(const BallSet &balls, uint32_t i, uint32_t j, uint32_t k);
bool are_coplanar(const BallSet &balls, uint32_t i, uint32_t j, uint32_t k, uint32_t l);

// The way goes up a curve of three balls, or of two in a plane, from the point of it that is nearest to their centres.
// Whether a ball that is tied there gets farther (+1) or nearer (-1), or stays tied (0); its centre is in the plane, or
// on the line, of the centres of the curve. side: the side on which the way goes, for a ball off the plane or line.
int departure_from_lowest(const BallSet &balls, const TangentCurve &curve, int side, uint32_t ball);

// A curve in doubles, relative to its base: y = p + q z + h e, with e the normal of its plane of symmetry and h^2 = -(A
// z^2 + 2 b z + c). error_at(z, off): how far y may be off if z is off by at most `off`; infinite if nothing is known.
// error_up_to(z): the same for all smaller z; it grows with z. If h^2 is off by d, h is off by d/(h + true h), hence by
// at most d/h, and by at most sqrt(d), which is less only near h = 0.
struct CurveShape {
  Vec3 p, q, e;
  double A, b, c;
  double error_p, error_q, error_A, error_b, error_c;

  CurveShape(const BallSet &balls, const TangentCurve &curve);
  double height(double z) const {
    const double squared = -((A * z + 2.0 * b) * z + c);
    return squared > 0.0 ? std::sqrt(squared) : 0.0;
  }
  double error_at(double z, double off = 0.0) const {
    const double slope = 2.0 * std::fabs(A * z + b) + std::fabs(A) * off;
    const double h = height(z), squared = error_of_square(z) + slope * off, most = std::sqrt(squared);
    return error_with(z, h > most ? squared / h : most);
  }
  double error_up_to(double z) const { return error_with(z, std::sqrt(error_of_square(z))); }

 private:
  double error_of_square(double z) const { return (error_A * z + 2.0 * error_b) * z + error_c; }
  double error_with(double z, double error_h) const { return 1.001 * (error_p + error_q * z + error_h) + 1e-12 * z; }
};

// The piece of a curve between two z. low, high: the range of h on it.
struct CurvePiece {
  CurvePiece(const CurveShape &shape, double from, double to);
  // Whether a ball is certainly farther than those of the curve on all of the piece.
  bool is_far_from(const BallSet &balls, uint32_t base, uint32_t ball) const {
    const Vec3 C = balls.difference(base, ball);
    const double e = balls.r[ball] - balls.r[base], size = std::fabs(C.x) + std::fabs(C.y) + std::fabs(C.z);
    const double w = dot(C, C) - e * e, slope = dot(C, shape->q) + e, across = dot(C, shape->e);
    const double most = dot(C, shape->p) + slope * (slope > 0.0 ? to : from) + across * (across > 0.0 ? high : low);
    return w - most > size * error + 1e-13 * size * (size + span);
  }

  const CurveShape *shape;
  double from, to, low, high, error;
  double span;  // a bound of all lengths on the piece
};

// The sign of det(v1, v2, C), v1 and v2 the rows of a curve and C the difference of a ball's centre from its base.
int side_of_centre(const BallSet &balls, const TangentCurve &curve, uint32_t ball);

// Whether the centres of two curves turn alike; all are in one plane.
bool turn_alike(const BallSet &balls, const TangentCurve &a, const TangentCurve &b);

// Whether a curve goes on for ever; shape: its shape.
bool is_unbounded(const BallSet &balls, const TangentCurve &curve, const CurveShape &shape);

}  // namespace hsp
