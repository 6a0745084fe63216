#include "contacts/contact_measures.hpp"

#include "exact/discriminant.hpp"
#include "exact/lattice_ball.hpp"

namespace hsp {

bool measure_contact_in_integers(const BallSet &balls, ContactMeasures &contacts, uint32_t s) {
  const exact::LatticeBall own = balls.ball(contacts.ball[0][s]);
  const exact::LatticeBall other = balls.ball(contacts.ball[1][s]);
  const exact::Plane P = exact::plane_of(own, other);
  const int64_t U = dot(P.v, P.v);
  const double square = exact::circle_discriminant(exact::sphere_of(own), P, U) / (4 * static_cast<double>(U));
  const double distance = std::sqrt(static_cast<double>(U));
  const double area = contacts.area[s] / distance + 0.5 * square * contacts.rim[s];
  contacts.area[s] = area > 0.0 && square > 0.0 ? area : 0.0;
  contacts.rim[s] *= std::sqrt(square);
  // Twice the heights of the contact's plane over both centres are h and 2 |v|^2 - h over |v|.
  const int64_t other_h = U + (other.radius - own.radius) * (other.radius + own.radius);
  contacts.cone[0][s] = static_cast<double>(P.h) / (2 * distance) * contacts.area[s];
  contacts.cone[1][s] = static_cast<double>(other_h) / (2 * distance) * contacts.area[s];
  return square == 0.0;
}

}  // namespace hsp
