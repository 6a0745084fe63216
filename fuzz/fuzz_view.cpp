// Views and pictures of any set: everything the header promises about records, the regions they enclose and what is
// seen, the same bytes twice, no effect of the order of the balls, short arrays and limits that are too small; pictures
// with any options, and sinks that refuse.
#include <picture_sink.h>
#include <view_invariants.h>

#include <string>

#include "computed_set.hpp"
#include "guarded_output.hpp"
#include "required_limits.hpp"
#include "topology_input.hpp"
#include "view_input.hpp"

namespace {

using fuzz::same;

// ---- records ----

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

// What has been read can be read again.
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

// ---- pictures ----

hsp_picture_options picture_options(fuzz::Bytes &bytes) {
  hsp_picture_options options;
  FUZZ_REQUIRE(hsp_picture_options_init(&options, sizeof options) == HSP_OK, "hsp_picture_options_init");
  static constexpr double sizes[] = {1000, 0, 1, 37.5, 1e6, 1e-3, 5e-324};
  static constexpr double outlines[] = {-1, 0, 0.5, 3, 1e6, -1e300, 5e-324};
  options.format = bytes.below(3);
  options.style = bytes.below(3);
  options.unit = bytes.below(2);
  options.flags = bytes.below(4);
  options.width = sizes[bytes.below(7)];
  options.height = bytes.one_in(3) || options.width == 0 ? sizes[bytes.below(7)] : 0;
  if (options.width == 0 && options.height == 0) options.height = 200;
  options.outline = outlines[bytes.below(7)];
  options.margin = bytes.one_in(4) ? bytes.below(101) / 10.0 : 0.03;
  options.fog = bytes.below(5) / 4.0;
  options.outline_colour = bytes.below(256) << 16 | bytes.below(256);
  options.background = bytes.below(256) << 8;
  if (bytes.one_in(3)) {
    // Around the scale at which balls of a set are as large as the page, and far from it.
    static constexpr double scales[] = {1, 10, 100, 0.01, 1e4, 1e6, 1e-30, 5e-324, 1e300};
    options.scale = scales[bytes.below(9)];
    for (double &coordinate : options.centre) {
      coordinate = bytes.one_in(20) ? 1e9 : (bytes.below(41) - 20.0) * (bytes.one_in(5) ? 1000 : 1);
    }
  }
  return options;
}

// Of a ball's place and radius alone, so that equal balls have equal colours.
std::vector<uint32_t> colours_of(const computed &c) {
  std::vector<uint32_t> colour(c.n + 1);
  for (uint32_t i = 0; i < c.n; ++i) {
    const double place = c.xyz[3 * i] + 2 * c.xyz[3 * i + 1] + 3 * c.xyz[3 * i + 2] + 5 * c.radius[i];
    const auto number = static_cast<uint32_t>(std::fmod(std::fabs(place), 120.0));
    colour[i] = hsp_palette_colour(number % 4, number, number / 7);
    FUZZ_REQUIRE(colour[i] <= 0xFFFFFF, "hsp_palette_colour");
  }
  return colour;
}

class Picture {
 public:
  Picture(const view_result &v, const hsp_picture_options &options, const std::string &title, size_t accepts) {
    const std::vector<uint32_t> colour = colours_of(*v.base);
    uint64_t bytes = 12345;
    picture_sink_start(&sink_, accepts);
    status_ = hsp_picture_write(v.view, colour.data(), &options, title.c_str(), title.c_str(), picture_sink_take,
                                &sink_, &bytes);
    FUZZ_REQUIRE(status_ == HSP_OK || status_ == HSP_E_SINK || (status_ == HSP_E_RANGE && options.scale > 0),
                 hsp_status_text(status_));
    FUZZ_REQUIRE(bytes == sink_.count, "bytes is not the number of bytes taken");
    FUZZ_REQUIRE(sink_.odd == 0, "the sink was called with too much, nothing, or after it had refused");
    FUZZ_REQUIRE((status_ == HSP_E_SINK) == (sink_.refused == 1), "HSP_E_SINK exactly if the sink refuses");
  }
  ~Picture() { picture_sink_release(&sink_); }
  Picture(const Picture &) = delete;
  Picture &operator=(const Picture &) = delete;

  int32_t status() const { return status_; }
  std::string text() const { return {sink_.bytes, sink_.count}; }
  std::string text_without_ids() const {
    size_t length = 0;
    char *bare = picture_without_ids(sink_.bytes, sink_.count, &length);
    const std::string result(bare, length);
    std::free(bare);
    return result;
  }

 private:
  picture_sink sink_{};
  int32_t status_ = 0;
};

std::string some_title(fuzz::Bytes &bytes) {
  std::string title;
  for (uint32_t more = bytes.one_in(3) ? bytes.below(12) : 0; more > 0; --more) {
    title.push_back(static_cast<char>(bytes.byte()));
  }
  return title;
}

void require_pictures(const view_result &v, const view_result &other, fuzz::Bytes &bytes) {
  const hsp_picture_options options = picture_options(bytes);
  const std::string title = some_title(bytes);
  const Picture one(v, options, title, SIZE_MAX), again(v, options, title, SIZE_MAX);
  FUZZ_REQUIRE(one.status() == again.status(), "a picture is refused now and then");
  if (one.status() == HSP_E_RANGE) {
    FUZZ_REQUIRE(one.text().empty(), "a part of a picture that is refused");
    return;
  }
  const std::string text = one.text();
  FUZZ_REQUIRE(one.status() == HSP_OK && !text.empty(), "a picture");
  FUZZ_REQUIRE(text == again.text(), "a picture differs the second time");
  if (options.format != HSP_FORMAT_PDF && title.empty()) {
    FUZZ_REQUIRE(text.find("nan") == std::string::npos && text.find("inf") == std::string::npos, "not a number");
    for (const char character : text) {
      FUZZ_REQUIRE(character == '\n' || (character >= ' ' && character <= '~'), "a character that is not ASCII");
    }
  }
  // hsp_picture_write, property 1
  const Picture of_other(other, options, title, SIZE_MAX);
  FUZZ_REQUIRE(one.text_without_ids() == of_other.text_without_ids(), "a picture depends on the order of the balls");
  const size_t accepts = bytes.below(65536) % text.size();
  const Picture stopped(v, options, title, accepts);
  FUZZ_REQUIRE(stopped.status() == HSP_E_SINK, "a sink that refuses");
  FUZZ_REQUIRE(text.compare(0, stopped.text().size(), stopped.text()) == 0, "bytes before the sink refuses");
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
  require_pictures(reference.get(), other.get(), bytes);
  require_unchanged(reference.get());
  return 0;
}
