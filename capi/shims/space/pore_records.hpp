// The conversion of the records of pores for the caller, and of radii to levels.
#pragma once

#include <bit>

#include "conversion.hpp"
#include "handle_memory.hpp"
#include "hsp_pores.hpp"
#include "periodic_shifts.hpp"

namespace hsp::capi {

inline double floor_of(const hsp_pores &pores) {
  return pores.lattice().length(static_cast<double>(pores.builder.floor()));
}

// The radius at a maximum or gate; at none, which is no_id, the floor.
template <class Points>
double radius_at(const hsp_pores &pores, const Points &points, uint32_t k) {
  return k == no_id ? floor_of(pores) : pores.lattice().length(points[k].point.level);
}

// A place in the caller's unit, but in the frame of the box.
inline Vec3 lengths_of(const hsp_pores &pores, const Vec3 &place) {
  const exact::Lattice &lattice = pores.lattice();
  return {lattice.length(place.x), lattice.length(place.y), lattice.length(place.z)};
}

inline void put_position(const hsp_pores &pores, const Vec3 &place, double xyz[3]) {
  const Vec3 lengths = lengths_of(pores, place);
  to_array(pores.in_box ? pores.periodic->builder.images().box().frame().turned_back(lengths) : lengths, xyz);
}

// Rounds a point of the caller.
inline int32_t round_point(const hsp_pores &pores, const double *xyz, exact::Vector &point) {
  return pores.in_box ? round_point(pores.periodic->builder.images(), xyz, point)
                      : round_point(pores.lattice(), xyz, point);
}

// The highest level that is `radius` or less in the caller's unit. So a probe that is exactly as wide as a gate, to the
// last bit, does not pass it. level: an estimate of the result. It is a few doubles away from the result as a rule, but
// up to 2^52 where lengths are so small that thousands of levels are rounded to one: so strides double, and are halved
// again.
inline double highest_level(const hsp_pores &pores, double level, double radius) {
  if (std::fabs(level) < 0x1p-40) return level;  // no gate has so small a level
  const auto moved = [level](int64_t by) {
    return std::bit_cast<double>(std::bit_cast<int64_t>(level) + (level > 0.0 ? by : -by));
  };
  const auto is_within = [&](int64_t by) { return pores.lattice().length(moved(by)) <= radius; };
  int64_t within = 0, beyond = 1;
  if (is_within(0)) {
    for (; is_within(beyond); beyond *= 2) within = beyond;
  } else {
    for (within = -1, beyond = 0; !is_within(within); within *= 2) beyond = within;
  }
  while (beyond - within > 1) {
    const int64_t between = within + (beyond - within) / 2;
    (is_within(between) ? within : beyond) = between;
  }
  return moved(within);
}

// Whether a level is not below the floor of the pores, and on the lattice.
inline bool is_level(const hsp_pores &pores, double level) {
  return level >= static_cast<double>(pores.builder.floor()) && level <= exact::query_radius_limit;
}

// Writes put(..) for each entry of list(*pores), if the number of the record is below number(*pores). needed may be
// null.
template <class T, class Number, class List, class Put>
int32_t get_list(const hsp_pores *pores, uint32_t record, T *out, uint32_t capacity, uint32_t *needed, Number number,
                 List list, Put put) {
  const int32_t status = check_results(pores, out == nullptr && capacity > 0);
  if (status != HSP_OK) return status;
  if (record >= number(*pores)) return HSP_E_ID;
  const auto there = list(*pores);
  uint32_t count = 0;
  const int32_t fits = check_output(capacity, there.size(), needed != nullptr ? needed : &count);
  if (fits != HSP_OK) return fits;
  for (uint32_t k = 0; k < there.size(); ++k) out[k] = put(there[k]);
  return HSP_OK;
}

inline constexpr auto as_it_is = [](const auto &item) { return item; };

// Puts the directions in which a class goes on for ever, in the given vectors of the box, into a record that has none.
template <class Record>
void put_windings(const hsp_pores &pores, const WindingLattice &lattice, Record &record) {
  WindingLattice in_given;
  for (uint32_t r = 0; r < lattice.rank; ++r) {
    const auto &row = lattice.row[r];
    const BoxShift given = pores.given({{row[0], row[1], row[2]}});
    static_cast<void>(in_given.add({given.k[0], given.k[1], given.k[2]}));
  }
  put_lattice(in_given, record);
}

}  // namespace hsp::capi
