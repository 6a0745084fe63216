#include "contacts/contact_measures.hpp"

#if HSP_AVX2
#include "sphere/lane_planes_avx2.hpp"

namespace hsp {

bool measure_contacts_in_lanes(const BallArrays &balls, ContactMeasures &contacts) {
  const Doubles none = Doubles::all(0.0);
  const LaneBalls own(balls, contacts.ball[0]), other(balls, contacts.ball[1]);
  const LanePlanes P(own, other);
  const Twofold U = from(P.U), h = from(P.h);
  const Twofold WU = product(exact_square(own.r + own.r), U), hh = square(h);
  Twofold Delta{};
  LaneBits certain = rounded_within(difference(WU, hh), Doubles::all(0x1p-98) * (WU.high + hh.high), Delta);
  certain &= greater(Delta.high, none);
  if (certain != 15U) return false;

  const Doubles rho_2 = Delta.high / (Doubles::all(4.0) * U.high);
  const Doubles distance = square_root(U.high);
  const Doubles twice = distance + distance;
  const Doubles angle = Doubles::load(contacts.rim);
  const Doubles area = larger(Doubles::load(contacts.area) / distance + Doubles::all(0.5) * rho_2 * angle, none);
  area.store(contacts.area);
  (angle * square_root(rho_2)).store(contacts.rim);
  (h.high / twice * area).store(contacts.cone[0]);
  (to_doubles(P.U + P.U - P.h) / twice * area).store(contacts.cone[1]);
  return true;
}

}  // namespace hsp
#endif
