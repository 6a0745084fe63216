// hsp_contacts: contacts, shares, groups and simplices, in the caller's order.
//
// As an example the balls of radius 5 at (0,0,0), (6,0,0) and (0,6,0), which make seven simplices:
//   balls 0, 1, 2            each has a face and contacts: HSP_SIMPLEX_REGULAR
//   edges 01, 02, 12         each has an arc, and not its whole circle: HSP_SIMPLEX_REGULAR
//   triangle 012             both ends of its chord are free: HSP_SIMPLEX_SINGULAR
// Balls of a record ascend in the caller's order, whatever that of the grid is.
#include "hsp_contacts.hpp"

#include "compute_from.hpp"

#include "contacts/contacts_check.hpp"
#include "core/summation.hpp"
#include "group_rows.hpp"

using namespace hsp::capi;

namespace {

// The numbers that the header gives the kinds of simplices.
static_assert(static_cast<uint32_t>(hsp::SimplexKind::singular) == HSP_SIMPLEX_SINGULAR);
static_assert(static_cast<uint32_t>(hsp::SimplexKind::regular) == HSP_SIMPLEX_REGULAR);
static_assert(static_cast<uint32_t>(hsp::SimplexKind::interior) == HSP_SIMPLEX_INTERIOR);

hsp_contact record_of(const hsp::BallSet &balls, const hsp::ContactRecord &contact) {
  const auto [first, second] = contact.ball;
  const hsp::Vec3 v = balls.difference(first, second);
  const uint32_t a = balls.caller[first];
  const uint32_t b = balls.caller[second];
  const uint32_t flags = (contact.is_touching() ? HSP_CONTACT_TOUCHING : 0) |
                         (contact.has_arc() || contact.is_circle() ? 0 : HSP_CONTACT_BURIED) |
                         (contact.is_circle() ? HSP_CONTACT_CIRCLE : 0);
  return {balls.lattice.area(contact.area),
          balls.lattice.length(contact.rim),
          balls.lattice.length(std::sqrt(dot(v, v))),
          {a < b ? a : b, a < b ? b : a},
          contact.chords,
          flags,
          {0, 0}};
}

// The balls of a simplex in the caller's order, ascending.
template <uint32_t n>
hsp_simplex to_simplex(const hsp::BallSet &balls, const uint32_t (&ball)[n], hsp::SimplexKind kind) {
  hsp_simplex simplex{{HSP_NONE, HSP_NONE, HSP_NONE, HSP_NONE}, static_cast<uint32_t>(kind), 0};
  for (uint32_t k = 0; k < n; ++k) simplex.ball[k] = balls.caller[ball[k]];
  hsp::sort_ascending(hsp::Span<uint32_t>(simplex.ball, n));
  return simplex;
}

}  // namespace

int32_t hsp_contacts_limits_init(hsp_contacts_limits *limits, uint32_t struct_size, const hsp_boundary *boundary) {
  if (const int32_t status = first_failure(check_handle(boundary), check_struct(limits, struct_size)); status != HSP_OK)
    return status;
  if (!boundary->has_results()) return HSP_E_STATE;
  hsp::ContactLimits defaults;
  const hsp::Status status = hsp::default_limits(boundary->balls().n, boundary->builder.needed().neighbours, defaults);
  if (status == hsp::Status::ok) hsp_contacts::Limits::write(defaults, limits, struct_size);
  return to_c(status);
}

HSP_HANDLE_MEMORY(hsp_contacts);

int32_t hsp_contacts_compute(hsp_contacts *contacts, const hsp_boundary *boundary, hsp_contacts_limits *limits) {
  return hsp_contacts_compute_with(contacts, boundary, nullptr, limits);
}

int32_t hsp_contacts_compute_with(hsp_contacts *contacts, const hsp_boundary *boundary,
                                  const hsp_contacts_request *request, hsp_contacts_limits *limits) {
  return compute_from_boundary(contacts, boundary, request, limits);
}

int32_t hsp_contacts_get_pairs(const hsp_contacts *contacts, hsp_contact *out, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  const int32_t status = check_request(contacts, out, capacity, needed,
                                       [](const hsp_contacts &c) { return c.structure().contact_count(); });
  if (status != HSP_OK) return status;
  const hsp::Contacts &structure = contacts->structure();
  const hsp::BallSet &balls = contacts->balls();
  uint32_t written = 0;
  for (uint32_t i = 0; i < balls.n; ++i) {
    const uint32_t ball = contacts->grid().grid_index(i);
    for (const uint32_t id : structure.row(ball)) {
      const hsp::ContactRecord &contact = structure.contact(id);
      if (balls.given_before(ball, contact.other(ball))) out[written++] = record_of(balls, contact);
    }
  }
  return HSP_OK;
}

int32_t hsp_contacts_get_row(const hsp_contacts *contacts, uint32_t ball, hsp_contact *out, uint32_t capacity,
                             uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(contacts, out == nullptr && capacity > 0); status != HSP_OK) return status;
  if (ball >= contacts->balls().n) return HSP_E_ID;
  const hsp::Span<const uint32_t> row = contacts->structure().row(contacts->grid().grid_index(ball));
  const int32_t status = check_output(capacity, row.size(), needed);
  if (status != HSP_OK) return status;
  const hsp::BallSet &balls = contacts->balls();
  for (uint32_t k = 0; k < row.size(); ++k) out[k] = record_of(balls, contacts->structure().contact(row[k]));
  return HSP_OK;
}

int32_t hsp_contacts_measure(const hsp_contacts *contacts, hsp_totals *totals, double *share_volume,
                             double *contact_area, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(contacts); status != HSP_OK) return status;
  const hsp::BallSet &balls = contacts->balls();
  const bool wanted = share_volume != nullptr || contact_area != nullptr;
  if (!fits(wanted, capacity, balls.n, needed)) return HSP_E_CAPACITY;
  const hsp::Contacts &structure = contacts->structure();
  hsp::TreeSum area, volume;
  for (uint32_t i = 0; i < balls.n; ++i) {
    const uint32_t ball = contacts->grid().grid_index(i);
    area.add(structure.contact_area(ball));
    volume.add(structure.share_volume(ball));
    if (share_volume != nullptr) share_volume[i] = balls.lattice.volume(structure.share_volume(ball));
    if (contact_area != nullptr) contact_area[i] = balls.lattice.area(structure.contact_area(ball));
  }
  // Each contact is counted for both of its balls: hence half of the area.
  if (totals != nullptr)
    *totals = {balls.lattice.area(0.5 * area.total()), balls.lattice.volume(volume.total()), {0, 0}};
  return HSP_OK;
}

int32_t hsp_contacts_group(hsp_contacts *contacts, const uint32_t *group, hsp_group_contact *out, uint32_t capacity,
                           uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(contacts, group == nullptr || (out == nullptr && capacity > 0));
      status != HSP_OK)
    return status;
  const hsp::Contacts &structure = contacts->structure();
  const hsp::ContactGroups groups(contacts->balls(), structure, structure.contact_count(), {group, nullptr},
                                  contacts->builder.scratch());
  return put_groups(groups, contacts->balls().lattice, out, capacity, needed);
}

int32_t hsp_contacts_get_complex(const hsp_contacts *contacts, hsp_complex *counts) {
  if (const int32_t status = check_results(contacts, counts == nullptr); status != HSP_OK) return status;
  const hsp::SimplexCounts &simplices = contacts->structure().simplices();
  const hsp::Boundary &boundary = contacts->boundary->structure();
  *counts = {};
  for (uint32_t d = 0; d < 4; ++d) {
    counts->singular[d] = simplices.of[d][HSP_SIMPLEX_SINGULAR];
    counts->regular[d] = simplices.of[d][HSP_SIMPLEX_REGULAR];
    counts->interior[d] = simplices.of[d][HSP_SIMPLEX_INTERIOR];
  }
  // Components are counted; voids follow by Alexander duality, and the rest from Euler's formula.
  counts->euler = simplices.euler();
  counts->betti[0] = boundary.component_count();
  counts->betti[2] = boundary.shell_count() - boundary.component_count();
  counts->betti[1] = counts->betti[0] + counts->betti[2] - static_cast<uint32_t>(counts->euler);
  return HSP_OK;
}

int32_t hsp_contacts_get_simplices(const hsp_contacts *contacts, uint32_t dimension, hsp_simplex *out,
                                   uint32_t capacity, uint32_t *needed) {
  if (const int32_t status =
          check_results(contacts, (out == nullptr && capacity > 0) || dimension < 2 || dimension > 3);
      status != HSP_OK)
    return status;
  const hsp::Contacts &structure = contacts->structure();
  const uint32_t kept = dimension == 2 ? structure.triangles().size() : structure.tetrahedra().size();
  if (kept < structure.simplices().dimension(dimension)) return HSP_E_STATE;
  const int32_t status = check_output(capacity, kept, needed);
  if (status != HSP_OK) return status;
  const hsp::BallSet &balls = contacts->balls();
  for (uint32_t k = 0; k < kept; ++k) {
    if (dimension == 2) {
      const hsp::TriangleRecord &triangle = structure.triangles()[k];
      out[k] = to_simplex(balls, triangle.ball, triangle.kind());
    } else {
      out[k] = to_simplex(balls, structure.tetrahedra()[k].ball, hsp::SimplexKind::interior);
    }
  }
  return HSP_OK;
}

int32_t hsp_contacts_check(hsp_contacts *contacts, uint32_t *invariant, uint32_t *id) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(contacts, invariant == nullptr || id == nullptr); status != HSP_OK)
    return status;
  const hsp::ContactViolation violation =
      hsp::check_contacts(contacts->balls(), contacts->boundary->structure(), contacts->structure());
  return report(violation, invariant, id);
}
