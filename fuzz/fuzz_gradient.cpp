// Derivatives and parts of areas: the numbered properties of hsp_boundary_gradient and hsp_boundary_get_area_row, rows
// against the gradient, faces against balls, selected balls against all, and no effect of the order.
#include "computed_set.hpp"
#include "guarded_output.hpp"

namespace {

// A gradient and how large the numbers are that enter it.
struct Gradient {
  hsp_energy energy{};
  std::vector<double> centre, radius;
  std::vector<uint32_t> flags;

  Gradient(const computed &c, const double *sigma, double tension, double pressure, uint32_t tangency)
      : centre(3 * size_t{c.n} + 1), radius(c.n + 1), flags(c.n + 1) {
    const int32_t status = hsp_boundary_gradient(c.boundary, sigma, tension, pressure, tangency, &energy, centre.data(),
                                                 radius.data(), flags.data(), c.n);
    FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
    for (const double x : centre) FUZZ_REQUIRE(std::isfinite(x), "dE/dc is not finite");
    for (const double x : radius) FUZZ_REQUIRE(std::isfinite(x), "dE/dr is not finite");
    for (const uint32_t x : flags) FUZZ_REQUIRE(x <= HSP_GRADIENT_ONE_SIDED, "unknown flags");
  }
};

// What roundings are measured by: the lengths, areas and derivatives that sums are made of.
struct Scale {
  double length = 1e-300, derivative = 1e-300;

  Scale(const computed &c, const Gradient &g) {
    for (uint32_t i = 0; i < c.n; ++i) {
      for (size_t k = 0; k < 3; ++k) {
        length = std::max(length, std::fabs(c.xyz[3 * i + k]));
        derivative += std::fabs(g.centre[3 * i + k]);
      }
      length = std::max(length, c.radius[i]);
      derivative += std::fabs(g.radius[i]);
    }
  }
};

// hsp_boundary_gradient, properties 1 and 2, and the energy against hsp_boundary_measure.
void require_laws(const computed &c, const std::vector<double> *sigma, double tension, double pressure,
                  uint32_t tangency) {
  const Gradient g(c, sigma == nullptr ? nullptr : sigma->data(), tension, pressure, tangency);
  const Scale scale(c, g);
  double sum[3] = {}, torque[3] = {}, dilation = 0, probe = 0, area = 0, absolute = 0;
  for (uint32_t i = 0; i < c.n; ++i) {
    const double *x = c.xyz + 3 * size_t{i}, *f = g.centre.data() + 3 * size_t{i};
    for (size_t k = 0; k < 3; ++k) {
      sum[k] += f[k];
      torque[k] += x[(k + 1) % 3] * f[(k + 2) % 3] - x[(k + 2) % 3] * f[(k + 1) % 3];
      dilation += x[k] * f[k];
    }
    dilation += c.radius[i] * g.radius[i];
    probe += g.radius[i];
    area += (sigma == nullptr ? 1 : (*sigma)[i]) * c.area[i];
    absolute += std::fabs((sigma == nullptr ? 1 : (*sigma)[i]) * c.area[i]);
  }
  const double volume = c.totals.volume;
  const double moments = scale.derivative * scale.length;
  const double allowed = 1e-10 * scale.derivative, allowed_moment = 1e-10 * moments;
  for (size_t k = 0; k < 3; ++k) {
    FUZZ_REQUIRE(std::fabs(sum[k]) <= allowed, "hsp_boundary_gradient, property 1: translations");
    FUZZ_REQUIRE(std::fabs(torque[k]) <= allowed_moment, "hsp_boundary_gradient, property 1: rotations");
  }
  FUZZ_REQUIRE(std::fabs(g.energy.probe - probe) <= allowed, "energy.probe is not the sum of dE/dr");
  FUZZ_REQUIRE(std::fabs(g.energy.area - area) <= 1e-12 * absolute, "energy.area");
  FUZZ_REQUIRE(std::fabs(g.energy.volume - volume) <= 1e-10 * (std::fabs(volume) + absolute * scale.length),
               "energy.volume");
  FUZZ_REQUIRE(std::fabs(g.energy.value - (tension * g.energy.area + pressure * g.energy.volume)) <=
                   1e-12 * (std::fabs(tension * area) + std::fabs(pressure * volume)),
               "energy.value is not tension * area + pressure * volume");
  if (sigma == nullptr) {
    FUZZ_REQUIRE(std::fabs(dilation - (2 * tension * area + 3 * pressure * volume)) <=
                     1e-9 * (moments + std::fabs(tension * area) + std::fabs(pressure * volume)),
                 "hsp_boundary_gradient, property 2: dilations");
  }
}

// hsp_boundary_gradient, property 3.
void require_no_order(const fuzz::BallSet &set, const computed &c, const std::vector<double> &sigma, uint32_t tangency,
                      fuzz::Bytes &bytes) {
  const std::vector<uint32_t> order = fuzz::shuffled(set.n(), bytes);
  const fuzz::ComputedSet other(fuzz::permuted(set, order));
  std::vector<double> other_sigma(sigma);
  for (uint32_t i = 0; i < set.n(); ++i) other_sigma[i] = sigma[order[i]];
  const Gradient here(c, sigma.data(), 1.25, -0.5, tangency);
  const Gradient there(other.get(), other_sigma.data(), 1.25, -0.5, tangency);
  for (uint32_t i = 0; i < set.n(); ++i) {
    // of equal balls any may be the one that is exposed
    bool copied = false;
    for (uint32_t j = 0; j < set.n(); ++j) {
      copied = copied || (j != order[i] && set.balls[j].centre == set.balls[order[i]].centre &&
                          set.balls[j].radius == set.balls[order[i]].radius);
    }
    if (copied) return;
  }
  for (uint32_t i = 0; i < set.n(); ++i) {
    const uint32_t from = order[i];
    for (size_t k = 0; k < 3; ++k) {
      FUZZ_REQUIRE(there.centre[3 * size_t{i} + k] == here.centre[3 * size_t{from} + k], "dE/dc in another order");
    }
    FUZZ_REQUIRE(there.radius[i] == here.radius[from], "dE/dr in another order");
    FUZZ_REQUIRE(there.flags[i] == here.flags[from], "flags in another order");
  }
}

// A row is what the gradient of that ball's area alone says; its laws; and a short array.
void require_rows(const computed &c, uint32_t tangency, fuzz::Bytes &bytes) {
  std::vector<std::vector<hsp_area_derivative>> rows(c.n);
  for (uint32_t i = 0; i < c.n; ++i) {
    uint32_t needed = 0;
    rows[i].resize(c.n);
    FUZZ_REQUIRE(hsp_boundary_get_area_row(c.boundary, i, tangency, rows[i].data(), c.n, &needed) == HSP_OK, "a row");
    FUZZ_REQUIRE(needed <= c.n, "a row longer than there are balls");
    FUZZ_REQUIRE((needed == 0) == (c.balls[i].faces == 0), "a row without entries exactly for a buried ball");
    rows[i].resize(needed);
    if (needed > 0) {
      const uint32_t capacity = bytes.below(needed);
      fuzz::Output<hsp_area_derivative> out(capacity, false);
      const int32_t status = hsp_boundary_get_area_row(c.boundary, i, tangency, out.data(), capacity, &needed);
      FUZZ_REQUIRE(status == HSP_E_CAPACITY && needed == rows[i].size(), "a row in too short an array");
      FUZZ_REQUIRE(out.untouched_from(0), "a row half written");
    }
    std::vector<double> alone(c.n + 1, 0.0);
    alone[i] = 1;
    const Gradient g(c, alone.data(), 1, 0, tangency);
    std::vector<double> centre(3 * size_t{c.n}, 0.0), radius(c.n, 0.0);
    // A face may be infinitesimal: then all of a row is rounding, of lengths as large as the ball.
    double sum[3] = {}, sizes = 1e-4 * c.radius[i] + 1e-300;
    for (size_t e = 0; e < rows[i].size(); ++e) {
      const hsp_area_derivative &entry = rows[i][e];
      FUZZ_REQUIRE(entry.ball < c.n && (e == 0 || rows[i][e - 1].ball < entry.ball), "entries ascend");
      FUZZ_REQUIRE(entry.flags <= HSP_GRADIENT_ONE_SIDED, "unknown flags in a row");
      FUZZ_REQUIRE(entry.angle >= 0 && entry.angle <= 6.2831853072, "angle of a row");
      FUZZ_REQUIRE(entry.ball != i || entry.angle == 0, "angle of the ball's own entry");
      for (size_t k = 0; k < 3; ++k) {
        centre[3 * size_t{entry.ball} + k] = entry.centre[k];
        sum[k] += entry.centre[k];
        sizes += std::fabs(entry.centre[k]);
      }
      radius[entry.ball] = entry.radius;
      sizes += std::fabs(entry.radius);
    }
    for (const double x : sum) {
      FUZZ_REQUIRE(std::fabs(x) <= 1e-10 * sizes, "hsp_boundary_get_area_row, property 1: entries sum to 0");
    }
    for (size_t k = 0; k < 3 * size_t{c.n}; ++k) {
      FUZZ_REQUIRE(std::fabs(centre[k] - g.centre[k]) <= 1e-9 * sizes, "a row's dA/dc is not the gradient's");
    }
    for (uint32_t k = 0; k < c.n; ++k) {
      FUZZ_REQUIRE(std::fabs(radius[k] - g.radius[k]) <= 1e-9 * sizes, "a row's dA/dr is not the gradient's");
    }
  }
  const auto entry_of = [&rows](uint32_t i, uint32_t j) {
    for (const hsp_area_derivative &entry : rows[i]) {
      if (entry.ball == j) return entry.radius;
    }
    return 0.0;
  };
  for (uint32_t i = 0; i < c.n; ++i) {
    for (uint32_t j = 0; j < i; ++j) {
      const double here = entry_of(i, j), there = entry_of(j, i);
      FUZZ_REQUIRE(
          std::fabs(here - there) <= 1e-9 * (std::fabs(here) + std::fabs(there)) + 1e-12 * c.info.largest_radius,
          "hsp_boundary_get_area_row, property 2: dA_i/dr_j = dA_j/dr_i");
    }
  }
}

// hsp_boundary_measure_faces, property 1.
void require_faces(const computed &c) {
  std::vector<double> area(c.counts.faces + 1), volume(c.counts.faces + 1);
  FUZZ_REQUIRE(hsp_boundary_measure_faces(c.boundary, area.data(), volume.data(), c.counts.faces) == HSP_OK,
               "measure_faces");
  for (uint32_t i = 0; i < c.n; ++i) {
    const double r = c.radius[i];
    double areas = 0, volumes = 0, sizes = 0;
    for (uint32_t f = 0; f < c.balls[i].faces; ++f) {
      areas += area[c.balls[i].first_face + f];
      volumes += volume[c.balls[i].first_face + f];
      sizes += std::fabs(volume[c.balls[i].first_face + f]);
      FUZZ_REQUIRE(area[c.balls[i].first_face + f] >= -1e-10 * r * r, "a face with a negative area");
    }
    FUZZ_REQUIRE(std::fabs(areas - c.area[i]) <= 1e-10 * r * r, "areas of a ball's faces");
    FUZZ_REQUIRE(std::fabs(volumes - c.volume[i]) <= 1e-10 * (sizes + r * r * r), "volumes of a ball's faces");
  }
  if (c.counts.faces > 0) {
    fuzz::Output<double> out(c.counts.faces - 1, false);
    FUZZ_REQUIRE(hsp_boundary_measure_faces(c.boundary, out.data(), nullptr, out.capacity()) == HSP_E_CAPACITY &&
                     out.untouched_from(0),
                 "measure_faces in too short an array");
  }
}

void require_selected(const computed &c, fuzz::Bytes &bytes) {
  std::vector<uint8_t> selected(c.n + 1);
  for (uint8_t &byte : selected) byte = bytes.below(2) == 0 ? uint8_t{0} : uint8_t{3};
  std::vector<double> area(c.n + 1), volume(c.n + 1);
  hsp_totals totals{}, all{};
  FUZZ_REQUIRE(
      hsp_boundary_measure_selected(c.boundary, selected.data(), &totals, area.data(), volume.data(), c.n) == HSP_OK,
      "measure_selected");
  double sum = 0, sums = 0;
  for (uint32_t i = 0; i < c.n; ++i) {
    FUZZ_REQUIRE(area[i] == (selected[i] != 0 ? c.area[i] : 0), "a selected ball's area");
    FUZZ_REQUIRE(selected[i] != 0 || volume[i] == 0, "volume of a ball that is not selected");
    FUZZ_REQUIRE(selected[i] == 0 || fuzz::close(c.volume[i], volume[i]), "a selected ball's volume");
    sum += area[i];
    sums += std::fabs(volume[i]);
  }
  FUZZ_REQUIRE(std::fabs(totals.area - sum) <= 1e-12 * sum && std::isfinite(totals.volume), "totals of selected balls");
  FUZZ_REQUIRE(std::fabs(totals.volume) <= sums * (1 + 1e-12), "volume of selected balls");
  FUZZ_REQUIRE(hsp_boundary_measure_selected(c.boundary, nullptr, &all, nullptr, nullptr, 0) == HSP_OK, "all");
  FUZZ_REQUIRE(fuzz::same(&all, &c.totals, 1), "nothing selected is everything");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const uint32_t tangency = bytes.below(2);
  const fuzz::BallSet set = fuzz::ball_set(bytes, 32);
  const fuzz::ComputedSet result(set);
  const computed &c = result.get();
  std::vector<double> sigma(set.n() + 1);
  for (double &s : sigma) s = (bytes.below(17) - 8.0) / 4;
  require_laws(c, nullptr, 1, 0, tangency);
  require_laws(c, nullptr, 0, 1, tangency);
  require_laws(c, &sigma, 1.5, -0.25, tangency);
  require_no_order(set, c, sigma, tangency, bytes);
  require_rows(c, tangency, bytes);
  require_faces(c);
  require_selected(c, bytes);
  return 0;
}
