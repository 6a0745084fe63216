#include "core/elementary.hpp"
#include "surface/arc_places.hpp"

namespace hsp {
namespace {

// The angle whose sine and cosine are these two, divided by the same positive number. False if it may be a whole turn
// off.
constexpr double least_error = 0x1p-36;
bool has_angle(const BoundedDouble &sine, const BoundedDouble &cosine, double &angle) {
  const double s = std::fabs(sine.value), c = std::fabs(cosine.value), larger = s > c ? s : c;
  if (sine.sign() == 0 || !(sine.error <= least_error * larger) || !(cosine.error <= least_error * larger))
    return false;
  angle = arc_tangent(sine.value, cosine.value);
  return true;
}
bool has_angle(const WideFloat &sine, const WideFloat &cosine, double &angle) {
  int32_t exponent_of_sine = 0, exponent_of_cosine = 0;
  const double s = sine.leading(exponent_of_sine), c = cosine.leading(exponent_of_cosine);
  const int32_t larger = exponent_of_sine > exponent_of_cosine ? exponent_of_sine : exponent_of_cosine;
  if (sine.sign() == 0 || sine.error_exponent() > larger - 50 || cosine.error_exponent() > larger - 50) return false;
  // Below the range of doubles the sign alone matters.
  const auto scaled = [larger](double mantissa, int32_t exponent) {
    if (exponent - larger < -1000) return mantissa * std::numeric_limits<double>::min();
    return mantissa * std::bit_cast<double>(static_cast<uint64_t>(exponent - larger + 1023) << 52);
  };
  angle = arc_tangent(scaled(s, exponent_of_sine), scaled(c, exponent_of_cosine));
  return true;
}
bool has_length(const BoundedDouble &a) {
  return a.value > 0.0 && a.error <= least_error * a.value;
}
bool has_length(const WideFloat &a) {
  int32_t exponent = 0;
  return a.leading(exponent) > 0.0 && a.error_exponent() <= exponent - 50;
}

template <class Number>
[[gnu::noinline]] bool measure_exterior(const ActualPoints<Number> &actual, uint32_t vertex, const BorderArc &arc,
                                        const BorderArc &next, double &angle) {
  NumberVector<Number> at, before, after;
  actual.find_arm(vertex, arc.to, at);
  find_axis(actual, vertex, arc.across, before);
  find_axis(actual, vertex, next.across, after);
  before = cross(before, at);
  after = cross(after, at);
  const Number sine = -determinant(at, before, after);
  return has_angle(sine, actual.probe() * dot(before, after), angle);
}

template <class Number>
[[gnu::noinline]] bool measure_arc(const ActualPoints<Number> &actual, uint32_t vertex, const BorderArc &arc,
                                   ArcFigures &figures) {
  ArcPlace<Number> place;
  find_place(actual, vertex, arc, place);
  Number length = dot(place.axis, place.axis);
  if (!has_length(length)) return false;
  length = square_root(length);
  figures.height = BoundedDouble(dot(place.axis, place.middle) / (length * actual.probe())).value;
  figures.angle = 2 * pi;
  figures.chord = {0.0, 0.0, 0.0};
  if (!arc.is_whole()) {
    const Number sine = determinant(place.axis, place.start, place.end);
    if (!has_angle(sine, dot(place.start, place.end) * length, figures.angle)) return false;
    if (figures.angle < 0.0) figures.angle += 2 * pi;
    place.end -= place.start;
    place.end *= actual.number(1) / actual.probe();
    figures.chord = to_double(place.end);
  }
  place.axis *= actual.number(1) / length;
  figures.axis = to_double(place.axis);
  return true;
}

}  // namespace

bool PatchLoops::measure(uint32_t k, ArcFigures &figures) const {
  const BorderArc &arc = arcs_[k];
  figures.exterior = 0.0;
  return actual_.measure_at(vertex_, [&](const auto &actual) {
    return measure_arc(actual, vertex_, arc, figures) &&
                   (arc.is_whole() || measure_exterior(actual, vertex_, arc, arcs_[arc.next], figures.exterior))
               ? 1
               : 0;
  }) != 0;
}

}  // namespace hsp
