#include <limits>

#include "caller_executor.hpp"
#include "hsp_boundary.hpp"
#include "plugged_balls.hpp"

using namespace hsp::capi;

namespace {

// The least number of steps that is not less than `radius` in the caller's unit. level: the radius in steps, rounded.
int64_t steps_not_below(const hsp_pores &pores, double level, double radius) {
  int64_t steps = hsp::nearest(level) - 1;
  while (pores.lattice().length(static_cast<double>(steps)) < radius) ++steps;
  return steps;
}

template <auto list>
int32_t get_pocket_list(const hsp_pores *pores, uint32_t pocket, uint32_t *out, uint32_t capacity, uint32_t *needed) {
  return get_list(
      pores, pocket, out, capacity, needed,
      [](const hsp_pores &handle) { return handle.builder.pockets().pockets().size(); },
      [&](const hsp_pores &handle) {
        const hsp::PocketFinder &pockets = handle.builder.pockets();
        return (pockets.*list)(pockets.pockets()[pocket]);
      },
      as_it_is);
}

hsp_pore_region to_region(const hsp_pores &pores, const hsp::PoreRegion &region) {
  const hsp::exact::Lattice &lattice = pores.lattice();
  const bool outside = region.maximum == hsp::pore_outside;
  hsp_pore_region record{};
  record.radius = outside ? std::numeric_limits<double>::infinity() : radius_at(pores, pores.maxima(), region.maximum);
  record.area = lattice.area(region.area);
  record.volume = lattice.volume(region.volume);
  record.maximum = region.maximum;
  record.maxima = region.maxima;
  record.shells = region.shells;
  record.accessible = region.is_accessible() ? 1 : 0;
  put_windings(pores, region.lattice, record);
  return record;
}

void forget_pockets(hsp_pores &pores) {
  pores.builder.forget_pockets();
  pores.narrow_steps = 0;
}

// Checks a boundary, which may be null only for pores in a box.
int32_t check_boundary(const hsp_pores &pores, const hsp_boundary *boundary) {
  if (boundary == nullptr) return pores.in_box ? HSP_OK : HSP_E_ARGUMENT;
  return check_handle(boundary);
}

// Checks that regions of the pores can be found from a boundary.
int32_t check_surface(const hsp_pores &pores, const hsp_boundary *boundary) {
  if (pores.in_box != (boundary == nullptr)) return HSP_E_ARGUMENT;
  if (!pores.in_box) {
    if (const int32_t status = check_results(boundary, false); status != HSP_OK) return status;
    if (!boundary->model.is(&*pores.model)) return HSP_E_ARGUMENT;
  }
  return pores.builder.floor() > 0 ? HSP_E_RANGE : HSP_OK;
}

// Finds the regions, after check_surface().
hsp::Status find_regions(hsp_pores &pores, const hsp_boundary *boundary, uint32_t first_plug, hsp::Patience patience) {
  const hsp::PeriodicUnion *const periodic = pores.in_box ? &pores.periodic->builder : nullptr;
  return pores.builder.find_regions(pores.balls_around(), pores.in_box ? periodic->boundary() : boundary->structure(),
                                    periodic, first_plug, patience);
}

int32_t find_all_regions(hsp_pores *pores, const hsp_boundary *boundary, const hsp_pores_request *request,
                         hsp_pore_access *access, uint32_t *regions) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(pores); status != HSP_OK) return status;
  pores->builder.forget_regions();
  hsp_pores_request asked;
  Executor executor(arithmetic);
  if (const int32_t refused = first_failure(check_boundary(*pores, boundary), read_request(request, asked, executor));
      refused != HSP_OK)
    return refused;
  if (!pores->has_results()) return HSP_E_STATE;
  if (const int32_t refused = check_surface(*pores, boundary); refused != HSP_OK) return refused;
  const hsp::Status found = find_regions(*pores, boundary, hsp::no_id, hsp::Patience(&executor));
  if (found != hsp::Status::ok) return to_c(found);
  const hsp::Span<const hsp::PoreRegion> there = pores->builder.regions().regions();
  if (regions != nullptr) *regions = there.size();
  if (access == nullptr) return HSP_OK;
  *access = {};
  for (const hsp::PoreRegion &region : there) {
    const bool open = region.is_accessible();
    (open ? access->accessible_area : access->blocked_area) += pores->lattice().area(region.area);
    (open ? access->accessible_volume : access->blocked_volume) += pores->lattice().volume(region.volume);
    ++(open ? access->accessible : access->blocked);
  }
  return HSP_OK;
}

int32_t measure_pockets(hsp_pores *pores, hsp_pores *plugged, const hsp_boundary *boundary,
                        const hsp_pores_request *request, hsp_pore_pocket_size *out, uint32_t capacity,
                        uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = first_failure(check_handle(pores), check_handle(plugged)); status != HSP_OK) return status;
  hsp_pores_request asked;
  Executor executor(arithmetic);
  if (const int32_t refused = first_failure(check_boundary(*plugged, boundary), read_request(request, asked, executor));
      refused != HSP_OK)
    return refused;
  if (out == nullptr && capacity > 0) return HSP_E_ARGUMENT;
  if (!pores->has_results() || !plugged->has_results()) return HSP_E_STATE;
  const PluggedBalls balls(*pores);
  if (!balls.are_those_of(*plugged)) return HSP_E_ARGUMENT;
  if (const int32_t refused = check_surface(*plugged, boundary); refused != HSP_OK) return refused;
  const hsp::PocketFinder &finder = pores->builder.pockets();
  const uint32_t count = finder.pockets().size();
  if (!fits(true, capacity, count, needed)) return HSP_E_CAPACITY;
  plugged->builder.forget_regions();
  if (plugged != pores) forget_pockets(*plugged);
  hsp::Status status = find_regions(*plugged, boundary, balls.given(), hsp::Patience(&executor));
  if (status == hsp::Status::ok) {
    status = pores->builder.match_pockets(
        plugged->builder, plugged->balls_around(),
        [&](uint32_t maximum, hsp::exact::Vector &point) {
          double place[3];
          to_array(lengths_of(*pores, pores->maxima()[maximum].point.position), place);
          return plugged->lattice().round(place, point) ? hsp::Status::ok : hsp::Status::range;
        },
        hsp::Patience(&executor));
  }
  if (status != hsp::Status::ok) {
    plugged->builder.forget_regions();
    return to_c(status);
  }
  for (uint32_t k = 0; k < count; ++k) out[k] = {0.0, 0.0, 0.0, 0, 1};
  const hsp::exact::Lattice &lattice = plugged->lattice();
  finder.visit_regions(
      plugged->builder.regions().regions(),
      [&](uint32_t pocket) {
        constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
        out[pocket] = {unknown, unknown, unknown, 0, 0};
      },
      [&](uint32_t pocket, const hsp::PoreRegion &region) {
        hsp_pore_pocket_size &size = out[pocket];
        if (size.closed == 0) return;
        size.volume += lattice.volume(region.volume);
        size.area += lattice.area(region.area - region.plug_area);
        size.plug_area += lattice.area(region.plug_area);
        ++size.regions;
      });
  return HSP_OK;
}

}  // namespace

int32_t hsp_pores_find_pockets(hsp_pores *pores, double narrow, double wide, uint32_t *pockets) {
  LibraryArithmetic arithmetic(narrow, wide);
  if (const int32_t status = check_handle(pores); status != HSP_OK) return status;
  forget_pockets(*pores);
  const bool are_finite = hsp::is_finite(narrow) && hsp::is_finite(wide);
  if (pockets == nullptr || (are_finite && wide < narrow)) return HSP_E_ARGUMENT;
  if (!pores->has_results()) return HSP_E_STATE;
  if (!are_finite) return HSP_E_NOT_FINITE;
  const double narrow_level = pores->lattice().steps(narrow), wide_level = pores->lattice().steps(wide);
  if (!is_level(*pores, narrow_level) || !is_level(*pores, wide_level)) return HSP_E_RANGE;
  pores->builder.find_pockets(highest_level(*pores, narrow_level, narrow), highest_level(*pores, wide_level, wide));
  pores->narrow_steps = steps_not_below(*pores, narrow_level, narrow);
  *pockets = pores->builder.pockets().pockets().size();
  return HSP_OK;
}

int32_t hsp_pores_get_pockets(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_pocket *out) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_range(pores, first, count, out,
                                     [](const hsp_pores &handle) { return handle.builder.pockets().pockets().size(); });
  if (status != HSP_OK) return status;
  const hsp::PocketFinder &finder = pores->builder.pockets();
  for (uint32_t k = 0; k < count; ++k) {
    const hsp::Pocket &pocket = finder.pockets()[first + k];
    out[k] = {radius_at(*pores, pores->maxima(), pocket.maximum),
              radius_at(*pores, pores->gates(), pocket.mouth),
              pocket.maximum,
              pocket.mouth,
              finder.maxima(pocket).size(),
              finder.mouths(pocket).size(),
              finder.balls(pocket).size(),
              0};
  }
  return HSP_OK;
}

int32_t hsp_pores_get_pocket_maxima(const hsp_pores *pores, uint32_t pocket, uint32_t *maxima, uint32_t capacity,
                                    uint32_t *needed) {
  return get_pocket_list<&hsp::PocketFinder::maxima>(pores, pocket, maxima, capacity, needed);
}

int32_t hsp_pores_get_pocket_mouths(const hsp_pores *pores, uint32_t pocket, uint32_t *gates, uint32_t capacity,
                                    uint32_t *needed) {
  return get_pocket_list<&hsp::PocketFinder::mouths>(pores, pocket, gates, capacity, needed);
}

int32_t hsp_pores_get_pocket_balls(const hsp_pores *pores, uint32_t pocket, uint32_t *balls, uint32_t capacity,
                                   uint32_t *needed) {
  return get_pocket_list<&hsp::PocketFinder::balls>(pores, pocket, balls, capacity, needed);
}

int32_t hsp_pores_get_plugged_balls(const hsp_pores *pores, double *xyz, double *radius, uint32_t capacity,
                                    uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(pores, false); status != HSP_OK) return status;
  const PluggedBalls balls(*pores);
  const bool wanted = xyz != nullptr || radius != nullptr;
  if (!fits(wanted, capacity, balls.size(), needed)) return HSP_E_CAPACITY;
  for (uint32_t k = 0; wanted && k < balls.size(); ++k) {
    double place[3], length = 0.0;
    balls.put(k, place, length);
    put_vector(place, xyz, k);
    if (radius != nullptr) radius[k] = length;
  }
  return HSP_OK;
}

int32_t hsp_pores_find_regions(hsp_pores *pores, const hsp_boundary *boundary, hsp_pore_access *access,
                               uint32_t *regions) {
  return find_all_regions(pores, boundary, nullptr, access, regions);
}

int32_t hsp_pores_find_regions_with(hsp_pores *pores, const hsp_boundary *boundary, const hsp_pores_request *request,
                                    hsp_pore_access *access, uint32_t *regions) {
  return find_all_regions(pores, boundary, request, access, regions);
}

int32_t hsp_pores_get_regions(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_region *out) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_range(pores, first, count, out,
                                     [](const hsp_pores &handle) { return handle.builder.regions().regions().size(); });
  if (status != HSP_OK) return status;
  for (uint32_t k = 0; k < count; ++k) out[k] = to_region(*pores, pores->builder.regions().regions()[first + k]);
  return HSP_OK;
}

int32_t hsp_pores_measure_pockets(hsp_pores *pores, hsp_pores *plugged, const hsp_boundary *boundary,
                                  hsp_pore_pocket_size *out, uint32_t capacity, uint32_t *needed) {
  return measure_pockets(pores, plugged, boundary, nullptr, out, capacity, needed);
}

int32_t hsp_pores_measure_pockets_with(hsp_pores *pores, hsp_pores *plugged, const hsp_boundary *boundary,
                                       const hsp_pores_request *request, hsp_pore_pocket_size *out, uint32_t capacity,
                                       uint32_t *needed) {
  return measure_pockets(pores, plugged, boundary, request, out, capacity, needed);
}
