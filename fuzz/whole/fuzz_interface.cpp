// Random sequences of calls with null pointers, wrong sizes, NaNs, short and misaligned memory. The harness keeps track
// of the contents of each handle, from which it knows the status that each call must return; outputs must be untouched
// whenever the header says so.
#include <hardsphere.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "gradient_calls.hpp"
#include "model_contents.hpp"
#include "struct_version.hpp"
#include "surface_calls.hpp"
#include "topology_calls.hpp"

namespace {

class Session {
 public:
  explicit Session(fuzz::Bytes &bytes) : bytes_(bytes), topology_(bytes), surface_(bytes) {
    // Most sessions begin in the usual order; else few would ever hold results.
    if (bytes_.one_in(4)) return;
    init_model();
    set_model();
    init_boundary();
    compute();
    topology_.init(boundary_, ready());
    topology_.compute(boundary_, ready(), results());
    surface_.init(boundary_, ready());
    surface_.compute(boundary_, ready(), results());
  }

  void step() {
    switch (bytes_.below(28)) {
      case 0:
        init_model();
        break;
      case 1:
      case 2:
        set_model();
        break;
      case 3:
        describe_model();
        break;
      case 4:
        query_places();
        break;
      case 5:
        query_neighbours();
        query_pairs();
        break;
      case 6:
        init_boundary();
        break;
      case 7:
      case 8:
        compute();
        break;
      case 9:
        read_records();
        break;
      case 10:
        measure();
        break;
      case 11:
        topology_.init(boundary_, ready());
        break;
      case 12:
      case 13:
        topology_.compute(null() ? nullptr : boundary_, ready(), results());
        break;
      case 14:
      case 15:
        topology_.read(results());
        break;
      case 16:
        topology_.locate(results());
        break;
      case 17:
        call_parts();
        break;
      case 18:
        call_derivatives();
        break;
      case 20:
      case 21:
      case 22:
        compute_with();
        break;
      case 23:
        surface_.init(boundary_, ready());
        break;
      case 24:
        surface_.compute(null() ? nullptr : boundary_, ready(), results());
        break;
      case 25:
      case 26:
        surface_.read(results());
        break;
      default:  // 19 and 27; inputs that were kept have these numbers
        constants();
    }
  }

 private:
  // The memory of a handle, and one byte behind it that must not be written.
  struct Block {
    std::vector<uint8_t> bytes;
    size_t misalignment = 0;

    uint8_t *handle() { return bytes.data() + misalignment; }
  };

  // Provides so many bytes for a handle: its own memory, so that it is made again in place, or a new block
  // (lib/ground/core/poison.hpp).
  bool take_block(Block &block, bool is_there, size_t bytes) {
    const size_t misalignment = bytes_.below(16);
    if (is_there && bytes_.below(2) == 0 && block.misalignment + bytes < block.bytes.size()) return true;
    const size_t spare = bytes_.below(2) * 16384;
    block = {std::vector<uint8_t>(misalignment + bytes + spare + 1, 0x3C), misalignment};
    return false;
  }

  void drop_boundary() {
    topology_.drop();
    surface_.drop();
    boundary_ = nullptr;
  }

  // ready: whether the boundary holds results of the model's contents. results: the number of these contents, 0 if not.
  bool ready() const { return !refused_ && complete_ && of_ == contents_; }
  uint64_t results() const { return ready() ? of_ : 0; }

  // Notes the new contents of the model. If it is unknown whether they equal earlier contents, all handles that were
  // computed from earlier contents are dropped.
  void take_contents(const std::vector<double> &xyz, const std::vector<double> &radius,
                     const hsp_model_options *options) {
    fuzz::ModelContents contents{xyz, radius, {0, 0, 0}, {}};
    if (options != nullptr) {
      contents.options[0] = options->probe;
      contents.options[1] = options->step;
      contents.options[2] = options->largest_radius;
    }
    FUZZ_REQUIRE(hsp_model_get_info(model_, &contents.info) == HSP_OK, "hsp_model_get_info");
    contents_ = known_.number_of(contents);
    if (contents_ != 0) return;
    drop_boundary();
    contents_ = known_.start_with(contents);
  }

  bool null() { return fuzz::null(bytes_); }
  double number() { return fuzz::number(bytes_, odd_numbers_); }

  void constants() {
    FUZZ_REQUIRE(hsp_version() == HSP_VERSION_NUMBER, "version");
    FUZZ_REQUIRE(hsp_abi() == HSP_ABI_NUMBER, "ABI number");
    FUZZ_REQUIRE(hsp_provisional() == HSP_PROVISIONAL_NUMBER, "provisional number");
    FUZZ_REQUIRE(hsp_numerics() == HSP_NUMERICS_NUMBER, "numerics number");
    FUZZ_REQUIRE(hsp_provisional_numerics() == HSP_PROVISIONAL_NUMERICS_NUMBER, "provisional numerics number");
    FUZZ_REQUIRE(hsp_model_max_balls() == HSP_MAX_BALLS, "most balls");
    const int32_t status = -static_cast<int32_t>(bytes_.below(20));
    FUZZ_REQUIRE(hsp_status_text(status) != nullptr && hsp_status_text(status)[0] != 0, "status text");
    element_radius();
    names();
  }

  // Texts of a few bytes, most of them letters and blanks.
  std::string text() {
    std::string made(bytes_.below(6), ' ');
    for (char &letter : made) {
      const bool odd = bytes_.one_in(10);
      letter = odd ? static_cast<char>(1 + bytes_.below(255)) : "AaBbCcDdEeGgHhLlNnOoPpSs12 "[bytes_.below(27)];
    }
    return made;
  }

  void names() {
    const std::string symbol = text(), residue = text();
    const uint32_t set = bytes_.below(5);
    uint32_t number = 777;
    double radius = 777;
    const int32_t known = hsp_element_number(null() ? nullptr : symbol.c_str(), &number);
    FUZZ_REQUIRE(known == HSP_OK ? number >= 1 && number <= 118 : number == 777, "number of an element");
    if (known == HSP_OK) {
      uint32_t again = 0;
      FUZZ_REQUIRE(hsp_element_number(hsp_element_symbol(number), &again) == HSP_OK && again == number, "symbol");
    }
    const bool there = set == HSP_RADII_PROTOR || set == HSP_RADII_NACCESS;
    const int32_t status = hsp_residue_radius(set, bytes_.one_in(2) ? "GLY" : residue.c_str(), symbol.c_str(), &radius);
    FUZZ_REQUIRE(status == HSP_OK ? 1 < radius && radius < 2 : radius == 777, "radius of a residue's atom");
    FUZZ_REQUIRE(there ? status == HSP_OK || status == HSP_E_ID : status == HSP_E_ARGUMENT, "hsp_residue_radius");
    check_array<hsp_residue_atom>(1500, there ? HSP_OK : HSP_E_ARGUMENT,
                                  [&](hsp_residue_atom *out, uint32_t capacity, uint32_t *needed) {
                                    return hsp_residue_get_atoms(set, out, capacity, needed);
                                  });
  }

  void element_radius() {
    const uint32_t set = bytes_.one_in(20) ? 2 + bytes_.byte() : bytes_.below(2);
    const uint32_t number = bytes_.one_in(20) ? HSP_NONE - bytes_.byte() : bytes_.below(125);
    fuzz::Output<double> radius(1, null());
    fuzz::Output<uint32_t> flags(1, null());
    const int32_t status = hsp_element_radius(set, number, radius.data(), flags.data());
    const bool bad_argument = (set > HSP_RADII_CHEM3D && set != HSP_RADII_UFF) || radius.data() == nullptr;
    const int32_t expected = bad_argument ? HSP_E_ARGUMENT : number < 1 || number > 118 ? HSP_E_ID : HSP_OK;
    FUZZ_REQUIRE(status == expected, "hsp_element_radius");
    const bool written = status == HSP_OK;
    FUZZ_REQUIRE(radius.untouched_from(written ? 1 : 0), "radius of an element on failure");
    FUZZ_REQUIRE(flags.untouched_from(written && flags.data() != nullptr ? 1 : 0), "flags of an element on failure");
    if (!written) return;
    FUZZ_REQUIRE(0.5 < *radius.data() && *radius.data() < 4, "radius of an element");
    if (flags.data() != nullptr) FUZZ_REQUIRE(*flags.data() <= HSP_RADIUS_FALLBACK, "flags of an element");
  }

  void init_model() {
    const uint32_t limit = bytes_.below(24);
    const bool no_memory = null(), no_handle = null();
    size_t bytes = 0;
    FUZZ_REQUIRE(hsp_model_bytes(limit, &bytes) == HSP_OK, "hsp_model_bytes");
    const size_t missing = bytes_.one_in(8) ? 1 + bytes_.below(200) : 0;
    const size_t given = missing < bytes ? bytes - missing : 0;
    const bool in_place = take_block(model_memory_, model_ != nullptr, given);
    if (!in_place) {
      // Handles that refer to the old memory go with it.
      drop_boundary();
      model_ = nullptr;
    }
    uint8_t *memory = no_memory ? nullptr : model_memory_.handle();
    hsp_model *made = nullptr;
    const int32_t status = hsp_model_init(memory, given, limit, no_handle ? nullptr : &made);
    const int32_t expected = no_memory || no_handle ? HSP_E_ARGUMENT : missing > 0 ? HSP_E_MEMORY : HSP_OK;
    FUZZ_REQUIRE(status == expected, "hsp_model_init");
    FUZZ_REQUIRE(model_memory_.bytes.back() == 0x3C, "written past the model's memory");
    if (status != HSP_OK) {
      FUZZ_REQUIRE(made == nullptr, "a handle after failure");
      if (in_place) return;  // what the handle's memory holds is its own
      for (const uint8_t byte : model_memory_.bytes) FUZZ_REQUIRE(byte == 0x3C, "written although refused");
      return;
    }
    FUZZ_REQUIRE(!in_place || made == model_, "a handle in the same memory is elsewhere");
    model_ = made;
    take_contents({}, {}, nullptr);
    limit_ = limit;
    balls_ = 0;
    as_made_ = true;
    refused_ = false;
  }

  void set_model() {
    const uint32_t wanted = bytes_.one_in(8) ? bytes_.below(28) : bytes_.below(limit_ + 1);
    std::vector<double> xyz(3 * size_t{wanted}), radius(wanted);
    odd_numbers_ = bytes_.one_in(3);
    for (double &x : xyz) x = number();
    for (double &r : radius) r = number();
    const bool again = known_.any() && bytes_.one_in(3);
    const fuzz::ModelContents *const before = again ? &known_.at(bytes_.byte()) : nullptr;
    if (again) {
      xyz = before->xyz;
      radius = before->radius;
    }
    const uint32_t n = static_cast<uint32_t>(radius.size());
    const bool no_model = model_ == nullptr || null(), no_xyz = null(), no_radius = null(),
               no_options = bytes_.below(2) == 0;
    hsp_model_options options;
    FUZZ_REQUIRE(hsp_model_options_init(&options, sizeof options) == HSP_OK, "hsp_model_options_init");
    options.reserved = bytes_.one_in(40) ? 1 : 0;
    options.probe = bytes_.one_in(3) ? number() : 0;
    options.step = bytes_.one_in(3) ? (bytes_.below(2) == 0 ? 1e-3 : number()) : 0;
    options.largest_radius = bytes_.one_in(6) ? number() : 0;
    if (again && bytes_.below(4) > 0) {
      options.probe = before->options[0];
      options.step = before->options[1];
      options.largest_radius = before->options[2];
    }
    fuzz::StructVersion<hsp_model_options, 24> version(options, bytes_);
    if (!version.whole()) options.largest_radius = 0;
    const bool bad_options = !no_options && (!version.good() || options.reserved != 0);

    uint32_t bad = 12345;
    const int32_t status =
        hsp_model_set(no_model ? nullptr : model_, n, no_xyz ? nullptr : xyz.data(),
                      no_radius ? nullptr : radius.data(), no_options ? nullptr : version.get(), &bad);
    FUZZ_REQUIRE(model_memory_.bytes.empty() || model_memory_.bytes.back() == 0x3C, "written past the model's memory");
    const bool bad_pointer = no_model || (n > 0 && (xyz.data() == nullptr || no_xyz || no_radius));
    if (!no_model) {
      balls_ = status == HSP_OK ? n : 0;
      as_made_ = refused_ = status != HSP_OK;
      if (status == HSP_OK) {
        take_contents(xyz, radius, no_options ? nullptr : &options);
      } else {
        take_contents({}, {}, nullptr);
      }
    }
    if (bad_pointer || bad_options) {
      FUZZ_REQUIRE(status == (no_model || !bad_options ? HSP_E_ARGUMENT : HSP_E_VERSION), "hsp_model_set, arguments");
      return;
    }
    if (n > limit_) {
      FUZZ_REQUIRE(status == HSP_E_CAPACITY, "hsp_model_set, capacity");
      return;
    }
    bool finite = true, negative = false;
    for (const double x : xyz) finite = finite && std::isfinite(x);
    for (const double r : radius) finite = finite && std::isfinite(r);
    for (const double r : radius) negative = negative || r < 0;
    if (!no_options) {
      finite = finite && std::isfinite(options.probe) && std::isfinite(options.step) &&
               std::isfinite(options.largest_radius);
      negative = negative || options.probe < 0 || options.step < 0 || options.largest_radius < 0;
    }
    switch (status) {
      case HSP_OK:
        FUZZ_REQUIRE(finite && !negative && bad == HSP_NONE, "taken although it should be refused");
        break;
      case HSP_E_NOT_FINITE:
        FUZZ_REQUIRE(!finite, "refused as not finite");
        break;
      case HSP_E_NEGATIVE:
        FUZZ_REQUIRE(negative, "refused as negative");
        break;
      case HSP_E_RANGE:
        break;
      default:
        FUZZ_REQUIRE(false, "a status that hsp_model_set does not have");
    }
    FUZZ_REQUIRE(bad == HSP_NONE || bad < n, "first_bad is no ball");
  }

  // The status of a question to the model, some of whose other arguments may be bad.
  int32_t model_status(const hsp_model *model, bool bad = false) const {
    return model == nullptr || bad ? HSP_E_ARGUMENT : refused_ ? HSP_E_STATE : HSP_OK;
  }

  void describe_model() {
    hsp_model *model = null() ? nullptr : model_;
    hsp_model_info info;
    hsp_packing figures;
    const int32_t expected = model == nullptr ? HSP_E_ARGUMENT : HSP_OK;
    FUZZ_REQUIRE(hsp_model_get_info(model, &info) == expected, "hsp_model_get_info");
    FUZZ_REQUIRE(hsp_model_get_packing(model, &figures) == model_status(model), "hsp_model_get_packing");
    if (expected != HSP_OK) return;
    FUZZ_REQUIRE(info.balls == balls_, "number of balls");
    FUZZ_REQUIRE(!as_made_ || (info.step == 1e-8 && info.probe == 0 && info.cubes == 0), "an empty model");
  }

  template <class Record, class Ask>
  void check_array(uint32_t most, int32_t argument_status, const Ask &ask) {
    fuzz::check_array<Record>(bytes_, most, argument_status, ask);
  }

  void query_places() {
    const hsp_model *model = null() ? nullptr : model_;
    double xyz[3];
    odd_numbers_ = bytes_.one_in(3);
    for (double &x : xyz) x = number();
    const double radius = number();
    const double *place = null() ? nullptr : xyz;
    uint32_t meets = 12345;
    const int32_t status = hsp_query_meets(model, place, radius, &meets);
    const bool pointers = model != nullptr && place != nullptr;
    const bool finite = std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]);
    FUZZ_REQUIRE(pointers || status == HSP_E_ARGUMENT, "hsp_query_meets, arguments");
    FUZZ_REQUIRE(!pointers || (status == HSP_E_STATE) == refused_, "hsp_query_meets of a model whose set has failed");
    FUZZ_REQUIRE(!pointers || (finite && std::isfinite(radius)) || status < 0,
                 "hsp_query_meets takes what is not finite");
    FUZZ_REQUIRE(status != HSP_OK || meets == 0 || meets == 1, "meets");
    FUZZ_REQUIRE(status == HSP_OK || meets == 12345, "meets written on failure");
    FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_ARGUMENT || status == HSP_E_NOT_FINITE ||
                     status == HSP_E_NEGATIVE || status == HSP_E_RANGE || status == HSP_E_STATE,
                 "a status that hsp_query_meets does not have");
    check_array<uint32_t>(24, status, [&](uint32_t *out, uint32_t capacity, uint32_t *needed) {
      return hsp_query_ball(model, place, radius, out, capacity, needed);
    });
    const int32_t whether = hsp_query_meets(model, place, 0, &meets);
    check_array<uint32_t>(24, whether, [&](uint32_t *out, uint32_t capacity, uint32_t *needed) {
      return hsp_query_point(model, place, out, capacity, needed);
    });
  }

  void query_neighbours() {
    const hsp_model *model = null() ? nullptr : model_;
    const uint32_t ball = bytes_.below(30);
    const int32_t asked = model_status(model), expected = asked == HSP_OK && ball >= balls_ ? HSP_E_ID : asked;
    check_array<uint32_t>(24, expected, [&](uint32_t *out, uint32_t capacity, uint32_t *needed) {
      return hsp_query_neighbours(model, ball, out, capacity, needed);
    });
  }

  void query_pairs() {
    const hsp_model *model = null() ? nullptr : model_;
    const uint32_t flags = bytes_.one_in(8) ? bytes_.below(8) : bytes_.below(2);
    std::vector<uint32_t> first(balls_ + 1);
    uint32_t *const begins = null() ? nullptr : first.data();
    const int32_t expected = model_status(model, begins == nullptr || flags > HSP_PAIRS_ONCE);
    check_array<uint32_t>(60, expected, [&](uint32_t *out, uint32_t capacity, uint32_t *needed) {
      return hsp_query_pairs(model, flags, begins, out, capacity, needed);
    });
  }

  void init_boundary() {
    hsp_boundary_limits limits;
    FUZZ_REQUIRE(hsp_boundary_limits_init(&limits, sizeof limits, bytes_.below(28)) == HSP_OK, "limits");
    if (bytes_.below(2) == 0) {
      limits.neighbours = bytes_.below(28);
      limits.vertices = bytes_.below(100);
      limits.circles = bytes_.below(30);
    }
    limits.workers = bytes_.one_in(40) ? HSP_MAX_WORKERS + 1 : bytes_.below(5);
    if (bytes_.one_in(16)) limits.vertices = 0xFFFFFFFF;
    fuzz::StructVersion<hsp_boundary_limits> version(limits, bytes_);
    size_t bytes = 12345;
    const int32_t status = hsp_boundary_bytes(version.get(), &bytes);
    const bool too_large = limits.vertices > HSP_MAX_BALLS || limits.workers > HSP_MAX_WORKERS;
    const int32_t expected = !version.good() ? HSP_E_VERSION : too_large ? HSP_E_RANGE : HSP_OK;
    FUZZ_REQUIRE(status == expected, "hsp_boundary_bytes");
    FUZZ_REQUIRE(status == HSP_OK || bytes == 12345, "bytes written on failure");
    if (status != HSP_OK) bytes = 4096;
    const size_t missing = bytes_.one_in(8) ? 1 + bytes_.below(200) : 0;
    const size_t given = missing < bytes ? bytes - missing : 0;
    const bool in_place = take_block(boundary_memory_, boundary_ != nullptr, given);
    if (!in_place) drop_boundary();
    hsp_boundary *made = nullptr;
    const int32_t done = hsp_boundary_init(boundary_memory_.handle(), given, version.get(), &made);
    FUZZ_REQUIRE(done == (status != HSP_OK ? status : missing > 0 ? HSP_E_MEMORY : HSP_OK), "hsp_boundary_init");
    FUZZ_REQUIRE(boundary_memory_.bytes.back() == 0x3C, "written past the boundary's memory");
    if (done != HSP_OK) {
      FUZZ_REQUIRE(made == nullptr, "a handle after failure");
      return;
    }
    FUZZ_REQUIRE(!in_place || made == boundary_, "a handle in the same memory is elsewhere");
    boundary_ = made;
    limits_ = limits;
    complete_ = false;
  }

  void compute() {
    hsp_boundary *boundary = null() ? nullptr : boundary_;
    const hsp_model *model = null() ? nullptr : model_;
    hsp_boundary_limits needed = limits_;
    const int32_t status = hsp_boundary_compute(boundary, model, &needed);
    FUZZ_REQUIRE(boundary_memory_.bytes.empty() || boundary_memory_.bytes.back() == 0x3C,
                 "written past the boundary's memory");
    if (boundary == nullptr) {
      FUZZ_REQUIRE(status == HSP_E_ARGUMENT, "hsp_boundary_compute, arguments");
      return;
    }
    // Earlier results are gone in any case.
    complete_ = status == HSP_OK;
    of_ = contents_;
    if (model == nullptr) {
      FUZZ_REQUIRE(status == HSP_E_ARGUMENT, "hsp_boundary_compute, arguments");
      return;
    }
    FUZZ_REQUIRE((status == HSP_E_STATE) == refused_, "hsp_boundary_compute of a model whose set has failed");
    if (refused_) return;
    FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_CAPACITY, "a status that hsp_boundary_compute does not have");
    const bool more = needed.balls > limits_.balls || needed.neighbours > limits_.neighbours ||
                      needed.vertices > limits_.vertices || needed.circles > limits_.circles;
    FUZZ_REQUIRE(more == (status == HSP_E_CAPACITY), "a limit is raised exactly after HSP_E_CAPACITY");
    if (status == HSP_OK) {
      hsp_boundary_counts counts;
      FUZZ_REQUIRE(hsp_boundary_get_counts(boundary, &counts) == HSP_OK, "hsp_boundary_get_counts");
      FUZZ_REQUIRE(counts.balls == balls_ && counts.vertices == needed.vertices && counts.circles == needed.circles,
                   "counts and needed limits");
    }
  }

  // Computes by an executor with any fields: it must give the same as one thread, or be refused.
  void compute_with() {
    hsp_boundary *boundary = null() ? nullptr : boundary_;
    const int ways = bytes_.one_in(3) ? static_cast<int>(LOOP_WAYS) : static_cast<int>(LOOP_RIGHT_WAYS);
    loop own = loop_of(static_cast<int>(bytes_.below(static_cast<uint32_t>(ways))));
    own.seed = bytes_.byte();
    own.first_wrong = bytes_.below(9);
    hsp_executor executor = executor_of(&own, bytes_.below(6));
    if (bytes_.one_in(16)) executor.run = nullptr;
    std::vector<uint8_t> selected(balls_);
    for (uint8_t &chosen : selected) chosen = bytes_.byte() & 1;
    const bool asked = !null();
    const bool of_some = asked && bytes_.one_in(3) && !selected.empty();
    hsp_boundary_request request{};
    request.struct_size = sizeof request;
    request.executor = null() ? nullptr : &executor;
    request.selected = of_some ? selected.data() : nullptr;
    hsp_boundary_limits needed = limits_;
    const int32_t status = hsp_boundary_compute_with(boundary, model_, asked ? &request : nullptr, &needed);
    if (boundary == nullptr || model_ == nullptr) {
      FUZZ_REQUIRE(status == HSP_E_ARGUMENT, "hsp_boundary_compute_with, arguments");
      if (boundary != nullptr) complete_ = false;
      return;
    }
    complete_ = status == HSP_OK;
    of_ = contents_;
    if (status == HSP_E_ARGUMENT) {
      FUZZ_REQUIRE(executor.run == nullptr && executor.workers > 1, "hsp_boundary_compute_with refuses an executor");
      return;
    }
    FUZZ_REQUIRE((status == HSP_E_STATE) == refused_, "hsp_boundary_compute_with of a model whose set has failed");
    if (refused_) return;
    if (own.runs > 0) FUZZ_REQUIRE(own.most_tasks == limits_.workers, "parts");
    if (status == HSP_E_EXECUTOR) {
      FUZZ_REQUIRE(own.way >= LOOP_RIGHT_WAYS && own.runs == own.first_wrong + 1, "a loop is refused");
      return;
    }
    FUZZ_REQUIRE(own.way < LOOP_RIGHT_WAYS || own.runs <= own.first_wrong, "a wrong loop is not refused");
    FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_CAPACITY, "a status that hsp_boundary_compute_with does not have");
    const bool for_workers = needed.workers > limits_.workers;
    FUZZ_REQUIRE(!for_workers || (status == HSP_E_CAPACITY && own.runs == 0 && needed.workers == executor.workers),
                 "parts for workers");
    if (for_workers) return;
    // One worker needs the same.
    hsp_boundary_limits again = limits_;
    if (of_some) {
      request.executor = nullptr;
      FUZZ_REQUIRE(hsp_boundary_compute_with(boundary, model_, &request, &again) == status, "another status by one");
      FUZZ_REQUIRE(std::memcmp(&again, &needed, sizeof needed) == 0, "other limits by one worker, of some balls");
      areas_of_some(boundary, selected, status);
      return;
    }
    FUZZ_REQUIRE(hsp_boundary_compute(boundary, model_, &again) == status, "another status by one worker");
    FUZZ_REQUIRE(std::memcmp(&again, &needed, sizeof needed) == 0, "other limits by one worker");
  }

  // The areas of some balls are those in the whole boundary, which is there afterwards.
  void areas_of_some(hsp_boundary *boundary, const std::vector<uint8_t> &selected, int32_t status) {
    std::vector<double> area[2] = {std::vector<double>(balls_), std::vector<double>(balls_)};
    hsp_measure_request request{};
    request.struct_size = sizeof request;
    request.selected = selected.data();
    hsp_boundary_counts counts;
    FUZZ_REQUIRE(hsp_boundary_get_counts(boundary, &counts) == HSP_E_STATE, "counts of some balls");
    for (std::vector<double> &areas : area) {
      hsp_measure_outputs outputs{};
      outputs.struct_size = sizeof outputs;
      outputs.capacity = balls_;
      outputs.area = areas.data();
      const int32_t expected = status == HSP_OK ? HSP_OK : HSP_E_STATE;
      FUZZ_REQUIRE(hsp_boundary_get_measures(boundary, &request, &outputs) == expected, "hsp_boundary_get_measures");
      if (&areas == &area[0]) status = hsp_boundary_compute(boundary, model_, nullptr);
    }
    complete_ = status == HSP_OK;
    if (complete_) FUZZ_REQUIRE(area[0] == area[1], "areas of some balls");
  }

  int32_t reader_status(const hsp_boundary *boundary) const {
    return boundary == nullptr ? HSP_E_ARGUMENT : ready() ? HSP_OK : HSP_E_STATE;
  }

  void read_records() {
    const hsp_boundary *boundary = null() ? nullptr : boundary_;
    const int32_t expected = reader_status(boundary);
    hsp_boundary_counts counts;
    FUZZ_REQUIRE(hsp_boundary_get_counts(boundary, &counts) == expected, "hsp_boundary_get_counts");
    uint32_t invariant = 12345, id = 12345;
    hsp_boundary *checked = boundary == nullptr ? nullptr : boundary_;
    FUZZ_REQUIRE(hsp_boundary_check(checked, &invariant, &id) == expected, "hsp_boundary_check");
    FUZZ_REQUIRE(invariant == (expected == HSP_OK ? 0U : 12345U), "invariant");
    FUZZ_REQUIRE(id == (expected == HSP_OK ? HSP_NONE : 12345U), "id");
    check_array<hsp_vertex>(40, expected, [&](hsp_vertex *out, uint32_t capacity, uint32_t *count) {
      return hsp_boundary_get_vertices(boundary, out, capacity, count);
    });
    check_array<hsp_arc>(60, expected, [&](hsp_arc *out, uint32_t capacity, uint32_t *count) {
      return hsp_boundary_get_arcs(boundary, out, capacity, count);
    });
    check_array<hsp_circle>(10, expected, [&](hsp_circle *out, uint32_t capacity, uint32_t *count) {
      return hsp_boundary_get_circles(boundary, out, capacity, count);
    });
    check_array<hsp_face>(40, expected, [&](hsp_face *out, uint32_t capacity, uint32_t *count) {
      return hsp_boundary_get_faces(boundary, out, capacity, count);
    });
    check_array<hsp_loop>(40, expected, [&](hsp_loop *out, uint32_t capacity, uint32_t *count) {
      return hsp_boundary_get_loops(boundary, out, capacity, count);
    });
    check_array<hsp_loop_arc>(120, expected, [&](hsp_loop_arc *out, uint32_t capacity, uint32_t *count) {
      return hsp_boundary_get_loop_arcs(boundary, out, capacity, count);
    });
    check_array<hsp_ball>(24, expected, [&](hsp_ball *out, uint32_t capacity, uint32_t *count) {
      return hsp_boundary_get_balls(boundary, out, capacity, count);
    });
  }

  void measure() {
    const hsp_boundary *boundary = null() ? nullptr : boundary_;
    const bool no_totals = null(), no_area = null(), no_volume = null();
    fuzz::Output<double> area(bytes_.below(30), no_area);
    fuzz::Output<double> volume(area.capacity(), no_volume);
    fuzz::Output<hsp_totals> totals(1, no_totals);
    const int32_t status =
        hsp_boundary_measure(boundary, nullptr, totals.data(), area.data(), volume.data(), area.capacity(), nullptr);
    int32_t expected = reader_status(boundary);
    if (expected == HSP_OK && !(no_area && no_volume) && area.capacity() < balls_) expected = HSP_E_CAPACITY;
    FUZZ_REQUIRE(status == expected, "hsp_boundary_measure");
    const uint32_t written = status == HSP_OK ? balls_ : 0;
    FUZZ_REQUIRE(area.untouched_from(no_area ? 0 : written), "area written where nothing belongs");
    FUZZ_REQUIRE(volume.untouched_from(no_volume ? 0 : written), "volume written where nothing belongs");
    FUZZ_REQUIRE(totals.untouched_from(status == HSP_OK && !no_totals ? 1 : 0), "totals written on failure");
  }

  void call_parts() {
    const hsp_boundary *boundary = null() ? nullptr : boundary_;
    fuzz::call_measure_parts(bytes_, boundary, reader_status(boundary), balls_);
  }

  void call_derivatives() {
    const hsp_boundary *boundary = null() ? nullptr : boundary_;
    fuzz::call_gradient(bytes_, boundary, reader_status(boundary), balls_);
  }

  fuzz::Bytes &bytes_;
  fuzz::TopologyCalls topology_;
  fuzz::SurfaceCalls surface_;
  Block model_memory_, boundary_memory_;
  fuzz::KnownContents known_;
  hsp_model *model_ = nullptr;
  hsp_boundary *boundary_ = nullptr;
  hsp_boundary_limits limits_{};
  uint32_t limit_ = 0;        // of the model
  uint32_t balls_ = 0;        // that the model holds
  bool as_made_ = false;      // nothing set since it was made, or the last set failed
  bool refused_ = false;      // the last set failed
  bool odd_numbers_ = false;  // NaN and the like may occur in the current call
  uint64_t contents_ = 0;     // of the model
  uint64_t of_ = 0;           // the contents that the boundary was computed from
  bool complete_ = false;     // the boundary was computed
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  Session session(bytes);
  for (int calls = 0; calls < 200 && !bytes.empty(); ++calls) session.step();
  return 0;
}
