// Contacts, shares and curvatures of any set: the library's check of itself, rows, groups and simplices against all
// contacts, areas and volumes against the boundary, the same twice and in any order, and limits that are too small.
#include <cmath>
#include <cstring>
#include <map>
#include <vector>

#include "computed_set.hpp"
#include "required_limits.hpp"
#include "topology_input.hpp"

namespace {

struct Result {
  std::vector<hsp_contact> contacts;
  std::vector<double> share, area;
  hsp_totals totals;
  hsp_complex complex;
  hsp_contacts_limits needed;
};

Result read_result(hsp_contacts *contacts, uint32_t n) {
  Result result{};
  result.contacts = support::all_records<hsp_contact>(
      [contacts](auto... out) { return hsp_contacts_get_pairs(contacts, out...); }, "hsp_contacts_get_pairs");
  result.share.resize(n);
  result.area.resize(n);
  FUZZ_REQUIRE(hsp_contacts_measure(contacts, &result.totals, result.share.data(), result.area.data(), n, nullptr) == 0,
               "hsp_contacts_measure");
  FUZZ_REQUIRE(hsp_contacts_get_complex(contacts, &result.complex) == HSP_OK, "hsp_contacts_get_complex");
  return result;
}

Result result_of(support::OwnedContacts &contacts, const computed &base, bool with_simplices) {
  hsp_contacts_limits limits = support::contacts_limits_for(base.boundary);
  if (with_simplices) limits.triangles = limits.tetrahedra = 1;
  contacts.take(limits);
  contacts.compute([&base](hsp_contacts *handle, hsp_contacts_limits *asked) {
    return hsp_contacts_compute(handle, base.boundary, asked);
  });
  Result result = read_result(contacts.get(), base.n);
  result.needed = contacts.needed();
  return result;
}

void require_laws(hsp_contacts *contacts, const computed &base, const Result &result) {
  uint32_t invariant = 0, id = 0;
  FUZZ_REQUIRE(hsp_contacts_check(contacts, &invariant, &id) == HSP_OK, "hsp_contacts_check");
  const hsp_complex &c = result.complex;
  FUZZ_REQUIRE(2 * int64_t{c.euler} == base.counts.euler, "Euler characteristics");
  FUZZ_REQUIRE(c.betti[0] == base.counts.components && c.betti[2] == base.counts.voids, "Betti numbers");
  FUZZ_REQUIRE(c.betti[1] < UINT32_C(0x80000000), "tunnels");
  FUZZ_REQUIRE(c.regular[2] + 2 * c.singular[2] == base.counts.vertices, "triangles and vertices");
  FUZZ_REQUIRE(c.singular[1] == base.counts.circles, "edges and circles");
  FUZZ_REQUIRE(c.singular[1] + c.regular[1] + c.interior[1] == result.contacts.size(), "edges and contacts");
  double size = 1.0;
  for (uint32_t i = 0; i < base.n; ++i) size += std::fabs(result.share[i]) + std::fabs(base.volume[i]);
  FUZZ_REQUIRE(std::fabs(result.totals.volume - base.totals.volume) <= 1e-9 * size, "volume of the shares");

  // The rows must be all contacts, each once for each of its two balls.
  std::vector<std::vector<hsp_contact>> rows(base.n);
  for (const hsp_contact &contact : result.contacts) {
    FUZZ_REQUIRE(contact.ball[0] < contact.ball[1] && contact.ball[1] < base.n, "balls of a contact");
    FUZZ_REQUIRE(contact.area >= 0.0 && contact.rim >= 0.0 && contact.distance > 0.0, "numbers of a contact");
    for (const uint32_t ball : contact.ball) rows[ball].push_back(contact);
  }
  for (uint32_t i = 0; i < base.n; ++i) {
    const auto row = support::all_records<hsp_contact>(
        [contacts, i](auto... out) { return hsp_contacts_get_row(contacts, i, out...); }, "hsp_contacts_get_row");
    FUZZ_REQUIRE(
        row.size() == rows[i].size() &&
            fuzz::same(row.data(), rows[i].data(), base.counts.balls > 0 ? static_cast<uint32_t>(row.size()) : 0),
        "a row");
  }
}

void require_groups(hsp_contacts *contacts, const Result &result, uint32_t n, fuzz::Bytes &bytes) {
  std::vector<uint32_t> group(n + 1);
  for (uint32_t &g : group) g = bytes.one_in(8) ? HSP_NONE : bytes.below(4);
  std::map<std::pair<uint32_t, uint32_t>, std::pair<uint32_t, double>> expected;
  for (const hsp_contact &contact : result.contacts) {
    const uint32_t a = group[contact.ball[0]], b = group[contact.ball[1]];
    if (a == b || a == HSP_NONE || b == HSP_NONE) continue;
    auto &[count, area] = expected[std::minmax(a, b)];
    ++count;
    area += contact.area;
  }
  const auto sums = support::all_records<hsp_group_contact>(
      [&](auto... out) { return hsp_contacts_group(contacts, group.data(), out...); }, "hsp_contacts_group");
  FUZZ_REQUIRE(sums.size() == expected.size(), "number of pairs of groups");
  size_t k = 0;
  for (const auto &[pair, sum] : expected) {
    const hsp_group_contact &found = sums[k++];
    FUZZ_REQUIRE(found.group[0] == pair.first && found.group[1] == pair.second, "a pair of groups");
    FUZZ_REQUIRE(found.contacts == sum.first && fuzz::close(found.area, sum.second), "the sum of a pair of groups");
  }
}

void require_simplices(hsp_contacts *contacts, const Result &result) {
  for (uint32_t d = 2; d < 4; ++d) {
    uint32_t kinds[3] = {0, 0, 0};
    const auto simplices = support::all_records<hsp_simplex>(
        [contacts, d](auto... out) { return hsp_contacts_get_simplices(contacts, d, out...); },
        "hsp_contacts_get_simplices");
    for (const hsp_simplex &simplex : simplices) {
      ++kinds[simplex.kind];
      for (uint32_t k = 0; k < d; ++k) FUZZ_REQUIRE(simplex.ball[k] < simplex.ball[k + 1], "balls of a simplex");
    }
    const hsp_complex &c = result.complex;
    FUZZ_REQUIRE(kinds[0] == c.singular[d] && kinds[1] == c.regular[d] && kinds[2] == c.interior[d], "simplices");
  }
}

#if HSP_HAS_CURVATURE
void require_curvature(const computed &base, fuzz::Bytes &bytes) {
  hsp_curvatures totals{};
  std::vector<double> mean(base.n), centre(3 * size_t{base.n}), by_radius(base.n), sigma(base.n), area(base.n);
  std::vector<double> measured(base.n);
  std::vector<int32_t> thirds(base.n);
  FUZZ_REQUIRE(hsp_boundary_curvature(base.boundary, &totals, mean.data(), thirds.data(), base.n, nullptr) == HSP_OK,
               "hsp_boundary_curvature");
  int64_t sum = 0;
  bool finite = std::isfinite(totals.mean);
  for (uint32_t i = 0; i < base.n; ++i) {
    sum += thirds[i];
    finite = finite && std::isfinite(mean[i]);
    sigma[i] = bytes.below(5);
  }
  FUZZ_REQUIRE(finite, "a mean curvature that is no number");
  FUZZ_REQUIRE(sum == 6 * base.counts.euler, "Gauss-Bonnet");
  hsp_morphometry_request factors{};
  factors.struct_size = sizeof factors;
  factors.pressure = 1;
  factors.tension = 1;
  factors.bending = 1;
  factors.gaussian = 1;
  factors.sigma = sigma.data();
  hsp_morphometric_energy energy{};
  hsp_morphometry_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = base.n;
  outputs.energy = &energy;
  outputs.d_centre = centre.data();
  outputs.d_radius = by_radius.data();
  outputs.area = area.data();
  FUZZ_REQUIRE(hsp_boundary_get_morphometry(base.boundary, &factors, &outputs) == HSP_OK,
               "hsp_boundary_get_morphometry");
  FUZZ_REQUIRE(
      hsp_boundary_measure(base.boundary, nullptr, nullptr, measured.data(), nullptr, base.n, nullptr) == HSP_OK,
      "hsp_boundary_measure");
  FUZZ_REQUIRE(area == measured, "areas beside curvatures");
  finite = std::isfinite(energy.value);
  for (const double x : centre) finite = finite && std::isfinite(x);
  for (const double x : by_radius) finite = finite && std::isfinite(x);
  FUZZ_REQUIRE(finite, "a derivative that is no number");
}
#endif

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const fuzz::ScaledBalls set = fuzz::topology_set(bytes);
  const fuzz::ComputedSet base(set);
  support::OwnedContacts contacts;
  const Result reference = result_of(contacts, base.get(), true);
  require_laws(contacts.get(), base.get(), reference);
  require_groups(contacts.get(), reference, set.n(), bytes);
  require_simplices(contacts.get(), reference);
#if HSP_HAS_CURVATURE
  require_curvature(base.get(), bytes);
#endif

  const Result plain = result_of(contacts, base.get(), false);
  FUZZ_REQUIRE(
      plain.contacts.size() == reference.contacts.size() &&
          fuzz::same(plain.contacts.data(), reference.contacts.data(), static_cast<uint32_t>(plain.contacts.size())),
      "contacts differ without simplices");
  fuzz::require_limits<support::ContactsKind>(
      plain.needed, bytes,
      [&](hsp_contacts *handle, hsp_contacts_limits *limits) {
        return hsp_contacts_compute(handle, base.get().boundary, limits);
      },
      [&](hsp_contacts *handle) {
        hsp_totals totals{};
        const int32_t status = hsp_contacts_measure(handle, &totals, nullptr, nullptr, 0, nullptr);
        if (status == HSP_OK)
          FUZZ_REQUIRE(std::memcmp(&totals, &plain.totals, sizeof totals) == 0, "totals differ with more room");
        return status;
      });

  const std::vector<uint32_t> order = fuzz::shuffled(set.n(), bytes);
  const fuzz::ComputedSet other(fuzz::permuted(set, order));
  const Result mixed = result_of(contacts, other.get(), false);
  // Equal balls differ by their order alone, so results may be exchanged between them.
  bool distinct = true;
  for (uint32_t i = 0; i < set.n(); ++i)
    for (uint32_t k = 0; k < i; ++k) distinct = distinct && set.balls[i] != set.balls[k];
  for (uint32_t k = 0; distinct && k < set.n(); ++k) {
    FUZZ_REQUIRE(mixed.share[k] == reference.share[order[k]], "a share depends on the order of the balls");
    FUZZ_REQUIRE(mixed.area[k] == reference.area[order[k]], "an area depends on the order of the balls");
  }
  FUZZ_REQUIRE(std::memcmp(&mixed.complex, &reference.complex, sizeof mixed.complex) == 0,
               "the complex depends on the order of the balls");
  return 0;
}
