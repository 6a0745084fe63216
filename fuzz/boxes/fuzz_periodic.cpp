// Unions in a periodic box. Against each other: the library's check of itself, contacts and neighbours from both sides,
// sums of cells, windings and groups, morphometric energies, second derivatives, records. Against other inputs: the
// same bytes from other images of the balls, other vectors of the box, reversed vectors, exchanged axes; twice
// everything in a box twice as long. Against brute force: points and query balls against all images. And limits that
// are too small.
#include <loops.h>

#include <array>
#include <cmath>
#include <cstring>
#include <set>
#include <vector>

#include "box_records.hpp"
#include "crystal_input.hpp"
#include "owned_boxes.hpp"
#include "required_limits.hpp"

namespace {

using Vectors = fuzz::BoxVectors;

struct Crystal {
  uint32_t n() const { return balls.size(); }
  support::BallList balls;
  Vectors box{};
  hsp_model_options options{};
};

// The box is never thinner than a fifth of the largest radius, so that
// a few balls do not have thousands of images.
Crystal crystal_from(fuzz::Bytes &bytes) {
  Crystal crystal;
  const uint32_t n = bytes.below(5);
  fuzz::StepLengths length(bytes);
  crystal.box = length.box(8, 4);
  for (uint32_t i = 0; i < n; ++i) {
    const double x = length(-8, 8);
    const double y = length(-8, 8);
    const double z = length(-8, 8);
    crystal.balls.add(x, y, z, length(0, 5));
  }
  if (n > 0 && bytes.one_in(4)) {
    crystal.balls.add(crystal.balls.xyz[0], crystal.balls.xyz[1], crystal.balls.xyz[2], crystal.balls.radius[0]);
  }
  crystal.options.struct_size = sizeof crystal.options;
  crystal.options.step = 1.0;
  crystal.options.probe = static_cast<double>(bytes.below(3));
  return crystal;
}

void move_ball(Crystal &crystal, uint32_t i, const std::array<int, 3> &times) {
  for (size_t axis = 0; axis < 3; ++axis) {
    for (size_t row = 0; row < 3; ++row) {
      crystal.balls.xyz[3 * size_t{i} + axis] += times[row] * crystal.box[3 * row + axis];
    }
  }
}

struct Result {
  hsp_periodic_counts counts{};
  hsp_periodic_totals totals{};
  hsp_curvatures curvatures{};
  std::vector<double> area, cell, mean, centre, radius;
  std::vector<int32_t> thirds;
  std::vector<hsp_periodic_contact> contacts;
  std::vector<hsp_winding> windings;
  std::vector<uint32_t> component;
  hsp_energy energy{};
  hsp_morphometric_energy morphometric{};
  std::array<double, 9> strain{}, box{}, curved_strain{}, curved_box{};
  std::vector<double> curved_centre, curved_radius;
  std::vector<uint32_t> curved_flags;
  std::vector<hsp_group_contact> groups;
  std::vector<uint32_t> first, column, block_flags;
  std::vector<double> block;
  hsp_periodic_limits needed{};
};

int32_t compute(hsp_periodic *handle, const Crystal &crystal, hsp_periodic_limits *limits) {
  uint32_t first_bad = 7;
  const int32_t status =
      hsp_periodic_compute(handle, crystal.n(), crystal.balls.xyz.data(), crystal.balls.radius.data(),
                           crystal.box.data(), &crystal.options, limits, &first_bad);
  FUZZ_REQUIRE(first_bad == HSP_NONE, "a ball that is refused");
  return status;
}

// Areas and derivatives computed without the rest, by several threads, must have the same bits.
void require_areas_alone(const Crystal &crystal, const Result &whole, uint32_t workers) {
  loop own = loop_of(LOOP_REVERSED);
  const hsp_executor executor = executor_of(&own, workers);
  hsp_periodic_request request{};
  request.struct_size = sizeof request;
  request.areas_alone = 1;
  request.options = &crystal.options;
  request.executor = &executor;
  hsp_gradient_request energy{};
  energy.struct_size = sizeof energy;
  energy.tangency = HSP_TANGENT_OVERLAP;
  energy.tension = 1;
  const uint32_t n = crystal.n();
  support::OwnedPeriodic periodic;
  hsp_periodic_limits limits{};
  limits.struct_size = sizeof limits;
  periodic.take(limits);
  periodic.compute([&](hsp_periodic *handle, hsp_periodic_limits *asked) {
    return hsp_periodic_compute_with(handle, n, crystal.balls.xyz.data(), crystal.balls.radius.data(),
                                     crystal.box.data(), &request, asked, nullptr);
  });
  std::vector<double> area(n), centre(3 * size_t{n});
  hsp_periodic_totals totals{};
  hsp_energy found{};
  hsp_periodic_gradient_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = n;
  outputs.energy = &found;
  outputs.d_centre = centre.data();
  outputs.area = area.data();
  FUZZ_REQUIRE(hsp_periodic_measure(periodic.get(), &totals, nullptr, nullptr, 0, nullptr) == HSP_OK, "areas alone");
  FUZZ_REQUIRE(hsp_periodic_get_gradient(periodic.get(), &energy, &outputs) == HSP_OK, "gradient of areas alone");
  FUZZ_REQUIRE(totals.area == whole.totals.area && found.area == whole.energy.area, "the area alone");
  FUZZ_REQUIRE(n == 0 || std::memcmp(area.data(), whole.area.data(), n * sizeof(double)) == 0,
               "the bits of areas alone");
}

Result result_of(support::OwnedPeriodic &periodic, const Crystal &crystal) {
  hsp_periodic_limits limits{};
  FUZZ_REQUIRE(hsp_periodic_limits_init(&limits, sizeof limits, crystal.n()) == HSP_OK, "limits");
  periodic.take(limits);
  periodic.compute([&](hsp_periodic *handle, hsp_periodic_limits *asked) { return compute(handle, crystal, asked); });
  hsp_periodic *const p = periodic.get();
  Result result;
  result.needed = periodic.needed();
  const uint32_t n = crystal.n();
  uint32_t invariant = 7, id = 0;
  FUZZ_REQUIRE(hsp_periodic_check(p, &invariant, &id) == HSP_OK && invariant == 0, "hsp_periodic_check");
  FUZZ_REQUIRE(hsp_periodic_get_counts(p, &result.counts) == HSP_OK, "counts");
  result.area.resize(n);
  result.cell.resize(n);
  result.radius.resize(n);
  result.centre.resize(3 * size_t{n});
  FUZZ_REQUIRE(hsp_periodic_measure(p, &result.totals, result.area.data(), result.cell.data(), n, nullptr) == HSP_OK,
               "measures");
  result.mean.resize(n);
  result.thirds.resize(n);
  FUZZ_REQUIRE(
      hsp_periodic_curvature(p, &result.curvatures, result.mean.data(), result.thirds.data(), n, nullptr) == HSP_OK,
      "curvatures");
  result.contacts = support::all_records<hsp_periodic_contact>(
      [p](auto... out) { return hsp_periodic_get_contacts(p, out...); }, "hsp_periodic_get_contacts");
  result.windings = support::all_records<hsp_winding>([p](auto... out) { return hsp_periodic_get_windings(p, out...); },
                                                      "hsp_periodic_get_windings");
  result.component = support::all_records<uint32_t>([p](auto... out) { return hsp_periodic_get_components(p, out...); },
                                                    "hsp_periodic_get_components");
  hsp_gradient_request energy{};
  energy.struct_size = sizeof energy;
  energy.tangency = HSP_TANGENT_OVERLAP;
  energy.tension = 1;
  energy.pressure = 0.5;
  hsp_periodic_gradient_outputs gradient{};
  gradient.struct_size = sizeof gradient;
  gradient.capacity = n;
  gradient.energy = &result.energy;
  gradient.d_centre = result.centre.data();
  gradient.d_radius = result.radius.data();
  gradient.d_strain = result.strain.data();
  gradient.d_box = result.box.data();
  FUZZ_REQUIRE(hsp_periodic_get_gradient(p, &energy, &gradient) == HSP_OK, "gradient");
  result.first.resize(size_t{n} + 1);
  result.block_flags.resize(size_t{n} + 1);
  uint32_t entries = 0;
  const int32_t counted =
      hsp_periodic_get_hessian_rows(p, &energy, result.first.data(), nullptr, nullptr, nullptr, 0, &entries);
  FUZZ_REQUIRE(counted == (entries > 0 ? HSP_E_CAPACITY : HSP_OK), "the number of blocks");
  result.column.resize(entries);
  result.block.resize(9 * size_t{entries});
  FUZZ_REQUIRE(hsp_periodic_get_hessian_rows(p, &energy, result.first.data(), result.column.data(), result.block.data(),
                                             result.block_flags.data(), entries, &entries) == HSP_OK,
               "second derivatives");
  result.curved_radius.resize(n);
  result.curved_centre.resize(3 * size_t{n});
  result.curved_flags.resize(n);
  hsp_morphometry_request bending{};
  bending.struct_size = sizeof bending;
  bending.bending = 1;
  hsp_periodic_morphometry_outputs curved{};
  curved.struct_size = sizeof curved;
  curved.capacity = n;
  curved.energy = &result.morphometric;
  curved.d_centre = result.curved_centre.data();
  curved.d_radius = result.curved_radius.data();
  curved.flags = result.curved_flags.data();
  curved.d_strain = result.curved_strain.data();
  curved.d_box = result.curved_box.data();
  std::vector<double> area(n);
  curved.area = area.data();
  FUZZ_REQUIRE(hsp_periodic_get_morphometry(p, &bending, &curved) == HSP_OK, "morphometric energy");
  FUZZ_REQUIRE(area == result.area, "areas beside curvatures");
  std::vector<uint32_t> group(size_t{n} + 1);
  for (uint32_t i = 0; i < n; ++i) group[i] = i % 3 == 2 ? HSP_NONE : i % 3;
  result.groups = support::all_records<hsp_group_contact>(
      [&](auto... out) { return hsp_periodic_group_contacts(periodic.get(), group.data(), out...); },
      "hsp_periodic_group_contacts");
  return result;
}

// Gradients of the mean curvature may be very steep, and then lose as many digits.
void require_curved_laws(const Crystal &crystal, const Result &result) {
  double sum[3] = {0, 0, 0}, lengths = 0, steepest = 1;
  for (const double x : result.curved_centre) steepest = std::fmax(steepest, std::fabs(x));
  for (uint32_t i = 0; i < crystal.n(); ++i) {
    const double radius = crystal.balls.radius[i] + crystal.options.probe;
    lengths += radius * result.curved_radius[i];
    steepest = std::fmax(steepest, radius * std::fabs(result.curved_radius[i]));
    for (size_t axis = 0; axis < 3; ++axis) sum[axis] += result.curved_centre[3 * size_t{i} + axis];
  }
  for (const double x : result.curved_strain) steepest = std::fmax(steepest, std::fabs(x));
  FUZZ_REQUIRE(std::isfinite(steepest), "the gradient of the mean curvature");
  for (const double x : sum) FUZZ_REQUIRE(std::fabs(x) <= 1e-7 * steepest, "sum of the gradient of the mean curvature");
  for (const double x : result.curved_box) FUZZ_REQUIRE(std::isfinite(x), "the mean curvature by the box");
  for (size_t p = 0; p < 3; ++p) lengths += result.curved_strain[4 * p];
  FUZZ_REQUIRE(std::fabs(result.morphometric.mean - result.curvatures.mean) <= 1e-9 * steepest, "the mean curvature");
  FUZZ_REQUIRE(std::fabs(result.morphometric.mean - lengths) <= 1e-7 * steepest, "lengths of the mean curvature");
  for (const uint32_t flags : result.curved_flags) {
    if (flags != 0) return;
  }
  for (size_t p = 0; p < 3; ++p) {
    for (size_t q = 0; q < p; ++q) {
      const double turning = result.curved_strain[3 * p + q] - result.curved_strain[3 * q + p];
      FUZZ_REQUIRE(std::fabs(turning) <= 1e-7 * steepest, "the mean curvature of what is turned");
    }
  }
}

// Blocks and their transposes have the same bits, and a row sums to 0.
void require_second_derivatives(const Result &result) {
  const size_t n = result.first.size() - 1;
  for (size_t i = 0; i < n; ++i) {
    double sum[9] = {}, magnitude = 1.0;
    for (uint32_t entry = result.first[i]; entry < result.first[i + 1]; ++entry) {
      const uint32_t j = result.column[entry];
      FUZZ_REQUIRE(entry == result.first[i] || result.column[entry - 1] < j, "the order of a row");
      uint32_t back = result.first[j];
      while (back < result.first[j + 1] && result.column[back] != i) ++back;
      FUZZ_REQUIRE(back < result.first[j + 1], "a block from one side alone");
      for (size_t k = 0; k < 9; ++k) {
        const double x = result.block[9 * size_t{entry} + k];
        FUZZ_REQUIRE(std::isfinite(x), "a second derivative");
        FUZZ_REQUIRE(std::memcmp(&x, &result.block[9 * size_t{back} + 3 * (k % 3) + k / 3], sizeof x) == 0,
                     "a block and its transpose");
        sum[k] += x;
        magnitude += std::fabs(x);
      }
    }
    if ((result.block_flags[i] & HSP_HESSIAN_SINGULAR) != 0) continue;
    for (const double x : sum) FUZZ_REQUIRE(std::fabs(x) <= 1e-6 * magnitude, "the sum of a row");
  }
}

// Sums by groups of balls must be the sums over the contacts.
void require_groups(const Result &result) {
  hsp_group_contact sum{};
  for (const hsp_periodic_contact &contact : result.contacts) {
    const uint32_t a = contact.ball[0] % 3, b = contact.ball[1] % 3;
    if (a == b || a == 2 || b == 2) continue;
    sum.area += contact.area;
    sum.rim += contact.rim;
    ++sum.contacts;
  }
  FUZZ_REQUIRE(result.groups.size() == (sum.contacts > 0 ? 1U : 0U), "how many groups are in contact");
  if (sum.contacts == 0) return;
  const hsp_group_contact &found = result.groups[0];
  FUZZ_REQUIRE(found.group[0] == 0 && found.group[1] == 1 && found.contacts == sum.contacts, "two groups");
  FUZZ_REQUIRE(std::fabs(found.area - sum.area) <= 1e-12 * sum.area, "area between groups");
  FUZZ_REQUIRE(std::fabs(found.rim - sum.rim) <= 1e-12 * sum.rim, "edges between groups");
}

void require_laws(const hsp_periodic *periodic, const Crystal &crystal, const Result &result) {
  const hsp_periodic_counts &c = result.counts;
  FUZZ_REQUIRE(c.balls == crystal.n() && c.contacts == result.contacts.size(), "counts of balls and contacts");
  FUZZ_REQUIRE(2 * c.arcs == 3 * c.vertices && c.euler % 2 == 0, "arcs of vertices");
  FUZZ_REQUIRE(c.components == result.windings.size() && c.shells <= c.faces, "counts of components and shells");
  FUZZ_REQUIRE(result.totals.free_volume >= 0.0 && result.totals.volume >= 0.0, "volumes below 0");
  const double size = result.totals.box_volume;
  FUZZ_REQUIRE(std::fabs(result.totals.volume + result.totals.free_volume - size) <= 1e-9 * size, "volume of the box");
  std::vector<uint32_t> balls(c.components);
  for (const uint32_t component : result.component) ++balls[component];
  for (uint32_t k = 0; k < c.components; ++k) {
    const hsp_winding &winding = result.windings[k];
    FUZZ_REQUIRE(winding.balls == balls[k] && winding.directions <= 3 && winding.copies > 0, "a winding");
    FUZZ_REQUIRE(result.component[winding.first] == k, "the first ball of a component");
  }
  int64_t thirds = 0;
  for (const int32_t of_ball : result.thirds) thirds += of_ball;
  FUZZ_REQUIRE(thirds == 6 * int64_t{c.euler}, "Gauss-Bonnet");
  FUZZ_REQUIRE(std::isfinite(result.curvatures.mean), "the mean curvature");
  double sum[3] = {0, 0, 0};
  for (uint32_t i = 0; i < crystal.n(); ++i) {
    FUZZ_REQUIRE(result.area[i] >= 0.0 && result.cell[i] >= 0.0 && std::isfinite(result.radius[i]),
                 "numbers of a ball");
    for (size_t axis = 0; axis < 3; ++axis) sum[axis] += result.centre[3 * size_t{i} + axis];
  }
  for (const double x : sum) FUZZ_REQUIRE(std::fabs(x) <= 1e-6 * (1.0 + size), "sum of the gradient");
  for (size_t k = 0; k < 9; ++k)
    FUZZ_REQUIRE(std::isfinite(result.strain[k]) && std::isfinite(result.box[k]), "a derivative by the box");

  // Contacts are among neighbours, and those are from both sides.
  using Key = std::array<int32_t, 5>;
  std::set<Key> meeting;
  std::vector<uint32_t> first(size_t{crystal.n()} + 1), first_once(first);
  const auto pairs_of = [periodic](uint32_t flags, uint32_t *begins) {
    return support::all_records<hsp_image>(
        [&](auto... out) { return hsp_periodic_query_pairs(periodic, flags, begins, out...); },
        "hsp_periodic_query_pairs");
  };
  const auto pairs = pairs_of(0, first.data());
  const auto once = pairs_of(HSP_PAIRS_ONCE, first_once.data());
  FUZZ_REQUIRE(pairs.size() == first.back() && once.size() == first_once.back() && 2 * once.size() == pairs.size(),
               "how many pairs");
  for (uint32_t i = 0; i < crystal.n(); ++i) {
    const auto row =
        support::all_records<hsp_image>([&](auto... out) { return hsp_periodic_query_neighbours(periodic, i, out...); },
                                        "hsp_periodic_query_neighbours");
    FUZZ_REQUIRE(row.size() == first[i + 1] - first[i], "the length of a row");
    FUZZ_REQUIRE(row.empty() || std::memcmp(row.data(), &pairs[first[i]], row.size() * sizeof(hsp_image)) == 0,
                 "a row of all pairs");
    for (const hsp_image &m : row) {
      const Key key{static_cast<int32_t>(i), static_cast<int32_t>(m.ball), m.shift[0], m.shift[1], m.shift[2]};
      FUZZ_REQUIRE(meeting.insert(key).second, "a neighbour twice");
      FUZZ_REQUIRE(result.component[i] == result.component[m.ball], "neighbours in two components");
    }
  }
  for (const Key &k : meeting)
    FUZZ_REQUIRE(meeting.count({k[1], k[0], -k[2], -k[3], -k[4]}) == 1, "a neighbour from one side alone");
  std::set<Key> once_each;
  for (uint32_t i = 0; i < crystal.n(); ++i) {
    for (uint32_t k = first_once[i]; k < first_once[i + 1]; ++k) {
      const hsp_image &m = once[k];
      const Key key{static_cast<int32_t>(i), static_cast<int32_t>(m.ball), m.shift[0], m.shift[1], m.shift[2]};
      FUZZ_REQUIRE(meeting.count(key) == 1 && once_each.insert(key).second, "a pair that is not there, or twice");
      FUZZ_REQUIRE(once_each.count({key[1], key[0], -key[2], -key[3], -key[4]}) == 0, "a pair from both sides");
    }
  }
  for (const hsp_periodic_contact &contact : result.contacts) {
    const Key key{static_cast<int32_t>(contact.ball[0]), static_cast<int32_t>(contact.ball[1]), contact.shift[0],
                  contact.shift[1], contact.shift[2]};
    FUZZ_REQUIRE(contact.ball[0] <= contact.ball[1] && once_each.count(key) == 1, "a contact without neighbours");
    FUZZ_REQUIRE(contact.area >= 0.0 && contact.rim >= 0.0 && contact.distance > 0.0, "numbers of a contact");
  }
}

bool same_numbers(const std::vector<double> &p, const std::vector<double> &q) {
  return p.size() == q.size() && (p.empty() || std::memcmp(p.data(), q.data(), p.size() * sizeof(double)) == 0);
}

// Everything but shifts.
void require_same(const Result &p, const Result &q) {
  FUZZ_REQUIRE(std::memcmp(&p.counts, &q.counts, sizeof p.counts) == 0, "counts of other images");
  FUZZ_REQUIRE(std::memcmp(&p.totals, &q.totals, sizeof p.totals) == 0, "totals of other images");
  FUZZ_REQUIRE(same_numbers(p.area, q.area) && same_numbers(p.cell, q.cell), "measures of other images");
  FUZZ_REQUIRE(std::memcmp(&p.curvatures, &q.curvatures, sizeof p.curvatures) == 0 && same_numbers(p.mean, q.mean) &&
                   p.thirds == q.thirds,
               "curvatures of other images");
  FUZZ_REQUIRE(same_numbers(p.centre, q.centre) && same_numbers(p.radius, q.radius), "gradients of other images");
  FUZZ_REQUIRE(std::memcmp(&p.energy, &q.energy, sizeof p.energy) == 0, "energies of other images");
  FUZZ_REQUIRE(p.strain == q.strain, "strain of other images");
  FUZZ_REQUIRE(
      p.first == q.first && p.column == q.column && same_numbers(p.block, q.block) && p.block_flags == q.block_flags,
      "second derivatives of other images");
  FUZZ_REQUIRE(std::memcmp(&p.morphometric, &q.morphometric, sizeof p.morphometric) == 0 &&
                   same_numbers(p.curved_centre, q.curved_centre) && same_numbers(p.curved_radius, q.curved_radius) &&
                   p.curved_flags == q.curved_flags && p.curved_strain == q.curved_strain,
               "morphometric energies of other images");
  FUZZ_REQUIRE(p.groups.size() == q.groups.size() &&
                   (p.groups.empty() ||
                    std::memcmp(p.groups.data(), q.groups.data(), p.groups.size() * sizeof p.groups[0]) == 0),
               "groups of other images");
}

// Compared as numbers: a 0 may have another sign.
bool are_turned(const double *v, const double *turned) {
  return turned[1] == v[0] && turned[2] == v[1] && turned[0] == v[2];
}

// With the axes exchanged (x along y, y along z, z along x) all results must be the same, with exchanged axes.
// `crystal` comes back with exchanged axes.
void require_same_turned(Crystal &crystal, const Result &reference) {
  const auto turn = [](double *v) {
    const double last = v[2];
    v[2] = v[1];
    v[1] = v[0];
    v[0] = last;
  };
  for (uint32_t i = 0; i < crystal.n(); ++i) turn(&crystal.balls.xyz[3 * size_t{i}]);
  for (size_t row = 0; row < 3; ++row) turn(&crystal.box[3 * row]);
  support::OwnedPeriodic periodic;
  const Result result = result_of(periodic, crystal);
  FUZZ_REQUIRE(std::memcmp(&result.counts, &reference.counts, sizeof result.counts) == 0, "counts of a turned box");
  FUZZ_REQUIRE(std::memcmp(&result.totals, &reference.totals, sizeof result.totals) == 0, "totals of a turned box");
  FUZZ_REQUIRE(same_numbers(result.area, reference.area) && same_numbers(result.cell, reference.cell) &&
                   same_numbers(result.radius, reference.radius) && same_numbers(result.mean, reference.mean),
               "numbers of balls in a turned box");
  for (size_t i = 0; i < crystal.n(); ++i) {
    FUZZ_REQUIRE(are_turned(&reference.centre[3 * i], &result.centre[3 * i]) &&
                     are_turned(&reference.curved_centre[3 * i], &result.curved_centre[3 * i]),
                 "derivatives by centres in a turned box");
  }
  for (size_t row = 0; row < 3; ++row) {
    FUZZ_REQUIRE(are_turned(&reference.box[3 * row], &result.box[3 * row]) &&
                     are_turned(&reference.strain[3 * row], &result.strain[3 * ((row + 1) % 3)]),
                 "derivatives by a turned box");
  }
  FUZZ_REQUIRE(result.column == reference.column, "second derivatives in a turned box");
  for (size_t entry = 0; entry < result.column.size(); ++entry) {
    for (size_t row = 0; row < 3; ++row) {
      FUZZ_REQUIRE(are_turned(&reference.block[9 * entry + 3 * row], &result.block[9 * entry + 3 * ((row + 1) % 3)]),
                   "blocks in a turned box");
    }
  }
  require_laws(periodic.get(), crystal, result);
}

// The records of the boundary against each other and against the balls.
support::BoxRecords require_records(const hsp_periodic *periodic, const support::BoxedBalls &set) {
  support::BoxRecords records(periodic);
  const support::BoxReader reader(set, records);
  FUZZ_REQUIRE(reader.problem().empty(), reader.problem().c_str());
  return records;
}

// With the probe.
support::BoxedBalls boxed(const Crystal &crystal) {
  support::BoxedBalls set{crystal.balls, crystal.box};
  for (double &r : set.balls.radius) r += crystal.options.probe;
  return set;
}

// All balls that meet a query ball, or hold a point.
void require_hits(const hsp_periodic *periodic, const Crystal &crystal, fuzz::Bytes &bytes) {
  double at[3];
  for (double &x : at) x = static_cast<double>(bytes.below(40)) - 20.0;
  const double radius = static_cast<double>(bytes.below(14));
  const auto found = support::all_records<hsp_image>(
      [&](auto... out) {
        return radius == 0.0 ? hsp_periodic_query_point(periodic, at, out...)
                             : hsp_periodic_query_ball(periodic, at, radius, out...);
      },
      "hsp_periodic_query_ball");
  std::vector<std::array<int64_t, 4>> expected;
  for (uint32_t i = 0; i < crystal.n(); ++i) {
    const double *const xyz = &crystal.balls.xyz[3 * size_t{i}];
    const double r = crystal.balls.radius[i] + crystal.options.probe + radius;
    // In a box that leans, multiples of c move images sideways, so far multiples of a or b can be near again.
    const double high = std::ceil((r + std::fabs(at[2] - xyz[2])) / crystal.box[8]);
    for (double c = -high; c <= high; ++c) {
      const double y = xyz[1] + c * crystal.box[7] - at[1];
      const double z = xyz[2] + c * crystal.box[8] - at[2];
      for (double b = std::floor((-y - r) / crystal.box[4]); b <= std::ceil((-y + r) / crystal.box[4]); ++b) {
        const double x = xyz[0] + c * crystal.box[6] + b * crystal.box[3] - at[0];
        const double yy = y + b * crystal.box[4];
        for (double a = std::floor((-x - r) / crystal.box[0]); a <= std::ceil((-x + r) / crystal.box[0]); ++a) {
          const double xx = x + a * crystal.box[0];
          if (xx * xx + yy * yy + z * z <= r * r)
            expected.push_back({i, static_cast<int64_t>(a), static_cast<int64_t>(b), static_cast<int64_t>(c)});
        }
      }
    }
  }
  std::sort(expected.begin(), expected.end());
  FUZZ_REQUIRE(found.size() == expected.size(), "how many balls meet a ball");
  for (size_t k = 0; k < found.size(); ++k) {
    const std::array<int64_t, 4> hit{found[k].ball, found[k].shift[0], found[k].shift[1], found[k].shift[2]};
    FUZZ_REQUIRE(hit == expected[k], "which balls meet a ball");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const Crystal crystal = crystal_from(bytes);
  support::OwnedPeriodic periodic;
  const Result reference = result_of(periodic, crystal);
  require_laws(periodic.get(), crystal, reference);
  require_curved_laws(crystal, reference);
  require_groups(reference);
  require_second_derivatives(reference);
  for (int k = 0; k < 3; ++k) require_hits(periodic.get(), crystal, bytes);

  Crystal moved = crystal;
  for (uint32_t i = 0; i < crystal.n(); ++i) {
    std::array<int, 3> times{};
    for (int &t : times) t = static_cast<int>(bytes.below(9)) - 4;
    move_ball(moved, i, times);
  }
  support::OwnedPeriodic other;
  const Result of_images = result_of(other, moved);
  require_same(reference, of_images);
  const support::BoxedBalls set = boxed(crystal), moved_set = boxed(moved);
  const support::BoxRecords records = require_records(periodic.get(), set);
  const auto require_same_records = [&](const support::BoxedBalls &as, const support::BoxRecords &same) {
    const std::string difference = support::difference_of_records(set, records, as, same);
    FUZZ_REQUIRE(difference.empty(), difference.c_str());
  };
  require_same_records(moved_set, require_records(other.get(), moved_set));
  FUZZ_REQUIRE(reference.box == of_images.box, "derivatives by the box from other images");
  Crystal leaning = crystal;
  const int lean = static_cast<int>(bytes.below(5)) - 2;
  for (size_t axis = 0; axis < 3; ++axis) leaning.box[6 + axis] += lean * crystal.box[axis] + crystal.box[3 + axis];
  require_same(reference, result_of(other, leaning));
  const support::BoxedBalls leaning_set = boxed(leaning);
  require_same_records(leaning_set, require_records(other.get(), leaning_set));

  // Vectors that point to the other side.
  Crystal reversed = crystal;
  const uint32_t sides = bytes.below(8);
  for (size_t k = 0; k < 9; ++k) reversed.box[k] *= (sides >> (k / 3) & 1) != 0 ? -1 : 1;
  const Result of_reversed = result_of(other, reversed);
  require_same(reference, of_reversed);
  for (size_t k = 0; k < 9; ++k) {
    const double side = (sides >> (k / 3) & 1) != 0 ? -1 : 1;
    FUZZ_REQUIRE(of_reversed.box[k] == side * reference.box[k], "derivatives by reversed vectors");
  }
  Crystal turned = crystal;
  require_same_turned(turned, reference);

  // Twice as long along one vector, with every ball and a copy of it.
  const size_t row = bytes.below(3);
  Crystal twice = crystal;
  for (uint32_t i = 0; i < crystal.n(); ++i) {
    const double *const xyz = &crystal.balls.xyz[3 * size_t{i}];
    const double *const v = &crystal.box[3 * row];
    twice.balls.add(xyz[0] + v[0], xyz[1] + v[1], xyz[2] + v[2], crystal.balls.radius[i]);
  }
  for (size_t axis = 0; axis < 3; ++axis) twice.box[3 * row + axis] *= 2;
  const Result doubled = result_of(other, twice);
  FUZZ_REQUIRE(
      doubled.counts.vertices == 2 * reference.counts.vertices && doubled.counts.euler == 2 * reference.counts.euler,
      "the boundary in twice the box");
  FUZZ_REQUIRE(doubled.counts.contacts == 2 * reference.counts.contacts, "contacts in twice the box");
  const double scale = reference.totals.box_volume;
  FUZZ_REQUIRE(std::fabs(doubled.totals.volume - 2 * reference.totals.volume) <= 1e-9 * scale,
               "volume in twice the box");
  for (uint32_t i = 0; i < crystal.n(); ++i) {
    FUZZ_REQUIRE(
        doubled.windings[doubled.component[i]].directions == reference.windings[reference.component[i]].directions,
        "directions in twice the box");
  }

  fuzz::require_limits<support::PeriodicKind>(
      reference.needed, bytes,
      [&](hsp_periodic *handle, hsp_periodic_limits *limits) { return compute(handle, crystal, limits); },
      [&](hsp_periodic *handle) {
        hsp_periodic_totals totals{};
        const int32_t status = hsp_periodic_measure(handle, &totals, nullptr, nullptr, 0, nullptr);
        if (status == HSP_OK)
          FUZZ_REQUIRE(std::memcmp(&totals, &reference.totals, sizeof totals) == 0, "totals with more room");
        return status;
      });
  require_areas_alone(crystal, reference, bytes.below(4));
  return 0;
}
