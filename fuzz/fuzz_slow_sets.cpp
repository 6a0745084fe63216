// No set is slow: the work of each stage of the stable tier must stay below a bound times the size of its input and
// output. Work is counted, not timed: the basic blocks that run, in a copy of the core that is compiled to count them.
// libFuzzer keeps each set that takes a twentieth more work for its size than all sets before it.
#include <owned_handle.hpp>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "checked_model.hpp"
#include "crowded_sets.hpp"
#include "exact/stage_counters.hpp"

#if !defined(HSP_COUNT_STAGES)
#error "this harness is about what is counted"
#endif

namespace {

uint64_t blocks_run = 0;

enum StageId : size_t {
  setting,
  pairing,
  boundary_stage,
  measuring,
  flagging,
  contact_stage,
  topology_stage,
  integers,
  all
};

// `most`: the bound of a stage for each ball, pair of balls that meet, vertex and circle of a set. It is a number of
// basic blocks; for `integers` it is a number of questions that no filter answers. Sanitizers make up to five blocks of
// one.
//
// The worst of 3,000 random sets take 6,300 blocks of the boundary, 5,300 of contacts, 1,300 of topology, and 43
// questions. The worst that libFuzzer found in 69,000 sets take
//   - 8,700 of contacts, with 49 questions: 288 balls around a circle of the lattice and 21 through one point,
//   - 11,800 of topology, with 73 questions: 314 balls that stud one of two balls that nearly agree,
//   - 4,700 of flags: small balls, too few for an index, beside a line of large ones.
// One known set is beyond the bounds: 399 balls around a circle of the lattice with one beside it take 44,400 blocks of
// the boundary, 0.7 seconds.
struct Stage {
  const char *name;
  double most;
};
constexpr Stage stages[] = {{"model", 300},  {"pairs", 1000},    {"boundary", 7000},  {"measures", 400},
                            {"flags", 6000}, {"contacts", 9500}, {"topology", 15000}, {"integers", 90}};
static_assert(std::size(stages) == all);
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HSP_SANITIZED 1
#endif
#endif
#if defined(HSP_SANITIZED) || defined(__SANITIZE_ADDRESS__)
constexpr double blocks_of_one = 5;
#else
constexpr double blocks_of_one = 1;
#endif

using Work = std::array<uint64_t, all>;

// Work is reported to libFuzzer in steps of a twentieth; it keeps the first set that reaches a step.
constexpr uint32_t steps_of_work = 320;
#if defined(__linux__)
__attribute__((used, section("__libfuzzer_extra_counters")))
#endif
uint8_t reached[all][steps_of_work];

const char *const printed = std::getenv("SLOW_SETS_PRINTED");

// Requires that the work of each stage is within its bound. 64 is added to the size of each set, as starting takes
// work, too.
void require_little(const Work &work, uint64_t size) {
  for (size_t k = 0; k < all; ++k) {
    const double each = static_cast<double>(work[k]) / static_cast<double>(size + 64);
    const auto step = static_cast<uint32_t>(std::log(each + 1.0) / std::log(1.05));
    reached[k][std::min(step, steps_of_work - 1)] = 1;
    if (printed != nullptr) {
      std::printf(" %s %.1f", stages[k].name, each);
    } else {
      FUZZ_REQUIRE(each <= blocks_of_one * stages[k].most, stages[k].name);
    }
  }
}

uint64_t pairs_of(const hsp_model *model, uint32_t n) {
  std::vector<uint32_t> first(n + 1);
  uint32_t needed = 0;
  const int32_t status = hsp_query_pairs(model, HSP_PAIRS_ONCE, first.data(), nullptr, 0, &needed);
  FUZZ_REQUIRE(status == (needed == 0 ? HSP_OK : HSP_E_CAPACITY), "hsp_query_pairs");
  return needed;
}

void measure(const hsp_boundary *boundary, uint32_t n) {
  std::vector<double> area(n), term(n), by_area(3 * size_t{n}), by_volume(3 * size_t{n});
  FUZZ_REQUIRE(hsp_boundary_measure(boundary, nullptr, nullptr, area.data(), term.data(), n, nullptr) == HSP_OK, "");
  hsp_derivatives_outputs derivatives{};
  derivatives.struct_size = sizeof derivatives;
  derivatives.capacity = n;
  derivatives.area_centre = by_area.data();
  derivatives.volume_centre = by_volume.data();
  FUZZ_REQUIRE(hsp_boundary_get_derivatives(boundary, nullptr, &derivatives) == HSP_OK, "derivatives");
}

void flag(const hsp_boundary *boundary, uint32_t n) {
  std::vector<uint32_t> flags(n);
  hsp_derivatives_outputs derivatives{};
  derivatives.struct_size = sizeof derivatives;
  derivatives.capacity = n;
  derivatives.flags = flags.data();
  FUZZ_REQUIRE(hsp_boundary_get_derivatives(boundary, nullptr, &derivatives) == HSP_OK, "flags");
}

// Repeats a computation until its limits suffice, and counts the call that takes most work, successful or not.
template <class Handle, class Compute>
void count(Work &work, StageId stage, Handle &handle, Compute compute) {
  uint64_t most_integers = 0;
  handle.compute([&](auto *inside, auto *limits) {
    hsp::exact::stage_counters = {};
    blocks_run = 0;
    const int32_t status = compute(inside, limits);
    work[stage] = std::max(work[stage], blocks_run);
    uint64_t questions = 0;
    for (const auto &of_question : hsp::exact::stage_counters.answers) {
      for (const auto by : {hsp::exact::Stage::exact, hsp::exact::Stage::perturbation}) {
        questions += of_question[static_cast<size_t>(by)];
      }
    }
    most_integers = std::max(most_integers, questions);
    return status;
  });
  work[integers] += most_integers;
}

// Prints the balls in the form that the program hardsphere reads.
void print_balls(const oracle::Balls &balls) {
  for (const oracle::LatticeBall &ball : balls) {
    for (const int64_t number : {ball.x, ball.y, ball.z, ball.radius}) {
      std::printf("%lld ", static_cast<long long>(number));
    }
    std::printf("\n");
  }
}

}  // namespace

extern "C" void __wrap___sanitizer_cov_trace_pc();
extern "C" void __wrap___sanitizer_cov_trace_pc() {
  ++blocks_run;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const fuzz::ScaledBalls set = fuzz::CrowdedSet(bytes, 400).take();
  Work work{};

  blocks_run = 0;
  const fuzz::CheckedModel model(set, 0);
  work[setting] = std::exchange(blocks_run, 0);
  const uint64_t pairs = pairs_of(model.get(), set.n());
  work[pairing] = blocks_run;

  support::OwnedBoundary boundary;
  boundary.take(support::default_boundary_limits(set.n()));
  count(work, boundary_stage, boundary, [&model](hsp_boundary *handle, hsp_boundary_limits *limits) {
    return hsp_boundary_compute(handle, model.get(), limits);
  });
  hsp_boundary_counts counts;
  FUZZ_REQUIRE(hsp_boundary_get_counts(boundary.get(), &counts) == HSP_OK, "counts");
  blocks_run = 0;
  measure(boundary.get(), set.n());
  work[measuring] = std::exchange(blocks_run, 0);
  flag(boundary.get(), set.n());
  work[flagging] = blocks_run;

  support::OwnedContacts contacts;
  contacts.take(support::contacts_limits_for(boundary.get()));
  count(work, contact_stage, contacts, [&boundary](hsp_contacts *handle, hsp_contacts_limits *limits) {
    return hsp_contacts_compute(handle, boundary.get(), limits);
  });
  support::OwnedTopology topology;
  topology.take(support::topology_limits_for(boundary.get()));
  count(work, topology_stage, topology, [&boundary](hsp_topology *handle, hsp_topology_limits *limits) {
    return hsp_topology_compute(handle, boundary.get(), limits);
  });

  if (printed != nullptr) {
    std::printf("balls %u pairs %llu vertices %u", set.n(), static_cast<unsigned long long>(pairs), counts.vertices);
  }
  require_little(work, set.n() + pairs + counts.vertices + counts.circles);
  if (printed != nullptr) {
    std::printf("\n");
    if (std::strcmp(printed, "balls") == 0) print_balls(set.balls);
  }
  return 0;
}
