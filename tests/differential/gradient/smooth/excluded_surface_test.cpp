// Gradients of the smooth surface's area and volume, and of its balls' shares of the area with weights, against
// difference quotients of the library's own, which differential_measure_smooth_excluded_surface holds against lines:
// molecules, and sets at random that meet themselves.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

#include "difference_quotients.hpp"
#include "molecule_file.hpp"
#include "owned_handle.hpp"
#include "owned_surfaces.hpp"
#include "random_numbers.hpp"
#include "sweep_length.hpp"

namespace {

// A model with its surface; the lattice is fine enough for differences.
class SmoothSurface {
 public:
  SmoothSurface(const support::BallList &list, double probe) : model_(list.size()), n_(list.size()) {
    hsp_model_options options;
    support::expect_ok(hsp_model_options_init(&options, sizeof options), "hsp_model_options_init");
    options.probe = probe;
    options.step = std::ldexp(1.0, -27);
    support::expect_ok(model_.set(list, &options), "hsp_model_set");
    boundary_.take(support::default_boundary_limits(list.size()));
    boundary_.compute([&](hsp_boundary *handle, hsp_boundary_limits *limits) {
      return hsp_boundary_compute(handle, model_.get(), limits);
    });
    surface_.take(support::surface_limits_for(boundary_.get()));
    surface_.compute([&](hsp_surface *handle, hsp_surface_limits *limits) {
      return hsp_surface_compute(handle, boundary_.get(), limits);
    });
  }

  [[nodiscard]] hsp_surface_totals totals() const {
    hsp_surface_totals totals;
    support::expect_ok(hsp_surface_measure(surface_.get(), &totals, nullptr, 0, nullptr), "hsp_surface_measure");
    return totals;
  }
  // The shares of the balls, times weights.
  [[nodiscard]] double weighted_area(const std::vector<double> &sigma) const {
    std::vector<hsp_surface_totals> balls(n_);
    support::expect_ok(hsp_surface_measure(surface_.get(), nullptr, balls.data(), n_, nullptr), "hsp_surface_measure");
    double sum = 0;
    for (uint32_t i = 0; i < n_; ++i) sum += sigma[i] * balls[i].area;
    return sum;
  }
  [[nodiscard]] hsp_surface_counts counts() const {
    hsp_surface_counts counts;
    support::expect_ok(hsp_surface_get_counts(surface_.get(), &counts), "hsp_surface_get_counts");
    return counts;
  }

  struct Gradient {
    hsp_energy energy;
    std::vector<double> centre, radius;
    std::vector<uint32_t> flags;
  };
  [[nodiscard]] Gradient gradient(double tension, double pressure) const {
    return gradient(nullptr, tension, pressure);
  }
  // Of the weighted area.
  [[nodiscard]] Gradient gradient(const std::vector<double> &sigma) const { return gradient(sigma.data(), 1, 0); }

 private:
  [[nodiscard]] Gradient gradient(const double *sigma, double tension, double pressure) const {
    Gradient g = empty_gradient();
    hsp_gradient_request request{};
    request.struct_size = sizeof request;
    request.tangency = HSP_TANGENT_OVERLAP;
    request.tension = tension;
    request.pressure = pressure;
    request.sigma = sigma;
    hsp_gradient_outputs outputs{};
    outputs.struct_size = sizeof outputs;
    outputs.capacity = n_;
    outputs.energy = &g.energy;
    outputs.d_centre = g.centre.data();
    outputs.d_radius = g.radius.data();
    outputs.flags = g.flags.data();
    support::expect_ok(hsp_surface_get_gradient(surface_.get(), &request, &outputs), "hsp_surface_get_gradient");
    return g;
  }
  [[nodiscard]] Gradient empty_gradient() const {
    return {{}, std::vector<double>(3 * size_t{n_}), std::vector<double>(n_), std::vector<uint32_t>(n_)};
  }

  support::OwnedModel model_;
  support::OwnedBoundary boundary_;
  support::OwnedSurface surface_;
  uint32_t n_;
};

// A number of a set: x, y, z and radius of the balls, then the probe.
struct Set {
  support::BallList balls;
  double probe = 0;

  [[nodiscard]] size_t numbers() const { return 4 * size_t{balls.size()} + 1; }
  double &number(size_t k) {
    if (k == 4 * size_t{balls.size()}) return probe;
    return k % 4 < 3 ? balls.xyz[k / 4 * 3 + k % 4] : balls.radius[k / 4];
  }
};
double component(const SmoothSurface::Gradient &g, size_t k) {
  if (k == 4 * g.radius.size()) return g.energy.d_probe;
  return k % 4 < 3 ? g.centre[k / 4 * 3 + k % 4] : g.radius[k / 4];
}

struct Tally {
  uint32_t compared = 0, uncertain = 0, weighted_uncertain = 0;
};
std::ostream &operator<<(std::ostream &out, const Tally &tally) {
  return out << tally.compared << " compared, " << tally.uncertain << " uncertain, with weights "
             << tally.weighted_uncertain;
}

// The common part of the balls is not smooth where arcs and vertices are born: its quotients converge less often.
struct Gradients {
  SmoothSurface::Gradient area, volume, weighted;
  std::vector<double> sigma;

  Gradients(const SmoothSurface &surface, std::vector<double> weights)
      : area(surface.gradient(1, 0)),
        volume(surface.gradient(0, 1)),
        weighted(surface.gradient(weights)),
        sigma(std::move(weights)) {}
};

bool same_counts(const hsp_surface_counts &a, const hsp_surface_counts &b) {
  return a.convex_patches == b.convex_patches && a.saddle_patches == b.saddle_patches &&
         a.concave_patches == b.concave_patches && a.cusped_patches == b.cusped_patches &&
         a.cut_patches == b.cut_patches && a.hidden_patches == b.hidden_patches;
}

// Where a patch, a cusp or a cut is born within the steps a quotient is uncertain. The counts say so; its own error
// does as a rule, not always: of four steps the three widest may contain the birth.
void expect_derivative(const Set &set, const Gradients &found, size_t k, Tally &tally) {
  const SmoothSurface::Gradient &area = found.area, &volume = found.volume;
  constexpr double widest = 0x1p-10;
  const hsp_surface_counts counts = SmoothSurface(set.balls, set.probe).counts();
  bool same = true;
  std::array<long double, quotient_levels> of_area{}, of_volume{}, of_weighted{};
  for (size_t level = 0; level < quotient_levels; ++level) {
    hsp_surface_totals at[2];
    double weighted[2];
    for (int side = 0; side < 2; ++side) {
      Set moved = set;
      moved.number(k) += std::ldexp(side == 0 ? widest : -widest, -static_cast<int>(level));
      const SmoothSurface surface(moved.balls, moved.probe);
      at[side] = surface.totals();
      weighted[side] = surface.weighted_area(found.sigma);
      same = same && same_counts(surface.counts(), counts);
    }
    of_area[level] = at[0].area - at[1].area;
    of_volume[level] = at[0].volume - at[1].volume;
    of_weighted[level] = weighted[0] - weighted[1];
  }
  const double noise_of_area = 1e-14 * area.energy.area, noise_of_volume = 1e-14 * volume.energy.volume;
  const DifferenceQuotient by_area = extrapolated_quotient(of_area, widest, noise_of_area);
  const DifferenceQuotient by_volume = extrapolated_quotient(of_volume, widest, noise_of_volume);
  const DifferenceQuotient by_weighted = extrapolated_quotient(of_weighted, widest, noise_of_area);
  ++tally.compared;
  if (!same || by_weighted.error > 1e-4) {
    ++tally.weighted_uncertain;
  } else if (found.weighted.flags[k / 4 < found.sigma.size() ? k / 4 : 0] == 0) {
    EXPECT_NEAR(component(found.weighted, k), static_cast<double>(by_weighted.value),
                2 * static_cast<double>(by_weighted.error) + 1e-7);
  }
  if (!same || by_area.error > 1e-5 || by_volume.error > 1e-5) {
    ++tally.uncertain;
    return;
  }
  EXPECT_NEAR(component(area, k), static_cast<double>(by_area.value), static_cast<double>(by_area.error) + 1e-8);
  EXPECT_NEAR(component(volume, k), static_cast<double>(by_volume.value), static_cast<double>(by_volume.error) + 1e-8);
}

// Sums over the balls: translation, rotation, magnification; and dV/dt = -A.
void expect_sums(Set set, const SmoothSurface::Gradient &area, const SmoothSurface::Gradient &volume) {
  for (const SmoothSurface::Gradient *g : {&area, &volume}) {
    double force[3]{}, torque[3]{}, growth = set.probe * g->energy.d_probe;
    for (size_t i = 0; i < g->radius.size(); ++i) {
      const double *const c = &set.balls.xyz[3 * i];
      const double *const d = &g->centre[3 * i];
      for (size_t axis = 0; axis < 3; ++axis) {
        force[axis] += d[axis];
        torque[axis] += c[(axis + 1) % 3] * d[(axis + 2) % 3] - c[(axis + 2) % 3] * d[(axis + 1) % 3];
        growth += c[axis] * d[axis];
      }
      growth += set.balls.radius[i] * g->radius[i];
    }
    const double wanted = g == &area ? 2 * area.energy.area : 3 * volume.energy.volume;
    // Coordinates are rounded to the lattice.
    EXPECT_NEAR(growth, wanted, 1e-8 * wanted);
    for (size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(force[axis], 0, 1e-12 * wanted);
      EXPECT_NEAR(torque[axis], 0, 1e-8 * wanted);
    }
  }
  double by_radii = 0;
  for (const double d : volume.radius) by_radii += d;
  EXPECT_NEAR(volume.energy.d_probe, by_radii - volume.energy.area, 1e-11 * volume.energy.area);
}

void expect_gradient(const Set &set, size_t chosen, support::Random &random, Tally &tally) {
  const SmoothSurface surface(set.balls, set.probe);
  std::vector<double> sigma(set.balls.size());
  for (double &weight : sigma) weight = 3 * random.fraction() - 1;
  const Gradients found(surface, sigma);
  expect_sums(set, found.area, found.volume);
  EXPECT_NEAR(found.weighted.energy.value, surface.weighted_area(sigma), 1e-12 * found.area.energy.area);
  expect_derivative(set, found, set.numbers() - 1, tally);
  for (size_t k = 0; k < chosen; ++k) {
    const size_t number = random.below(static_cast<uint32_t>(set.numbers() - 1));
    if (found.area.flags[number / 4] != 0) continue;
    expect_derivative(set, found, number, tally);
  }
}

// Of few sets too many may be uncertain.
void expect_nearly_all_certain(const Tally &tally) {
  if (oracle::emulated) return;
  EXPECT_LT(5 * tally.uncertain, tally.compared);
  EXPECT_LT(3 * tally.weighted_uncertain, tally.compared);
}

// In general position, as files have three decimals: every coordinate moved by less.
Set molecule(const std::filesystem::path &file, double probe, support::Random &random,
             support::Records records = support::Records::all) {
  Set set{support::with_radii(support::read_atoms(file, records), support::Radii::van_der_waals), probe};
  for (double &coordinate : set.balls.xyz) coordinate += 1e-3 * (random.fraction() - 0.5);
  return set;
}

TEST(SurfaceGradient, OfMolecules) {
  support::Random random(16);
  Tally tally;
  for (const char *name : {"caffeine.pdb", "crambin.pdb"}) {
    for (const double probe : {1.0, 1.4, 3.0}) {
      SCOPED_TRACE(name);
      const Set set = molecule(support::own_molecule(name), probe, random);
      expect_gradient(set, oracle::emulated ? 1 : 15, random, tally);
    }
  }
  std::cout << tally << "\n";
  expect_nearly_all_certain(tally);
}

TEST(SurfaceGradient, OfHaemoglobin) {
  const auto file = support::further_molecule("4hhb.pdb.gz");
  if (!file) GTEST_SKIP() << "no 4hhb.pdb.gz";
  support::Random random(17);
  Tally tally;
  expect_gradient(molecule(*file, 1.4, random, support::Records::protein), 8, random, tally);
  std::cout << tally << "\n";
}

TEST(SurfaceGradient, OfRandomSets) {
  support::Random random(18);
  Tally tally;
  uint32_t cut = 0, cusped = 0;
  for (int round = 0; round < (oracle::emulated ? 4 : 60); ++round) {
    Set set;
    set.probe = 0.8 + 1.5 * random.fraction();
    for (int ball = 0; ball < 8; ++ball) {
      const double x = 6 * random.fraction(), y = 6 * random.fraction(), z = 6 * random.fraction();
      set.balls.add(x, y, z, 0.8 + random.fraction());
    }
    const SmoothSurface surface(set.balls, set.probe);
    cut += surface.counts().cut_patches;
    cusped += surface.counts().cusped_patches;
    SCOPED_TRACE(round);
    expect_gradient(set, 6, random, tally);
    if (HasFailure()) return;
  }
  std::cout << tally << "\n";
  expect_nearly_all_certain(tally);
  if (!oracle::emulated) {
    EXPECT_GT(cut, 60U);
    EXPECT_GT(cusped, 20U);
  }
}

}  // namespace
