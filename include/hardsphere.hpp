// hardsphere.hpp: the C interface for C++20, a header without a library of its own: it owns memory, takes spans,
// returns vectors and throws exceptions.
//
//   double area = hardsphere::measure(xyz, radius, {.probe = 1.4}).total.area;       spans: xyz [n][3], radius [n]
//
//   hardsphere::workspace work(xyz, radius, {.probe = 1.4});                         more than one question
//   std::vector<double> areas = work.measure().area;
//   std::vector<double> forces = work.gradient({.tension = -0.0072}).d_centre;
//   hardsphere::threads four(4);                                                     threads that share the work
//   work.use(four);                                                                  with the same bits
//   for (const hsp_contact &contact : hardsphere::all(hsp_contacts_get_pairs, work.contacts())) ..
//   work.set(next_xyz, radius);                                                      the next frame, in the same memory
//
//   hardsphere::box(xyz, radius, vectors, {.probe = 1.4}).gradient({.tension = 1}).d_strain   in a periodic box
//   hardsphere::moving walk(xyz, radius, {.tension = 1});  walk.move(balls, to);  walk.undo();   a few at a time
//   hardsphere::body(xyz, radius).hits(hardsphere::body(others, radii), poses)                molecule against molecule
//   work.pores(), box.pores()                                                                 free space for any probe
//
// all() calls any function of hardsphere.h that ends with (out, capacity, needed), range() any that ends with
// (first, count, out). For all other functions a workspace has the handles; it computes boundary, topology, contacts,
// surface and pores when they are first asked for. check() throws an exception if the status of a call of your own is
// not HSP_OK. A workspace owns all that hsp_workspace_* of hardsphere_workspace.h make; run() calls one of these with
// arguments: run(hsp_workspace_view, 1, &options).
#ifndef HARDSPHERE_HPP
#define HARDSPHERE_HPP

#if __cplusplus <= 201703L
#error hardsphere.hpp needs C++20: give the compiler -std=c++20
#else

#include <hardsphere_workspace.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace hardsphere {

// A call failed: status() is one of HSP_E_*, ball() the index of the ball, pose or move that was refused, or HSP_NONE.
class error : public std::runtime_error {
 public:
  explicit error(int32_t status, uint32_t ball = HSP_NONE)
      : std::runtime_error(hsp_status_text(status)), status_(status), ball_(ball) {}
  int32_t status() const noexcept { return status_; }
  uint32_t ball() const noexcept { return ball_; }

 private:
  int32_t status_;
  uint32_t ball_;
};

inline void check(int32_t status, uint32_t ball = HSP_NONE) {
  if (status != HSP_OK) throw error(status, ball);
}

// The type that a function writes: that of its argument number Place, counted from 0, without the star.
template <class... Arguments>
std::tuple<Arguments...> arguments_of(int32_t (*)(Arguments...));
template <size_t Place, class Function>
using written_by =
    std::remove_pointer_t<std::tuple_element_t<Place, decltype(arguments_of(static_cast<Function>(nullptr)))>>;

// How many elements of out make one record: 3 coordinates of a point, 2 balls of a pair, else 1. 0: out is no list of
// records.
template <class Function>
inline constexpr size_t numbers_each = 1;
#if HSP_HAS_SPACE
template <>
inline constexpr size_t numbers_each<decltype(&hsp_paths_get_points)> = 3;
#endif
#if HSP_HAS_MOTION
template <>
inline constexpr size_t numbers_each<decltype(&hsp_body_pairs)> = 2;
template <>
inline constexpr size_t numbers_each<decltype(&hsp_body_rational_pairs)> = 2;
#endif
#if HSP_HAS_CURVATURE
template <>
inline constexpr size_t numbers_each<decltype(&hsp_boundary_get_hessian_rows)> = 0;
#endif
#if HSP_HAS_BOXES
template <>
inline constexpr size_t numbers_each<decltype(&hsp_periodic_get_hessian_rows)> = 0;
#endif

// All records that a function (given.., out, capacity, needed) writes to out.
template <class... Arguments, class... Given>
auto all(int32_t (*function)(Arguments...), Given... given) {
  constexpr size_t each = numbers_each<decltype(function)>;
  static_assert(each > 0, "flags of rows have an entry for each ball and one more: call the function itself");
  std::vector<written_by<sizeof...(Given), decltype(function)>> out;
  uint32_t needed = 0;
  int32_t status = function(given..., nullptr, 0, &needed);
  // Functions of several arrays, all of which may be NULL, return HSP_OK without any array.
  if (status == HSP_E_CAPACITY || (status == HSP_OK && needed > 0)) {
    out.resize(each * needed);
    status = function(given..., out.data(), needed, &needed);
  }
  check(status);
  return out;
}

// `count` records of a function (handle, first, count, out).
template <class... Arguments, class Handle>
auto range(int32_t (*function)(Arguments...), Handle *handle, uint32_t first, uint32_t count) {
  std::vector<written_by<3, decltype(function)>> out(count);
  check(function(handle, first, count, out.data()));
  return out;
}

// An executor with `number` threads, which are started and joined in each loop. Any other hsp_executor serves as well.
class threads {
 public:
  explicit threads(uint32_t number) noexcept
      : executor_{sizeof executor_, number, reinterpret_cast<void *>(uintptr_t{number}), run, nullptr} {}
  operator const hsp_executor &() const noexcept { return executor_; }

 private:
  static int32_t run(void *number, uint32_t tasks, hsp_task *task, void *data) {
    std::atomic<uint32_t> next = 0;
    const auto work = [&] {
      for (uint32_t k = next++; k < tasks; k = next++) task(data, k);
    };
    struct joined : std::vector<std::thread> {  // libc++ has had std::jthread since version 20 only
      ~joined() {
        for (std::thread &each : *this) each.join();
      }
    } others;
    try {
      const uintptr_t most = reinterpret_cast<uintptr_t>(number);
      while (others.size() + 1 < most && others.size() + 1 < tasks) others.emplace_back(work);
    } catch (const std::exception &) {  // fewer will do
    }
    work();
    return 0;
  }

  hsp_executor executor_;
};

// As hsp_model_options, lengths: 0 for the default.
struct options {
  double probe = 0, step = 0, largest_radius = 0;
};

struct measures {
  hsp_totals total{};
  std::vector<double> area, volume_term;  // of each ball: its free area, and its term of the volume
};

// E = tension * sum_i sigma_i A_i + pressure * V.
struct energy_terms {
  double tension = 0, pressure = 0;
  std::span<const double> sigma = {};  // empty: all ones
  uint32_t tangency = HSP_TANGENT_OVERLAP;
};

struct gradients {
  hsp_energy energy{};
  std::vector<double> d_centre, d_radius, area;  // [n][3], [n], [n]: free areas come with it
  std::vector<uint32_t> flags;                   // [n]
};

// Which balls meet: a row for each ball.
struct neighbours {
  std::vector<uint32_t> first, ids;
  std::span<const uint32_t> of(uint32_t ball) const { return {ids.data() + first[ball], ids.data() + first[ball + 1]}; }
};

inline hsp_model_options model_options(const options &how) {
  hsp_model_options c{};
  check(hsp_model_options_init(&c, sizeof c));
  c.probe = how.probe, c.step = how.step, c.largest_radius = how.largest_radius;
  return c;
}

// Balls as functions of C take them. Spans whose sizes do not fit become null pointers, which these functions refuse.
struct given_balls {
  given_balls(std::span<const double> centres, std::span<const double> radii) {
    if (centres.size() != 3 * radii.size() || radii.size() > HSP_MAX_BALLS) return;
    n = static_cast<uint32_t>(radii.size()), xyz = centres.data(), radius = radii.data();
  }
  uint32_t n = 1;
  const double *xyz = nullptr, *radius = nullptr;
};

// The base of all classes that own a workspace of C. They can be moved, not copied.
class owner {
 public:
  // The workspace of C, whose handles hardsphere_workspace.h lists.
  hsp_workspace *operator->() noexcept { return &work_; }

  // Calls a function of hardsphere_workspace.h with its arguments after the workspace. Member functions do not reuse
  // results that it made, as these may be of other balls, of some balls alone, or with other options.
  template <class... Arguments, class... Given>
  void run(int32_t (*function)(hsp_workspace *, Arguments...), Given &&...given) {
    computed_ &= ~made_otherwise(function);
    const int32_t status = function(&work_, std::forward<Given>(given)...);
    if (status != HSP_OK) computed_ = 0;  // a handle lost its results; all are computed again when they are asked for
    check(status);
  }

 protected:
  owner() = default;
  owner(const owner &) = delete;
  owner &operator=(const owner &) = delete;
  owner(owner &&other) noexcept { swap(other); }
  owner &operator=(owner &&other) noexcept {
    owner taken(std::move(other));
    swap(taken);
    return *this;
  }
  ~owner() { hsp_workspace_free(&work_); }
  void swap(owner &other) noexcept {
    std::swap(work_, other.work_);
    std::swap(computed_, other.computed_);
    std::swap(executor_, other.executor_);
#if HSP_HAS_SPACE
    std::swap(floor_, other.floor_);
#endif
  }

  // Refuses a span of another size than the number of balls. An empty one counts as not given.
  static void held(size_t given, uint32_t balls) {
    if (given != 0 && given != balls) throw error(HSP_E_ARGUMENT);
  }
  // That of a vector that was cleared still points to what it held.
  template <class Number>
  static const Number *numbers(std::span<const Number> given) noexcept {
    return given.empty() ? nullptr : given.data();
  }
  // The number of balls of a handle, from one of its functions (.., capacity, needed) without arrays; 0 without balls.
  template <class... Arguments, class Handle, class... Nothing>
  static uint32_t count(int32_t (*function)(Arguments...), Handle *handle, Nothing... nothing) noexcept {
    uint32_t needed = 0;
    return function(handle, nothing..., 0, &needed) == HSP_OK ? needed : 0;
  }
  template <class Function, class Other>
  static bool same(Function function, Other other) noexcept {
    if constexpr (std::is_same_v<Function, Other>) return function == other;
    return false;
  }
  // The bits of once() of results that a function of C may make of other balls, of some balls or with other options.
  template <class Function>
  static unsigned made_otherwise(Function function) noexcept {
    if (same(function, hsp_workspace_set) || same(function, hsp_workspace_areas) ||
        same(function, hsp_workspace_boundary) || same(function, hsp_workspace_boundary_with))
      return ~0U;
#if HSP_HAS_BOXES
    if (same(function, hsp_workspace_periodic) || same(function, hsp_workspace_periodic_with)) return ~0U;
#endif
#if HSP_HAS_SMOOTH
    if (same(function, hsp_workspace_surface_of)) return surface_is_there;
#endif
#if HSP_HAS_SPACE
    if (same(function, hsp_workspace_pores) || same(function, hsp_workspace_pores_periodic)) return pores_are_there;
#endif
    return 0;
  }
  template <class Compute>
  void once(unsigned bit, Compute compute) {
    if ((computed_ & bit) != 0) return;
    computed_ &= ~bit;
    check(compute(&work_));
    computed_ |= bit;
  }

  // The gradient of an energy by a function of C; outputs: what else it is to write.
  template <class Outputs, class Handle>
  gradients slope(int32_t (*function)(const Handle *, const hsp_gradient_request *, Outputs *), const Handle *handle,
                  uint32_t n, const energy_terms &terms, Outputs outputs = {}) {
    held(terms.sigma.size(), n);
    gradients found{{},
                    std::vector<double>(3 * size_t{n}),
                    std::vector<double>(n),
                    std::vector<double>(n),
                    std::vector<uint32_t>(n)};
    const hsp_gradient_request request = asked(terms);
    outputs.struct_size = sizeof outputs, outputs.capacity = n, outputs.energy = &found.energy;
    outputs.d_centre = found.d_centre.data(), outputs.d_radius = found.d_radius.data(),
    outputs.flags = found.flags.data(), outputs.area = found.area.data();
    outputs.first_bad = HSP_NONE;
    const int32_t status = function(handle, &request, &outputs);
    check(status, outputs.first_bad);
    return found;
  }
  hsp_gradient_request asked(const energy_terms &terms) const {
    hsp_gradient_request request{};
    check(hsp_gradient_request_init(&request, sizeof request));
    request.tension = terms.tension, request.pressure = terms.pressure, request.tangency = terms.tangency;
    request.sigma = numbers(terms.sigma), request.executor = &executor_;
    return request;
  }
#if HSP_HAS_SPACE
  hsp_pores *some_pores(int32_t (*compute)(hsp_workspace *, const hsp_pores_options *), double floor) {
    if (floor != floor_) computed_ &= ~pores_are_there;
    once(pores_are_there, [&](hsp_workspace *work) {
      hsp_pores_options options{};
      options.struct_size = sizeof options, options.floor = floor_ = floor, options.executor = &executor_;
      return compute(work, &options);
    });
    return work_.pores;
  }
  double floor_ = 0;
#endif
  static constexpr unsigned surface_is_there = 8, pores_are_there = 16;

  hsp_workspace work_{};
  hsp_executor executor_{sizeof executor_, 1, nullptr, nullptr, nullptr};
  unsigned computed_ = 0;
};

class workspace : public owner {
 public:
  workspace() = default;
  workspace(std::span<const double> xyz, std::span<const double> radius, const options &how = {}) {
    set(xyz, radius, how);
  }
  void swap(workspace &other) noexcept { owner::swap(other); }
  uint32_t size() const noexcept { return count(hsp_model_get_balls, work_.model, nullptr, nullptr); }

  // Takes other balls. If it throws there are no balls, and functions that need balls throw, too.
  workspace &set(std::span<const double> xyz, std::span<const double> radius, const options &how = {}) {
    const hsp_model_options c = model_options(how);
    const given_balls balls(xyz, radius);
    uint32_t bad = HSP_NONE;
    computed_ = 0;
    const int32_t status = hsp_workspace_set(&work_, balls.n, balls.xyz, balls.radius, &c, &bad);
    return check(status, bad), *this;
  }

  // Sets the executor, of which a copy is kept: its threads share boundaries, measures and gradients from then on.
  workspace &use(const hsp_executor &executor) noexcept { return executor_ = executor, *this; }

  // Handles. All but the model are computed when they are first asked for after set(). The workspace owns them.
  const hsp_model *model() const noexcept { return work_.model; }
  hsp_boundary *boundary() {
    const auto compute = [this](hsp_workspace *work) {
      hsp_boundary_request request{};
      request.struct_size = sizeof request, request.executor = &executor_;
      return hsp_workspace_boundary_with(work, &request);
    };
    return once(1, compute), work_.boundary;
  }
  hsp_topology *topology() { return boundary(), once(2, hsp_workspace_topology), work_.topology; }
  hsp_contacts *contacts() { return boundary(), once(4, hsp_workspace_contacts), work_.contacts; }
#if HSP_HAS_SMOOTH
  hsp_surface *surface() {
    return boundary(), once(surface_is_there, hsp_workspace_surface), work_.surface;
  }
#endif
#if HSP_HAS_SPACE
  // Free space for probes of any radius above the floor, a length.
  hsp_pores *pores(double floor = 0) {
    return some_pores(hsp_workspace_pores, floor);
  }
#endif

  // Areas and volume. selected: empty for all, or a number for each ball; balls with 0 only block.
  hardsphere::measures measure(std::span<const uint8_t> selected = {}) {
    const uint32_t n = size();
    held(selected.size(), n);
    hardsphere::measures found{{}, std::vector<double>(n), std::vector<double>(n)};
    hsp_measure_request request{};
    request.struct_size = sizeof request, request.selected = numbers(selected), request.executor = &executor_;
    hsp_measure_outputs outputs{};
    outputs.struct_size = sizeof outputs, outputs.capacity = n, outputs.totals = &found.total;
    outputs.area = found.area.data(), outputs.volume_term = found.volume_term.data();
    check(hsp_boundary_get_measures(boundary(), &request, &outputs));
    return found;
  }

  gradients gradient(const energy_terms &terms) {
    return slope(hsp_boundary_get_gradient, boundary(), size(), terms);
  }
#if HSP_HAS_SMOOTH
  // The gradient of an energy of the smooth surface (hardsphere/surface.h).
  gradients smooth_gradient(const energy_terms &terms) {
    return slope(hsp_surface_get_gradient, surface(), size(), terms);
  }
#endif

  neighbours pairs(uint32_t flags = HSP_PAIRS_ONCE) const {
    neighbours found{std::vector<uint32_t>(size_t{size()} + 1), {}};
    found.ids = all(hsp_query_pairs, model(), flags, found.first.data());
    return found;
  }
};

#if HSP_HAS_BOXES

struct box_measures {
  hsp_periodic_totals total{};
  std::vector<double> area, share_volume;  // of each ball: its free area, and the volume of its share
};

// With the derivatives by the strain and by the box vectors (hsp_periodic_gradient_outputs).
struct box_gradients : gradients {
  std::array<double, 9> d_strain{}, d_box{};
};

// Balls in a periodic box. vectors: three lengths of an upright box, or three vectors one after another, any.
class box : public owner {
 public:
  box() = default;
  box(std::span<const double> xyz, std::span<const double> radius, std::span<const double> vectors,
      const options &how = {}) {
    set(xyz, radius, vectors, how);
  }
  uint32_t size() const noexcept { return count(hsp_periodic_measure, work_.periodic, nullptr, nullptr, nullptr); }

  // Takes other balls and another box. If it throws there are no balls.
  box &set(std::span<const double> xyz, std::span<const double> radius, std::span<const double> vectors,
           const options &how = {}) {
    std::array<double, 9> all{};
    for (size_t k = 0; k < 3 && vectors.size() == 3; ++k) all[4 * k] = vectors[k];
    if (vectors.size() == 9) std::copy(vectors.begin(), vectors.end(), all.begin());
    const hsp_model_options c = model_options(how);
    hsp_periodic_request request{};
    request.struct_size = sizeof request, request.options = &c, request.executor = &executor_;
    request.areas_alone = areas_alone_ ? 1 : 0;
    const given_balls balls(xyz, radius);
    uint32_t bad = HSP_NONE;
    computed_ = 0;
    const bool right = vectors.size() == 3 || vectors.size() == 9;
    const int32_t status = hsp_workspace_periodic_with(&work_, balls.n, balls.xyz, balls.radius,
                                                       right ? all.data() : nullptr, &request, &bad);
    check(status, bad);
    return *this;
  }

  // Both count from the next set() on. use: threads that share the work. areas_alone: only areas and their gradient, in
  // a third of the time.
  box &use(const hsp_executor &executor) noexcept { return executor_ = executor, *this; }
  box &areas_alone(bool alone = true) noexcept { return areas_alone_ = alone, *this; }

  hsp_periodic *periodic() noexcept { return work_.periodic; }
#if HSP_HAS_SPACE
  hsp_pores *pores(double floor = 0) {
    return some_pores(hsp_workspace_pores_periodic, floor);
  }
#endif

  box_measures measure() {
    const uint32_t n = size();
    box_measures found{{}, std::vector<double>(n), std::vector<double>(n)};
    const auto take = [&](double *share) {
      return hsp_periodic_measure(periodic(), &found.total, found.area.data(), share, n, nullptr);
    };
    int32_t status = take(found.share_volume.data());
    if (status == HSP_E_STATE) {  // there are areas alone, or nothing
      found.share_volume.clear();
      status = take(nullptr);
    }
    check(status);
    return found;
  }
  box_gradients gradient(const energy_terms &terms) {
    box_gradients found;
    hsp_periodic_gradient_outputs outputs{};
    outputs.d_strain = found.d_strain.data(), outputs.d_box = found.d_box.data();
    static_cast<gradients &>(found) = slope(hsp_periodic_get_gradient, periodic(), size(), terms, outputs);
    return found;
  }

 private:
  bool areas_alone_ = false;  // of the next set
};

#endif  // HSP_HAS_BOXES

#if HSP_HAS_MOTION

// A molecule prepared for poses. Copies share it. Two bodies need the same lattice step (options::step). If a function
// throws error::ball() is the index of the pose.
class body {
 public:
  body() = default;
  body(std::span<const double> xyz, std::span<const double> radius, const options &how = {}) {
    workspace work(xyz, radius, how);
    size_t bytes = 0;
    check(hsp_body_bytes(work.size(), &bytes));
    const std::shared_ptr<std::byte[]> memory(new std::byte[bytes]);
    hsp_body *made = nullptr;
    check(hsp_body_init(memory.get(), bytes, work.size(), &made));
    check(hsp_body_set(made, work.model()));
    body_ = {memory, made};
  }
  operator const hsp_body *() const noexcept { return body_.get(); }

  // For each pose of the other body: hits, whether they meet; gaps, how far apart they are; overlaps, how much they
  // overlap.
  std::vector<uint32_t> hits(const body &posed, std::span<const hsp_pose> poses) const {
    return each<uint32_t>(hsp_body_hits, posed, poses);
  }
  std::vector<uint32_t> hits(const body &posed, std::span<const hsp_rational_pose> poses) const {
    return each<uint32_t>(hsp_body_rational_hits, posed, poses);
  }
  // The same for the poses of a motion, each near the one before. The best margin, a length, is some ten times the
  // distance that a ball moves from one pose to the next.
  std::vector<uint32_t> hits_along(const body &posed, std::span<const hsp_pose> poses, double margin) const {
    return each<uint32_t>(hsp_body_hits_along, posed, poses, margin);
  }
  std::vector<uint32_t> hits_along(const body &posed, std::span<const hsp_rational_pose> poses, double margin) const {
    return each<uint32_t>(hsp_body_rational_hits_along, posed, poses, margin);
  }
  std::vector<hsp_body_gap> gaps(const body &posed, std::span<const hsp_pose> poses) const {
    return each<hsp_body_gap>(hsp_body_gaps, posed, poses);
  }
  std::vector<hsp_body_gap> gaps(const body &posed, std::span<const hsp_rational_pose> poses) const {
    return each<hsp_body_gap>(hsp_body_rational_gaps, posed, poses);
  }
  std::vector<hsp_body_overlap> overlaps(const body &posed, std::span<const hsp_pose> poses) const {
    return each<hsp_body_overlap>(hsp_body_overlaps, posed, poses);
  }
  // The pairs of balls that meet: first the ball of this body, then the ball of the other.
  std::vector<std::array<uint32_t, 2>> pairs(const body &posed, const hsp_pose &pose) const {
    return two_by_two(all(hsp_body_pairs, body_.get(), posed.body_.get(), &pose));
  }
  std::vector<std::array<uint32_t, 2>> pairs(const body &posed, const hsp_rational_pose &pose) const {
    return two_by_two(all(hsp_body_rational_pairs, body_.get(), posed.body_.get(), &pose));
  }

 private:
  static std::vector<std::array<uint32_t, 2>> two_by_two(const std::vector<uint32_t> &balls) {
    std::vector<std::array<uint32_t, 2>> found(balls.size() / 2);
    for (size_t k = 0; k < found.size(); ++k) found[k] = {balls[2 * k], balls[2 * k + 1]};
    return found;
  }
  // margin: the argument that some functions take after the poses.
  template <class Answer, class Function, class Pose, class... Margin>
  std::vector<Answer> each(Function function, const body &posed, std::span<const Pose> poses, Margin... margin) const {
    if (poses.size() > UINT32_MAX) throw error(HSP_E_RANGE);
    std::vector<Answer> answers(poses.size());
    uint32_t bad = HSP_NONE;
    const int32_t status =
        function(*this, posed, static_cast<uint32_t>(poses.size()), poses.data(), margin..., answers.data(), &bad);
    check(status, bad);
    return answers;
  }

  std::shared_ptr<const hsp_body> body_;
};

// Balls of which a few move at a time, with an energy that is known after each move. If move() throws error::ball() is
// the position in `balls` of the move that was refused.
class moving : public owner {
 public:
  moving() = default;
  moving(std::span<const double> xyz, std::span<const double> radius, const energy_terms &terms,
         const options &how = {}) {
    set(xyz, radius, terms, how);
  }
  moving(moving &&) = default;
  moving &operator=(moving &&other) noexcept {
    moving taken(std::move(other));  // also from itself
    owner::swap(taken);
    std::swap(terms_, taken.terms_), std::swap(sigma_, taken.sigma_), std::swap(others_, taken.others_);
    return *this;
  }
  uint32_t size() const noexcept { return count(hsp_moving_measure, work_.moving, nullptr, nullptr, nullptr); }

  template <class... Arguments, class... Given>
  void run(int32_t (*function)(hsp_workspace *, Arguments...), Given &&...given) {
    if (same(function, hsp_workspace_moving)) others_ = true;
    owner::run(function, std::forward<Given>(given)...);
  }

  moving &set(std::span<const double> xyz, std::span<const double> radius, const energy_terms &terms,
              const options &how = {}) {
    const hsp_model_options c = model_options(how);
    const given_balls balls(xyz, radius);
    const bool right = terms.sigma.empty() || terms.sigma.size() == radius.size();
    uint32_t bad = HSP_NONE;
    terms_ = terms, others_ = false;
    sigma_.assign(terms.sigma.begin(), terms.sigma.end());
    terms_.sigma = {};
    const int32_t set =
        hsp_workspace_set(&work_, right ? balls.n : 1, right ? balls.xyz : nullptr, balls.radius, &c, &bad);
    const int32_t taken = take(set == HSP_OK ? &bad : nullptr);  // leaves no balls if set was refused
    return check(set == HSP_OK ? taken : set, bad), *this;
  }

  // Moves some balls to other centres, or gives them other radii, or both; an empty span leaves all as they are. If it
  // throws everything is as before, or there are no balls if memory ran out.
  moving &move(std::span<const uint32_t> balls, std::span<const double> xyz, std::span<const double> radius = {}) {
    if ((!xyz.empty() && xyz.size() != 3 * balls.size()) || (!radius.empty() && radius.size() != balls.size()))
      throw error(HSP_E_ARGUMENT);
    for (;;) {
      hsp_moving_limits limits = work_.moving_limits;
      uint32_t bad = HSP_NONE;
      int32_t status = hsp_moving_move(work_.moving, static_cast<uint32_t>(balls.size()), balls.data(), numbers(xyz),
                                       numbers(radius), &limits, &bad);
      if (status != HSP_E_CAPACITY) return check(status, bad), *this;
      // Into a larger handle, with the energy that set() was given: one that run() has taken is not known.
      if (others_) throw error(HSP_E_STATE);
      check(hsp_moving_get_model(work_.moving, work_.model));
      status = hsp_workspace_grow_moving(&work_, &limits);
      check(status == HSP_OK ? take(nullptr) : status);
    }
  }
  // Takes the last move back.
  moving &undo() { return check(hsp_moving_undo(work_.moving)), *this; }

  hsp_moving *handle() noexcept { return work_.moving; }
  hsp_energy energy() {
    hsp_energy found{};
    check(hsp_moving_gradient(work_.moving, &found, nullptr, nullptr, nullptr, 0, nullptr));
    return found;
  }
  hardsphere::measures measure() {
    const uint32_t n = size();
    hardsphere::measures found{{}, std::vector<double>(n), std::vector<double>(n)};
    check(hsp_moving_measure(work_.moving, &found.total, found.area.data(), found.volume_term.data(), n, nullptr));
    return found;
  }
  gradients gradient() {
    const uint32_t n = size();
    gradients found{
        {}, std::vector<double>(3 * size_t{n}), std::vector<double>(n), measure().area, std::vector<uint32_t>(n)};
    check(hsp_moving_gradient(work_.moving, &found.energy, found.d_centre.data(), found.d_radius.data(),
                              found.flags.data(), n, nullptr));
    return found;
  }
  // A model of the balls as they are; the next call replaces it.
  const hsp_model *model() { return check(hsp_moving_get_model(work_.moving, work_.model)), work_.model; }

 private:
  int32_t take(uint32_t *bad) {
    return hsp_workspace_moving(&work_, numbers<double>(sigma_), terms_.tension, terms_.pressure, terms_.tangency, bad);
  }

  energy_terms terms_{};
  std::vector<double> sigma_;
  bool others_ = false;  // whether run() has taken balls with an energy of its own
};

#endif  // HSP_HAS_MOTION

// Area and volume of a union of balls, and each ball's terms of both.
inline measures measure(std::span<const double> xyz, std::span<const double> radius, const options &how = {}) {
  return workspace(xyz, radius, how).measure();
}

}  // namespace hardsphere

#endif  // C++20
#endif
