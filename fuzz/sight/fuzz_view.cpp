// Views and pictures of any set: every promise of the header about records, the regions they enclose and the balls that
// are seen, by the invariants of tests/api/support; the same bytes twice; no effect of the order of the balls; short
// arrays and limits that are too small; pictures with any options, and sinks that refuse.
#include <view_invariants.h>

#include "computed_set.hpp"
#include "guarded_output.hpp"
#include "owned_views.hpp"
#include "picture_calls.hpp"
#include "required_limits.hpp"
#include "topology_input.hpp"
#include "view_input.hpp"

namespace {

using fuzz::same;

class Result {
 public:
  Result(const fuzz::ScaledBalls &set, const hsp_view_options &options, bool with_boundary) : set_(set) {
    const int32_t status = view_result_make(&set_.get(), &options, with_boundary ? 1 : 0, &view_);
    FUZZ_REQUIRE(status == HSP_OK, hsp_status_text(status));
  }
  ~Result() { view_result_release(&view_); }
  Result(const Result &) = delete;
  Result &operator=(const Result &) = delete;

  const view_result &get() const { return view_; }

 private:
  fuzz::ComputedSet set_;
  view_result view_{};
};

void require_sound(const view_result &v, fuzz::Bytes &bytes) {
  const char *broken = broken_view(&v);
  FUZZ_REQUIRE(broken == nullptr, broken);
  broken = broken_view_regions(&v, 4, bytes.below(65536));
  FUZZ_REQUIRE(broken == nullptr, broken);
}

void require_same_bytes(const view_result &a, const view_result &b) {
  FUZZ_REQUIRE(std::memcmp(&a.info, &b.info, sizeof a.info) == 0, "info differs the second time");
  FUZZ_REQUIRE(same(a.pieces, b.pieces, a.info.pieces), "pieces differ the second time");
  FUZZ_REQUIRE(same(a.loops, b.loops, a.info.loops), "loops differ the second time");
  FUZZ_REQUIRE(same(a.arcs, b.arcs, a.info.arcs), "arcs differ the second time");
}

// Arrays that are too short: HSP_E_CAPACITY, the number that suffices, and nothing written.
template <class Record, class Get>
void require_short_array(const hsp_view *view, uint32_t count, const Get &get, fuzz::Bytes &bytes) {
  const uint32_t capacity = bytes.below(count + 2);
  fuzz::Output<Record> out(capacity, false);
  uint32_t needed = 12345;
  const int32_t status = get(view, out.data(), capacity, &needed);
  FUZZ_REQUIRE(status == (capacity < count ? HSP_E_CAPACITY : HSP_OK), "status of an array function");
  FUZZ_REQUIRE(needed == count, "needed");
  FUZZ_REQUIRE(out.untouched_from(status == HSP_OK ? count : 0), "written where nothing belongs");
}

void require_short_arrays(const view_result &v, fuzz::Bytes &bytes) {
  require_short_array<hsp_view_piece>(v.view, v.info.pieces, hsp_view_get_pieces, bytes);
  require_short_array<hsp_view_loop>(v.view, v.info.loops, hsp_view_get_loops, bytes);
  require_short_array<hsp_view_arc>(v.view, v.info.arcs, hsp_view_get_arcs, bytes);
}

void require_capacities(const view_result &reference, fuzz::Bytes &bytes) {
  const hsp_boundary *boundary = reference.with_boundary != 0 ? reference.base->boundary : nullptr;
  const auto compute = [&](hsp_view *view, hsp_view_limits *limits) {
    return hsp_view_compute(view, reference.base->model, boundary, &reference.options, limits);
  };
  const auto read = [&](const hsp_view *view) {
    hsp_view_info info{};
    const int32_t status = hsp_view_get_info(view, &info);
    if (status == HSP_OK)
      FUZZ_REQUIRE(std::memcmp(&info, &reference.info, sizeof info) == 0, "info differs with more room");
    return status;
  };
  hsp_view_limits limits;
  FUZZ_REQUIRE(hsp_view_limits_init(&limits, sizeof limits, reference.base->n) == HSP_OK, "hsp_view_limits_init");
  fuzz::require_limits<support::ViewKind>(reference.needed, bytes, compute, read);
}

// Results that have been read can be read again.
void require_unchanged(const view_result &v) {
  view_result again = v;
  std::vector<hsp_view_piece> pieces(v.info.pieces + 1);
  std::vector<hsp_view_loop> loops(v.info.loops + 1);
  std::vector<hsp_view_arc> arcs(v.info.arcs + 1);
  uint32_t needed = 0;
  FUZZ_REQUIRE(hsp_view_get_info(v.view, &again.info) == HSP_OK, "info after pictures");
  FUZZ_REQUIRE(hsp_view_get_pieces(v.view, pieces.data(), v.info.pieces, &needed) == HSP_OK, "pieces after pictures");
  FUZZ_REQUIRE(hsp_view_get_loops(v.view, loops.data(), v.info.loops, &needed) == HSP_OK, "loops after pictures");
  FUZZ_REQUIRE(hsp_view_get_arcs(v.view, arcs.data(), v.info.arcs, &needed) == HSP_OK, "arcs after pictures");
  again.pieces = pieces.data();
  again.loops = loops.data();
  again.arcs = arcs.data();
  require_same_bytes(v, again);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const hsp_view_options options = fuzz::view_options(bytes);
  const bool with_boundary = options.pieces == HSP_PIECES_OUTSIDE_ALL || bytes.one_in(3);
  const fuzz::ScaledBalls set = fuzz::topology_set(bytes);
  const Result reference(set, options, with_boundary);
  require_sound(reference.get(), bytes);
  const Result again(set, options, with_boundary);
  require_same_bytes(reference.get(), again.get());
  // hsp_view_compute, property 1
  const Result other(fuzz::permuted(set, fuzz::shuffled(set.n(), bytes)), options, with_boundary);
  const char *what = view_difference_after_permutation(&reference.get(), &other.get());
  FUZZ_REQUIRE(what == nullptr, what);
  require_short_arrays(reference.get(), bytes);
  require_capacities(reference.get(), bytes);
  const auto writes = [](const view_result &v) {
    return [&v](auto... arguments) { return hsp_picture_write(v.view, arguments...); };
  };
  fuzz::require_pictures(*reference.get().base, writes(reference.get()), *other.get().base, writes(other.get()), bytes);
  require_unchanged(reference.get());
  return 0;
}
