// Derivatives and parts of areas: the invariants of gradients and of rows of the Jacobian, no effect of the order,
// faces against balls, and selected balls against all.
#include <gradient_invariants.h>
#include <loops.h>

#include "computed_set.hpp"
#include "guarded_output.hpp"

namespace {

void require_sound(const char *broken) {
  FUZZ_REQUIRE(broken == nullptr, broken);
}

// hsp_boundary_get_gradient, property 3, with equal weights for equal balls.
void require_no_order(const fuzz::ScaledBalls &set, const computed &c, uint32_t tangency, fuzz::Bytes &bytes) {
  const fuzz::ComputedSet other(fuzz::permuted(set, fuzz::shuffled(set.n(), bytes)));
  const auto weights_of = [](const computed &of) {
    std::vector<double> sigma(of.n + 1);
    for (uint32_t i = 0; i < of.n; ++i) {
      sigma[i] = std::cos(of.xyz[3 * i] + 2 * of.xyz[3 * i + 1] + 3 * of.xyz[3 * i + 2] + 5 * of.radius[i]);
    }
    return sigma;
  };
  require_sound(gradient_difference_after_permutation(&c, weights_of(c).data(), &other.get(),
                                                      weights_of(other.get()).data(), tangency));
}

// Asks for a row with an array that is too short for it.
void require_short_rows(const computed &c, uint32_t tangency, fuzz::Bytes &bytes) {
  for (uint32_t i = 0; i < c.n; ++i) {
    uint32_t length = 0, needed = 0;
    const int32_t query = hsp_boundary_get_area_row(c.boundary, i, tangency, nullptr, 0, &length);
    FUZZ_REQUIRE(query == (length == 0 ? HSP_OK : HSP_E_CAPACITY), "length of a row");
    if (length == 0) continue;
    fuzz::Output<hsp_area_derivative> out(bytes.below(length), false);
    const int32_t status = hsp_boundary_get_area_row(c.boundary, i, tangency, out.data(), out.capacity(), &needed);
    FUZZ_REQUIRE(status == HSP_E_CAPACITY && needed == length, "a row in too short an array");
    FUZZ_REQUIRE(out.untouched_from(0), "a row half written");
  }
}

// hsp_boundary_get_area_rows, property 1 without weights, by several threads.
void require_all_rows(const computed &c, uint32_t tangency, fuzz::Bytes &bytes) {
  loop own = loop_of(LOOP_REVERSED);
  const hsp_executor executor = executor_of(&own, bytes.below(4));
  hsp_derivatives_request request{};
  request.struct_size = sizeof request;
  request.tangency = tangency;
  request.executor = &executor;
  std::vector<uint32_t> first(c.n + 1);
  uint32_t entries = 0;
  const int32_t counted =
      hsp_boundary_get_area_rows(c.boundary, &request, first.data(), nullptr, nullptr, nullptr, 0, &entries);
  FUZZ_REQUIRE(counted == (entries > 0 ? HSP_E_CAPACITY : HSP_OK), "the number of all entries");
  fuzz::Output<uint32_t> ball(entries, false);
  fuzz::Output<double> centre(3 * entries, false), radius(entries, bytes.one_in(2));
  FUZZ_REQUIRE(hsp_boundary_get_area_rows(c.boundary, &request, first.data(), ball.data(), centre.data(), radius.data(),
                                          entries, nullptr) == HSP_OK,
               "all rows");
  for (uint32_t i = 0; i < c.n; ++i) {
    std::vector<hsp_area_derivative> row(first[i + 1] - first[i] + 1);
    uint32_t length = 0;
    const auto room = static_cast<uint32_t>(row.size());
    FUZZ_REQUIRE(hsp_boundary_get_area_row(c.boundary, i, tangency, row.data(), room, &length) == HSP_OK, "a row");
    FUZZ_REQUIRE(length == first[i + 1] - first[i], "the length of a row among all");
    for (uint32_t k = 0; k < length; ++k) {
      const uint32_t e = first[i] + k;
      FUZZ_REQUIRE(ball.data()[e] == row[k].ball, "the balls of a row among all");
      FUZZ_REQUIRE(std::memcmp(centre.data() + 3 * size_t{e}, row[k].centre, sizeof row[k].centre) == 0,
                   "a row among all");
      FUZZ_REQUIRE(radius.data() == nullptr || std::memcmp(radius.data() + e, &row[k].radius, sizeof(double)) == 0,
                   "a row among all by radii");
    }
  }
}

// hsp_boundary_measure_faces, property 1.
void require_faces(const computed &c) {
  std::vector<double> area(c.counts.faces + 1), volume(c.counts.faces + 1);
  FUZZ_REQUIRE(hsp_boundary_measure_faces(c.boundary, area.data(), volume.data(), c.counts.faces, nullptr) == HSP_OK,
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
    FUZZ_REQUIRE(
        hsp_boundary_measure_faces(c.boundary, out.data(), nullptr, out.capacity(), nullptr) == HSP_E_CAPACITY &&
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
      hsp_boundary_measure(c.boundary, selected.data(), &totals, area.data(), volume.data(), c.n, nullptr) == HSP_OK,
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
  FUZZ_REQUIRE(hsp_boundary_measure(c.boundary, nullptr, &all, nullptr, nullptr, 0, nullptr) == HSP_OK, "all");
  FUZZ_REQUIRE(fuzz::same(&all, &c.totals, 1), "nothing selected is everything");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const uint32_t tangency = bytes.below(2);
  const fuzz::ScaledBalls set = fuzz::ball_set(bytes, 32);
  const fuzz::ComputedSet result(set);
  const computed &c = result.get();
  std::vector<double> sigma(set.n() + 1);
  for (double &s : sigma) s = (bytes.below(17) - 8.0) / 4;
  require_sound(broken_gradients(&c, nullptr, 1.5, -0.25, tangency));
  require_sound(broken_gradients(&c, sigma.data(), 1.5, -0.25, tangency));
  require_sound(broken_gradient_flags(&c, sigma.data()));
  require_sound(broken_area_rows(&c, sigma.data(), tangency));
  require_no_order(set, c, tangency, bytes);
  require_short_rows(c, tangency, bytes);
  require_faces(c);
  require_selected(c, bytes);
  require_all_rows(c, tangency, bytes);
  return 0;
}
