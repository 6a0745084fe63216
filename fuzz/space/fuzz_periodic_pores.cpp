// Pores in a periodic box. Against brute force over all images: points and their balls, places and tunnels. Against
// other answers of the library: ends of gates, the widest probes through the box against the channels just below and
// above their levels, regions against the volume and area of the box. The same levels and volumes from other images of
// the balls, other vectors of the box, another order and twice the box. And limits that are too small.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "ball_list.hpp"
#include "crystal_input.hpp"
#include "owned_boxes.hpp"
#include "owned_spaces.hpp"
#include "required_limits.hpp"

namespace {

using Vectors = fuzz::BoxVectors;

struct Crystal {
  uint32_t n() const { return balls.size(); }
  support::BallList balls;
  Vectors box{};
};

Crystal crystal_from(fuzz::Bytes &bytes) {
  Crystal crystal;
  fuzz::StepLengths length(bytes);
  crystal.box = length.box(6, 2);
  for (uint32_t n = bytes.below(4); n > 0; --n) {
    const double x = length(-4, 4), y = length(-4, 4), z = length(-4, 4);
    crystal.balls.add(x, y, z, length(1, 3));
  }
  return crystal;
}

std::array<double, 3> moved(const Crystal &crystal, const double *from, const int32_t *times) {
  std::array<double, 3> at{from[0], from[1], from[2]};
  for (size_t axis = 0; axis < 3; ++axis) {
    for (size_t row = 0; row < 3; ++row) at[axis] += times[row] * crystal.box[3 * row + axis];
  }
  return at;
}

double gap(const Crystal &crystal, const double *xyz, uint32_t ball, const int32_t *times) {
  const auto at = moved(crystal, &crystal.balls.xyz[3 * size_t{ball}], times);
  return std::hypot(at[0] - xyz[0], at[1] - xyz[1], at[2] - xyz[2]) - crystal.balls.radius[ball];
}

struct Pores {
  explicit Pores(const Crystal &given, double floor) : crystal(given), options(with_floor(floor)) {
    hsp_periodic_limits limits{};
    FUZZ_REQUIRE(hsp_periodic_limits_init(&limits, sizeof limits, crystal.n()) == HSP_OK, "limits of the box");
    periodic.take(limits);
    hsp_model_options lattice{};
    FUZZ_REQUIRE(hsp_model_options_init(&lattice, sizeof lattice) == HSP_OK, "options");
    lattice.step = 1e-6;  // of few steps every set of four is tried
    periodic.compute([&](hsp_periodic *handle, hsp_periodic_limits *asked) {
      return hsp_periodic_compute(handle, crystal.n(), crystal.balls.xyz.data(), crystal.balls.radius.data(),
                                  crystal.box.data(), &lattice, asked, nullptr);
    });
    hsp_pores_limits first{};
    FUZZ_REQUIRE(hsp_pores_limits_init(&first, sizeof first, crystal.n()) == HSP_OK, "limits of pores");
    pores.take(first);
    pores.compute([&](hsp_pores *handle, hsp_pores_limits *asked) { return compute(handle, asked); });
    FUZZ_REQUIRE(read(pores.get()) == HSP_OK, "results");
  }

  static hsp_pores_options with_floor(double floor) {
    hsp_pores_options options;
    FUZZ_REQUIRE(hsp_pores_options_init(&options, sizeof options) == HSP_OK, "hsp_pores_options_init");
    options.floor = floor;
    return options;
  }
  int32_t compute(hsp_pores *handle, hsp_pores_limits *limits) const {
    return hsp_pores_compute_periodic(handle, periodic.get(), &options, limits);
  }
  int32_t read(const hsp_pores *handle) {
    const int32_t status = hsp_pores_get_counts(handle, &counts);
    if (status != HSP_OK) return status;
    maxima.resize(counts.maxima);
    gates.resize(counts.gates);
    shifts.resize(counts.gates);
    FUZZ_REQUIRE(hsp_pores_get_maxima(handle, 0, counts.maxima, maxima.data()) == HSP_OK, "maxima");
    FUZZ_REQUIRE(hsp_pores_get_gates(handle, 0, counts.gates, gates.data()) == HSP_OK, "gates");
    FUZZ_REQUIRE(hsp_pores_get_gate_shifts(handle, 0, counts.gates, shifts.data()) == HSP_OK, "shifts");
    FUZZ_REQUIRE(hsp_pores_get_percolation(handle, &wide) == HSP_OK, "percolation");
    return HSP_OK;
  }

  // The levels, each `times` times, in ascending order.
  std::vector<double> levels(int times) const {
    std::vector<double> all;
    for (int k = 0; k < times; ++k) {
      for (const auto &maximum : maxima) all.push_back(maximum.radius);
      for (const auto &gate : gates) all.push_back(gate.radius);
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  Crystal crystal;
  hsp_pores_options options;
  support::OwnedPeriodic periodic;
  support::OwnedHandle<support::PoresKind> pores;
  hsp_pores_counts counts{};
  hsp_pore_percolation wide{};
  std::vector<hsp_pore_maximum> maxima;
  std::vector<hsp_pore_gate> gates;
  std::vector<hsp_pore_gate_shifts> shifts;
};

void require_same(const Pores &one, const Pores &other, int times, const char *what) {
  FUZZ_REQUIRE(one.levels(times) == other.levels(1), what);
  for (int d = 0; d < 3; ++d) FUZZ_REQUIRE(one.wide.through[d] == other.wide.through[d], what);
}

// The images of the balls that a point names must touch the probe there, and no image may be nearer.
template <class Get>
void require_point(const Pores &found, const double *xyz, double radius, uint32_t point, uint32_t least, Get get) {
  constexpr double error = 1e-6;
  std::vector<hsp_image> images(256);
  uint32_t needed = 0;
  FUZZ_REQUIRE(get(found.pores.get(), point, images.data(), 256, &needed) == HSP_OK, "images");
  FUZZ_REQUIRE(needed >= least, "enough balls");
  for (uint32_t k = 0; k < needed; ++k) {
    FUZZ_REQUIRE(std::fabs(gap(found.crystal, xyz, images[k].ball, images[k].shift) - radius) < error, "its balls");
  }
  uint32_t touching = 0;
  constexpr int32_t far = 7;
  for (uint32_t ball = 0; ball < found.crystal.n(); ++ball) {
    for (int32_t a = -far; a <= far; ++a) {
      for (int32_t b = -far; b <= far; ++b) {
        for (int32_t c = -far; c <= far; ++c) {
          const int32_t times[3] = {a, b, c};
          const double more = gap(found.crystal, xyz, ball, times) - radius;
          FUZZ_REQUIRE(more > -error, "a ball is nearer");
          touching += more < error ? 1U : 0U;
        }
      }
    }
  }
  FUZZ_REQUIRE(touching >= needed, "all of them are seen");
}

std::vector<hsp_pore_channel> channels_of(const Pores &found, double radius) {
  uint32_t needed = 0;
  const int32_t status = hsp_pores_get_channels(found.pores.get(), radius, nullptr, 0, &needed);
  FUZZ_REQUIRE(status == (needed > 0 ? HSP_E_CAPACITY : HSP_OK), "how many channels");
  std::vector<hsp_pore_channel> channels(needed);
  FUZZ_REQUIRE(hsp_pores_get_channels(found.pores.get(), radius, channels.data(), needed, &needed) == HSP_OK,
               "channels");
  uint32_t maxima = 0, fitting = 0;
  for (const auto &channel : channels) maxima += channel.maxima;
  for (const auto &maximum : found.maxima) fitting += maximum.radius > radius ? 1U : 0U;
  FUZZ_REQUIRE(maxima == fitting, "every maximum is in one channel");
  return channels;
}

uint32_t most_directions(const Pores &found, double radius) {
  uint32_t most = 0;
  for (const auto &channel : channels_of(found, radius)) most = std::max(most, channel.directions);
  return most;
}

void require_sound(const Pores &found) {
  for (uint32_t k = 0; k < found.counts.maxima; ++k) {
    const auto &maximum = found.maxima[k];
    require_point(found, maximum.xyz, maximum.radius, k, 4, hsp_pores_get_maximum_images);
    FUZZ_REQUIRE(maximum.parent == HSP_NONE || maximum.parent < k, "a parent is older");
  }
  for (uint32_t k = 0; k < found.counts.gates; ++k) {
    const auto &gate = found.gates[k];
    require_point(found, gate.xyz, gate.radius, k, 3, hsp_pores_get_gate_images);
    for (const uint32_t end : gate.end) {
      FUZZ_REQUIRE(end < found.counts.maxima && found.maxima[end].radius >= gate.radius, "an end of a gate");
    }
    for (int b = 0; b < 3; ++b) {
      FUZZ_REQUIRE(
          std::fabs(gap(found.crystal, gate.xyz, gate.ball[b], found.shifts[k].ball + 3 * b) - gate.radius) < 1e-6,
          "shifts of its balls");
    }
  }
  for (uint32_t d = 0; d < 3; ++d) {
    if (found.wide.gate[d] == HSP_NONE) {
      FUZZ_REQUIRE(most_directions(found, found.options.floor) <= d, "nothing gets through");
      continue;
    }
    const double radius = found.wide.through[d];
    FUZZ_REQUIRE(most_directions(found, radius) <= d, "a probe as wide does not get through");
    const double narrower = std::nextafter(radius, -1e9);
    if (narrower >= found.options.floor) {
      FUZZ_REQUIRE(most_directions(found, narrower) > d, "a narrower one does");
    }
    FUZZ_REQUIRE(d == 0 || radius <= found.wide.through[d - 1], "more directions are no wider");
  }
  double along = -INFINITY;
  for (int axis = 0; axis < 3; ++axis) along = std::max(along, found.wide.along[axis]);
  FUZZ_REQUIRE(along == found.wide.through[0], "the widest of the three vectors");
}

// The radius of the largest probe at a point, which is first moved into the box: over the images up to 7 boxes away.
double room_at(const Crystal &crystal, const double *xyz) {
  int32_t home[3];
  home[2] = -static_cast<int32_t>(std::floor(xyz[2] / crystal.box[8]));
  home[1] = -static_cast<int32_t>(std::floor((xyz[1] + home[2] * crystal.box[7]) / crystal.box[4]));
  home[0] = -static_cast<int32_t>(
      std::floor((xyz[0] + home[2] * crystal.box[6] + home[1] * crystal.box[3]) / crystal.box[0]));
  const auto near = moved(crystal, xyz, home);
  double least = INFINITY;
  constexpr int32_t far = 7;
  for (uint32_t ball = 0; ball < crystal.n(); ++ball) {
    for (int32_t a = -far; a <= far; ++a) {
      for (int32_t b = -far; b <= far; ++b) {
        for (int32_t c = -far; c <= far; ++c) {
          const int32_t times[3] = {a, b, c};
          least = std::min(least, gap(crystal, near.data(), ball, times));
        }
      }
    }
  }
  return least;
}

double apart(const std::array<double, 3> &p, const double *q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

using Point = std::array<double, 3>;

// The points of a tunnel must be as wide as they say, follow each other, and lead to the copy of the box that it names.
void require_way(const Pores &found, const Point &from, const Point &to, const hsp_tunnel &tunnel) {
  constexpr double error = 1e-5;
  std::vector<hsp_tunnel_point> points(tunnel.points);
  std::vector<hsp_tunnel_point_shifts> shifts(tunnel.points);
  hsp_tunnel_route route{};
  const hsp_pores *const pores = found.pores.get();
  FUZZ_REQUIRE(hsp_pores_get_tunnel_points(pores, points.data(), tunnel.points, nullptr) == HSP_OK, "points");
  FUZZ_REQUIRE(hsp_pores_get_tunnel_point_shifts(pores, shifts.data(), tunnel.points, nullptr) == HSP_OK, "shifts");
  FUZZ_REQUIRE(hsp_pores_get_tunnel_route(pores, &route) == HSP_OK, "route");
  FUZZ_REQUIRE(apart(from, points.front().xyz) < error, "its start");
  FUZZ_REQUIRE(apart(moved(found.crystal, to.data(), route.shift), points.back().xyz) < error, "its end");
  for (size_t k = 0; k < points.size(); ++k) {
    const double room = room_at(found.crystal, points[k].xyz);
    FUZZ_REQUIRE(std::fabs(room - points[k].radius) < error && room > tunnel.radius - error, "room at a point");
    for (size_t b = 0; b < 4 && points[k].ball[b] != HSP_NONE; ++b) {
      const double there = gap(found.crystal, points[k].xyz, points[k].ball[b], shifts[k].ball + 3 * b);
      FUZZ_REQUIRE(std::fabs(there - room) < error, "the copy of its ball");
    }
  }
}

void require_tunnels(Pores &found, const Point &from, const Point *to) {
  const double *const end = to == nullptr ? nullptr : to->data();
  hsp_pore_passage passage{};
  FUZZ_REQUIRE(hsp_pores_widest(found.pores.get(), from.data(), end, &passage) == HSP_OK, "widest");
  double cost = INFINITY;
  for (const auto find : {hsp_pores_find_tunnel, hsp_pores_find_cheapest_tunnel}) {
    const bool widest = find == hsp_pores_find_tunnel;
    hsp_tunnel tunnel{};
    hsp_tunnel_route route{};
    const int32_t status = find(found.pores.get(), from.data(), end, nullptr, 0, &tunnel, nullptr);
    if (status == HSP_E_CAPACITY) return;
    FUZZ_REQUIRE(status == HSP_OK, "a tunnel");
    FUZZ_REQUIRE(hsp_pores_get_tunnel_route(found.pores.get(), &route) == HSP_OK, "its cost");
    FUZZ_REQUIRE(tunnel.there == passage.passes || (!widest && std::isinf(cost)), "whether there is one");
    if (tunnel.there == 0) continue;
    FUZZ_REQUIRE(tunnel.radius == passage.radius || (!widest && tunnel.radius < passage.radius), "as wide");
    FUZZ_REQUIRE(route.cost <= cost * (1 + 1e-9), "cheaper");
    cost = route.cost;
    if (found.crystal.n() > 0) require_way(found, from, to == nullptr ? from : *to, tunnel);
  }
}

// The regions must be the channels of their points, and their volumes and areas must sum to those of the box's free
// space; also with other images, other vectors and twice the box. There are none where free space is too narrow to know
// them.
std::vector<hsp_pore_region> regions_of(Pores &found) {
  uint32_t count = 0;
  hsp_pore_access access{};
  const int32_t status = hsp_pores_find_regions(found.pores.get(), nullptr, &access, &count);
  FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_RANGE, "regions");
  if (status != HSP_OK) return {};
  std::vector<hsp_pore_region> regions(count);
  FUZZ_REQUIRE(hsp_pores_get_regions(found.pores.get(), 0, count, regions.data()) == HSP_OK, "the list of regions");
  hsp_periodic_totals totals{};
  FUZZ_REQUIRE(hsp_periodic_measure(found.periodic.get(), &totals, nullptr, nullptr, 0, nullptr) == HSP_OK, "totals");
  const double volume = access.accessible_volume + access.blocked_volume;
  const double area = access.accessible_area + access.blocked_area;
  FUZZ_REQUIRE(std::fabs(volume - totals.free_volume) <= 1e-10 * totals.box_volume, "volumes of regions");
  FUZZ_REQUIRE(std::fabs(area - totals.area) <= 1e-9 * (1 + totals.area), "areas of regions");
  if (found.crystal.n() == 0) return regions;
  const auto channels = channels_of(found, 0.0);
  FUZZ_REQUIRE(channels.size() == count, "as many as channels");
  for (size_t k = 0; k < channels.size(); ++k) {
    FUZZ_REQUIRE(channels[k].maximum == regions[k].maximum && channels[k].maxima == regions[k].maxima, "its maxima");
    FUZZ_REQUIRE(channels[k].directions == regions[k].directions && regions[k].shells > 0, "its directions");
    FUZZ_REQUIRE(regions[k].volume >= 0 && regions[k].volume <= totals.free_volume + 1e-12 * totals.box_volume,
                 "its volume");
  }
  return regions;
}

// In ascending order.
std::vector<double> volumes(const std::vector<hsp_pore_region> &regions) {
  std::vector<double> all;
  for (const auto &region : regions) all.push_back(region.volume);
  std::sort(all.begin(), all.end());
  return all;
}

void require_same_regions(const std::vector<hsp_pore_region> &one, Pores &other, double box_volume) {
  const auto before = volumes(one), after = volumes(regions_of(other));
  if (before.empty() || after.empty()) return;
  FUZZ_REQUIRE(before.size() == after.size(), "as many regions");
  for (size_t k = 0; k < before.size(); ++k) {
    FUZZ_REQUIRE(std::fabs(before[k] - after[k]) <= 1e-10 * box_volume, "the same volume");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const Crystal crystal = crystal_from(bytes);
  const double floor = bytes.one_in(2) ? 0.0 : -static_cast<double>(bytes.below(8));
  Pores found(crystal, floor);
  require_sound(found);
  const auto regions = regions_of(found);
  const double volume = crystal.box[0] * crystal.box[4] * crystal.box[8];

  for (int k = 0; k < 2; ++k) {
    Point ends[2];
    for (Point &end : ends) {
      for (double &x : end) x = 1e-6 * (static_cast<int32_t>(bytes.below(24000000)) - 12000000);
    }
    require_tunnels(found, ends[0], bytes.one_in(2) ? nullptr : &ends[1]);
  }

  Crystal other = crystal;
  for (uint32_t i = 0; i < other.n(); ++i) {
    const int32_t times[3] = {static_cast<int32_t>(bytes.below(5)) - 2, static_cast<int32_t>(bytes.below(5)) - 2,
                              static_cast<int32_t>(bytes.below(5)) - 2};
    const auto at = moved(crystal, &crystal.balls.xyz[3 * size_t{i}], times);
    std::copy(at.begin(), at.end(), other.balls.xyz.begin() + 3 * static_cast<ptrdiff_t>(i));
  }
  Pores moved_images(other, floor);
  require_same(found, moved_images, 1, "other images");
  require_same_regions(regions, moved_images, volume);
  Crystal skew = crystal;
  for (size_t axis = 0; axis < 3; ++axis) {
    skew.box[6 + axis] += skew.box[3 + axis];
    skew.box[3 + axis] -= skew.box[axis];
  }
  Pores other_vectors(skew, floor);
  require_same(found, other_vectors, 1, "other vectors");
  require_same_regions(regions, other_vectors, volume);
  // With x along y, y along z and z along x, and with a vector that points to the other side.
  Crystal turned = crystal;
  const auto turn = [](double *v) { std::rotate(v, v + 2, v + 3); };
  for (size_t row = 0; row < 3; ++row) turn(&turned.box[3 * row]);
  for (uint32_t i = 0; i < turned.n(); ++i) turn(&turned.balls.xyz[3 * size_t{i}]);
  Pores exchanged_axes(turned, floor);
  require_same(found, exchanged_axes, 1, "exchanged axes");
  for (size_t k = 0; k < found.maxima.size(); ++k) {
    const double *const own = found.maxima[k].xyz, *const other_xyz = exchanged_axes.maxima[k].xyz;
    FUZZ_REQUIRE(other_xyz[1] == own[0] && other_xyz[2] == own[1] && other_xyz[0] == own[2], "a turned maximum");
  }
  Crystal reversed = crystal;
  const size_t side = bytes.below(3);
  for (size_t axis = 0; axis < 3; ++axis) reversed.box[3 * side + axis] *= -1;
  Pores reversed_vector(reversed, floor);
  require_same(found, reversed_vector, 1, "a reversed vector");
  Crystal twice = crystal;
  const size_t row = bytes.below(3);
  for (uint32_t i = 0; i < crystal.n(); ++i) {
    int32_t times[3] = {0, 0, 0};
    times[row] = 1;
    const auto at = moved(crystal, &crystal.balls.xyz[3 * size_t{i}], times);
    twice.balls.add(at[0], at[1], at[2], crystal.balls.radius[i]);
  }
  for (size_t axis = 0; axis < 3; ++axis) twice.box[3 * row + axis] *= 2;
  Pores twice_the_box(twice, floor);
  require_same(found, twice_the_box, 2, "twice the box");
  static_cast<void>(regions_of(twice_the_box));

  const auto before = found.levels(1);
  fuzz::require_limits<support::PoresKind>(
      found.pores.needed(), bytes,
      [&](hsp_pores *handle, hsp_pores_limits *limits) { return found.compute(handle, limits); },
      [&](const hsp_pores *handle) {
        const int32_t status = found.read(handle);
        if (status == HSP_OK) FUZZ_REQUIRE(found.levels(1) == before, "pores the second time");
        return status;
      });
  return 0;
}
