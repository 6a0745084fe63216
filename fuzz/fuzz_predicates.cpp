// The library's inner predicates (lib/ground/exact), every stage and both limb widths, against the oracle's naive
// determinants with symbolic infinitesimals (tests/oracle/sphere_predicates.hpp). The input makes four balls, mostly in
// special position.
#include "exact/predicates.hpp"

#include "exact/lattice_ball.hpp"
#include "fuzz_input.hpp"
#include "sphere_predicates.hpp"

namespace {

using namespace hsp::exact;

LatticeBall to_library(const oracle::LatticeBall &ball, uint32_t index) {
  return {{ball.x, ball.y, ball.z}, ball.radius, index};
}

PairRelation to_library(oracle::PairRelation relation) {
  switch (relation) {
    case oracle::PairRelation::disjoint:
      return PairRelation::disjoint;
    case oracle::PairRelation::circle:
      return PairRelation::circle;
    case oracle::PairRelation::first_inside_second:
      return PairRelation::first_in_second;
    default:
      return PairRelation::second_in_first;
  }
}

// Balls a, b, c, d: circles of b and c on the sphere of a, their points against d.
void check_four(const oracle::TiedBalls &tied, const LatticeBall *ball, uint32_t a, uint32_t b, uint32_t c,
                uint32_t d) {
  const Sphere sphere = sphere_of(ball[a]);
  const Plane P = plane_of(ball[a], ball[b]);
  const Plane Q = plane_of(ball[a], ball[c]);
  const Plane R = plane_of(ball[a], ball[d]);
  double length_squared = static_cast<double>(sphere.W);
  for (const Plane &plane : {P, Q, R}) {
    length_squared = std::max(length_squared, static_cast<double>(dot(plane.v, plane.v)));
  }
  const Predicates predicates(sphere, length_squared);

  const bool cross = tied.circles_cross(a, tied.cap(a, b), tied.cap(a, c));
  FUZZ_REQUIRE((predicates.crossing(P, Q).sign > 0) == cross, "crossing");
  FUZZ_REQUIRE((Exact::crossing(sphere, P, Q).sign > 0) == cross, "crossing, exact stage");
  FUZZ_REQUIRE((ExactPredicates<uint32_t>::crossing(sphere, P, Q).sign > 0) == cross, "crossing, 32-bit limbs");
  if (!cross) {
    const bool inside = tied.circle_inside(a, tied.cap(a, b), tied.cap(a, c));
    FUZZ_REQUIRE((predicates.side(P, Q).sign > 0) == inside, "side");
    FUZZ_REQUIRE((Exact::side(sphere, P, Q).sign > 0) == inside, "side, exact stage");
    FUZZ_REQUIRE((ExactPredicates<uint32_t>::side(sphere, P, Q).sign > 0) == inside, "side, 32-bit limbs");
    return;
  }
  const PointStatus status = predicates.point_status(P, Q, R);
  const PointStatus exact = Exact::point_status(sphere, P, Q, R);
  const PointStatus narrow = ExactPredicates<uint32_t>::point_status(sphere, P, Q, R);
  for (int point = 0; point < 2; ++point) {
    const oracle::Crossing crossing{tied.cap(a, b), tied.cap(a, c), point == 1 ? +1 : -1};
    const bool inside = tied.crossing_inside(a, crossing, tied.cap(a, d));
    FUZZ_REQUIRE((status.side[point] > 0) == inside, "point status");
    FUZZ_REQUIRE((exact.side[point] > 0) == inside, "point status, exact stage");
    FUZZ_REQUIRE((narrow.side[point] > 0) == inside, "point status, 32-bit limbs");
    const bool on = tied.crossing_inside_as_given(a, crossing, tied.cap(a, d)) == 0;
    FUZZ_REQUIRE(exact.tied[point] == on, "tie of a point");
    FUZZ_REQUIRE(narrow.tied[point] == on, "tie of a point, 32-bit limbs");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const fuzz::ScaledBalls set = fuzz::ball_set(bytes, 6);
  if (set.n() < 4) return 0;
  const oracle::Balls all = set.with_probe();
  const oracle::Balls balls(all.end() - 4, all.end());
  LatticeBall ball[4];
  for (uint32_t k = 0; k < 4; ++k) ball[k] = to_library(balls[k], k);
  const oracle::TiedBalls tied(balls);
  bool circle[4][4] = {};
  for (uint32_t a = 0; a < 4; ++a) {
    for (uint32_t b = 0; b < 4; ++b) {
      if (a == b) continue;
      const PairRelation relation = pair_relation(ball[a], ball[b]);
      FUZZ_REQUIRE(relation == to_library(tied.pair(a, b)), "pair relation");
      circle[a][b] = relation == PairRelation::circle;
    }
  }
  for (uint32_t a = 0; a < 4; ++a) {
    for (uint32_t b = 0; b < 4; ++b) {
      for (uint32_t c = 0; c < 4; ++c) {
        if (a == b || a == c || b == c) continue;
        const uint32_t d = 6 - a - b - c;
        if (circle[a][b] && circle[a][c] && circle[a][d]) check_four(tied, ball, a, b, c, d);
      }
    }
  }
  return 0;
}
