// The predicates that the other rooms call: the filter stage first, then, where it is not certain, the exact stage with
// its symbolic perturbation.
#pragma once

#include "exact/filter.hpp"
#include "exact/stage_counters.hpp"

namespace hsp::exact {

class Predicates {
 public:
  // length_squared: at least max(W, |v|^2) over all planes that will be used.
  Predicates(const Sphere &sphere, double length_squared)
      : sphere_(sphere), bounds_(FilterBounds::for_length_squared(length_squared)) {}

  const Sphere &sphere() const { return sphere_; }

  Sign crossing(const Plane &P, const Plane &Q) const {
    const int sign = filter_crossing(bounds_, sphere_, P, Q);
    return sign != 0 ? filtered(Question::crossing, sign) : counted(Question::crossing, Exact::crossing(sphere_, P, Q));
  }
  Sign side(const Plane &P, const Plane &R) const {
    const int sign = filter_side(bounds_, P, R);
    return sign != 0 ? filtered(Question::side, sign) : counted(Question::side, Exact::side(sphere_, P, R));
  }
  PointStatus point_status(const Plane &P, const Plane &Q, const Plane &R) const {
    PointStatus status;
    if (filter_point_status(bounds_, sphere_, P, Q, R, status)) {
      count_answer(Question::point_status, Stage::filter);
      return status;
    }
    status = Exact::point_status(sphere_, P, Q, R);
    count_answer(Question::point_status, status.tied[0] || status.tied[1] ? Stage::perturbation : Stage::exact);
    return status;
  }
  Sign near(const Plane &P, const Plane &Q, const Plane &R, const Plane &S) const {
    const int sign = filter_near(bounds_, P, Q, R, S);
    return sign != 0 ? filtered(Question::near, sign) : counted(Question::near, Exact::near(sphere_, P, Q, R, S));
  }
  // +1 if the point p^sign of circles P, Q lies inside R, else -1.
  int inside(const Plane &P, const Plane &Q, int sign, const Plane &R) const {
    return point_status(P, Q, R).side[sign > 0 ? 1 : 0];
  }

 private:
  static Sign filtered(Question question, int sign) {
    count_answer(question, Stage::filter);
    return {sign, false};
  }
  static Sign counted(Question question, const Sign &sign) {
    count_answer(question, sign.tied ? Stage::perturbation : Stage::exact);
    return sign;
  }

  Sphere sphere_;
  FilterBounds bounds_;
};

}  // namespace hsp::exact
