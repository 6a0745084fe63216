// Molecules against molecules in any pose: hits, pairs, gaps and overlaps against each other and, where rotations keep
// the lattice, against brute force; no effect of the order of the balls; poses that are refused.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "call_checks.hpp"
#include "checked_model.hpp"
#include "computed_set.hpp"
#include "topology_input.hpp"

namespace {

class CheckedBody {
 public:
  explicit CheckedBody(const fuzz::ScaledBalls &set, size_t misalignment = 0) {
    const fuzz::CheckedModel model(set, misalignment);
    size_t bytes = 0;
    FUZZ_REQUIRE(hsp_body_bytes(set.n(), &bytes) == HSP_OK, "size");
    FUZZ_REQUIRE(bytes <= HSP_BODY_BYTES(set.n()), "hsp_body_bytes, property 1");
    memory_.assign(misalignment + bytes, 0xC3);
    FUZZ_REQUIRE(hsp_body_init(memory_.data() + misalignment, bytes, set.n(), &body_) == HSP_OK, "init");
    FUZZ_REQUIRE(hsp_body_set(body_, model.get()) == HSP_OK, "set");
  }
  CheckedBody(const CheckedBody &) = delete;
  CheckedBody &operator=(const CheckedBody &) = delete;

  const hsp_body *get() const { return body_; }

 private:
  std::vector<uint8_t> memory_;
  hsp_body *body_ = nullptr;
};

using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

struct Answers {
  uint32_t hit = 7;
  hsp_body_gap gap{};
  hsp_body_overlap overlap{};
  Pairs pairs;
};

Answers answers_to(const hsp_body *fixed, const hsp_body *moving, const hsp_pose &pose) {
  Answers result;
  uint32_t first_bad = 7, needed = 0;
  FUZZ_REQUIRE(hsp_body_hits(fixed, moving, 1, &pose, &result.hit, &first_bad) == HSP_OK, "hits");
  FUZZ_REQUIRE(first_bad == HSP_NONE, "first_bad after HSP_OK");
  FUZZ_REQUIRE(hsp_body_gaps(fixed, moving, 1, &pose, &result.gap, nullptr) == HSP_OK, "gaps");
  FUZZ_REQUIRE(hsp_body_overlaps(fixed, moving, 1, &pose, &result.overlap, nullptr) == HSP_OK, "overlaps");
  const int32_t status = hsp_body_pairs(fixed, moving, &pose, nullptr, 0, &needed);
  FUZZ_REQUIRE(status == (needed > 0 ? HSP_E_CAPACITY : HSP_OK), "the number of pairs");
  std::vector<uint32_t> pair(2 * size_t{needed});
  FUZZ_REQUIRE(hsp_body_pairs(fixed, moving, &pose, pair.data(), needed, &needed) == HSP_OK, "pairs");
  for (size_t k = 0; k < pair.size(); k += 2) result.pairs.emplace_back(pair[k], pair[k + 1]);
  FUZZ_REQUIRE(std::is_sorted(result.pairs.begin(), result.pairs.end()), "the order of pairs");
  FUZZ_REQUIRE(result.hit == (needed > 0 ? 1U : 0U) && result.overlap.pairs == needed,
               "hits and overlaps, by the pairs");
  FUZZ_REQUIRE(result.overlap.volume >= 0 && (needed > 0 || result.overlap.volume == 0), "a volume");
  // A gap of less than a rounding is 0.
  FUZZ_REQUIRE(result.gap.gap <= 0 ? needed > 0 || result.gap.gap == 0 : needed == 0, "the sign of the gap");
  return result;
}

// The same answers for a rational pose, without overlaps. `step` is the lattice step.
Answers rational_answers(const hsp_body *fixed, const hsp_body *moving, const hsp_rational_pose &pose, double step) {
  Answers result;
  uint32_t first_bad = 7, needed = 0;
  FUZZ_REQUIRE(hsp_body_rational_hits(fixed, moving, 1, &pose, &result.hit, &first_bad) == HSP_OK, "rational hits");
  FUZZ_REQUIRE(first_bad == HSP_NONE, "first_bad after HSP_OK");
  FUZZ_REQUIRE(hsp_body_rational_gaps(fixed, moving, 1, &pose, &result.gap, nullptr) == HSP_OK, "rational gaps");
  const int32_t status = hsp_body_rational_pairs(fixed, moving, &pose, nullptr, 0, &needed);
  FUZZ_REQUIRE(status == (needed > 0 ? HSP_E_CAPACITY : HSP_OK), "the number of pairs");
  std::vector<uint32_t> pair(2 * size_t{needed});
  FUZZ_REQUIRE(hsp_body_rational_pairs(fixed, moving, &pose, pair.data(), needed, &needed) == HSP_OK, "rational pairs");
  for (size_t k = 0; k < pair.size(); k += 2) result.pairs.emplace_back(pair[k], pair[k + 1]);
  FUZZ_REQUIRE(std::is_sorted(result.pairs.begin(), result.pairs.end()), "the order of pairs");
  FUZZ_REQUIRE(result.hit == (needed > 0 ? 1U : 0U), "hits, by the pairs");
  // Two balls that nearly touch are at most the sum of their radii apart, less than 2^32 steps.
  FUZZ_REQUIRE(std::fabs(result.gap.gap) <= 0x1p-18 * step || (result.gap.gap < 0) == (needed > 0),
               "the sign of the gap");
  return result;
}

// A sequence of poses, close to each other or not: the answers must be those of each pose alone, whatever the margin.
void check_motion(const hsp_body *fixed, const hsp_body *moving, hsp_pose pose, hsp_rational_pose rational, double step,
                  fuzz::Bytes &bytes) {
  std::vector<hsp_pose> way;
  std::vector<hsp_rational_pose> ideal_way;
  for (int k = 0; k < 12; ++k) {
    const double shift = step * static_cast<double>(1U << bytes.below(31));
    pose.translation[k % 3] += bytes.one_in(2) ? shift : -shift;
    pose.quaternion[1 + k % 3] += pose.quaternion[0] / static_cast<double>(1U << bytes.below(31));
    rational.translation[k % 3] = pose.translation[k % 3];
    const int32_t turn = INT32_C(1) << bytes.below(30);
    rational.quaternion[1 + k % 3] += rational.quaternion[1 + k % 3] < 0 ? turn : -turn;
    way.push_back(pose);
    ideal_way.push_back(rational);
  }
  const uint32_t steps = bytes.below(0x10000), bits = bytes.below(16);
  const double margin = bytes.one_in(4) ? 1e300 : step * static_cast<double>(steps << bits);
  uint32_t hit[12], along[12], first_bad = 7;
  const auto poses = static_cast<uint32_t>(way.size());
  const int32_t status = hsp_body_hits(fixed, moving, poses, way.data(), hit, nullptr);
  FUZZ_REQUIRE(hsp_body_hits_along(fixed, moving, poses, way.data(), margin, along, &first_bad) == status,
               "status along a motion");
  FUZZ_REQUIRE(status != HSP_OK || std::memcmp(hit, along, sizeof hit) == 0, "hits along a motion");
  const int32_t ideal_status = hsp_body_rational_hits(fixed, moving, poses, ideal_way.data(), hit, nullptr);
  FUZZ_REQUIRE(
      hsp_body_rational_hits_along(fixed, moving, poses, ideal_way.data(), margin, along, &first_bad) == ideal_status,
      "status along a rational motion");
  FUZZ_REQUIRE(ideal_status != HSP_OK || std::memcmp(hit, along, sizeof hit) == 0, "hits along a rational motion");
}

// The largest distance of a point of the balls from the origin.
double reach_of(const fuzz::ScaledBalls &set) {
  double reach = 0;
  for (const oracle::LatticeBall &ball : set.balls) {
    const int64_t sum = std::abs(ball.x) + std::abs(ball.y) + std::abs(ball.z);
    reach = std::max(reach, set.length(sum));
  }
  return reach;
}

// The quarter and half turns about x, as quaternions, and what they do.
oracle::LatticeBall turned_about_x(oracle::LatticeBall ball, uint32_t quarters) {
  for (uint32_t k = 0; k < quarters; ++k) ball = {ball.x, -ball.z, ball.y, ball.radius};
  return ball;
}

hsp_pose quarter_turns(uint32_t quarters) {
  static constexpr double quaternions[4][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}};
  return {{quaternions[quarters][0], quaternions[quarters][1], 0, 0}, {0, 0, 0}};
}

Pairs brute_force(const oracle::Balls &fixed, const oracle::Balls &moving) {
  Pairs pairs;
  for (uint32_t i = 0; i < fixed.size(); ++i)
    for (uint32_t j = 0; j < moving.size(); ++j) {
      const oracle::Vector v = oracle::centre_difference(fixed[i], moving[j]);
      const oracle::Int128 sum = oracle::Int128{fixed[i].radius} + moving[j].radius;
      if (oracle::dot(v, v) <= sum * sum) pairs.emplace_back(i, j);
    }
  return pairs;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const fuzz::ScaledBalls set = fuzz::topology_set(bytes);
  // The moving one: some of the balls, elsewhere.
  fuzz::ScaledBalls part = set;
  if (set.n() > 0) part.balls.resize(1 + bytes.below(set.n()));
  const CheckedBody fixed(set, bytes.below(9)), moving(part);

  const uint32_t quarters = bytes.below(4);
  hsp_pose pose = quarter_turns(quarters);
  oracle::Balls turned = part.with_probe();
  for (oracle::LatticeBall &ball : turned) ball = turned_about_x(ball, quarters);
  // Shifted so that some ball of the one comes near some ball of the other.
  if (set.n() > 0) {
    const oracle::LatticeBall &at = set.balls[bytes.below(set.n())], &from = turned[bytes.below(part.n())];
    const int64_t shift[3] = {at.x - from.x + bytes.below(64), at.y - from.y, at.z - from.z - bytes.below(64)};
    for (oracle::LatticeBall &ball : turned) {
      ball.x += shift[0];
      ball.y += shift[1];
      ball.z += shift[2];
    }
    for (size_t k = 0; k < 3; ++k) pose.translation[k] = set.length(shift[k]);
  }
  const Answers exact = answers_to(fixed.get(), moving.get(), pose);
  FUZZ_REQUIRE(exact.pairs == brute_force(set.with_probe(), turned), "pairs that meet");

  // The same pose as a rational one, then a rational pose of any integers. For the latter nothing more is known
  // beforehand than that ideal places differ from those on the lattice by less than a step.
  const double step = set.step();
  hsp_rational_pose rational{{0, 0, 0, 0}, {pose.translation[0], pose.translation[1], pose.translation[2]}};
  const int32_t longer = static_cast<int32_t>(bytes.below(1000)) + 1;
  for (size_t k = 0; k < 4; ++k) rational.quaternion[k] = longer * static_cast<int32_t>(pose.quaternion[k]);
  FUZZ_REQUIRE(rational_answers(fixed.get(), moving.get(), rational, step).pairs == exact.pairs,
               "pairs that meet in a rational pose");
  for (size_t k = 0; k < 4; ++k) {
    const uint32_t high = bytes.below(0x10000), low = bytes.below(0x10000);
    rational.quaternion[k] = static_cast<int32_t>(high << 16 | low);
  }
  if (rational.quaternion[0] == 0) rational.quaternion[0] = INT32_MIN;
  for (size_t k = 0; k < 4; ++k) pose.quaternion[k] = rational.quaternion[k];
  const Answers ideal = rational_answers(fixed.get(), moving.get(), rational, step);
  const Answers near = answers_to(fixed.get(), moving.get(), pose);
  const double reach = reach_of(set) + reach_of(part) + std::fabs(pose.translation[0]) +
                       std::fabs(pose.translation[1]) + std::fabs(pose.translation[2]);
  FUZZ_REQUIRE(
      near.gap.gap == ideal.gap.gap || std::fabs(near.gap.gap - ideal.gap.gap) <= 0.88 * step + 0x1p-45 * reach,
      "gaps of snapped and ideal balls");

  // Any rotation: the order of the balls has no effect but on ids.
  for (double &component : pose.quaternion) component = static_cast<double>(bytes.below(256)) - 100;
  if (pose.quaternion[0] == 0) pose.quaternion[0] = 1;
  const Answers any = answers_to(fixed.get(), moving.get(), pose);
  const std::vector<uint32_t> order = fuzz::shuffled(set.n(), bytes);
  const CheckedBody other(fuzz::permuted(set, order));
  Answers permuted = answers_to(other.get(), moving.get(), pose);
  for (auto &[i, j] : permuted.pairs) i = order[i];
  std::sort(permuted.pairs.begin(), permuted.pairs.end());
  FUZZ_REQUIRE(permuted.pairs == any.pairs, "pairs depend on the order of the balls");
  FUZZ_REQUIRE(std::memcmp(&permuted.gap.gap, &any.gap.gap, sizeof(double)) == 0, "the gap depends on the order");
  FUZZ_REQUIRE(std::memcmp(&permuted.overlap, &any.overlap, sizeof any.overlap) == 0, "overlaps depend on the order");

  check_motion(fixed.get(), moving.get(), pose, rational, step, bytes);

  // A matrix of small numbers is taken as a rotation or refused; a refused one leaves everything as it was.
  double matrix[9];
  for (double &entry : matrix)
    entry = bytes.one_in(2) ? fuzz::number(bytes, true) : static_cast<double>(bytes.below(3)) - 1;
  hsp_pose found{{-7, 7, 7, 7}, {7, 7, 7}};
  const int32_t made = hsp_pose_from_matrix(matrix, pose.translation, &found);
  FUZZ_REQUIRE(made == HSP_OK || made == HSP_E_NOT_FINITE || made == HSP_E_RANGE, hsp_status_text(made));
  double square = 0;
  for (const double component : found.quaternion) square += component * component;
  FUZZ_REQUIRE(made == HSP_OK ? std::fabs(square - 1) < 1e-5 : found.quaternion[0] == -7, "a rotation, by the status");

  // Numbers of any kind: a status, and nothing written then.
  for (double &component : pose.quaternion) component = fuzz::number(bytes, true);
  for (double &component : pose.translation) component = fuzz::number(bytes, true);
  hsp_body_gap gap{-7, 7, 7};
  uint32_t first_bad = 7;
  const int32_t status = hsp_body_gaps(fixed.get(), moving.get(), 1, &pose, &gap, &first_bad);
  FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_NOT_FINITE || status == HSP_E_RANGE, hsp_status_text(status));
  FUZZ_REQUIRE((status == HSP_OK) == (first_bad == HSP_NONE), "first_bad, by the status");
  FUZZ_REQUIRE(status == HSP_OK || gap.gap == -7, "written on failure");
  std::copy(pose.translation, pose.translation + 3, rational.translation);
  gap.gap = -7;
  const int32_t other_status = hsp_body_rational_gaps(fixed.get(), moving.get(), 1, &rational, &gap, &first_bad);
  FUZZ_REQUIRE(other_status == HSP_OK || other_status == HSP_E_NOT_FINITE || other_status == HSP_E_RANGE,
               hsp_status_text(other_status));
  FUZZ_REQUIRE((other_status == HSP_OK) == (first_bad == HSP_NONE), "first_bad, by the status");
  FUZZ_REQUIRE(other_status == HSP_OK || gap.gap == -7, "written on failure");
  return 0;
}
