#include "tangents/tangent_point.hpp"

#include <initializer_list>

#include "tangents/tangent_rows.hpp"

namespace hsp {
namespace {

// The side of the root of a polynomial A l^2 + 2 b l + c at which it decreases on which some l is: -1 below, +1 above,
// 0 at the root. value: the sign of the polynomial at l; falls: whether it decreases there.
int side_of_falling_root(const Long &A, int value, bool falls) {
  if (value == 0 && falls) return 0;
  return (A.sign() > 0 ? value > 0 && falls : !(value <= 0 && falls)) ? -1 : 1;
}

// The sign of constant + slope l at the root of A l^2 + 2 b l + c at which that polynomial decreases.
int sign_at_falling_root(const Long &A, const Long &b, const Long &c, const Long &constant, const Long &slope) {
  if (slope.sign() == 0) return constant.sign();
  const Long twice(2);
  const int value = (A * constant * constant - twice * (b * constant * slope) + c * slope * slope).sign();
  const bool falls = (b * slope - A * constant).sign() * slope.sign() < 0;
  return -slope.sign() * side_of_falling_root(A, value, falls);
}

// The parts of a line are computed in functions that are not inlined, so that their stack is not added up.

// The line of rows that leave z free; false if they do not.
[[gnu::noinline]] bool fill_steep(const CurveRows<Integer> &rows, const Row<Integer> &third, TangentLines::Line &line) {
  const SteepLine<Integer> steep(rows, third);
  if (steep.D.sign() == 0) return false;
  line.P = steep.P;
  line.Q = steep.Q;
  line.D = line.q = steep.D;
  line.p = Integer();
  line.A = steep.A();
  line.b = steep.b();
  line.c = steep.c();
  return true;
}

// |P|^2 - p^2.
[[gnu::noinline]] Long constant_of(const TangentLines::Line &line) {
  const Long x(line.P.x), y(line.P.y), z(line.P.z), p(line.p);
  return x * x + y * y + z * z - p * p;
}

// The line, without its c, of rows whose third v is a combination of the others: they fix z to zeta / delta.
[[gnu::noinline]] void fill_flat(const CurveRows<Integer> &rows, const Row<Integer> &third, TangentLines::Line &line) {
  const Row<Integer> &first = rows.first, &second = rows.second;
  const Triple<Integer> to_first = cross(second.v, rows.normal), to_second = cross(rows.normal, first.v);
  const Integer G = dot(rows.normal, rows.normal), g1 = dot(third.v, to_first), g2 = dot(third.v, to_second);
  const Integer delta = G * third.e - g1 * first.e - g2 * second.e, zeta = G * third.w - g1 * first.w - g2 * second.w;
  line.P = (first.w * delta - first.e * zeta) * to_first + (second.w * delta - second.e * zeta) * to_second;
  line.Q = rows.normal;
  line.D = G * delta;
  line.p = G * zeta;
  line.q = Integer();
  line.A = G;
  line.b = Long();
  line.there = line.D.sign() != 0;
}

int sign_at_root(const TangentLines::Line &line, const Long &constant, const Long &slope) {
  return sign_at_falling_root(line.A, line.b, line.c, constant, slope);
}
bool has_root(const TangentLines::Line &line) {
  if ((line.b * line.b - line.A * line.c).sign() <= 0) return false;
  return line.A.sign() != 0 || line.b.sign() < 0;
}
// The sign of the z of a point on a line less (zeta / delta + steps).
int compare_with_fixed(const TangentLines::Line &line, const Integer &zeta, const Integer &delta, int64_t steps) {
  const Integer there = zeta + Integer(steps) * delta;
  const Long D(delta);
  return sign_at_root(line, D * line.p - Long(there) * line.D, D * line.q) * line.D.sign() * delta.sign();
}

// x 2^exponent, in steps whose factors are doubles.
double scaled(double x, int exponent) {
  while (exponent != 0) {
    const int step = exponent > 62 ? 62 : exponent < -62 ? -62 : exponent;
    const auto factor = static_cast<double>(INT64_C(1) << (step < 0 ? -step : step));
    x = step < 0 ? x / factor : x * factor;
    exponent -= step;
  }
  return x;
}

// The sign by the filter if that is certain, else by integers.
template <class Make>
int sign_of_number(const Make &make) {
  const int certain = make.template operator()<Bounded>().sign();
  return certain != 0 ? certain : make.template operator()<Integer>().sign();
}

// Not inlined, for the same reason as the parts of a line.
template <class Make>
[[gnu::noinline]] void make_exactly(const Make &make, AffineForm<Integer> &form) {
  form = make.template operator()<Integer>();
}

// Sets z to a root of W on a line; false if there certainly is none.
template <class RoughLines>
bool find_z(const RoughLines &line, bool rising, Bounded &z) {
  const Bounded A = rising ? -line.A() : line.A(), b = rising ? -line.b() : line.b(), c = rising ? -line.c() : line.c();
  const Bounded discriminant = b * b - A * c;
  if (discriminant.sign() < 0) return false;
  const Bounded root = square_root(discriminant);
  z = b.value < 0.0 ? c / (root - b) : (-b - root) / A;
  return true;
}

}  // namespace

void TangentPoint::begin(const BallSet &balls, const TangentCurve &curve, uint32_t last, bool rising) {
  balls_ = &balls;
  curve_ = curve;
  last_ = last;
  rising_ = rising;
  number_ = lines_->next_point();
}

bool TangentPoint::find(const BallSet &balls, const TangentCurve &curve, uint32_t last, bool rising) {
  begin(balls, curve, last, rising);
  return is_there(estimate(RoughLine(balls, curve, last)));
}

void TangentPoint::find_both(const BallSet &balls, const TangentCurve &curve, uint32_t last, TangentPoint (&points)[2],
                             bool (&there)[2]) {
  const RoughLine line(balls, curve, last);
  for (const bool rising : {false, true}) {
    TangentPoint &point = points[rising ? 1 : 0];
    point.begin(balls, curve, last, rising);
    there[rising ? 1 : 0] = point.is_there(point.estimate(line));
  }
}

TangentPoint TangentPoint::found_by(const uint32_t *four) const {
  const RoughLine line(*balls_, {four[0], four[1], four[2]}, four[3]);
  TangentPoint best = *this;
  uint32_t found = 0;
  for (const bool rising : {false, true}) {
    TangentPoint point(*lines_);
    point.begin(*balls_, {four[0], four[1], four[2]}, four[3], rising);
    const int known = point.estimate(line);
    const Vec3 off = point.position_estimate() - position_estimate();
    if (known < 0 || longest_part(off) > position_error() + point.position_error()) continue;
    ++found;
    best = point;
  }
  return found == 1 ? best : *this;
}

TangentPoint TangentPoint::sharpened() const {
  TangentPoint point = *this;
  const CurveRows<Bounded> rows(*balls_, curve_);
  static_cast<void>(point.estimate(SteepLine<Bounded>(rows, last_row(*balls_, curve_, rows, last_))));
  return point;
}

// Whether the point exists. known: the answer of doubles, as estimate() returns it.
bool TangentPoint::is_there(int known) {
  if (known != 0) return known > 0;
  if (!is_steep_ && is_of_equal_balls_in_plane()) return false;
  const Line &line = exact_line();
  return line.there && has_root(line) && sign_at_root(line, line.p, line.q) * line.D.sign() > 0;
}

// Both stages of doubles: 1 if there is certainly a point, -1 if certainly none, 0 if nothing is certain.
template <class RoughLines>
int TangentPoint::estimate(const RoughLines &line) {
  z_ = {0.0, std::numeric_limits<double>::infinity()};
  y_ = {z_, z_, z_};
  is_steep_ = line.D.sign() != 0;
  if (!is_steep_) return 0;
  if (!find_z(line, rising_, z_)) return -1;
  if (z_.sign() <= 0) return z_.sign();
  y_ = line.position_at(z_);
  return 1;
}

// Whether the point is of four equal balls with their centres in one plane. They tie on a whole line or nowhere: there
// is no such point.
bool TangentPoint::is_of_equal_balls_in_plane() const {
  const BallSet &balls = *balls_;
  const auto is_equal = [&](uint32_t ball) { return balls.r[ball] == balls.r[curve_.base]; };
  return last_ != no_id && !curve_.in_plane && is_equal(curve_.second) && is_equal(curve_.third) && is_equal(last_) &&
         are_coplanar(balls, curve_.base, curve_.second, curve_.third, last_);
}

const TangentPoint::Line &TangentPoint::exact_line() const {
  Line &line = lines_->line_of(number_);
  if (line.point != number_) {
    line.point = number_;
    fill(line);
  }
  return line;
}

// Fills the line of the point. There is none if the rows leave no line that crosses the cone |y|^2 = z^2 in points.
void TangentPoint::fill(Line &line) const {
  const CurveRows<Integer> rows(*balls_, curve_);
  const Row<Integer> third = last_row(*balls_, curve_, rows, last_);
  line.there = true;
  line.flat = !fill_steep(rows, third, line);
  if (line.flat) {
    fill_flat(rows, third, line);
    line.c = constant_of(line);
  }
  if (rising_) {
    line.A = -line.A;
    line.b = -line.b;
    line.c = -line.c;
  }
}

template <class Make>
int TangentPoint::sign_of(const Make &make) const {
  const AffineForm<Bounded> rough = moved(*balls_, make.template operator()<Bounded>(), curve_.base);
  const int certain = (dot(rough.a, y_) + rough.c * z_ + rough.k).sign();
  if (certain != 0) return certain;
  lines_->count_question();
  AffineForm<Integer> form;
  make_exactly(make, form);
  const Line &line = exact_line();
  if (!line.there) return 0;
  const AffineForm<Integer> own = moved(*balls_, form, curve_.base);
  const Integer constant = dot(own.a, line.P) + own.c * line.p + own.k * line.D;
  const Integer slope = dot(own.a, line.Q) + own.c * line.q;
  return sign_at_root(line, constant, slope) * line.D.sign();
}

int TangentPoint::nearness(uint32_t ball) const {
  const uint32_t base = curve_.base;
  if (ball == base || ball == curve_.second || (!curve_.in_plane && ball == curve_.third) || ball == last_) return 0;
  return sign_of([&]<class Number>() {
    const Row<Number> row = row_of<Number>(*balls_, base, ball);
    return AffineForm<Number>{-row.v, -row.e, row.w, base};
  });
}

int TangentPoint::side_of_plane(uint32_t i, uint32_t j, uint32_t k) const {
  return sign_of([&]<class Number>() {
    return homogeneous(cross(difference<Number>(*balls_, i, j), difference<Number>(*balls_, i, k)), number<Number>(0.0),
                       i);
  });
}

int TangentPoint::side_of_edge(const TangentCurve &plane, uint32_t i, uint32_t j) const {
  return sign_of([&]<class Number>() {
    const Triple<Number> normal = CurveRows<Number>(*balls_, plane).normal;
    return homogeneous(cross(normal, difference<Number>(*balls_, i, j)), number<Number>(0.0), i);
  });
}

int TangentPoint::side_of_curve(const TangentCurve &curve) const {
  return sign_of([&]<class Number>() {
    return homogeneous(CurveRows<Number>(*balls_, curve).normal, number<Number>(0.0), curve.base);
  });
}

int TangentPoint::departure(const TangentCurve &curve, int side, uint32_t ball) const {
  // A direction (dy, dz) along the curve has v1.dy + e1 dz = v2.dy + e2 dz = 0 and y.dy = z dz, and the ball gets
  // farther by -(C.dy + e dz). Up to a factor of the sign of y.(v1 x v2) that is the determinant of (y, -z) and the
  // rows.
  const int turn = sign_of([&]<class Number>() {
    const CurveRows<Number> rows(*balls_, curve);
    const Row<Number> row = row_of<Number>(*balls_, curve.base, ball);
    const Row<Number> &first = rows.first, &second = rows.second;
    return homogeneous(first.e * cross(second.v, row.v) + second.e * cross(row.v, first.v) + row.e * rows.normal,
                       dot(rows.normal, row.v), curve.base);
  });
  if (turn != 0) return -side * turn;
  // The curve touches the surface as near to the ball: the curve is convex, so that the ball stays on its side.
  return side * side_of_centre(*balls_, curve, ball);
}

int TangentPoint::against(uint32_t axis, int64_t bound, double part) const {
  const BallSet &balls = *balls_;
  const double centre = axis == 0 ? balls.x[curve_.base] : axis == 1 ? balls.y[curve_.base] : balls.z[curve_.base];
  return sign_of([&]<class Number>() {
    const double scale = part == static_cast<double>(static_cast<int64_t>(part)) ? 1.0 : 0x1p10;
    const Number zero = number<Number>(0.0), one = number<Number>(scale);
    const Triple<Number> direction{axis == 0 ? one : zero, axis == 1 ? one : zero, axis == 2 ? one : zero};
    const Number from_bound = number<Number>(centre - static_cast<double>(bound));
    return AffineForm<Number>{
        direction, zero, number<Number>(2.0 * scale) * from_bound - number<Number>(2.0 * scale * part), curve_.base};
  });
}

int TangentPoint::compare_levels(const TangentPoint &other) const {
  const double shift = 2.0 * (balls_->r[other.curve_.base] - balls_->r[curve_.base]);
  const int certain = (z_ - other.z_ + Bounded(shift)).sign();
  if (certain != 0) return certain;
  const Line &own = exact_line(), &others = other.exact_line();
  if (!own.there || !others.there) return 0;
  // The z of this point less that of the other, whose base is different: hence `shift`.
  const auto steps = static_cast<int64_t>(shift);
  if (others.flat) return compare_with_fixed(own, others.p, others.D, -steps);
  if (own.flat) return -compare_with_fixed(others, own.p, own.D, steps);
  const Long twice(2), k(steps);
  const Long &A = others.A;
  const Long b = others.b + A * k, c = others.c + twice * (others.b * k) + A * k * k;
  const int slope = sign_at_root(own, b, A);
  int value = 0;
  if (own.A.sign() != 0) {
    value = sign_at_root(own, own.A * c - A * own.c, twice * (own.A * b - A * own.b)) * own.A.sign();
  } else {
    const Long zero = -own.c, per = twice * own.b;  // the root is zero / per
    value = (A * zero * zero + twice * (b * zero * per) + c * per * per).sign();
  }
  return side_of_falling_root(A, value, slope < 0);
}

Vec3 TangentPoint::position_estimate() const {
  const BallSet &balls = *balls_;
  const uint32_t base = curve_.base;
  return {balls.x[base] + 0.5 * y_.x.value, balls.y[base] + 0.5 * y_.y.value, balls.z[base] + 0.5 * y_.z.value};
}

double TangentPoint::position_error() const {
  const Vec3 at = position_estimate();
  const double rounding = unit_roundoff * (std::fabs(at.x) + std::fabs(at.y) + std::fabs(at.z));
  return (0.5 * (y_.x.error + y_.y.error + y_.z.error) + rounding) * (1.0 + 0x1p-50);
}

double TangentPoint::estimate_closely(Vec3 &off, double &level) {
  double tolerable = 0.0, error = 0.0;
  const auto is_good = [&] {
    off = {0.5 * y_.x.value, 0.5 * y_.y.value, 0.5 * y_.z.value};
    level = level_estimate();
    tolerable = 0x1p-42 * (std::fabs(z_.value) + std::fabs(level));
    error = level_error();
    return position_error() <= tolerable + 0x1p-20 && error <= tolerable;
  };
  if (is_good()) return error;
  *this = sharpened();
  if (is_good()) return error;
  const Line &line = exact_line();
  if (!line.there) return error;
  const auto quotient = [](const Integer &a, const Integer &b) {
    int up = 0, down = 0;
    const double above = a.leading(up), below = b.leading(down);
    return scaled(above / below, up - down);
  };
  const auto put = [&](double x, double y, double z, double distance) {
    off = {0.5 * x, 0.5 * y, 0.5 * z};
    level = 0.5 * distance - balls_->r[curve_.base];
  };
  if (line.flat) {
    // Here l^2 = -c / A, and P and Q are at right angles: nothing cancels.
    int up = 0, down = 0;
    const double above = std::fabs((-line.c).leading(up)), below = std::fabs(line.A.leading(down));
    const bool odd = ((up - down) & 1) != 0;
    const double root = std::sqrt(odd ? 2.0 * above / below : above / below);
    int of_D = 0;
    const double D = line.D.leading(of_D);
    const double height = scaled((rising_ ? root : -root) / D, (up - down - (odd ? 1 : 0)) / 2 - of_D);
    const Integer one(1);
    put(quotient(line.P.x, line.D) + height * quotient(line.Q.x, one),
        quotient(line.P.y, line.D) + height * quotient(line.Q.y, one),
        quotient(line.P.z, line.D) + height * quotient(line.Q.z, one), quotient(line.p, line.D));
    return tolerable + 0x1p-20;
  }
  // z is found by bisection: 2^bits z lies in [least, least + 2^size). Near the place where two balls touch a point
  // moves much farther than z changes: then z needs more bits.
  const double pace =
      longest_part({quotient(line.Q.x, line.D), quotient(line.Q.y, line.D), quotient(line.Q.z, line.D)});
  const int bits = pace > 32.0 ? 60 : 24;
  const Integer unit(INT64_C(1) << bits);
  Integer least;
  for (int size = 56 + bits; size-- > 0;) {
    const Integer next = least + Integer(INT64_C(1) << size / 2) * Integer(INT64_C(1) << (size + 1) / 2);
    if (sign_at_root(line, -next, unit) >= 0) least = next;
  }
  const Integer D = line.D * unit;
  put(quotient(line.P.x * unit + line.Q.x * least, D), quotient(line.P.y * unit + line.Q.y * least, D),
      quotient(line.P.z * unit + line.Q.z * least, D), quotient(least, unit));
  return tolerable + 0x1p-20;
}

// The sign of t - halves unit / 2; unit: a power of two.
int TangentPoint::level_against_half(double halves, double unit) const {
  const double scale = 2.0 / unit, bound = 2.0 * scale * balls_->r[curve_.base] + 2.0 * halves;
  return sign_of([&]<class Number>() {
    const Number zero = number<Number>(0.0);
    return AffineForm<Number>{{zero, zero, zero}, number<Number>(scale), number<Number>(-bound), curve_.base};
  });
}

// By how many units integers may correct a level: twice its error bound.
constexpr int most_units = 64;

double TangentPoint::rounded_level(double level, double error, double unit) const {
  double multiple = 0.0;
  const auto is_certain = [&](double estimate, double within) {
    multiple = static_cast<double>(nearest(estimate / unit));
    return std::fabs(estimate / unit - multiple) + within / unit < 0.499;
  };
  if (is_certain(level, error)) return multiple * unit;
  const Bounded sharper = Bounded(0.5) * sharpened().z_ - Bounded(balls_->r[curve_.base]);
  if (sharper.error < unit && is_certain(sharper.value, sharper.error)) return multiple * unit;
  static_cast<void>(is_certain(level, error));
  for (int turn = 0; turn < most_units && level_against_half(2.0 * multiple + 1.0, unit) >= 0; ++turn) multiple += 1.0;
  for (int turn = 0; turn < most_units && level_against_half(2.0 * multiple - 1.0, unit) < 0; ++turn) multiple -= 1.0;
  return multiple * unit;
}

double TangentPoint::refine_from_base(Vec3 &off, double &level) {
  const double error = estimate_closely(off, level);
  // The unit of levels: about 2^-40 of the largest radius, at least 2^-20 of a step.
  double unit = 0x1p-20;
  while (unit < 0x1p-41 * static_cast<double>(balls_->largest_radius)) unit *= 2.0;
  if (error <= 0.5 * most_units * unit && std::fabs(level) < 0x1p50 * unit) {
    level = rounded_level(level, error, unit);
  } else if (std::fabs(level) > error) {
    return error;
  }
  if (std::fabs(level) <= error + unit) {
    const int sign = level_against(0);
    if (sign == 0 || sign * level < unit) level = sign * unit;
  }
  return error + unit;
}

double TangentPoint::refine(Vec3 &position, double &level) {
  const double error = refine_from_base(position, level);
  position = Vec3{balls_->x[curve_.base], balls_->y[curve_.base], balls_->z[curve_.base]} + position;
  return error;
}

bool are_collinear(const BallSet &balls, uint32_t i, uint32_t j, uint32_t k) {
  const auto zero = [](const auto &n) { return n.x.sign() == 0 && n.y.sign() == 0 && n.z.sign() == 0; };
  const auto normal = [&]<class Number>() {
    return cross(difference<Number>(balls, i, j), difference<Number>(balls, i, k));
  };
  return zero(normal.template operator()<Bounded>()) && zero(normal.template operator()<Integer>());
}

// Integers of a fixed length, as the question comes when doubles have no answer. Differences are below 2^53.
bool are_coplanar(const BallSet &balls, uint32_t i, uint32_t j, uint32_t k, uint32_t l) {
  using Short = exact::WideInteger<exact::FastLimb, 64>;
  struct Difference {
    Short x, y, z;
  };
  const auto from_first = [&](uint32_t to) {
    const Vec3 d = balls.difference(i, to);
    const auto whole = [](double x) { return Short::from(static_cast<int64_t>(x)); };
    return Difference{whole(d.x), whole(d.y), whole(d.z)};
  };
  const Difference u = from_first(j), v = from_first(k), w = from_first(l);
  const auto part = [](const Short &a, const Short &b, const Short &c, const Short &d, const Short &along) {
    return exact::product<192>(exact::product<128>(a, b) - exact::product<128>(c, d), along);
  };
  return (part(u.y, v.z, u.z, v.y, w.x) + part(u.z, v.x, u.x, v.z, w.y) + part(u.x, v.y, u.y, v.x, w.z)).sign() == 0;
}

CurveShape::CurveShape(const BallSet &balls, const TangentCurve &curve) {
  const CurveRows<Bounded> rows(balls, curve);
  const SteepLine<Bounded> line(rows, plane_row(rows.normal));
  const Bounded square = line.D * line.D;
  const auto quotient = [](const Bounded &a, const Bounded &d, double &error) {
    const Bounded value = a / d;
    error += value.error;
    return value.value;
  };
  error_p = error_q = error_A = error_b = error_c = 0.0;
  p = {quotient(line.P.x, line.D, error_p), quotient(line.P.y, line.D, error_p), quotient(line.P.z, line.D, error_p)};
  q = {quotient(line.Q.x, line.D, error_q), quotient(line.Q.y, line.D, error_q), quotient(line.Q.z, line.D, error_q)};
  A = quotient(line.A(), square, error_A);
  b = quotient(line.b(), square, error_b);
  c = quotient(line.c(), square, error_c);
  const Vec3 n{rows.normal.x.value, rows.normal.y.value, rows.normal.z.value};
  e = (1.0 / std::sqrt(dot(n, n))) * n;
}

CurvePiece::CurvePiece(const CurveShape &curve, double lower, double upper)
    : shape(&curve), from(lower), to(upper), error(curve.error_up_to(upper)) {
  const double h0 = curve.height(from), h1 = curve.height(to);
  low = h0 < h1 ? h0 : h1;
  high = h0 < h1 ? h1 : h0;
  const double peak = curve.A > 0.0 ? -curve.b / curve.A : 0.0;
  if (peak > from && peak < to) {
    const double top = curve.height(peak);
    high = top > high ? top : high;
  }
  span = 4.0 * (std::sqrt(dot(curve.p, curve.p)) + std::sqrt(dot(curve.q, curve.q)) * to + high + to);
}

int side_of_centre(const BallSet &balls, const TangentCurve &curve, uint32_t ball) {
  return sign_of_number([&]<class Number>() {
    return dot(CurveRows<Number>(balls, curve).normal, difference<Number>(balls, curve.base, ball));
  });
}

int departure_from_lowest(const BallSet &balls, const TangentCurve &curve, int side, uint32_t ball) {
  const int off = side_of_centre(balls, curve, ball);
  if (off != 0) return -side * off;
  // The part of w - C.y - e z that grows with z, in the plane or line of the curve's centres.
  return sign_of_number([&]<class Number>() {
    const CurveRows<Number> rows(balls, curve);
    const Row<Number> row = row_of<Number>(balls, curve.base, ball);
    const SteepLine<Number> line(rows, plane_row(rows.normal));
    return -(dot(row.v, line.Q) + row.e * line.D);
  });
}

bool turn_alike(const BallSet &balls, const TangentCurve &a, const TangentCurve &b) {
  return sign_of_number([&]<class Number>() {
           return dot(CurveRows<Number>(balls, a).normal, CurveRows<Number>(balls, b).normal);
         }) > 0;
}

bool is_unbounded(const BallSet &balls, const TangentCurve &curve, const CurveShape &shape) {
  if (curve.in_plane) return true;
  if (std::fabs(shape.A) > shape.error_A) return shape.A < 0.0;
  return sign_of_number([&]<class Number>() {
           const CurveRows<Number> rows(balls, curve);
           return SteepLine<Number>(rows, plane_row(rows.normal)).A();
         }) <= 0;
}

}  // namespace hsp
