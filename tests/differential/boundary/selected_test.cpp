// The boundary of selected balls: areas, derivatives and flags are those of the whole boundary, bit for bit, which the
// other tests hold against brute force; for every way to select, by one worker and by several.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "library_run.hpp"
#include "random_balls.hpp"

namespace {

using oracle::Balls;
using oracle::RandomSource;

struct Answers {
  std::vector<double> area, d_centre, d_radius, area_centre, area_radius;
  std::vector<uint32_t> flags, first, ball;  // rows of the Jacobian
  std::vector<double> row;
  double total = 0, energy = 0;
};

Answers answers_of(const hsp_boundary *boundary, const std::vector<uint8_t> &selected,
                   const std::vector<double> &sigma) {
  const size_t n = selected.size();
  Answers found;
  constexpr double not_written = -7.0;
  found.area.resize(n, not_written);
  found.d_centre.resize(3 * n, not_written);
  found.d_radius.resize(n, not_written);
  found.area_centre.resize(3 * n, not_written);
  found.area_radius.resize(n, not_written);
  found.flags.resize(n, 7);
  hsp_totals totals{};
  hsp_measure_request measuring{};
  measuring.struct_size = sizeof measuring;
  measuring.selected = selected.data();
  hsp_measure_outputs measured{};
  measured.struct_size = sizeof measured;
  measured.capacity = static_cast<uint32_t>(n);
  measured.totals = &totals;
  measured.area = found.area.data();
  expect_ok(hsp_boundary_get_measures(boundary, &measuring, &measured), "hsp_boundary_get_measures");
  hsp_energy energy{};
  hsp_gradient_request asked{};
  expect_ok(hsp_gradient_request_init(&asked, sizeof asked), "hsp_gradient_request_init");
  asked.tension = 0.7;
  asked.sigma = sigma.data();
  hsp_gradient_outputs gradient{};
  gradient.struct_size = sizeof gradient;
  gradient.capacity = static_cast<uint32_t>(n);
  gradient.energy = &energy;
  gradient.d_centre = found.d_centre.data();
  gradient.d_radius = found.d_radius.data();
  gradient.flags = found.flags.data();
  expect_ok(hsp_boundary_get_gradient(boundary, &asked, &gradient), "hsp_boundary_get_gradient");
  hsp_derivatives_request parts_asked{};
  parts_asked.struct_size = sizeof parts_asked;
  parts_asked.sigma = sigma.data();
  std::vector<uint32_t> flags(n);
  hsp_derivatives_outputs parts{};
  parts.struct_size = sizeof parts;
  parts.capacity = static_cast<uint32_t>(n);
  parts.area_centre = found.area_centre.data();
  parts.area_radius = found.area_radius.data();
  parts.flags = flags.data();
  expect_ok(hsp_boundary_get_derivatives(boundary, &parts_asked, &parts), "hsp_boundary_get_derivatives");
  EXPECT_EQ(flags, found.flags);
  found.first.resize(n + 1);
  uint32_t entries = 0;
  static_cast<void>(
      hsp_boundary_get_area_rows(boundary, &parts_asked, found.first.data(), nullptr, nullptr, nullptr, 0, &entries));
  found.ball.resize(entries);
  found.row.resize(3 * size_t{entries});
  expect_ok(hsp_boundary_get_area_rows(boundary, &parts_asked, found.first.data(), found.ball.data(), found.row.data(),
                                       nullptr, entries, &entries),
            "hsp_boundary_get_area_rows");
  found.total = totals.area;
  found.energy = energy.value;
  return found;
}

int32_t run_backwards(void *, uint32_t tasks, hsp_task *task, void *data) {
  for (uint32_t k = tasks; k-- > 0;) task(data, k);
  return 0;
}

class Selection {
 public:
  // For so many workers.
  Selection(const hsp_model *model, const std::vector<uint8_t> &selected, uint32_t workers) {
    hsp_executor executor{};
    executor.struct_size = sizeof executor;
    executor.workers = workers;
    executor.run = run_backwards;
    hsp_boundary_request request{};
    request.struct_size = sizeof request;
    request.executor = &executor;
    request.selected = selected.data();
    hsp_boundary_limits limits = support::default_boundary_limits(static_cast<uint32_t>(selected.size()));
    limits.workers = workers;
    boundary_.take(limits);
    boundary_.compute([&](hsp_boundary *boundary, hsp_boundary_limits *needed) {
      return hsp_boundary_compute_with(boundary, model, &request, needed);
    });
  }
  [[nodiscard]] hsp_boundary *handle() const { return boundary_.get(); }
  [[nodiscard]] const hsp_boundary_limits &needed() const { return boundary_.needed(); }

 private:
  support::OwnedBoundary boundary_;
};

bool has_equal_left_out(const Balls &balls, const std::vector<uint8_t> &selected, size_t i) {
  for (size_t j = 0; j < balls.size(); ++j) {
    if (j != i && selected[j] == 0 && balls[j] == balls[i]) return true;
  }
  return false;
}

void expect_the_same(const Balls &balls, const std::vector<uint8_t> &selected, RandomSource &random) {
  const LibraryBoundary whole(balls);
  std::vector<double> sigma(balls.size());
  for (double &weight : sigma) weight = 0.01 * static_cast<double>(random.in(-200, 200));
  const Answers expected = answers_of(whole.handle(), selected, sigma);
  for (const uint32_t workers : {1U, 3U}) {
    const Selection some(whole.model(), selected, workers);
    const Answers found = answers_of(some.handle(), selected, sigma);
    EXPECT_EQ(std::memcmp(&found.total, &expected.total, sizeof found.total), 0);
    for (size_t i = 0; i < balls.size(); ++i) {
      if (selected[i] == 0) {
        EXPECT_EQ(found.area[i], 0);
        EXPECT_EQ(found.d_radius[i], 0);
        for (size_t k = 0; k < 3; ++k) EXPECT_EQ(found.d_centre[3 * i + k], 0);
        EXPECT_EQ(found.flags[i], 0U);
        EXPECT_EQ(found.first[i], found.first[i + 1]);
        continue;
      }
      ASSERT_EQ(std::memcmp(&found.area[i], &expected.area[i], sizeof(double)), 0) << "ball " << i;
      ASSERT_EQ(std::memcmp(&found.d_centre[3 * i], &expected.d_centre[3 * i], 3 * sizeof(double)), 0) << "ball " << i;
      ASSERT_EQ(std::memcmp(&found.d_radius[i], &expected.d_radius[i], sizeof(double)), 0) << "ball " << i;
      ASSERT_EQ(std::memcmp(&found.area_centre[3 * i], &expected.area_centre[3 * i], 3 * sizeof(double)), 0);
      ASSERT_EQ(std::memcmp(&found.area_radius[i], &expected.area_radius[i], sizeof(double)), 0);
      const uint32_t entries = expected.first[i + 1] - expected.first[i];
      ASSERT_EQ(found.first[i + 1] - found.first[i], entries);
      for (uint32_t k = 0; k < entries; ++k) {
        const size_t own = found.first[i] + k, whole_entry = expected.first[i] + k;
        ASSERT_EQ(found.ball[own], expected.ball[whole_entry]);
        ASSERT_EQ(std::memcmp(&found.row[3 * own], &expected.row[3 * whole_entry], 3 * sizeof(double)), 0);
      }
      if (!has_equal_left_out(balls, selected, i)) {
        ASSERT_EQ(found.flags[i], expected.flags[i]) << "ball " << i;
      }
    }
  }
}

// Random ones, those on one side of a plane, one ball, all but one.
std::vector<uint8_t> selection_of(const Balls &balls, RandomSource &random) {
  std::vector<uint8_t> selected(balls.size());
  const int64_t way = random.in(0, 4);
  const auto one = static_cast<size_t>(random.in(0, static_cast<int64_t>(balls.size()) - 1));
  for (size_t i = 0; i < balls.size(); ++i) {
    const bool chosen = way == 0   ? random.in(0, 1) == 1
                        : way == 1 ? balls[i].x < balls[one].x
                        : way == 2 ? i == one
                        : way == 3 ? i != one
                                   : i < balls.size() / 2;
    selected[i] = chosen ? 255 : 0;
  }
  return selected;
}

TEST(Selected, AreaAndGradientAreThoseOfTheWhole) {
  RandomSource random(5);
  for (int k = 0; k < oracle::sets(6000); ++k) {
    const Balls balls = oracle::any_balls(random, static_cast<size_t>(random.in(2, 40)));
    expect_the_same(balls, selection_of(balls, random), random);
    if (HasFailure()) return;
  }
}

TEST(Selected, SoIsThatOfManyCubes) {
  RandomSource random(6);
  for (int k = 0; k < oracle::sets(12); ++k) {
    const Balls balls = oracle::colliding_balls(random, static_cast<size_t>(random.in(200, 300)));
    expect_the_same(balls, selection_of(balls, random), random);
    Balls loose;
    for (int i = 0; i < 1500; ++i) {
      loose.push_back({random.in(0, 22000), random.in(0, 22000), random.in(0, 22000), random.in(900, 1600)});
    }
    expect_the_same(loose, selection_of(loose, random), random);
  }
}

TEST(Selected, TakesNoMoreRoomThanTheWhole) {
  RandomSource random(7);
  Balls balls;
  for (int i = 0; i < 800; ++i) {
    balls.push_back({random.in(0, 18000), random.in(0, 9000), random.in(0, 9000), random.in(900, 1600)});
  }
  std::vector<uint8_t> selected(balls.size());
  for (size_t i = 0; i < balls.size(); ++i) selected[i] = balls[i].x < 9000 ? 1 : 0;
  const LibraryBoundary whole(balls);
  const Selection some(whole.model(), selected, 1);
  EXPECT_LT(some.needed().vertices, whole.counts().vertices * 2 / 3);
  // Exactly the vertices that have a selected ball.
  uint32_t vertices = 0, circles = 0;
  for (const hsp_vertex &vertex : whole.vertices()) {
    vertices += selected[vertex.ball[0]] + selected[vertex.ball[1]] + selected[vertex.ball[2]] > 0 ? 1U : 0U;
  }
  for (const hsp_circle &circle : whole.circles()) {
    circles += selected[circle.ball[0]] + selected[circle.ball[1]] > 0 ? 1U : 0U;
  }
  EXPECT_EQ(some.needed().vertices, vertices);
  EXPECT_EQ(some.needed().circles, circles);
}

// Every other call for the whole is refused, until the whole is computed again.
TEST(Selected, AnswersNothingElse) {
  const Balls balls = {{0, 0, 0, 3}, {4, 0, 0, 3}, {2, 3, 0, 3}};
  const LibraryBoundary whole(balls);
  const Selection some(whole.model(), {1, 1, 0}, 1);
  hsp_boundary *const boundary = some.handle();
  hsp_boundary_counts counts;
  hsp_totals totals{1, 1, {}};
  uint32_t number = 0, id = 0;
  EXPECT_EQ(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
  EXPECT_EQ(hsp_boundary_get_vertices(boundary, nullptr, 0, &number), HSP_E_STATE);
  EXPECT_EQ(hsp_boundary_get_balls(boundary, nullptr, 0, &number), HSP_E_STATE);
  EXPECT_EQ(hsp_boundary_check(boundary, &number, &id), HSP_E_STATE);
  EXPECT_EQ(hsp_boundary_measure(boundary, nullptr, &totals, nullptr, nullptr, 0, nullptr), HSP_E_STATE);
  hsp_topology_limits limits;
  EXPECT_EQ(hsp_topology_limits_init(&limits, sizeof limits, boundary), HSP_E_STATE);
  double volume[3];
  hsp_measure_outputs measured{};
  measured.struct_size = sizeof measured;
  measured.capacity = 3;
  measured.volume_term = volume;
  EXPECT_EQ(hsp_boundary_get_measures(boundary, nullptr, &measured), HSP_E_STATE);
  measured.volume_term = nullptr;
  measured.totals = &totals;
  EXPECT_EQ(hsp_boundary_get_measures(boundary, nullptr, &measured), HSP_OK);
  EXPECT_GT(totals.area, 0);
  EXPECT_TRUE(std::isnan(totals.volume));
  hsp_energy energy{1, 1, 1, 1, {}};
  hsp_gradient_request asked{};
  asked.struct_size = sizeof asked;
  asked.pressure = 1;
  hsp_gradient_outputs gradient{};
  gradient.struct_size = sizeof gradient;
  gradient.energy = &energy;
  EXPECT_EQ(hsp_boundary_get_gradient(boundary, &asked, &gradient), HSP_E_STATE);
  asked.pressure = 0;
  EXPECT_EQ(hsp_boundary_get_gradient(boundary, &asked, &gradient), HSP_OK);
  EXPECT_TRUE(std::isnan(energy.volume));
  EXPECT_EQ(energy.area, totals.area);
  ASSERT_EQ(hsp_boundary_compute(boundary, whole.model(), nullptr), HSP_OK);
  EXPECT_EQ(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  EXPECT_EQ(counts.vertices, whole.counts().vertices);
}

}  // namespace
