#include "core/sorting.hpp"
#include "hsp_periodic.hpp"
#include "model/neighbour_lists.hpp"
#include "periodic/periodic_queries.hpp"
#include "periodic_shifts.hpp"

using namespace hsp::capi;

namespace {

// Sorts a row of images. Most rows are in order already.
void sort_images(hsp_image *out, uint32_t count) {
  uint32_t at = 1;
  while (at < count && image_comes_before(out[at - 1], out[at])) ++at;
  if (at >= count) return;
  // A lambda, not the function: sorting would call it through a pointer.
  hsp::sort_in_place(hsp::Span<hsp_image>(out, count),
                     [](const hsp_image &p, const hsp_image &q) { return image_comes_before(p, q); });
}

void put_image(const hsp::PeriodicImages &images, const hsp::BoxShift &from, uint32_t ball, const hsp::BoxShift &shift,
               hsp_image &image) {
  image.ball = ball;
  put_shift(images.box().in_given_vectors(shift - images.home(ball) + from), image.shift);
}

// Writes those of the hits for which wanted(k) is true, in their order; returns how many. None of the hits was dropped.
// from: the shift by which the query point was moved into the box.
template <class Wanted>
uint32_t put_hits(const hsp::PeriodicUnion &periodic, const hsp::QueryHits &hits, const hsp::BoxShift &from,
                  hsp_image *out, Wanted wanted) {
  const hsp::PeriodicImages &images = periodic.images();
  hsp::OrderedHits ordered;
  hsp::put_in_order(periodic, hits, ordered);
  uint32_t written = 0;
  for (uint32_t at = 0; at < ordered.count; ++at) {
    const uint32_t k = ordered.ids[at];
    if (!wanted(k)) continue;
    hsp_image image;
    put_image(images, from, images.ball_of(k), images.shift_of(k), image);
    uint32_t place = written++;
    for (; place > 0 && image_comes_before(image, out[place - 1]); --place) out[place] = out[place - 1];
    out[place] = image;
  }
  return written;
}

// Writes balls and images to an array of the program: counts them, writes them, and sorts them. visit(sink) calls
// sink(ball, shift) for each.
template <class Visit>
int32_t put_images(const hsp::PeriodicImages &images, const hsp::BoxShift &from, hsp_image *out, uint32_t capacity,
                   uint32_t *needed, Visit visit) {
  uint64_t count = 0;
  visit([&](uint32_t, const hsp::BoxShift &) { ++count; });
  if (count > UINT32_MAX) return HSP_E_RANGE;
  const uint32_t found = static_cast<uint32_t>(count);
  if (const int32_t status = check_output(capacity, found, needed); status != HSP_OK) return status;
  uint32_t written = 0;
  visit([&](uint32_t ball, const hsp::BoxShift &shift) { put_image(images, from, ball, shift, out[written++]); });
  sort_images(out, found);
  return HSP_OK;
}

// Writes the balls that meet a query ball around a point of the box, without ball `excluded`.
int32_t put_meeting(const hsp::PeriodicUnion &periodic, const hsp::exact::Vector &centre, int64_t radius,
                    uint32_t excluded, const hsp::BoxShift &from, hsp_image *out, uint32_t capacity, uint32_t *needed) {
  const hsp::PeriodicImages &images = periodic.images();
  if (radius <= images.largest_radius()) {
    const hsp::CubeGrid &grid = periodic.grid();
    hsp::QueryHits hits;
    hsp::find_in_block(grid, grid.block_around(grid.cube_at(centre)), centre, radius, excluded, hits);
    if (hits.count <= hsp::QueryHits::room) {
      const int32_t status = check_output(capacity, hits.count, needed);
      if (status == HSP_OK) put_hits(periodic, hits, from, out, [](uint32_t) { return true; });
      return status;
    }
  }
  return put_images(images, from, out, capacity, needed, [&](auto sink) {
    hsp::visit_images_at(periodic, centre, radius, [&](uint32_t ball, const hsp::BoxShift &shift) {
      if (ball != excluded || !shift.is_zero()) sink(ball, shift);
    });
  });
}

// A query ball in the box: its centre, the shift from there to where it was given, and its radius.
struct QueryInBox {
  hsp::exact::Vector centre;
  int64_t radius = 0;
  hsp::BoxShift home;
};

int32_t round_query(const hsp::PeriodicImages &images, const double *xyz, double radius, QueryInBox &query) {
  const int32_t rounded = round_point(images, xyz, query.centre);
  if (rounded == HSP_E_NOT_FINITE || !hsp::is_finite(radius)) return HSP_E_NOT_FINITE;
  if (radius < 0.0) return HSP_E_NEGATIVE;
  const double steps = images.lattice().steps(radius);
  const double widest = static_cast<double>(hsp::widest_query * images.box().shortest_side());
  if (rounded != HSP_OK || !(steps <= widest)) return HSP_E_RANGE;
  query.radius = hsp::nearest(steps);
  return images.box().wrap(query.centre, query.home) == hsp::Status::ok ? HSP_OK : HSP_E_RANGE;
}

int32_t ask_in_box(const hsp_periodic *periodic, const double *xyz, double radius, hsp_image *out, uint32_t capacity,
                   uint32_t *needed) {
  if (const int32_t status = check_results(periodic, xyz == nullptr || (out == nullptr && capacity > 0));
      status != HSP_OK)
    return status;
  QueryInBox query;
  const int32_t status = round_query(periodic->builder.images(), xyz, radius, query);
  if (status != HSP_OK) return status;
  return put_meeting(periodic->builder, query.centre, query.radius, hsp::no_id, query.home, out, capacity, needed);
}

}  // namespace

int32_t hsp_periodic_query_point(const hsp_periodic *periodic, const double *xyz, hsp_image *out, uint32_t capacity,
                                 uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return ask_in_box(periodic, xyz, 0.0, out, capacity, needed);
}

int32_t hsp_periodic_query_ball(const hsp_periodic *periodic, const double *xyz, double radius, hsp_image *out,
                                uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic(radius);
  return ask_in_box(periodic, xyz, radius, out, capacity, needed);
}

int32_t hsp_periodic_query_neighbours(const hsp_periodic *periodic, uint32_t ball, hsp_image *out, uint32_t capacity,
                                      uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(periodic, out == nullptr && capacity > 0); status != HSP_OK) return status;
  if (ball >= periodic->balls()) return HSP_E_ID;
  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::exact::LatticeBall own = structure.balls().ball(structure.grid().grid_index(ball));
  return put_meeting(structure, own.centre, own.radius, ball, structure.images().home(ball), out, capacity, needed);
}

int32_t hsp_periodic_query_pairs(const hsp_periodic *periodic, uint32_t flags, uint32_t *first, hsp_image *out,
                                 uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(
          periodic, (flags & ~HSP_PAIRS_ONCE) != 0 || first == nullptr || (out == nullptr && capacity > 0));
      status != HSP_OK)
    return status;
  const hsp::PeriodicUnion &structure = periodic->builder;
  const hsp::PeriodicImages &images = structure.images();
  const uint32_t n = images.balls();
  const auto wanted = [&](uint32_t i, uint32_t k) { return flags == 0 || structure.is_listed(i, k); };
  // Calls few(i, hits) for each ball and all that meet it, or many(i, k) for each of more than there is room for.
  const auto visit = [&](auto few, auto many) {
    hsp::QueryHits hits;
    hsp::visit_blocks_in_box(structure, [&](uint32_t i, const hsp::CubeBlock &block) {
      const hsp::exact::LatticeBall own = structure.balls().ball(structure.grid().grid_index(i));
      hsp::find_in_block(structure.grid(), block, own.centre, own.radius, i, hits);
      if (hits.count <= hsp::QueryHits::room) return few(i, hits);
      hsp::visit_neighbours_in_box(structure, i, [&](uint32_t k) {
        if (wanted(i, k)) many(i, k);
      });
    });
  };
  const hsp::Span<uint32_t> begins(first, n + 1);
  for (uint32_t &length : begins) length = 0;
  visit(
      [&](uint32_t i, const hsp::QueryHits &hits) {
        for (uint32_t at = 0; at < hits.count; ++at) begins[i] += wanted(i, hits.ids[at]) ? 1U : 0U;
      },
      [&](uint32_t i, uint32_t) { ++begins[i]; });
  if (!hsp::sum_up(begins)) return HSP_E_RANGE;
  if (const int32_t status = check_output(capacity, begins[n], needed); status != HSP_OK) return status;
  visit(
      [&](uint32_t i, const hsp::QueryHits &hits) {
        begins[i] +=
            put_hits(structure, hits, images.home(i), out + begins[i], [&](uint32_t k) { return wanted(i, k); });
      },
      [&](uint32_t i, uint32_t k) {
        put_image(images, images.home(i), images.ball_of(k), images.shift_of(k), out[begins[i]++]);
      });
  // Rows have been filled: each entry is the end of its row, which is the beginning of the next one.
  uint32_t begin = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t end = begins[i];
    begins[i] = begin;
    sort_images(out + begin, end - begin);
    begin = end;
  }
  return HSP_OK;
}
