#include "set_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>

#include "boundary_comparison.hpp"
#include "nerve.hpp"
#include "set_arrangements.hpp"

namespace degenerate {
namespace {

using oracle::Balls;
using oracle::LatticeBall;

// Everything that is compared to the last bit: the boundary and the measures of single balls, by their rank in the
// perturbation order.
struct Outcome {
  oracle::CanonicalBoundary boundary;
  std::vector<double> area;
  std::vector<double> volume;
  hsp_totals totals;
};

Outcome outcome_of(const Balls &balls) {
  const LibraryBoundary boundary(balls);
  const LibraryBoundary::Measures measures = boundary.measure();
  const std::vector<uint32_t> rank = oracle::tie_ranks(balls);
  Outcome outcome{oracle::canonical(boundary.record(), rank), measures.area, measures.volume, measures.totals};
  for (size_t i = 0; i < balls.size(); ++i) {
    outcome.area[rank[i]] = measures.area[i];
    outcome.volume[rank[i]] = measures.volume[i];
  }
  return outcome;
}

bool near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

double largest_sphere(const Balls &balls) {
  double largest = 0;
  for (const LatticeBall &ball : balls) largest = std::max(largest, static_cast<double>(ball.radius));
  return 4 * std::numbers::pi * largest * largest;
}

// Empty if the two are the same to the last bit but for the totals, which are sums in the order of the input.
std::string difference(const Outcome &found, const Outcome &expected) {
  if (found.boundary != expected.boundary) return oracle::differences(found.boundary, expected.boundary);
  if (found.area != expected.area) return "areas of balls";
  if (found.volume != expected.volume) return "volumes of balls";
  if (!near(found.totals.area, expected.totals.area, 1e-14)) return "total area";
  if (!near(found.totals.volume, expected.totals.volume, 1e-14)) return "total volume";
  return "";
}

}  // namespace

Topology topology_of(const LibraryBoundary &boundary) {
  const hsp_boundary_counts counts = boundary.counts();
  return {counts.components, counts.voids, counts.shells, counts.euler};
}

Topology topology_of(const oracle::BoundaryRecord &record) {
  return {record.counts.components, record.counts.voids, record.counts.shells, record.counts.euler};
}

Topology topology_of_nerve(const Balls &balls) {
  const std::array<int64_t, 3> betti = oracle::nerve_betti_numbers(balls);
  return {betti[0], betti[2], betti[0] + betti[2], 2 * (betti[0] - betti[1] + betti[2])};
}

bool small_enough_for_nerve(const Balls &balls) {
  constexpr int64_t most = 100;
  return std::all_of(balls.begin(), balls.end(), [&](const LatticeBall &a) {
    return a.radius <= most && std::all_of(balls.begin(), balls.end(), [&](const LatticeBall &b) {
             return std::abs(a.x - b.x) <= most && std::abs(a.y - b.y) <= most && std::abs(a.z - b.z) <= most;
           });
  });
}

std::string to_text(const Topology &topology) {
  std::ostringstream text;
  text << topology.components << " components, " << topology.voids << " voids, " << topology.shells << " shells, Euler "
       << topology.euler;
  return text.str();
}

std::string orders_disagree(const Balls &balls) {
  const Outcome expected = outcome_of(balls);
  Balls reversed(balls.rbegin(), balls.rend());
  Balls sorted = balls;
  std::sort(sorted.begin(), sorted.end());
  oracle::RandomSource random(balls.size());
  const Balls mixed = oracle::permuted(balls, random.permutation(balls.size()));
  for (const Balls &order : {reversed, sorted, mixed})
    if (const std::string what = difference(outcome_of(order), expected); !what.empty())
      return what + " depend on the order, e.g. " + oracle::to_text(order);
  return "";
}

std::string places_disagree(const Balls &balls) {
  const Outcome expected = outcome_of(balls);
  for (const std::array<int64_t, 3> &shift : shifts_within_lattice(balls))
    if (const std::string what = difference(outcome_of(moved(balls, shift)), expected); !what.empty())
      return what + " depend on the place: moved by " + std::to_string(shift[0]) + " " + std::to_string(shift[1]) +
             " " + std::to_string(shift[2]);
  return "";
}

std::string scales_disagree(const Balls &balls) {
  const Outcome expected = outcome_of(balls);
  const int64_t largest = largest_scale(balls);
  for (const int64_t factor : {std::min<int64_t>(7, largest), std::min<int64_t>(1000003, largest), largest}) {
    const Outcome found = outcome_of(scaled(balls, factor));
    const auto length = static_cast<double>(factor);
    std::string what;
    if (found.boundary != expected.boundary)
      what = oracle::differences(found.boundary, expected.boundary);
    else if (!near(found.totals.area, expected.totals.area * length * length, 1e-13))
      what = "total area";
    else if (!near(found.totals.volume, expected.totals.volume * length * length * length, 1e-13))
      what = "total volume";
    for (size_t i = 0; i < balls.size(); ++i)
      if (std::abs(found.area[i] / length / length - expected.area[i]) > 1e-13 * largest_sphere(balls))
        what += "area of a ball ";
    if (!what.empty()) return what + " depend on the scale: times " + std::to_string(factor);
  }
  return "";
}

std::string axes_disagree(const Balls &balls) {
  const LibraryBoundary straight(balls);
  const Topology expected = topology_of(straight);
  const LibraryBoundary::Measures measures = straight.measure();
  for (const Balls &turned : axis_images(balls)) {
    const LibraryBoundary boundary(turned);
    const LibraryBoundary::Measures found = boundary.measure();
    std::string what;
    if (topology_of(boundary) != expected) what = to_text(topology_of(boundary)) + " and " + to_text(expected) + " ";
    if (!near(found.totals.area, measures.totals.area, 1e-13)) what += "total area ";
    if (!near(found.totals.volume, measures.totals.volume, 1e-13)) what += "total volume ";
    for (size_t i = 0; i < balls.size(); ++i)
      if (std::abs(found.area[i] - measures.area[i]) > 1e-13 * largest_sphere(balls)) what += "area of a ball ";
    if (!what.empty()) return what + "depend on the axes, e.g. " + oracle::to_text(turned);
  }
  return "";
}

std::string copies_disagree(const Balls &balls) {
  const LibraryBoundary plain(balls);
  const hsp_boundary_counts alone = plain.counts();
  const LibraryBoundary::Measures measures = plain.measure();
  const auto n = static_cast<ptrdiff_t>(balls.size());
  const std::array<std::pair<const char *, Balls>, 3> more = {{{"every ball twice", with_copies(balls)},
                                                               {"balls of half the size", with_half_sizes(balls)},
                                                               {"balls that touch from inside", with_tangents(balls)}}};
  for (const auto &[name, set] : more) {
    const LibraryBoundary boundary(set);
    const hsp_boundary_counts counts = boundary.counts();
    const LibraryBoundary::Measures found = boundary.measure();
    std::string what;
    if (topology_of(boundary) != topology_of(plain))
      what = to_text(topology_of(boundary)) + " instead of " + to_text(topology_of(plain));
    if (!near(found.totals.area, measures.totals.area, 1e-13)) what += " total area";
    if (!near(found.totals.volume, measures.totals.volume, 1e-13)) what += " total volume";
    if (&set != &more[2].second) {
      // The copies lie inside and own nothing; the boundary is the one without them.
      if (counts.contained_balls != alone.contained_balls + balls.size()) what += " contained balls";
      if (counts.vertices != alone.vertices || counts.arcs != alone.arcs || counts.circles != alone.circles ||
          counts.faces != alone.faces || counts.loops != alone.loops || counts.tied_vertices != alone.tied_vertices)
        what += " numbers of vertices, arcs, circles, faces or loops";
      if (!std::equal(measures.area.begin(), measures.area.end(), found.area.begin()) ||
          std::any_of(found.area.begin() + n, found.area.end(), [](double area) { return area != 0; }))
        what += " areas of balls";
      if (!std::equal(measures.volume.begin(), measures.volume.end(), found.volume.begin()))
        what += " volumes of balls";
    }
    if (!what.empty()) return std::string(name) + ": " + what;
  }
  return "";
}

std::string nerve_disagrees(const Balls &balls) {
  const Topology expected = topology_of_nerve(balls);
  const Topology found = topology_of(LibraryBoundary(balls));
  return found == expected ? "" : to_text(found) + " instead of " + to_text(expected);
}

std::string brute_force_disagrees(const Balls &balls) {
  return boundary_differs(0, 0)(balls);
}

}  // namespace degenerate
