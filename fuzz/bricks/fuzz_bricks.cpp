// Bricks: a set is cut by owners that the input chooses, merged in a tree that it chooses, and compared with the same
// set in one piece, bit for bit. Summaries with some numbers changed and a right check sum, and any bytes as a summary,
// must lead to a status and nothing else.
#include <brick_summaries.hpp>
#include <cmath>

#include "fuzz_input.hpp"

namespace {

using support::BrickMaker;
using support::OwnedBalls;
using support::Summary;

struct Cut {
  OwnedBalls balls;
  double largest = 1;
  uint32_t bricks = 1;
};

Cut cut_set(fuzz::Bytes &bytes) {
  const fuzz::ScaledBalls set = fuzz::ball_set(bytes, 40);
  Cut cut;
  cut.bricks = 1 + bytes.below(6);
  const bool by_position = bytes.below(2) == 1;
  uint64_t id = 0;
  for (uint32_t i = 0; i < set.n(); ++i) {
    const oracle::LatticeBall &b = set.balls[i];
    const double centre[3] = {static_cast<double>(b.x), static_cast<double>(b.y), static_cast<double>(b.z)};
    const auto radius = static_cast<double>(set.radius_of(i));
    const auto slab = static_cast<uint32_t>(std::abs(b.x / (2 * set.steps_per_unit)));
    cut.balls.push(centre, radius, id += 1 + bytes.below(3), (by_position ? slab : bytes.byte()) % cut.bricks);
    cut.largest = std::max(cut.largest, radius);
  }
  return cut;
}

// The model of a brick: its own balls, those that meet one of them (decided in integers), and some others at random.
OwnedBalls model_of(const Cut &cut, uint32_t brick, fuzz::Bytes &bytes) {
  const OwnedBalls &balls = cut.balls;
  std::vector<uint8_t> in(balls.size());
  for (uint32_t i = 0; i < balls.size(); ++i) {
    in[i] = balls.owner[i] == brick || bytes.one_in(8);
    for (uint32_t j = 0; j < balls.size() && in[i] == 0; ++j) {
      if (balls.owner[j] != brick) continue;
      int64_t square = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const int64_t d = balls.at(i, axis) - balls.at(j, axis);
        square += d * d;
      }
      const int64_t touch = balls.r(i) + balls.r(j);
      in[i] = square <= touch * touch;
    }
  }
  return balls.part(in);
}

// Writes the check sum into a summary, as the library's summary_block.hpp defines it.
void put_check_sum(Summary &summary) {
  uint64_t sum = UINT64_C(0xCBF29CE484222325);
  size_t k = 0;
  for (; k + 12 <= summary.size(); k += 4) {
    uint32_t word = 0;
    for (size_t byte = 4; byte-- > 0;) word = word << 8 | summary[k + byte];
    sum = (sum ^ word) * UINT64_C(0x9E3779B97F4A7C15);
    sum ^= sum >> 32;
  }
  for (size_t byte = 0; byte < 8; ++byte) summary[k + byte] = static_cast<uint8_t>(sum >> 8 * byte);
}

bool is_documented(int32_t status) {
  return status == HSP_OK || status == HSP_E_ARGUMENT || status == HSP_E_VERSION || status == HSP_E_STATE ||
         status == HSP_E_ID || status == HSP_E_CONFLICT || status == HSP_E_DAMAGED;
}

// Reads a summary of any bytes by itself, and merges it with a sound one. The result of a successful merge must not be
// a damaged summary.
void require_total(const Summary &any, const Summary &sound) {
  hsp_brick_totals totals;
  const int32_t read = support::get_totals(any, totals);
  FUZZ_REQUIRE(is_documented(read), "a status of totals");
  uint32_t needed = 0;
  const int32_t listed = hsp_brick_get_shells(any.data(), any.size(), nullptr, 0, &needed, nullptr);
  if (listed == HSP_E_CAPACITY) {
    std::vector<hsp_brick_shell> shells(needed);
    FUZZ_REQUIRE(hsp_brick_get_shells(any.data(), any.size(), shells.data(), needed, &needed, nullptr) == HSP_OK,
                 "shells in as much room as they take");
  } else {
    FUZZ_REQUIRE(is_documented(listed), "a status of shells");
  }
  for (const bool turned : {false, true}) {
    Summary merged;
    const int32_t status = turned ? support::merge(any, sound, merged) : support::merge(sound, any, merged);
    FUZZ_REQUIRE(is_documented(status), "a status of merges");
    FUZZ_REQUIRE(status != HSP_OK || support::get_totals(merged, totals) != HSP_E_DAMAGED, "a merge is damaged");
  }
}

// Numbers of the header that say how long lists are come first, and are changed as often as all others.
void require_any_numbers(const std::vector<Summary> &parts, fuzz::Bytes &bytes) {
  Summary any = parts[bytes.below(static_cast<uint32_t>(parts.size()))];
  for (uint32_t changes = bytes.below(4); changes > 0; --changes) {
    const auto words = static_cast<uint32_t>(any.size() / 4);
    const size_t at = 4 * size_t{bytes.one_in(3) ? 10 + bytes.below(6) : bytes.below(words)};
    if (at < any.size()) any[at] = bytes.one_in(2) ? bytes.byte() : static_cast<uint8_t>(any[at] + 1);
  }
  put_check_sum(any);
  require_total(any, parts[0]);
}

void require_any_bytes(const Summary &sound, fuzz::Bytes &bytes) {
  Summary any(4 * bytes.below(100) + 4);
  for (uint8_t &byte : any) byte = bytes.byte();
  if (any.size() >= 12) put_check_sum(any);
  require_total(any, sound);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const Cut cut = cut_set(bytes);
  BrickMaker maker;
  OwnedBalls whole = cut.balls;
  for (uint32_t &owner : whole.owner) owner = 0;
  maker.compute(whole, cut.largest);
  const Summary one = maker.summarise(whole, 0, 1, HSP_BRICK_KEEP_SHELLS);
  hsp_brick_totals expected, totals;
  FUZZ_REQUIRE(support::get_totals(one, expected) == HSP_OK, "totals of one piece");
  hsp_boundary_counts counts;
  FUZZ_REQUIRE(hsp_boundary_get_counts(maker.work().boundary, &counts) == HSP_OK, "counts");
  FUZZ_REQUIRE(expected.components == counts.components && expected.voids == counts.voids &&
                   expected.euler == counts.euler && expected.vertices == counts.vertices,
               "counts of one piece");

  std::vector<Summary> parts;
  for (uint32_t brick = 0; brick < cut.bricks; ++brick) {
    const OwnedBalls balls = model_of(cut, brick, bytes);
    maker.compute(balls, cut.largest);
    parts.push_back(maker.summarise(balls, brick, cut.bricks, HSP_BRICK_KEEP_SHELLS));
  }
  require_any_numbers(parts, bytes);
  require_any_bytes(parts[0], bytes);
  while (parts.size() > 1) {
    const auto count = static_cast<uint32_t>(parts.size());
    const uint32_t a = bytes.below(count), b = (a + 1 + bytes.below(count - 1)) % count;
    Summary merged;
    FUZZ_REQUIRE(support::merge(parts[a], parts[b], merged) == HSP_OK, "a merge");
    parts[a].swap(merged);
    parts.erase(parts.begin() + b);
  }
  FUZZ_REQUIRE(support::get_totals(parts[0], totals) == HSP_OK, "totals");
  FUZZ_REQUIRE(support::same_bits(totals, expected), "totals have other bits");
  FUZZ_REQUIRE(support::same_bits(support::shells_of(parts[0]), support::shells_of(one)), "shells have other bits");
  return 0;
}
