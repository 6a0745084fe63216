#include "compute_from.hpp"
#include "core/sorting.hpp"
#include "pore_records.hpp"

namespace hsp::capi {

static_assert(pore_outside == HSP_PORE_OUTSIDE);

static hsp_pores_options default_options() {
  return {sizeof(hsp_pores_options), 0, 0.0, nullptr, nullptr};
}

static int32_t read_request(const hsp_pores_options *given, hsp_pores_options &complete, Executor &executor) {
  complete = default_options();
  if (given == nullptr) return HSP_OK;
  if (const int32_t status = read_struct(given, default_options(), complete); status != HSP_OK) return status;
  return complete.reserved != 0 ? HSP_E_VERSION : executor.read(complete.executor);
}

}  // namespace hsp::capi

using namespace hsp::capi;

namespace {

// Checks other pores from which points may be taken; null: there are none.
int32_t check_before(const hsp_pores &pores, const hsp_pores *before) {
  if (before == nullptr) return HSP_OK;
  if (before == &pores) return HSP_E_ARGUMENT;
  return check_results(before, false);
}

// The floor in steps, rounded down, and within the range of coordinates.
int64_t floor_in_steps(const hsp::exact::Lattice &lattice, double floor) {
  constexpr double limit = hsp::exact::query_radius_limit;
  const double steps = lattice.steps(floor);
  const double near = steps < -limit ? -limit : steps > limit ? limit : steps;
  const int64_t truncated = static_cast<int64_t>(near);
  return truncated - static_cast<int64_t>(static_cast<double>(truncated) > near);
}

// Whether a number is that of a maximum, or of the outside.
bool is_class(const hsp_pores &pores, uint32_t maximum) {
  return maximum == HSP_PORE_OUTSIDE || maximum < pores.maxima().size();
}

// Nearest balls as records.
struct TiedImages {
  const hsp_pores &pores;
  const hsp::CriticalPoint &point;

  uint32_t size() const { return pores.builder.pores().tied(point).size(); }
  hsp_image operator[](uint32_t k) const {
    hsp_image image{pores.builder.pores().tied(point)[k], {}};
    put_shift(pores.image_shift(image.ball, pores.builder.pores().tied_shifts(point)[k]), image.shift);
    return image;
  }
};

// Writes the nearest balls of a maximum or gate in the order of less(); in the records they are in the order of
// positions. list_of(handle, point): these balls.
template <class T, class Records, class ListOf, class Less>
int32_t get_sorted(const hsp_pores *pores, uint32_t record, T *out, uint32_t capacity, uint32_t *needed,
                   Records records, ListOf list_of, Less less) {
  uint32_t count = 0;
  const int32_t status = get_list(
      pores, record, out, capacity, needed, [&](const hsp_pores &handle) { return records(handle).size(); },
      [&](const hsp_pores &handle) {
        const auto list = list_of(handle, records(handle)[record].point);
        count = list.size();
        return list;
      },
      as_it_is);
  if (status == HSP_OK) hsp::sort_in_place(hsp::Span<T>(out, count), less);
  return status;
}
template <class Records>
int32_t get_tied(const hsp_pores *pores, uint32_t record, uint32_t *balls, uint32_t capacity, uint32_t *needed,
                 Records records) {
  return get_sorted(
      pores, record, balls, capacity, needed, records,
      [](const hsp_pores &handle, const hsp::CriticalPoint &point) { return handle.builder.pores().tied(point); },
      [](uint32_t a, uint32_t b) { return a < b; });
}
// The same balls as images.
template <class Records>
int32_t get_images(const hsp_pores *pores, uint32_t record, hsp_image *images, uint32_t capacity, uint32_t *needed,
                   Records records) {
  return get_sorted(
      pores, record, images, capacity, needed, records,
      [](const hsp_pores &handle, const hsp::CriticalPoint &point) {
        return TiedImages{handle, point};
      },
      [](const hsp_image &p, const hsp_image &q) { return image_comes_before(p, q); });
}

// Computes pores from a model or a box; build(options, patience) notes the source.
template <class Source, class Build>
int32_t compute(hsp_pores *pores, const Source *source, const hsp_pores_options *options, hsp_pores_limits *limits,
                Build build) {
  LibraryArithmetic arithmetic;
  const auto check = [&](const hsp_pores_options &asked) { return check_before(*pores, asked.before); };
  return compute_from(arithmetic, pores, source, options, limits, check,
                      [&](const hsp_pores_options &asked, Executor &executor) {
                        pores->narrow_steps = 0;
                        if (!hsp::is_finite(asked.floor)) return hsp::Status::not_finite;
                        return build(asked, hsp::Patience(&executor));
                      });
}

hsp_pore_channel to_channel(const hsp_pores &pores, const hsp::Windings &joined, uint32_t component) {
  hsp_pore_channel channel{};
  channel.maximum = joined.first_ball(component) - 1;
  channel.radius = radius_at(pores, pores.maxima(), channel.maximum);
  put_windings(pores, joined.lattice(component), channel);
  return channel;
}

// Locates a point. The handle has results.
int32_t locate(const hsp_pores &pores, const double *xyz, hsp::PoreLocation &place) {
  hsp::exact::Vector point;
  if (const int32_t status = round_point(pores, xyz, point); status != HSP_OK) return status;
  return to_c(hsp::locate(pores.builder.pores(), pores.balls_around(), point, pores.builder.floor(), place));
}

// Finds the best tunnel, by width or by cost.
int32_t find_tunnel(hsp_pores *pores, const double *from, const double *to, const uint32_t *avoided, uint32_t count,
                    const hsp_tunnel_request *request, hsp_tunnel *tunnel, hsp_pores_limits *limits) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(pores); status != HSP_OK) return status;
  pores->builder.forget_tunnel();
  hsp_tunnel_request asked;
  Executor executor(arithmetic);
  if (const int32_t refused = first_failure(check_struct(limits), read_request(request, asked)); refused != HSP_OK)
    return refused;
  if (const int32_t refused = executor.read(asked.executor); refused != HSP_OK) return refused;
  if (asked.cheapest > 1) return HSP_E_ARGUMENT;
  if (from == nullptr || tunnel == nullptr || (avoided == nullptr && count > 0)) return HSP_E_ARGUMENT;
  if (!pores->has_results()) return HSP_E_STATE;
  for (uint32_t k = 0; k < count; ++k) {
    if (avoided[k] >= pores->gates().size()) return HSP_E_ID;
  }
  hsp::exact::Vector start, end;
  int32_t status = round_point(*pores, from, start);
  if (status == HSP_OK && to != nullptr) status = round_point(*pores, to, end);
  if (status != HSP_OK) return status;
  const hsp::TunnelEnds ends{
      start, to != nullptr ? &end : nullptr, {avoided, count}, pores->builder.floor(), asked.cheapest != 0};
  hsp::TunnelSummary found;
  const hsp::Status searched = pores->builder.find_tunnel(pores->balls_around(), ends, found, hsp::Patience(&executor));
  hand_back_limits(*pores, searched, limits);
  if (searched != hsp::Status::ok) return to_c(searched);
  const hsp::exact::Lattice &lattice = pores->lattice();
  *tunnel = {lattice.length(found.level),
             lattice.length(found.length),
             found.there ? 1U : 0U,
             found.gate,
             found.gates,
             pores->builder.tunnel().points().size(),
             found.outside ? 1U : 0U,
             0};
  return HSP_OK;
}

}  // namespace

HSP_HANDLE_BY_BALLS(hsp_pores);

int32_t hsp_pores_options_init(hsp_pores_options *options, uint32_t struct_size) {
  return write_struct(default_options(), options, struct_size);
}

int32_t hsp_pores_compute(hsp_pores *pores, const hsp_model *model, const hsp_pores_options *options,
                          hsp_pores_limits *limits) {
  return compute(pores, model, options, limits, [&](const hsp_pores_options &asked, hsp::Patience patience) {
    pores->in_box = false;
    pores->model.set(model);
    return pores->builder.build(model->grid, floor_in_steps(model->balls().lattice, asked.floor), patience,
                                asked.before != nullptr ? &asked.before->builder : nullptr);
  });
}

int32_t hsp_pores_compute_periodic(hsp_pores *pores, const hsp_periodic *periodic, const hsp_pores_options *options,
                                   hsp_pores_limits *limits) {
  return compute(pores, periodic, options, limits, [&](const hsp_pores_options &asked, hsp::Patience patience) {
    pores->in_box = true;
    pores->periodic.set(periodic);
    return pores->builder.build(periodic->builder.images(), floor_in_steps(periodic->lattice(), asked.floor), patience);
  });
}

int32_t hsp_pores_get_counts(const hsp_pores *pores, hsp_pores_counts *counts) {
  if (const int32_t status = check_results(pores, counts == nullptr); status != HSP_OK) return status;
  const uint32_t merges = pores->builder.pores().mergers(), maxima = pores->maxima().size();
  *counts = {maxima, pores->gates().size(), merges, maxima - merges, pores->builder.pores().outer_balls(), 0};
  return HSP_OK;
}

int32_t hsp_pores_get_maxima(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_maximum *out) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_range(pores, first, count, out, [](const hsp_pores &handle) { return handle.maxima().size(); });
  if (status != HSP_OK) return status;
  for (uint32_t k = 0; k < count; ++k) {
    const hsp::PoreMaximum &maximum = pores->maxima()[first + k];
    hsp_pore_maximum &record = out[k];
    put_position(*pores, maximum.point.position, record.xyz);
    record.radius = pores->lattice().length(maximum.point.level);
    record.death = radius_at(*pores, pores->gates(), maximum.gate);
    for (int b = 0; b < 4; ++b) record.ball[b] = maximum.point.ball[b];
    record.gate = maximum.gate;
    record.parent = maximum.into;
  }
  return HSP_OK;
}

int32_t hsp_pores_get_gates(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_gate *out) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_range(pores, first, count, out, [](const hsp_pores &handle) { return handle.gates().size(); });
  if (status != HSP_OK) return status;
  for (uint32_t k = 0; k < count; ++k) {
    const hsp::PoreGate &gate = pores->gates()[first + k];
    hsp_pore_gate &record = out[k];
    put_position(*pores, gate.point.position, record.xyz);
    record.radius = pores->lattice().length(gate.point.level);
    for (int b = 0; b < 3; ++b) record.ball[b] = gate.point.ball[b];
    for (int side = 0; side < 2; ++side) record.end[side] = gate.end[side];
    record.merges = gate.merges ? 1 : 0;
  }
  return HSP_OK;
}

int32_t hsp_pores_get_gate_shifts(const hsp_pores *pores, uint32_t first, uint32_t count, hsp_pore_gate_shifts *out) {
  const int32_t status =
      check_range(pores, first, count, out, [](const hsp_pores &handle) { return handle.gates().size(); });
  if (status != HSP_OK) return status;
  for (uint32_t k = 0; k < count; ++k) {
    const hsp::PoreGate &gate = pores->gates()[first + k];
    hsp_pore_gate_shifts &record = out[k];
    for (int b = 0; b < 3; ++b) {
      put_shift(pores->image_shift(gate.point.ball[b], gate.point.shift[b]), record.ball + 3 * b);
    }
    for (int side = 0; side < 2; ++side) {
      put_shift(pores->given(gate.end_shift[side].shift()), record.end + 3 * side);
    }
    record.winds = gate.winds ? 1 : 0;
    record.directions = gate.directions;
  }
  return HSP_OK;
}

int32_t hsp_pores_get_maximum_balls(const hsp_pores *pores, uint32_t maximum, uint32_t *balls, uint32_t capacity,
                                    uint32_t *needed) {
  return get_tied(pores, maximum, balls, capacity, needed, [](const hsp_pores &handle) { return handle.maxima(); });
}

int32_t hsp_pores_get_gate_balls(const hsp_pores *pores, uint32_t gate, uint32_t *balls, uint32_t capacity,
                                 uint32_t *needed) {
  return get_tied(pores, gate, balls, capacity, needed, [](const hsp_pores &handle) { return handle.gates(); });
}

int32_t hsp_pores_get_maximum_images(const hsp_pores *pores, uint32_t maximum, hsp_image *images, uint32_t capacity,
                                     uint32_t *needed) {
  return get_images(pores, maximum, images, capacity, needed, [](const hsp_pores &handle) { return handle.maxima(); });
}

int32_t hsp_pores_get_gate_images(const hsp_pores *pores, uint32_t gate, hsp_image *images, uint32_t capacity,
                                  uint32_t *needed) {
  return get_images(pores, gate, images, capacity, needed, [](const hsp_pores &handle) { return handle.gates(); });
}

int32_t hsp_pores_get_percolation(const hsp_pores *pores, hsp_pore_percolation *percolation) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(pores, percolation == nullptr); status != HSP_OK) return status;
  const hsp::PorePassages &passages = pores->builder.pores().passages();
  percolation->largest = radius_at(*pores, pores->maxima(), pores->maxima().size() > 0 ? 0 : hsp::no_id);
  percolation->reserved = 0;
  for (int d = 0; d < 3; ++d) {
    percolation->gate[d] = passages.gate[d];
    percolation->maximum[d] = passages.maximum[d];
    percolation->gate_along[d] = passages.gate_along[d];
    percolation->through[d] = radius_at(*pores, pores->gates(), passages.gate[d]);
    percolation->included[d] = radius_at(*pores, pores->maxima(), passages.maximum[d]);
    percolation->along[d] = radius_at(*pores, pores->gates(), passages.gate_along[d]);
  }
  return HSP_OK;
}

int32_t hsp_pores_get_channels(hsp_pores *pores, double radius, hsp_pore_channel *out, uint32_t capacity,
                               uint32_t *needed) {
  LibraryArithmetic arithmetic(radius);
  if (const int32_t status = check_results(pores, out == nullptr && capacity > 0); status != HSP_OK) return status;
  if (!hsp::is_finite(radius)) return HSP_E_NOT_FINITE;
  const double level = pores->lattice().steps(radius);
  if (!is_level(*pores, level)) return HSP_E_RANGE;
  const uint32_t parts = pores->builder.join_above(highest_level(*pores, level, radius)) - 1;
  uint32_t count = 0;
  const int32_t fits = check_output(capacity, parts, needed != nullptr ? needed : &count);
  if (fits != HSP_OK) return fits;
  const hsp::Windings &joined = pores->builder.pores().joined();
  for (uint32_t k = 0; k < parts; ++k) out[k] = to_channel(*pores, joined, k + 1);
  for (uint32_t node = 1; node < joined.size(); ++node) {
    if (joined.component(node) > 0) ++out[joined.component(node) - 1].maxima;
  }
  return HSP_OK;
}

int32_t hsp_pores_class_at(const hsp_pores *pores, uint32_t maximum, double radius, uint32_t *member) {
  LibraryArithmetic arithmetic(radius);
  if (const int32_t status = check_results(pores, member == nullptr); status != HSP_OK) return status;
  if (!is_class(*pores, maximum)) return HSP_E_ID;
  if (!hsp::is_finite(radius)) return HSP_E_NOT_FINITE;
  const double level = pores->lattice().steps(radius);
  if (!is_level(*pores, level)) return HSP_E_RANGE;
  *member = pores->builder.tree().class_at(maximum, highest_level(*pores, level, radius));
  return HSP_OK;
}

int32_t hsp_pores_gate_between(const hsp_pores *pores, uint32_t maximum, uint32_t other, uint32_t *gate) {
  if (const int32_t status = check_results(pores, gate == nullptr); status != HSP_OK) return status;
  if (!is_class(*pores, maximum) || !is_class(*pores, other)) return HSP_E_ID;
  *gate = pores->builder.tree().gate_between(maximum, other);
  return HSP_OK;
}

int32_t hsp_pores_locate(const hsp_pores *pores, const double *xyz, hsp_pore_place *place) {
  LibraryArithmetic arithmetic;
  hsp_pore_place_shifts shifts;
  return hsp_pores_locate_with_shifts(pores, xyz, place, &shifts);
}

int32_t hsp_pores_locate_with_shifts(const hsp_pores *pores, const double *xyz, hsp_pore_place *place,
                                     hsp_pore_place_shifts *shifts) {
  LibraryArithmetic arithmetic;
  const int32_t refused = check_results(pores, xyz == nullptr || place == nullptr || shifts == nullptr);
  if (refused != HSP_OK) return refused;
  hsp::PoreLocation found;
  if (const int32_t status = locate(*pores, xyz, found); status != HSP_OK) return status;
  *place = {pores->lattice().length(found.level), found.ball, found.maximum};
  put_shift(pores->image_shift(found.ball, found.ball_shift), shifts->ball);
  put_shift(pores->given(found.maximum_shift), shifts->maximum);
  return HSP_OK;
}

int32_t hsp_pores_widest(const hsp_pores *pores, const double *from, const double *to, hsp_pore_passage *passage) {
  LibraryArithmetic arithmetic;
  const int32_t refused = check_results(pores, from == nullptr || passage == nullptr);
  if (refused != HSP_OK) return refused;
  hsp::exact::Vector start, end;
  int32_t status = round_point(*pores, from, start);
  if (status == HSP_OK && to != nullptr) status = round_point(*pores, to, end);
  if (status != HSP_OK) return status;
  hsp::PorePassage found;
  status = to_c(hsp::find_passage(pores->builder.pores(), pores->balls_around(), start, to == nullptr ? nullptr : &end,
                                  pores->builder.floor(), found));
  if (status != HSP_OK) return status;
  *passage = {pores->lattice().length(found.level),
              found.passes ? 1U : 0U,
              found.gate,
              found.ball,
              {found.ends[0], found.ends[1]},
              0};
  return HSP_OK;
}

int32_t hsp_pores_find_tunnel(hsp_pores *pores, const double *from, const double *to, const uint32_t *avoided,
                              uint32_t count, hsp_tunnel *tunnel, hsp_pores_limits *limits) {
  return find_tunnel(pores, from, to, avoided, count, nullptr, tunnel, limits);
}

int32_t hsp_pores_find_cheapest_tunnel(hsp_pores *pores, const double *from, const double *to, const uint32_t *avoided,
                                       uint32_t count, hsp_tunnel *tunnel, hsp_pores_limits *limits) {
  const hsp_tunnel_request request{sizeof request, 1, nullptr};
  return find_tunnel(pores, from, to, avoided, count, &request, tunnel, limits);
}

int32_t hsp_pores_find_tunnel_with(hsp_pores *pores, const double *from, const double *to, const uint32_t *avoided,
                                   uint32_t count, const hsp_tunnel_request *request, hsp_tunnel *tunnel,
                                   hsp_pores_limits *limits) {
  return find_tunnel(pores, from, to, avoided, count, request, tunnel, limits);
}

int32_t hsp_pores_get_tunnel_route(const hsp_pores *pores, hsp_tunnel_route *route) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(pores, route == nullptr); status != HSP_OK) return status;
  const hsp::TunnelSummary &found = pores->builder.tunnel().summary();
  route->cost = found.cost / pores->lattice().step();
  put_shift(pores->given(found.shift), route->shift);
  route->reserved = 0;
  return HSP_OK;
}

int32_t hsp_pores_get_tunnel_points(const hsp_pores *pores, hsp_tunnel_point *points, uint32_t capacity,
                                    uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return get_list(
      pores, 0, points, capacity, needed, [](const hsp_pores &) { return 1U; },
      [](const hsp_pores &handle) { return handle.builder.tunnel().points(); },
      [pores](const hsp::TunnelPoint &point) {
        hsp_tunnel_point record;
        put_position(*pores, point.position, record.xyz);
        record.radius = pores->lattice().length(point.level);
        for (int b = 0; b < 4; ++b) record.ball[b] = point.ball[b];
        record.gate = point.gate;
        record.maximum = point.maximum;
        return record;
      });
}

int32_t hsp_pores_get_tunnel_point_shifts(const hsp_pores *pores, hsp_tunnel_point_shifts *points, uint32_t capacity,
                                          uint32_t *needed) {
  return get_list(
      pores, 0, points, capacity, needed, [](const hsp_pores &) { return 1U; },
      [](const hsp_pores &handle) { return handle.builder.tunnel().points(); },
      [pores](const hsp::TunnelPoint &point) {
        hsp_tunnel_point_shifts record{};
        for (int b = 0; b < 4; ++b) {
          put_shift(pores->image_shift(point.ball[b], point.copy + point.shift[b].shift()), record.ball + 3 * b);
        }
        const bool is_copy = point.gate != hsp::no_id || point.maximum != hsp::no_id;
        put_shift(is_copy ? pores->given(point.copy) : hsp::BoxShift{}, record.at);
        return record;
      });
}
