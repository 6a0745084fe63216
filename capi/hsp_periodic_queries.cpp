#include "core/sorting.hpp"
#include "hsp_periodic.hpp"
#include "model/neighbour_lists.hpp"
#include "periodic/periodic_queries.hpp"
#include "periodic_shifts.hpp"

using hsp::capi::is_live;

namespace {

void sort_images(hsp_image *out, uint32_t count) {
  hsp::sort_in_place(hsp::Span<hsp_image>(out, count), hsp::capi::image_comes_before);
}

// Balls and images into an array that the program gives: counted, then written, then in their order. visit(sink) calls
// sink(ball, shift) for each; from: how far the place that they are seen from has been moved into the box.
template <class Visit>
int32_t put_images(const hsp::PeriodicImages &images, const hsp::BoxShift &from, hsp_image *out, uint32_t capacity,
                   uint32_t *needed, Visit visit) {
  uint64_t count = 0;
  visit([&](uint32_t, const hsp::BoxShift &) { ++count; });
  if (count > UINT32_MAX) return HSP_E_RANGE;
  const uint32_t found = static_cast<uint32_t>(count);
  if (const int32_t status = hsp::capi::check_output(out, capacity, found, needed); status != HSP_OK) return status;
  uint32_t written = 0;
  visit([&](uint32_t ball, const hsp::BoxShift &shift) {
    hsp_image &image = out[written++];
    image.ball = ball;
    hsp::capi::put_shift(images.box().in_given_vectors(shift - images.home(ball) + from), image.shift);
  });
  sort_images(out, found);
  return HSP_OK;
}

// A place in the box, so many boxes away from where it was given, and a radius.
struct QueryInBox {
  hsp::exact::Vector centre;
  int64_t radius = 0;
  hsp::BoxShift home;
};

int32_t round_query(const hsp::PeriodicImages &images, const double *xyz, double radius, QueryInBox &query) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!hsp::is_finite(xyz[axis])) return HSP_E_NOT_FINITE;
  }
  if (!hsp::is_finite(radius)) return HSP_E_NOT_FINITE;
  if (radius < 0.0) return HSP_E_NEGATIVE;
  const double steps = images.lattice().steps(radius);
  const double widest = static_cast<double>(hsp::widest_query * images.box().shortest_side());
  if (!(steps <= widest) || !images.lattice().round(xyz, query.centre)) return HSP_E_RANGE;
  query.radius = hsp::nearest(steps);
  return images.box().wrap(query.centre, query.home) == hsp::Status::ok ? HSP_OK : HSP_E_RANGE;
}

int32_t ask_in_box(const hsp_periodic *periodic, const double *xyz, double radius, hsp_image *out, uint32_t capacity,
                   uint32_t *needed) {
  if (!is_live(periodic) || xyz == nullptr || needed == nullptr || (out == nullptr && capacity > 0)) {
    return HSP_E_ARGUMENT;
  }
  if (!periodic->has_results()) return HSP_E_STATE;
  const hsp::PeriodicImages &images = periodic->builder.images();
  QueryInBox query;
  if (const int32_t status = round_query(images, xyz, radius, query); status != HSP_OK) return status;
  return put_images(images, query.home, out, capacity, needed,
                    [&](auto sink) { hsp::visit_images_at(periodic->builder, query.centre, query.radius, sink); });
}

}  // namespace

int32_t hsp_periodic_query_point(const hsp_periodic *periodic, const double *xyz, hsp_image *out, uint32_t capacity,
                                 uint32_t *needed) {
  return ask_in_box(periodic, xyz, 0.0, out, capacity, needed);
}

int32_t hsp_periodic_query_ball(const hsp_periodic *periodic, const double *xyz, double radius, hsp_image *out,
                                uint32_t capacity, uint32_t *needed) {
  return ask_in_box(periodic, xyz, radius, out, capacity, needed);
}

int32_t hsp_periodic_query_neighbours(const hsp_periodic *periodic, uint32_t ball, hsp_image *out, uint32_t capacity,
                                      uint32_t *needed) {
  if (!is_live(periodic) || needed == nullptr || (out == nullptr && capacity > 0)) return HSP_E_ARGUMENT;
  if (!periodic->has_results()) return HSP_E_STATE;
  if (ball >= periodic->balls()) return HSP_E_ID;
  const hsp::PeriodicImages &images = periodic->builder.images();
  return put_images(images, images.home(ball), out, capacity, needed, [&](auto sink) {
    hsp::visit_neighbours_in_box(periodic->builder, ball,
                                 [&](uint32_t k) { sink(images.ball_of(k), images.shift_of(k)); });
  });
}

int32_t hsp_periodic_query_pairs(const hsp_periodic *periodic, uint32_t flags, uint32_t *first, hsp_image *out,
                                 uint32_t capacity, uint32_t *needed) {
  if (!is_live(periodic) || (flags & ~HSP_PAIRS_ONCE) != 0 || first == nullptr || needed == nullptr ||
      (out == nullptr && capacity > 0)) {
    return HSP_E_ARGUMENT;
  }
  if (!periodic->has_results()) return HSP_E_STATE;
  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::PeriodicImages &images = structure.images();
  const uint32_t n = images.balls();
  const auto visit = [&](auto sink) {
    hsp::visit_all_neighbours_in_box(structure, [&](uint32_t i, uint32_t k) {
      if (flags == 0 || structure.is_listed(i, k)) sink(i, k);
    });
  };
  const hsp::Span<uint32_t> begins(first, n + 1);
  for (uint32_t &length : begins) length = 0;
  visit([&](uint32_t i, uint32_t) { ++begins[i]; });
  if (!hsp::sum_up(begins)) return HSP_E_RANGE;
  if (const int32_t status = hsp::capi::check_output(out, capacity, begins[n], needed); status != HSP_OK) return status;
  visit([&](uint32_t i, uint32_t k) {
    hsp_image &image = out[begins[i]++];
    image.ball = images.ball_of(k);
    hsp::capi::put_shift(images.caller_shift(i, k), image.shift);
  });
  // Rows have been filled to their ends, which is where the next ones begin.
  uint32_t begin = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t end = begins[i];
    begins[i] = begin;
    sort_images(out + begin, end - begin);
    begin = end;
  }
  return HSP_OK;
}
