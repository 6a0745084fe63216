#include "face_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

#include "face_quadrature.hpp"
#include "library_derivatives.hpp"

namespace {

using oracle::Balls;
using oracle::FaceMeasures;
using Real = long double;
using Vector = std::array<Real, 3>;

Vector real_centre_of(const oracle::LatticeBall &ball) {
  return {static_cast<Real>(ball.x), static_cast<Real>(ball.y), static_cast<Real>(ball.z)};
}

// The term of the divergence theorem, (r area + (c - origin) . N) / 3.
Real volume_term(const oracle::LatticeBall &ball, const Vector &origin, const FaceMeasures &face) {
  const Vector centre = real_centre_of(ball);
  Real sum = static_cast<Real>(ball.radius) * face.area;
  for (size_t k = 0; k < 3; ++k) sum += (centre[k] - origin[k]) * face.vector_area[k];
  return sum / 3;
}

class FaceComparison {
 public:
  explicit FaceComparison(const Balls &balls)
      : balls_(balls),
        boundary_(balls),
        library_balls_(boundary_.balls()),
        by_face_(measure_faces(boundary_)),
        by_ball_(boundary_.measure()),
        expected_(balls.size()) {
    for (const FaceMeasures &face : oracle::measure_faces_by_slices(oracle::real_balls(balls)))
      expected_[face.ball].push_back(face);
    for (const oracle::LatticeBall &a : balls)
      for (size_t k = 0; k < 3; ++k) extent_ = std::max(extent_, std::abs(real_centre_of(a)[k]));
  }

  std::string complaint() {
    for (uint32_t component = 0; component < boundary_.counts().components; ++component) compare(component);
    return text_.str();
  }

 private:
  // The origin of the volume terms is the centre of one of the component's balls, and the header leaves open of which:
  // the terms of all its faces must fit one of them.
  void compare(uint32_t component) {
    std::ostringstream best;
    bool first = true;
    for (size_t o = 0; o < balls_.size(); ++o) {
      if (library_balls_[o].component != component) continue;
      std::ostringstream text;
      text.precision(17);
      for (uint32_t i = 0; i < balls_.size(); ++i)
        if (library_balls_[i].component == component) compare_ball(i, real_centre_of(balls_[o]), text);
      if (text.str().empty()) return;
      if (first || text.str().size() < best.str().size()) best.swap(text);
      first = false;
    }
    text_ << "component " << component << ":\n" << best.str();
  }

  void compare_ball(uint32_t i, const Vector &origin, std::ostringstream &text) const {
    const Real radius = static_cast<Real>(balls_[i].radius);
    const Real area_tolerance = 1e-12L * 4 * std::numbers::pi_v<Real> * radius * radius;
    const Real volume_tolerance = area_tolerance * (radius + 2 * extent_) / 3;
    if (library_balls_[i].faces != expected_[i].size()) {
      text << "ball " << i << " has " << library_balls_[i].faces << " faces instead of " << expected_[i].size() << "\n";
      return;
    }
    std::vector<FaceMeasures> left = expected_[i];
    FaceMeasures whole;
    for (const FaceMeasures &face : left) {
      whole.area += face.area;
      for (size_t k = 0; k < 3; ++k) whole.vector_area[k] += face.vector_area[k];
    }
    for (uint32_t f = library_balls_[i].first_face; left.size() > 0; ++f) {
      const auto agrees = [&](const FaceMeasures &face) {
        return std::abs(static_cast<Real>(by_face_.area[f]) - face.area) <= area_tolerance &&
               std::abs(static_cast<Real>(by_face_.volume[f]) - volume_term(balls_[i], origin, face)) <=
                   volume_tolerance;
      };
      const auto found = std::find_if(left.begin(), left.end(), agrees);
      if (found == left.end()) {
        text << "face " << f << " of ball " << i << ": area " << by_face_.area[f] << ", volume " << by_face_.volume[f]
             << ", instead of one of";
        for (const FaceMeasures &face : left) text << " " << face.area << ", " << volume_term(balls_[i], origin, face);
        text << "\n";
        return;
      }
      left.erase(found);
    }
    if (!(std::abs(static_cast<Real>(by_ball_.area[i]) - whole.area) <= area_tolerance))
      text << "area of ball " << i << ": " << by_ball_.area[i] << " instead of " << whole.area << "\n";
    const Real volume = volume_term(balls_[i], origin, whole);
    if (!(std::abs(static_cast<Real>(by_ball_.volume[i]) - volume) <= volume_tolerance))
      text << "volume of ball " << i << ": " << by_ball_.volume[i] << " instead of " << volume << "\n";
  }

  const Balls &balls_;
  LibraryBoundary boundary_;
  std::vector<hsp_ball> library_balls_;
  LibraryFaceMeasures by_face_;
  LibraryBoundary::Measures by_ball_;
  std::vector<std::vector<FaceMeasures>> expected_;
  Real extent_ = 0;
  std::ostringstream text_;
};

}  // namespace

std::string faces_differ(const Balls &balls) {
  return FaceComparison(balls).complaint();
}
