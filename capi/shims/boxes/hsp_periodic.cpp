#include "hsp_periodic.hpp"

#include "gradient_arrays.hpp"
#include "group_rows.hpp"
#include "model_options.hpp"
#include "periodic/periodic_check.hpp"
#include "periodic/periodic_measures.hpp"
#include "periodic_shifts.hpp"

using namespace hsp::capi;

namespace {

using hsp::PeriodicInvariant;
static_assert(static_cast<uint32_t>(PeriodicInvariant::records) == 1);
static_assert(static_cast<uint32_t>(PeriodicInvariant::closure) == 2);
static_assert(static_cast<uint32_t>(PeriodicInvariant::outside) == 3);
static_assert(static_cast<uint32_t>(PeriodicInvariant::volume) == 4);

hsp_periodic_contact to_c(const hsp::PeriodicUnion &periodic, const hsp::PeriodicContact &contact) {
  const hsp::ContactRecord &record = *contact.record;
  const hsp::exact::Lattice &lattice = periodic.images().lattice();
  const hsp::CubeGrid &grid = periodic.grid();
  const hsp::Vec3 v = grid.balls().difference(grid.grid_index(contact.ball), grid.grid_index(contact.other));
  hsp_periodic_contact result{};
  result.area = lattice.area(record.area);
  result.rim = lattice.length(record.rim);
  result.distance = lattice.length(std::sqrt(dot(v, v)));
  result.ball[0] = contact.ball;
  result.ball[1] = periodic.images().ball_of(contact.other);
  result.chords = record.chords;
  result.flags = (record.is_touching() ? HSP_CONTACT_TOUCHING : 0) |
                 (record.has_arc() || record.is_circle() ? 0 : HSP_CONTACT_BURIED) |
                 (record.is_circle() ? HSP_CONTACT_CIRCLE : 0);
  put_shift(periodic.images().caller_shift(contact.ball, contact.other), result.shift);
  return result;
}

}  // namespace

HSP_HANDLE_BY_BALLS(hsp_periodic);

int32_t hsp_periodic_compute(hsp_periodic *periodic, uint32_t n, const double *xyz, const double *radius,
                             const double *box, const hsp_model_options *options, hsp_periodic_limits *limits,
                             uint32_t *first_bad) {
  hsp_periodic_request request{};
  request.struct_size = sizeof request;
  request.options = options;
  return hsp_periodic_compute_with(periodic, n, xyz, radius, box, &request, limits, first_bad);
}

int32_t hsp_periodic_compute_with(hsp_periodic *periodic, uint32_t n, const double *xyz, const double *radius,
                                  const double *box, const hsp_periodic_request *request, hsp_periodic_limits *limits,
                                  uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(periodic); status != HSP_OK) return name_none(status, first_bad);
  periodic->complete = false;
  uint32_t ignored = 0;
  uint32_t &bad = first_bad != nullptr ? *first_bad : ignored;
  bad = HSP_NONE;
  hsp::BallInput input;
  hsp_periodic_request asked;
  Executor executor(arithmetic);
  if (const int32_t status = first_failure(read_request(request, asked), check_struct(limits)); status != HSP_OK)
    return status;
  if (const int32_t status =
          versions_first(executor.read(asked.executor), get_input(n, xyz, radius, asked.options, input));
      status != HSP_OK)
    return status;
  if (box == nullptr || asked.areas_alone > 1) return HSP_E_ARGUMENT;
  if (n > HSP_MAX_BALLS) return HSP_E_RANGE;
  const hsp::Status status = periodic->builder.build(input, box, executor, asked.areas_alone != 0, bad);
  if (status == hsp::Status::ok) periodic->digest = hsp::digest_of(periodic->builder);
  return finish(*periodic, status, limits);
}

int32_t hsp_periodic_get_counts(const hsp_periodic *periodic, hsp_periodic_counts *counts) {
  if (const int32_t status = check_results(periodic, counts == nullptr); status != HSP_OK) return status;
  const hsp::PeriodicCounts &found = periodic->builder.counts();
  const hsp::PeriodicImages &images = periodic->builder.images();
  *counts = {images.balls(),   images.size() - images.balls(),
             found.vertices,   found.arcs,
             found.circles,    found.loops,
             found.faces,      found.shells,
             found.components, found.contacts,
             found.euler()};
  return HSP_OK;
}

int32_t hsp_periodic_measure(const hsp_periodic *periodic, hsp_periodic_totals *totals, double *area,
                             double *share_volume, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(periodic); status != HSP_OK) return status;
  if (!periodic->has_areas() || (share_volume != nullptr && !periodic->has_results())) return HSP_E_STATE;
  const bool wanted = area != nullptr || share_volume != nullptr;
  if (!fits(wanted, capacity, periodic->balls(), needed)) return HSP_E_CAPACITY;
  const hsp::PeriodicTotals found =
      hsp::measure_periodic(periodic->builder, [&](uint32_t i, const hsp::BallMeasure &own) {
        if (area != nullptr) area[i] = own.area;
        if (share_volume != nullptr) share_volume[i] = own.volume;
      });
  if (totals != nullptr) {
    *totals = {found.area, found.volume, found.box_volume, found.free_volume, found.contact_area};
  }
  return HSP_OK;
}

int32_t hsp_periodic_get_contacts(const hsp_periodic *periodic, hsp_periodic_contact *out, uint32_t capacity,
                                  uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status =
      check_request(periodic, out, capacity, needed, [](const hsp_periodic &p) { return p.builder.counts().contacts; });
  if (status != HSP_OK) return status;
  const hsp::PeriodicUnion &structure = periodic->builder;
  uint32_t written = 0;
  for (uint32_t i = 0; i < periodic->balls(); ++i) {
    const uint32_t first = written;
    structure.visit_contacts_of(i, [&](const hsp::PeriodicContact &contact) {
      if (structure.is_listed(contact)) out[written++] = to_c(structure, contact);
    });
    hsp::sort_in_place(hsp::Span<hsp_periodic_contact>(out + first, written - first),
                       [](const hsp_periodic_contact &p, const hsp_periodic_contact &q) {
                         return p.ball[1] != q.ball[1] ? p.ball[1] < q.ball[1] : shift_comes_before(p.shift, q.shift);
                       });
  }
  return HSP_OK;
}

int32_t hsp_periodic_group_contacts(hsp_periodic *periodic, const uint32_t *group, hsp_group_contact *out,
                                    uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(periodic, group == nullptr || (out == nullptr && capacity > 0));
      status != HSP_OK)
    return status;
  hsp::PeriodicUnion &structure = periodic->builder;
  return put_groups(structure.group_contacts(group), structure.images().lattice(), out, capacity, needed);
}

int32_t hsp_periodic_get_windings(const hsp_periodic *periodic, hsp_winding *out, uint32_t capacity, uint32_t *needed) {
  const int32_t status = check_request(periodic, out, capacity, needed,
                                       [](const hsp_periodic &p) { return p.builder.counts().components; });
  if (status != HSP_OK) return status;
  const hsp::Windings &windings = periodic->builder.windings();
  for (uint32_t c = 0; c < periodic->builder.counts().components; ++c) {
    out[c] = {};
    out[c].first = windings.first_ball(c);
    put_lattice(windings.lattice(c), out[c]);
  }
  for (uint32_t i = 0; i < periodic->balls(); ++i) ++out[windings.component(i)].balls;
  return HSP_OK;
}

int32_t hsp_periodic_get_components(const hsp_periodic *periodic, uint32_t *component, uint32_t capacity,
                                    uint32_t *needed) {
  const int32_t status =
      check_request(periodic, component, capacity, needed, [](const hsp_periodic &p) { return p.balls(); });
  if (status != HSP_OK) return status;
  for (uint32_t i = 0; i < periodic->balls(); ++i) component[i] = periodic->builder.windings().component(i);
  return HSP_OK;
}

int32_t hsp_periodic_get_gradient(const hsp_periodic *periodic, const hsp_gradient_request *request,
                                  hsp_periodic_gradient_outputs *outputs) {
  LibraryArithmetic arithmetic;
  GradientRequest asked(arithmetic);
  hsp_periodic_gradient_outputs out;
  if (const int32_t status = read_parts(periodic, request, asked, outputs, out); status != HSP_OK) return status;
  if (!periodic->has_areas() || (asked.given.pressure != 0.0 && !periodic->has_results())) return HSP_E_STATE;
  const GradientArrays arrays{out.d_centre, out.d_radius, out.flags, out.area};
  if (const int32_t status = asked.check(periodic->balls(), arrays.any(), *outputs); status != HSP_OK) return status;

  const hsp::PeriodicUnion &structure = periodic->builder;
  hsp::EnergyTerms terms = asked.terms();
  terms.weights = hsp::weights_in_box(structure, asked.given.sigma, terms.weights.touching_balls);
  hsp::Energy found;
  if (!hsp::differentiate_in_box(asked.executor, structure, terms, found,
                                 [&](uint32_t i, const hsp::EnergyGradient &gradient) {
                                   arrays.put(i, gradient, structure.images().lattice());
                                 }))
    return asked.executor.status();
  if (out.flags != nullptr) hsp::flag_free_inner_contacts_in_box(structure, HSP_GRADIENT_ONE_SIDED, out.flags);
  if (out.energy != nullptr) *out.energy = to_c(found);
  if (out.d_strain == nullptr && out.d_box == nullptr) return HSP_OK;
  put_box_gradient(hsp::differentiate_by_box(structure, terms), out.d_strain, out.d_box);
  return HSP_OK;
}

int32_t hsp_periodic_check(hsp_periodic *periodic, uint32_t *invariant, uint32_t *id) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(periodic, invariant == nullptr || id == nullptr); status != HSP_OK)
    return status;
  return report(hsp::check_periodic(periodic->builder), invariant, id);
}
