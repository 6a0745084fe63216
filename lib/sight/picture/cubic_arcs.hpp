// Arcs of circles and ellipses as Bezier cubics. Ends and handles are integers in units of a file's last decimal.
//
// With handles of 4/3 tan(d / 4) a cubic leaves an arc of the angle d by at most 2/27 sin^6(d / 4) / cos^2(d / 4) of
// the semi-axis; up to a quarter of a turn that is below 2/27 (d / 4)^6 times 1.01. Arcs are cut into parts for which
// this is at most one unit, and which are no longer than a quarter of a turn.
//
// An arc of a circle is cut at the joints of the whole circle, and the points there are rounded relative to the centre.
// So all parts of circles of one size are the same, but for the first and the last part of an arc: compression finds
// them again.
#pragma once

#include "core/elementary.hpp"
#include "picture/number_text.hpp"
#include "picture/page.hpp"

namespace hsp {

struct UnitPoint {
  int64_t x, y;
};
inline UnitPoint in_units(const PagePoint &point, int decimals) {
  return {scaled(point.x, decimals), scaled(point.y, decimals)};
}

// The least number of parts of a whole turn, at least 4, that cubics follow within a unit. semi_axis: in units.
inline uint32_t parts_of_turn(double semi_axis) {
  constexpr double quarter = pi / 8, sixth_power = quarter * quarter * quarter * quarter * quarter * quarter;
  constexpr double at_four = 1.01 * 2 / 27 * sixth_power * 4096;
  uint32_t parts = 4;
  for (; parts < 64; ++parts) {
    const double cube = static_cast<double>(parts) * parts * parts;
    if (semi_axis * at_four <= cube * cube) break;
  }
  return parts;
}

class CubicArc {
 public:
  CubicArc(const PageArc &arc, int decimals)
      : arc_(arc), decimals_(decimals), step_(2 * pi / parts_of_turn(arc.semi_axis[0] * power_of_ten[decimals])) {}

  // Calls visit(handle, handle, end) for each cubic.
  template <class Visit>
  void visit(Visit visit) const {
    Joint from{arc_.from, false};
    const auto cut = [&](double at) {
      const Joint here{at, true};
      put(from, here, visit);
      from = here;
    };
    if (arc_.circle && arc_.span() > step_) {
      const bool forward = arc_.to > arc_.from;
      const int most = static_cast<int>(4 * pi / step_) + 1;  // parameters are within two turns
      for (int k = -most; k <= most; ++k) {
        const double at = step_ * (forward ? k : -k);
        if (is_inside(at)) cut(at);
      }
    } else {
      const uint32_t parts = parts_of(arc_.span(), step_);
      for (uint32_t k = 1; k < parts; ++k) cut(arc_.from + (arc_.to - arc_.from) * k / parts);
    }
    put(from, {arc_.to, false}, visit);
  }

 private:
  static constexpr double least_part = 1e-9;

  // A parameter at which parts meet, or one of the ends.
  struct Joint {
    double at;
    bool inner;
  };
  bool is_inside(double at) const {
    const double low = arc_.to > arc_.from ? arc_.from : arc_.to, high = low + arc_.span();
    return at > low + least_part && at < high - least_part;
  }
  template <class Visit>
  void put(const Joint &from, const Joint &to, Visit &visit) const {
    const SinCos quarter = sin_cos((to.at - from.at) / 4);
    const double handle = 4.0 / 3.0 * quarter.sine / quarter.cosine;
    visit(point(from, arc_.start, handle), point(to, arc_.end, -handle), point(to, arc_.end, 0.0));
  }
  // The point of a joint, moved along the tangent by a handle. end: the point of a joint that is not an inner one.
  UnitPoint point(const Joint &joint, const PagePoint &end, double handle) const {
    const SinCos d = sin_cos(joint.at);
    const double along[2] = {d.cosine - handle * d.sine, d.sine + handle * d.cosine};
    const PagePoint moved{handle * (d.cosine * arc_.minor.x - d.sine * arc_.major.x),
                          handle * (d.cosine * arc_.minor.y - d.sine * arc_.major.y)};
    if (!joint.inner) return in_units({end.x + moved.x, end.y + moved.y}, decimals_);
    const UnitPoint centre = in_units(arc_.centre, decimals_);
    const UnitPoint from_centre =
        in_units({along[0] * arc_.major.x + along[1] * arc_.minor.x, along[0] * arc_.major.y + along[1] * arc_.minor.y},
                 decimals_);
    return {centre.x + from_centre.x, centre.y + from_centre.y};
  }

  const PageArc &arc_;
  int decimals_;
  double step_;
};

}  // namespace hsp
