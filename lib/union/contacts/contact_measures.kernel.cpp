#include "contacts/contact_measures.hpp"

#include "sphere/lane_planes.hpp"

namespace hsp::HSP_TARGET {

bool measure_contacts_in_lanes(const BallArrays &balls, ContactMeasures &contacts) {
  if constexpr (!has_twofold) return false;
  const FourDoubles none = Four::all(0.0);
  const LaneBalls own(balls, contacts.ball[0]), other(balls, contacts.ball[1]);
  const LanePlanes P(own, other);
  const Twofold U = from(P.U), h = from(P.h);
  const Twofold WU = product(exact_square(own.r + own.r), U), hh = square(h);
  Twofold Delta{};
  LaneBits certain = rounded_within(difference(WU, hh), Four::all(0x1p-98) * (WU.high + hh.high), Delta);
  certain &= lanes_where(Delta.high > none);
  if (certain != 15U) return false;

  const FourDoubles rho_2 = Delta.high / (Four::all(4.0) * U.high);
  const FourDoubles distance = Four::square_root(U.high);
  const FourDoubles twice = distance + distance;
  const FourDoubles angle = Four::load(contacts.rim);
  const FourDoubles area = Four::larger(Four::load(contacts.area) / distance + Four::all(0.5) * rho_2 * angle, none);
  Four::store(contacts.area, area);
  Four::store(contacts.rim, angle * Four::square_root(rho_2));
  Four::store(contacts.cone[0], h.high / twice * area);
  Four::store(contacts.cone[1], to_doubles(P.U + P.U - P.h) / twice * area);
  return true;
}

}  // namespace hsp::HSP_TARGET
