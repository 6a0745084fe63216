// A point of the caller on the lattice of some balls.
#pragma once

#include "conversion.hpp"
#include "model/queries.hpp"

namespace hsp::capi {

inline int32_t round_point(const BallSet &balls, const double *xyz, exact::Vector &point) {
  LatticeQuery query;
  const Status status = round_query(balls, xyz, 0.0, query);
  if (status == Status::ok) point = query.centre;
  return to_c(status);
}

}  // namespace hsp::capi
