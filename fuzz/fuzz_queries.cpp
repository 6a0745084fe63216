// The queries of the paper's Section 3 against all balls one by one, in integers, with output arrays of exactly the
// size that is needed and with shorter ones.
#include <algorithm>
#include <cmath>

#include "brute_queries.hpp"
#include "checked_model.hpp"

namespace {

using Place = oracle::LatticePoint;

// ask(out, capacity, needed) with every interesting capacity must give the expected hits.
template <class Ask>
void check_hits(const std::vector<uint32_t> &expected, fuzz::Bytes &bytes, const Ask &ask) {
  const auto hits = static_cast<uint32_t>(expected.size());
  uint32_t needed = 77;
  FUZZ_REQUIRE(ask(nullptr, 0, &needed) == (hits == 0 ? HSP_OK : HSP_E_CAPACITY), "the query of the number");
  FUZZ_REQUIRE(needed == hits, "number of hits");
  std::vector<uint32_t> out(hits, 0xDEAD);
  FUZZ_REQUIRE(ask(out.data(), hits, &needed) == HSP_OK && needed == hits, "room for all hits");
  FUZZ_REQUIRE(out == expected, "the hits");
  if (hits > 0) {
    const uint32_t less = bytes.below(hits);
    std::vector<uint32_t> small(less, 0xDEAD);
    needed = 77;
    FUZZ_REQUIRE(ask(small.data(), less, &needed) == HSP_E_CAPACITY && needed == hits, "too little room");
    FUZZ_REQUIRE(std::count(small.begin(), small.end(), 0xDEADU) == less, "written although there is no room");
  }
}

// Lists of all pairs. `first` has one entry more than there are balls.
void check_pairs(const hsp_model *model, const oracle::Balls &balls, fuzz::Bytes &bytes) {
  for (const uint32_t flags : {0U, HSP_PAIRS_ONCE}) {
    std::vector<uint32_t> first = {0};
    std::vector<uint32_t> ids;
    for (uint32_t i = 0; i < balls.size(); ++i) {
      for (const uint32_t j : oracle::neighbours(balls, i)) {
        if (flags == 0 || j > i) ids.push_back(j);
      }
      first.push_back(static_cast<uint32_t>(ids.size()));
    }
    std::vector<uint32_t> begins(first.size());
    check_hits(ids, bytes, [&](uint32_t *out, uint32_t capacity, uint32_t *needed) {
      std::fill(begins.begin(), begins.end(), 0xDEADU);
      const int32_t status = hsp_query_pairs(model, flags, begins.data(), out, capacity, needed);
      FUZZ_REQUIRE(begins == first, "where the rows begin");
      return status;
    });
  }
}

// A point near a ball, on its sphere, or anywhere.
Place next_place(fuzz::Bytes &bytes, const fuzz::ScaledBalls &set) {
  Place place{};
  if (set.n() > 0 && !bytes.one_in(4)) {
    const uint32_t i = bytes.below(set.n());
    place = centre_of(set.balls[i]);
    const uint32_t axis = bytes.below(3);
    if (bytes.below(2) == 0) place[axis] += set.radius_of(i);
    if (bytes.below(2) == 0) place[axis] += bytes.below(5) - int64_t{2};
  } else {
    for (int64_t &coordinate : place) coordinate = (bytes.below(41) - int64_t{20}) * set.steps_per_unit;
  }
  return place;
}

// Towards a ball, along an axis or a diagonal, or anywhere, with numbers of any size.
Place next_direction(fuzz::Bytes &bytes, const fuzz::ScaledBalls &set, const Place &origin) {
  Place direction{};
  if (set.n() > 0 && bytes.one_in(2)) {
    const Place centre = centre_of(set.balls[bytes.below(set.n())]);
    for (size_t axis = 0; axis < 3; ++axis) direction[axis] = centre[axis] - origin[axis];
  } else {
    for (int64_t &component : direction) component = bytes.below(7) - int64_t{3};
  }
  if (bytes.one_in(8)) direction[bytes.below(3)] += int64_t{1} << bytes.below(52);
  return direction;
}

// The first ball on the ray must be the oracle's. The point must be on its sphere, or the ray's origin if this is in a
// ball.
void check_ray(const hsp_model *model, const fuzz::ScaledBalls &set, const oracle::Balls &balls, const Place &origin,
               const Place &direction) {
  const double from[3] = {set.length(origin[0]), set.length(origin[1]), set.length(origin[2])};
  const double along[3] = {static_cast<double>(direction[0]), static_cast<double>(direction[1]),
                           static_cast<double>(direction[2])};
  hsp_ray_hit hit{};
  const int32_t status = hsp_query_ray(model, from, along, &hit);
  if (direction == Place{}) {
    FUZZ_REQUIRE(status == HSP_E_RANGE, "a ray without a direction");
    return;
  }
  FUZZ_REQUIRE(status == HSP_OK, "hsp_query_ray");
  const uint32_t first = oracle::first_on_ray(balls, origin, direction);
  FUZZ_REQUIRE(hit.ball == (first == oracle::no_ball ? HSP_NONE : first), "the first ball on a ray");
  if (first == oracle::no_ball) {
    FUZZ_REQUIRE(std::isinf(hit.distance), "the distance of nothing");
    return;
  }
  const Place centre = centre_of(balls[first]);
  double squared = 0, size = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    const double difference = hit.xyz[axis] - set.length(centre[axis]);
    squared += difference * difference;
    size += std::fabs(hit.xyz[axis]) + std::fabs(from[axis]);
  }
  const double radius = set.length(balls[first].radius);
  const double tolerance = 1e-13 * (size + radius);
  if (hit.distance == 0.0)
    FUZZ_REQUIRE(std::sqrt(squared) <= radius + tolerance, "the origin in its ball");
  else
    FUZZ_REQUIRE(std::fabs(std::sqrt(squared) - radius) <= tolerance, "a point on the sphere");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const size_t misalignment = bytes.below(16);
  const fuzz::ScaledBalls set = fuzz::ball_set(bytes, 48);
  const fuzz::CheckedModel checked(set, misalignment);
  const hsp_model *model = checked.get();
  const oracle::Balls balls = set.with_probe();
  for (uint32_t i = 0; i < set.n(); ++i) {
    check_hits(oracle::neighbours(balls, i), bytes, [&](uint32_t *out, uint32_t capacity, uint32_t *needed) {
      return hsp_query_neighbours(model, i, out, capacity, needed);
    });
  }
  check_pairs(model, balls, bytes);
  for (int round = 0; round < 12; ++round) {
    const Place place = next_place(bytes, set);
    const double xyz[3] = {set.length(place[0]), set.length(place[1]), set.length(place[2])};
    check_hits(oracle::balls_meeting(balls, oracle::ball_around(place, 0)), bytes,
               [&](uint32_t *out, uint32_t capacity, uint32_t *needed) {
                 return hsp_query_point(model, xyz, out, capacity, needed);
               });
    const int64_t scale = bytes.one_in(4) ? 100 * set.steps_per_unit : set.steps_per_unit;
    const int64_t reach = bytes.below(9) * scale + bytes.below(2);
    const std::vector<uint32_t> hits = oracle::balls_meeting(balls, oracle::ball_around(place, reach));
    check_hits(hits, bytes, [&](uint32_t *out, uint32_t capacity, uint32_t *needed) {
      return hsp_query_ball(model, xyz, set.length(reach), out, capacity, needed);
    });
    uint32_t meets = 77;
    FUZZ_REQUIRE(hsp_query_meets(model, xyz, set.length(reach), &meets) == HSP_OK, "hsp_query_meets");
    FUZZ_REQUIRE(meets == (hits.empty() ? 0U : 1U), "meets");
    check_ray(model, set, balls, place, next_direction(bytes, set, place));
  }
  return 0;
}
