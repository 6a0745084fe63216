// Balls and sticks of any set: pictures or conflicts, the same twice, no effect of the order of the balls, and limits
// that are too small.
#include <cmath>
#include <cstring>
#include <vector>

#include "computed_set.hpp"
#include "picture_calls.hpp"
#include "required_limits.hpp"
#include "topology_input.hpp"
#include "view_input.hpp"

namespace {

// Balls on a loose lattice, which rarely meet, or any set.
fuzz::ScaledBalls stick_set(fuzz::Bytes &bytes) {
  if (bytes.one_in(4)) return fuzz::topology_set(bytes);
  fuzz::ScaledBalls set;
  const uint32_t n = bytes.below(12);
  for (uint32_t k = 0; k < n; ++k) {
    oracle::LatticePoint centre{};
    for (int64_t &coordinate : centre) coordinate = 16 * int64_t{bytes.below(6)};
    centre[2] += bytes.below(16);
    set.balls.push_back(oracle::ball_around(centre, bytes.below(9)));
  }
  return set;
}

std::vector<hsp_stick> sticks_between(uint32_t n, fuzz::Bytes &bytes) {
  std::vector<hsp_stick> sticks(bytes.below(12));
  for (hsp_stick &stick : sticks) {
    stick = {{bytes.below(n + (bytes.one_in(16) ? 1 : 0) + (n == 0 ? 1 : 0)), 0}, bytes.below(2), 0};
    stick.ball[1] = n == 0 ? 0 : bytes.below(n);
  }
  return sticks;
}

struct Result {
  int32_t status;
  hsp_sticks_conflict conflict;
  hsp_sticks_limits needed;
  hsp_sticks_info info;
};

Result computed_with(const hsp_model *model, const hsp_view_options &options, const std::vector<hsp_stick> &stick,
                     double radius) {
  Result result{};
  const auto count = static_cast<uint32_t>(stick.size());
  // Suffices for so few.
  result.needed = {sizeof result.needed, 200, 200, 200 * 200, 4000};
  support::OwnedHandle<support::SticksKind> sticks;
  sticks.take(result.needed);
  result.status =
      hsp_sticks_compute(sticks.get(), model, &options, stick.data(), count, radius, &result.conflict, &result.needed);
  // Of a stick that is far thinner than roundings both sides are one line.
  const bool thin = radius < 1e-9;
  FUZZ_REQUIRE(result.status == HSP_OK || result.status == HSP_E_CONFLICT || (thin && result.status == HSP_E_CHECK),
               hsp_status_text(result.status));
  const int32_t read = hsp_sticks_get_info(sticks.get(), &result.info);
  FUZZ_REQUIRE(read == (result.status == HSP_OK ? HSP_OK : HSP_E_STATE), "results, by the status");
  return result;
}

// Numbers are those of balls or sticks, as the kind says.
void require_named(const Result &result, uint32_t n, uint32_t count) {
  if (result.status == HSP_E_CHECK) return;
  const uint32_t kind = result.conflict.kind, first = result.conflict.first, second = result.conflict.second;
  const bool without_order = kind == HSP_STICKS_BALLS_MEET || kind == HSP_STICKS_CYCLE;
  FUZZ_REQUIRE((result.status == HSP_OK) == (kind == HSP_STICKS_NO_CONFLICT || without_order),
               "a conflict, by the status");
  FUZZ_REQUIRE(result.status != HSP_OK || (result.needed.edges > 0) == without_order, "edges, by the order");
  if (result.status == HSP_OK) {
    FUZZ_REQUIRE(result.info.balls <= n && result.info.sticks == count, "numbers of info");
    FUZZ_REQUIRE(result.info.paths <= result.info.balls + 2 * count, "paths of info");
  }
  switch (kind) {
    case HSP_STICKS_NO_CONFLICT:
      FUZZ_REQUIRE(first == HSP_NONE && second == HSP_NONE, "no conflict");
      break;
    case HSP_STICKS_BALLS_MEET:
      FUZZ_REQUIRE(first < second && second < n, "two balls");
      break;
    case HSP_STICKS_NO_BALL:
      FUZZ_REQUIRE(first < count && second >= n, "a stick without a ball");
      break;
    case HSP_STICKS_THIN_BALL:
    case HSP_STICKS_STICK_IN_BALL:
      FUZZ_REQUIRE(first < count && second < n, "a stick and a ball");
      break;
    case HSP_STICKS_CYCLE:
      FUZZ_REQUIRE(first < count && second > 2, "a stick of a cycle");
      break;
    default:
      FUZZ_REQUIRE(kind <= HSP_STICKS_CYCLE && first <= second && second < count, "two sticks");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const hsp_view_options options = fuzz::view_options(bytes);
  const fuzz::ScaledBalls set = stick_set(bytes);
  std::vector<hsp_stick> stick = sticks_between(set.n(), bytes);
  const double radius = std::ldexp(1.0 + bytes.below(64), -static_cast<int>(bytes.below(8))) *
                        (bytes.one_in(32) ? 1e-300 : set.length(1));
  const auto count = static_cast<uint32_t>(stick.size());
  const fuzz::ComputedSet base(set);
  const Result reference = computed_with(base.get().model, options, stick, radius);
  require_named(reference, set.n(), count);
  const Result again = computed_with(base.get().model, options, stick, radius);
  FUZZ_REQUIRE(std::memcmp(&again, &reference, sizeof again) == 0, "another result the second time");

  const auto compute = [&](hsp_sticks *sticks, hsp_sticks_limits *limits) {
    return hsp_sticks_compute(sticks, base.get().model, &options, stick.data(), count, radius, nullptr, limits);
  };
  const auto read = [&](const hsp_sticks *sticks) {
    hsp_sticks_info info{};
    const int32_t status = hsp_sticks_get_info(sticks, &info);
    if (status == HSP_OK)
      FUZZ_REQUIRE(std::memcmp(&info, &reference.info, sizeof info) == 0, "info differs with more room");
    return status;
  };
  hsp_sticks_limits limits;
  FUZZ_REQUIRE(hsp_sticks_limits_init(&limits, sizeof limits, set.n()) == HSP_OK, "hsp_sticks_limits_init");
  if (reference.status == HSP_OK) fuzz::require_limits<support::SticksKind>(reference.needed, bytes, compute, read);

  if (reference.status == HSP_OK) {
    support::OwnedHandle<support::SticksKind> sticks;
    sticks.take(reference.needed);
    FUZZ_REQUIRE(compute(sticks.get(), nullptr) == HSP_OK, "with what is needed");
    const auto write = [&sticks](auto... arguments) { return hsp_picture_write_sticks(sticks.get(), arguments...); };
    fuzz::require_pictures(base.get(), write, base.get(), write, bytes);
  }

  const std::vector<uint32_t> order = fuzz::shuffled(set.n(), bytes);
  std::vector<uint32_t> place(set.n());
  for (uint32_t k = 0; k < set.n(); ++k) place[order[k]] = k;
  for (hsp_stick &each : stick)
    for (uint32_t &ball : each.ball) ball = ball < set.n() ? place[ball] : ball;
  const fuzz::ComputedSet other(fuzz::permuted(set, order));
  const Result permuted = computed_with(other.get().model, options, stick, radius);
  FUZZ_REQUIRE(permuted.status == reference.status, "the status depends on the order of the balls");
  FUZZ_REQUIRE(permuted.info.paths == reference.info.paths, "paths depend on the order of the balls");
  return 0;
}
