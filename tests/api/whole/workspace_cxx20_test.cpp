// hardsphere.hpp: values, exceptions, and what a workspace holds after moves and failures.
#include <atomic>
#include <thread>

// Threads that tell how many were started, and none that are not in every library of C++20.
namespace std {
struct counted_thread : thread {
  static inline atomic<unsigned> started = 0;
  template <class Work>
  explicit counted_thread(Work &&work) : thread(forward<Work>(work)) {
    ++started;
  }
};
}  // namespace std
#define thread counted_thread
#define jthread not_in_libcxx_19
#include <hardsphere.hpp>
#undef thread
#undef jthread

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace {

constexpr double pi = std::numbers::pi;
int failed = 0;

void expect(bool holds, const char *said) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", said);
  failed = 1;
}
#define EXPECT(condition) expect(condition, #condition)

bool near(double a, double b, double most = 1e-12) {
  return std::fabs(a - b) <= most;
}

// Two balls of radius 1: each loses a cap of height 1/2.
const std::vector<double> lens = {0, 0, 0, 1, 0, 0}, ones = {1, 1};

template <class Call>
hardsphere::error caught(Call &&call) {
  try {
    call();
  } catch (const hardsphere::error &failure) {
    return failure;
  }
  expect(false, "a call that has to throw does");
  return hardsphere::error(HSP_OK);
}

void test_values() {
  hardsphere::workspace work(lens, ones);
  const hardsphere::measures found = work.measure();
  EXPECT(near(found.total.area, 6 * pi) && near(found.area[1], 3 * pi));
  EXPECT(near(found.total.volume, 2 * pi * 27 / 24));
  EXPECT(near(found.volume_term[0] + found.volume_term[1], found.total.volume));
  const std::vector<uint8_t> selected = {0, 1};
  EXPECT(near(work.measure(selected).total.area, 3 * pi) && work.measure(selected).area[0] == 0);
  const hardsphere::gradients slope = work.gradient({.tension = 2, .sigma = ones});
  EXPECT(near(slope.energy.value, 12 * pi) && near(slope.d_centre[3], 4 * pi, 1e-7));
  EXPECT(near(work.gradient({.pressure = 1}).energy.value, found.total.volume) && slope.flags[0] == 0);
  EXPECT(hardsphere::measure(lens, ones, {.probe = 0.5}).total.area > found.total.area);
  EXPECT(work.pairs().of(0).size() == 1 && work.pairs().of(0)[0] == 1 && work.pairs().of(1).empty());
  EXPECT(work.pairs(0).ids.size() == 2);
  // Nothing is read of an empty span, wherever it points.
  std::vector<double> weights = {3, 4};
  weights.clear();
  const std::vector<uint8_t> neither = {0, 0};
  EXPECT(near(work.gradient({.tension = 1, .sigma = weights}).energy.area, found.total.area));
  EXPECT(near(work.measure(std::span(neither).first(0)).total.area, found.total.area));
}

void test_threads() {
  std::vector<double> xyz, radius;
  for (int i = 0; i < 900; ++i) {
    xyz.insert(xyz.end(), {0.1 * i, 0.09 * (i * 37 % 101), 0.09 * (i * 61 % 103)});
    radius.push_back(1.5);
  }
  hardsphere::workspace alone(xyz, radius), shared(xyz, radius);
  shared.use(hardsphere::threads(3));
  EXPECT(alone.measure().area == shared.measure().area);
  EXPECT(shared->boundary_limits.workers >= 3);
  const hardsphere::gradients one = alone.gradient({.tension = 1}), other = shared.gradient({.tension = 1});
  EXPECT(one.d_centre == other.d_centre && one.energy.value == other.energy.value);
  EXPECT(one.area == alone.measure().area);
  hardsphere::workspace moved = std::move(shared);
  moved.set(lens, ones);
  EXPECT(near(moved.measure().total.area, 6 * pi));
}

void test_number_of_threads() {
  const hardsphere::threads many(400), none(0);
  for (const uint32_t tasks : {0U, 1U, 2U, 5U}) {
    for (const hardsphere::threads *threads : {&many, &none}) {
      const hsp_executor &executor = *threads;
      std::atomic<uint32_t> calls = 0;
      const unsigned before = std::counted_thread::started;
      executor.run(
          executor.context, tasks, [](void *data, uint32_t) { ++*static_cast<decltype(calls) *>(data); }, &calls);
      EXPECT(calls == tasks && std::counted_thread::started - before < std::max(tasks, 1U));
    }
  }
}

void test_all_and_range() {
  hardsphere::workspace work(lens, ones);
  EXPECT(hardsphere::all(hsp_boundary_get_circles, work.boundary()).size() == 1);
  EXPECT(hardsphere::all(hsp_boundary_get_vertices, work.boundary()).empty());
  EXPECT(near(hardsphere::all(hsp_contacts_get_pairs, work.contacts())[0].area, pi * 3 / 4));
  EXPECT(hardsphere::all(hsp_query_neighbours, work.model(), 1U)[0] == 0);
  hsp_topology_counts counts{};
  hardsphere::check(hsp_topology_get_counts(work.topology(), &counts));
  EXPECT(hardsphere::range(hsp_topology_get_edges, work.topology(), 0, counts.edges).size() == counts.edges);
  EXPECT(caught([&] { hardsphere::all(hsp_query_neighbours, work.model(), 2U); }).status() == HSP_E_ID);
  // Arrays that may all be left out, and points of three numbers.
  EXPECT(hardsphere::all(hsp_contacts_measure, work.contacts(), nullptr, nullptr).size() == 2);
  EXPECT(hardsphere::all(hsp_model_get_balls, work.model(), nullptr) == ones);
  const double from[] = {-3, 0, 0}, to[] = {4, 0.3, 0};
  hsp_path path{};
  work.run(hsp_workspace_path, from, to, &path);
  const std::vector<double> points = hardsphere::all(hsp_paths_get_points, work->paths);
  EXPECT(path.points >= 2 && points.size() == 3 * path.points && points[0] == -3 && points.end()[-3] == 4);
}

void test_refusals() {
  const std::vector<double> bad = {0, 0, 0, std::numeric_limits<double>::quiet_NaN(), 0, 0};
  hardsphere::workspace work(lens, ones);
  const hardsphere::error failure = caught([&] { work.set(bad, ones); });
  EXPECT(failure.status() == HSP_E_NOT_FINITE && failure.ball() == 1);
  EXPECT(failure.what() == std::string_view(hsp_status_text(HSP_E_NOT_FINITE)));
  EXPECT(work.size() == 0);
  // Nothing of before can be measured behind a set that throws, whatever it throws.
  for (const auto &set : {std::pair{bad, ones}, {lens, bad}, {bad, bad}, {lens, {1, -1}}, {{}, ones}}) {
    work.set(lens, ones);
    work.contacts();
    caught([&] { work.set(set.first, set.second); });
    EXPECT(work.size() == 0);
    EXPECT(caught([&] { work.measure(); }).status() == HSP_E_STATE);
    EXPECT(caught([&] { work.gradient({.tension = 1}); }).status() == HSP_E_STATE);
    EXPECT(caught([&] { work.pairs(); }).status() == HSP_E_STATE);
    EXPECT(caught([&] { work.contacts(); }).status() == HSP_E_STATE);
    hardsphere::workspace fresh;
    caught([&] { fresh.set(set.first, set.second); });
    EXPECT(caught([&] { fresh.measure(); }).status() == HSP_E_STATE);
  }
  EXPECT(caught([&] { work.run(hsp_workspace_set, UINT32_MAX, nullptr, nullptr, nullptr, nullptr); }).status() ==
         HSP_E_RANGE);
  EXPECT(caught([&] { work.measure(); }).status() == HSP_E_STATE);
  work.set(lens, ones);  // all is as before
  EXPECT(near(work.measure().total.area, 6 * pi));
  const std::vector<double> sigma = {1, std::numeric_limits<double>::infinity()};
  EXPECT(caught([&] { work.gradient({.tension = 1, .sigma = sigma}); }).ball() == 1);
  EXPECT(caught([&] { work.set(lens, bad); }).status() == HSP_E_ARGUMENT);
  work.set(lens, ones);
  EXPECT(caught([&] { work.gradient({.tension = 1, .sigma = lens}); }).status() == HSP_E_ARGUMENT);
  const std::vector<uint8_t> one = {1};
  EXPECT(caught([&] { work.measure(one); }).status() == HSP_E_ARGUMENT);
  EXPECT(caught([] { hardsphere::workspace().boundary(); }).status() == HSP_E_ARGUMENT);
}

void test_lives() {
  hardsphere::workspace work(lens, ones);
  work.topology();
  hardsphere::workspace other = std::move(work);
  EXPECT(near(other.measure().total.area, 6 * pi) && work->boundary == nullptr && work.size() == 0);
  work = std::move(other);
  EXPECT(near(work.measure().total.area, 6 * pi) && work.size() == 2);
  // More balls than before, all handles anew; then fewer in the same memory.
  std::vector<double> row, radius(500, 1);
  for (int i = 0; i < 500; ++i) row.insert(row.end(), {1.0 * i, 0, 0});
  work.set(row, radius);
  EXPECT(near(work.measure().total.area, 4 * pi + 499 * 2 * pi, 1e-9));
  EXPECT(hardsphere::all(hsp_contacts_get_pairs, work.contacts()).size() == 499);
  work.set(lens, ones);
  EXPECT(near(work.measure().total.area, 6 * pi));
  EXPECT(hardsphere::all(hsp_contacts_get_pairs, work.contacts()).size() == 1);
  work.run(hsp_workspace_topology);
  work.set({}, {});
  EXPECT(work.measure().total.area == 0 && work.pairs().ids.empty());
}

// The class has the balls that run() has taken, and answers for all of them and with its own options.
void test_runs() {
  std::vector<double> row, radius(50, 1), ends(50, 0);
  for (int i = 0; i < 50; ++i) row.insert(row.end(), {1.0 * i, 0, 0});
  ends.front() = 1;
  const double area = 4 * pi + 49 * 2 * pi;
  hardsphere::workspace work(lens, ones), none;
  work.topology();
  for (hardsphere::workspace *each : {&work, &none}) {
    each->run(hsp_workspace_set, 50U, row.data(), radius.data(), nullptr, nullptr);
    EXPECT(each->size() == 50 && each->pairs().first.size() == 51 && each->pairs().ids.size() == 49 + 48);
    EXPECT(caught([&] { each->gradient({.tension = 1, .sigma = ones}); }).status() == HSP_E_ARGUMENT);
    EXPECT(caught([&] { each->measure(std::vector<uint8_t>(2)); }).status() == HSP_E_ARGUMENT);
    EXPECT(near(each->measure().total.area, area, 1e-9) && each->gradient({.sigma = ends}).area.size() == 50);
    EXPECT(hardsphere::all(hsp_topology_get_shells, each->topology()).size() == 1);
  }
  const std::vector<uint8_t> selected(50, 1);
  const hsp_executor threads = hardsphere::threads(8);
  const hsp_boundary_request request{sizeof request, 0, &threads, selected.data()};
  work.run(hsp_workspace_boundary_with, &request);  // in a larger handle, without the topology of the one before
  EXPECT(hardsphere::all(hsp_topology_get_shells, work.topology()).size() == 1);
  hsp_totals totals{};
  work.run(hsp_workspace_areas, 2U, lens.data(), ones.data(), 0.0, &totals, ends.data());
  EXPECT(work.size() == 2 && near(work.measure().total.area, totals.area));

  // A computation that fails leaves a handle without results. They are computed again when they are asked for.
  const hsp_executor stops{sizeof stops, 1, nullptr, nullptr, [](void *) { return 1; }};
  std::vector<double> many;
  for (int i = 0; i < 3000; ++i) many.insert(many.end(), {1.0 * i, 0, 0});
  work.set(many, std::vector<double>(3000, 1));
  EXPECT(hardsphere::all(hsp_contacts_get_pairs, work.contacts()).size() == 2999);
  work->executor = &stops;
  EXPECT(caught([&] { work.run(hsp_workspace_contacts); }).status() == HSP_E_STOPPED);
  work->executor = nullptr;
  EXPECT(hardsphere::all(hsp_contacts_get_pairs, work.contacts()).size() == 2999);

  const std::vector<double> apart = {0, 0, 0, 9, 0, 0};
  work.set(apart, ones);
  EXPECT(near(work.smooth_gradient({.tension = 1}).energy.area, 8 * pi));
  const uint32_t shell = 0;
  work.run(hsp_workspace_surface_of, &shell, 1U);
  EXPECT(near(work.smooth_gradient({.tension = 1}).energy.area, 8 * pi));

  std::vector<double> cube;
  for (int k = 0; k < 8; ++k) cube.insert(cube.end(), {4.0 * (k & 1), 4.0 * (k >> 1 & 1), 4.0 * (k >> 2)});
  work.set(cube, {radius.data(), 8});
  hsp_pores_options narrow{};
  narrow.struct_size = sizeof narrow, narrow.floor = 2.6;
  hsp_pores_counts counts{};
  work.pores();
  work.run(hsp_workspace_pores, &narrow);
  EXPECT(hsp_pores_get_counts(work.pores(), &counts) == HSP_OK && counts.maxima == 1);
  // A tunnel is one through the pores that are there.
  const double middle[] = {2, 2, 2};
  hsp_tunnel tunnel{};
  narrow.floor = 0;
  work.run(hsp_workspace_tunnel, &narrow, middle, nullptr, nullptr, 0U, &tunnel);
  EXPECT(!hardsphere::all(hsp_pores_get_tunnel_points, work.pores()).empty());

  const double vectors[] = {90, 0, 0, 0, 90, 0, 0, 0, 90};
  hardsphere::box box(lens, ones, {vectors, 9});
  box.run(hsp_workspace_periodic, 50U, row.data(), radius.data(), vectors, nullptr, nullptr);
  EXPECT(box.size() == 50 && near(box.measure().total.area, area, 1e-9));
  EXPECT(caught([&] { box.gradient({.tension = 1, .sigma = ones}); }).status() == HSP_E_ARGUMENT);

  hardsphere::moving walk(lens, ones, {.tension = 1, .sigma = ones});
  walk.run(hsp_workspace_set, 50U, row.data(), radius.data(), nullptr, nullptr);
  walk.run(hsp_workspace_moving, nullptr, 1.0, 0.0, HSP_TANGENT_OVERLAP, nullptr);
  EXPECT(walk.size() == 50 && near(walk.energy().value, area, 1e-9) && walk.gradient().area.size() == 50);
}

// A sphere that meets its own images along x: each side loses a cap of height 0.1.
void test_boxes() {
  const std::vector<double> centre = {7.3, -2, 0.5}, radius = {0.6}, lengths = {1, 2, 2};
  const double area = 4 * pi * 0.36 - 2 * 2 * pi * 0.6 * 0.1;
  hardsphere::box box(centre, radius, lengths);
  EXPECT(near(box.measure().total.area, area) && near(box.measure().total.box_volume, 4));
  EXPECT(near(box.measure().share_volume[0], box.measure().total.volume));
  const hardsphere::box_gradients slope = box.gradient({.tension = 1});
  EXPECT(near(slope.energy.value, area) && near(slope.d_strain[0], 2 * pi * 0.6, 1e-7) && near(slope.d_strain[4], 0));
  EXPECT(near(slope.d_box[0], 2 * pi * 0.6, 1e-7));  // a cap of 0.6 - a / 2
  // The same vectors turned: x to y, y to z, z to x.
  const std::vector<double> turned = {0, 1, 0, 0, 0, 2, 2, 0, 0};
  hardsphere::box other = std::move(box);
  EXPECT(box->periodic == nullptr && near(other.measure().total.area, area));
  other.areas_alone().set(centre, radius, turned);
  EXPECT(near(other.measure().total.area, area, 1e-8) && other.measure().share_volume.empty());
  EXPECT(near(other.gradient({.tension = 1}).d_strain[4], 2 * pi * 0.6, 1e-7));
  other.areas_alone(false);  // from the next set on: until then there are no shares
  EXPECT(near(other.measure().total.area, area, 1e-8) && other.measure().share_volume.empty());
  other.run(hsp_workspace_periodic, 1U, centre.data(), radius.data(), turned.data(), nullptr, nullptr);
  EXPECT(near(other.measure().share_volume[0], other.measure().total.volume));
  other.set(centre, radius, lengths);
  EXPECT(hardsphere::all(hsp_periodic_query_neighbours, other.periodic(), 0U).size() == 2);
  hsp_pores_counts counts{};
  hardsphere::check(hsp_pores_get_counts(other.pores(), &counts));
  const uint32_t maxima = counts.maxima;
  hardsphere::check(hsp_pores_get_counts(other.pores(1), &counts));
  EXPECT(maxima > 0 && counts.maxima == 0);
  for (const std::vector<double> &bad : {std::vector<double>{1, 2}, {1, 2, 0}, {1, 0, 0, 1, 0, 0, 0, 0, 1}}) {
    const int32_t status = caught([&] { other.set(centre, radius, bad); }).status();
    EXPECT(status == (bad.size() == 2 ? HSP_E_ARGUMENT : HSP_E_RANGE) && other.size() == 0);
    EXPECT(caught([&] { other.measure(); }).status() == HSP_E_STATE);
  }
  EXPECT(caught([&] { other.set(lens, radius, lengths); }).status() == HSP_E_ARGUMENT);
  const std::vector<double> negative = {-1};
  EXPECT(caught([&] { other.set(centre, negative, lengths); }).ball() == 0);
  EXPECT(caught([] { hardsphere::box().measure(); }).status() == HSP_E_ARGUMENT);
}

void test_smooth() {
  hardsphere::workspace work(lens, ones, {.probe = 1});
  hsp_surface_totals totals{};
  hardsphere::check(hsp_surface_measure(work.surface(), &totals, nullptr, 0, nullptr));
  const hardsphere::gradients slope = work.smooth_gradient({.tension = 1});
  EXPECT(near(slope.energy.value, totals.area) && slope.d_centre[0] < 0);
  EXPECT(near(slope.d_centre[0] + slope.d_centre[3], 0));
  EXPECT(near(work.smooth_gradient({.pressure = 1}).energy.value, totals.volume));
}

void test_bodies() {
  const hardsphere::body fixed(lens, ones);
  const hardsphere::body posed = fixed;
  const std::vector<hsp_pose> poses = {
      {{1, 0, 0, 0}, {0, 2.5, 0}}, {{1, 0, 0, 0}, {0, 1, 0}}, {{1, 0, 0, 0}, {3, 0, 0}}};
  EXPECT(fixed.hits(posed, poses) == (std::vector<uint32_t>{0, 1, 1}));  // that touch meet
  EXPECT(near(fixed.gaps(posed, poses)[0].gap, 0.5, 1e-8) && fixed.gaps(posed, poses)[2].fixed == 1);
  EXPECT(near(fixed.overlaps(posed, poses)[1].volume,
              2 * pi * 5 / 12 + 2 * pi * (4 + std::sqrt(2)) * std::pow(2 - std::sqrt(2), 2) / 12, 1e-7));
  EXPECT(fixed.pairs(posed, poses[0]).empty() && fixed.pairs(posed, poses[1]).size() == 4);
  EXPECT(fixed.pairs(posed, poses[2]) == (std::vector<std::array<uint32_t, 2>>{{1, 0}}));
  EXPECT(hardsphere::all(hsp_body_pairs, static_cast<const hsp_body *>(fixed), static_cast<const hsp_body *>(posed),
                         &poses[2]) == (std::vector<uint32_t>{1, 0}));
  const std::vector<hsp_rational_pose> exact = {{{1, 0, 0, 1}, {0, 2, 0}}, {{1, 0, 0, 1}, {0, 2.001, 0}}};
  EXPECT(fixed.hits(posed, exact) == (std::vector<uint32_t>{1, 0}));
  EXPECT(near(fixed.gaps(posed, exact)[1].gap, 0.001, 1e-8));
  EXPECT(fixed.pairs(posed, exact[0]) == (std::vector<std::array<uint32_t, 2>>{{0, 0}}));
  EXPECT(fixed.pairs(posed, exact[1]).empty());
  EXPECT(fixed.hits_along(posed, poses, 0.5) == fixed.hits(posed, poses));
  EXPECT(fixed.hits_along(posed, exact, 0.5) == fixed.hits(posed, exact));
  EXPECT(caught([&] { fixed.hits_along(posed, poses, -1); }).status() == HSP_E_RANGE);
  EXPECT(caught([&] { hardsphere::body().pairs(posed, exact[0]); }).status() == HSP_E_ARGUMENT);
  const std::vector<hsp_pose> bad = {poses[0], {{0, 0, 0, 0}, {0, 0, 0}}};
  const hardsphere::error failure = caught([&] { fixed.hits(posed, bad); });
  EXPECT(failure.status() == HSP_E_RANGE && failure.ball() == 1);
  EXPECT(caught([&] { hardsphere::body().hits(posed, poses); }).status() == HSP_E_ARGUMENT);
  EXPECT(caught([] { hardsphere::body(lens, {}); }).status() == HSP_E_ARGUMENT);
}

void test_moving() {
  const std::vector<double> sigma = {1, 2};
  hardsphere::moving walk(lens, ones, {.tension = 1, .sigma = sigma});
  EXPECT(near(walk.energy().value, 9 * pi) && near(walk.gradient().d_centre[3], 3 * pi, 1e-7));
  EXPECT(walk.gradient().area == walk.measure().area && near(walk.measure().total.area, 6 * pi));
  const uint32_t one = 1;
  const std::vector<double> away = {3, 0, 0}, larger = {1};
  EXPECT(near(walk.move({&one, 1}, away).energy().value, 12 * pi));
  EXPECT(near(walk.undo().energy().value, 9 * pi));
  EXPECT(near(walk.move({&one, 1}, away, larger).energy().value, 12 * pi));
  EXPECT(caught([&] { walk.move({&one, 1}, lens); }).status() == HSP_E_ARGUMENT);
  const uint32_t none = 2;
  EXPECT(caught([&] { walk.move({&none, 1}, away); }).status() == HSP_E_ID && near(walk.energy().value, 12 * pi));
  EXPECT(hardsphere::all(hsp_query_neighbours, walk.model(), 1U).empty());
  hardsphere::moving other = std::move(walk);
  EXPECT(near(other.energy().value, 12 * pi) && walk.handle() == nullptr);
  for (const auto &set : {std::pair{lens, lens}, {{0, 0, 0, 1, 0, std::numeric_limits<double>::infinity()}, ones}}) {
    other.set(lens, ones, {.tension = 1});
    caught([&] { other.set(set.first, set.second, {.tension = 1}); });
    EXPECT(other.size() == 0 && caught([&] { other.energy(); }).status() == HSP_E_STATE);
  }
  EXPECT(caught([&] { other.set(lens, ones, {.tension = 1, .sigma = lens}); }).status() == HSP_E_ARGUMENT);
  EXPECT(caught([&] { other.set({}, {}, {.tension = 1, .sigma = ones}); }).status() == HSP_E_ARGUMENT);
  other.set(lens, ones, {.tension = 1});
  other = hardsphere::moving(lens, ones, {.tension = 2, .sigma = sigma});
  walk = std::move(other);  // whose weights are gone
  EXPECT(near(walk.energy().value, 18 * pi) && other.handle() == nullptr && other.size() == 0);
  // 300 balls that come to meet each other need a larger handle, which holds what a new one does.
  std::vector<double> row, together, radius(300, 1);
  std::vector<uint32_t> all;
  for (uint32_t i = 0; i < 300; ++i) {
    all.push_back(i);
    row.insert(row.end(), {3.0 * i, 0, 0});
    together.insert(together.end(), {0.001 * i, 0.0007 * (i * 37 % 300), 0.0009 * (i * 61 % 300)});
  }
  hardsphere::moving many(row, radius, {.tension = 1, .sigma = radius});
  many.move(all, together);
  EXPECT(many.measure().area == hardsphere::moving(together, radius, {.tension = 1}).measure().area);
  EXPECT(near(many.undo().energy().value, 300 * 4 * pi, 1e-9));
  // Not of balls that the weights are not for.
  hardsphere::moving others(lens, ones, {.tension = 1, .sigma = sigma});
  others.run(hsp_workspace_set, 300U, row.data(), radius.data(), nullptr, nullptr);
  others.run(hsp_workspace_moving, nullptr, 1.0, 0.0, HSP_TANGENT_OVERLAP, nullptr);
  EXPECT(caught([&] { others.move(all, together); }).status() == HSP_E_STATE);
  EXPECT(near(others.energy().value, 300 * 4 * pi, 1e-9));
  // Nor with another energy than that which run() was given. One that is moved to itself has its weights still.
  const std::vector<double> twos(300, 2);
  hardsphere::moving sevenfold(row, radius, {.tension = 1, .sigma = twos});
  sevenfold.run(hsp_workspace_moving, nullptr, 7.0, 0.0, HSP_TANGENT_OVERLAP, nullptr);
  EXPECT(caught([&] { sevenfold.move(all, together); }).status() == HSP_E_STATE);
  EXPECT(near(sevenfold.energy().value, 7 * 300 * 4 * pi, 1e-8));
  hardsphere::moving &itself = sevenfold.set(row, radius, {.tension = 1, .sigma = twos});
  sevenfold = std::move(itself);
  sevenfold.move(all, together);
  EXPECT(near(sevenfold.energy().value, 2 * sevenfold.measure().total.area, 1e-9));
}

}  // namespace

int main() {
  test_values();
  test_threads();
  test_number_of_threads();
  test_all_and_range();
  test_refusals();
  test_lives();
  test_runs();
  test_boxes();
  test_smooth();
  test_bodies();
  test_moving();
  return failed;
}
