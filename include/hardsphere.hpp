// hardsphere.hpp: the C interface for C++20, in this header alone: owned memory, spans in, vectors out, exceptions.
//
//   double area = hardsphere::measure(xyz, radius, {.probe = 1.4}).total.area;       spans of doubles, xyz [n][3]
//
//   hardsphere::workspace work(xyz, radius, {.probe = 1.4});                         more than one question
//   std::vector<double> areas = work.measure().area;
//   std::vector<double> forces = work.gradient({.tension = -0.0072}).d_centre;
//   hardsphere::threads four(4);                                                     threads that share the work
//   work.use(four);                                                                  with the same bits
//   for (const hsp_contact &contact : hardsphere::all(hsp_contacts_get_pairs, work.contacts())) ..
//   work.set(next_xyz, radius);                                                      the next frame, in the same memory
//
// all() calls any function of hardsphere.h that ends with (out, capacity, needed), range() any that ends with
// (first, count, out). A workspace has the handles for all other functions and computes those of the boundary when they
// are first asked for. check() makes an exception of the status of a call of your own. A workspace owns what
// hsp_workspace_* of hardsphere_workspace.h makes: run(hsp_workspace_view, 1, &options) is for those with arguments.
#ifndef HARDSPHERE_HPP
#define HARDSPHERE_HPP

#if __cplusplus <= 201703L
#error hardsphere.hpp needs C++20: give the compiler -std=c++20
#else

#include <hardsphere_workspace.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace hardsphere {

// A call failed: status() is one of HSP_E_*, ball() the index of the ball to blame or HSP_NONE.
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

// The argument of a function after so many, without its star: what the function writes.
template <class... Arguments>
std::tuple<Arguments...> arguments_of(int32_t (*)(Arguments...));
template <size_t Place, class Function>
using written_by =
    std::remove_pointer_t<std::tuple_element_t<Place, decltype(arguments_of(static_cast<Function>(nullptr)))>>;

// All that a function (given.., out, capacity, needed) writes.
template <class... Arguments, class... Given>
auto all(int32_t (*function)(Arguments...), Given... given) {
  std::vector<written_by<sizeof...(Given), decltype(function)>> out;
  uint32_t needed = 0;
  int32_t status = function(given..., nullptr, 0, &needed);
  if (status == HSP_E_CAPACITY) {
    out.resize(needed);
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

// An executor with so many threads, which live as long as each loop. Any other hsp_executor serves as well.
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
    std::vector<std::jthread> others;  // joined at the end
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

// As hsp_model_options: 0 for the default.
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

class workspace {
 public:
  workspace() = default;
  workspace(std::span<const double> xyz, std::span<const double> radius, const options &how = {}) {
    set(xyz, radius, how);
  }
  workspace(const workspace &) = delete;
  workspace &operator=(const workspace &) = delete;
  workspace(workspace &&other) noexcept { swap(other); }
  workspace &operator=(workspace &&other) noexcept {
    swap(other);
    return *this;
  }
  ~workspace() { hsp_workspace_free(&work_); }
  void swap(workspace &other) noexcept {
    std::swap(work_, other.work_);
    std::swap(computed_, other.computed_);
    std::swap(executor_, other.executor_);
    std::swap(size_, other.size_);
  }

  // Of all that is in it, as hardsphere_workspace.h has it.
  hsp_workspace *operator->() noexcept { return &work_; }
  uint32_t size() const noexcept { return size_; }

  // One that throws leaves no balls: what asks for them throws, too.
  workspace &set(std::span<const double> xyz, std::span<const double> radius, const options &how = {}) {
    hsp_model_options c{};
    check(hsp_model_options_init(&c, sizeof c));
    c.probe = how.probe, c.step = how.step, c.largest_radius = how.largest_radius;
    const bool matching = xyz.size() == 3 * radius.size() && radius.size() <= HSP_MAX_BALLS;
    const auto n = matching ? static_cast<uint32_t>(radius.size()) : 1;
    uint32_t bad = HSP_NONE;
    computed_ = size_ = 0;
    const int32_t status = hsp_workspace_set(&work_, n, matching ? xyz.data() : nullptr, radius.data(), &c, &bad);
    check(status, bad);
    size_ = n;
    return *this;
  }

  // Whose threads share boundaries, measures and gradients from now on.
  workspace &use(const hsp_executor &executor) noexcept { return executor_ = executor, *this; }

  // A function of hardsphere_workspace.h, with its arguments behind the workspace.
  template <class... Arguments, class... Given>
  void run(int32_t (*function)(hsp_workspace *, Arguments...), Given &&...given) {
    check(function(&work_, std::forward<Given>(given)...));
  }

  // Handles, computed when they are first asked for after set().
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
    return boundary(), once(8, hsp_workspace_surface), work_.surface;
  }
#endif

  // selected: empty, or a number for each ball; those with 0 only block.
  hardsphere::measures measure(std::span<const uint8_t> selected = {}) {
    held(selected.size());
    hardsphere::measures found{{}, std::vector<double>(size_), std::vector<double>(size_)};
    hsp_measure_request request{};
    request.struct_size = sizeof request, request.selected = selected.data(), request.executor = &executor_;
    hsp_measure_outputs outputs{};
    outputs.struct_size = sizeof outputs, outputs.capacity = size_, outputs.totals = &found.total;
    outputs.area = found.area.data(), outputs.volume_term = found.volume_term.data();
    check(hsp_boundary_get_measures(boundary(), &request, &outputs));
    return found;
  }

  gradients gradient(const energy_terms &terms) {
    held(terms.sigma.size());
    gradients found{{},
                    std::vector<double>(3 * size_t{size_}),
                    std::vector<double>(size_),
                    std::vector<double>(size_),
                    std::vector<uint32_t>(size_)};
    hsp_gradient_request request{};
    check(hsp_gradient_request_init(&request, sizeof request));
    request.tension = terms.tension, request.pressure = terms.pressure, request.tangency = terms.tangency;
    request.sigma = terms.sigma.data(), request.executor = &executor_;
    hsp_gradient_outputs outputs{};
    outputs.struct_size = sizeof outputs, outputs.capacity = size_, outputs.energy = &found.energy;
    outputs.d_centre = found.d_centre.data(), outputs.d_radius = found.d_radius.data(),
    outputs.flags = found.flags.data(), outputs.area = found.area.data();
    outputs.first_bad = HSP_NONE;
    const int32_t status = hsp_boundary_get_gradient(boundary(), &request, &outputs);
    check(status, outputs.first_bad);
    return found;
  }

  neighbours pairs(uint32_t flags = HSP_PAIRS_ONCE) const {
    neighbours found{std::vector<uint32_t>(size_t{size_} + 1), {}};
    found.ids = all(hsp_query_pairs, model(), flags, found.first.data());
    return found;
  }

 private:
  // An empty span is none; with no balls it is that, too.
  void held(size_t given) const {
    if (given != 0 && given != size_) throw error(HSP_E_ARGUMENT);
  }
  template <class Compute>
  void once(unsigned bit, Compute compute) {
    if ((computed_ & bit) != 0) return;
    computed_ &= ~bit;
    check(compute(&work_));
    computed_ |= bit;
  }

  hsp_workspace work_{};
  hsp_executor executor_{sizeof executor_, 1, nullptr, nullptr, nullptr};
  unsigned computed_ = 0;
  uint32_t size_ = 0;
};

// Area and volume of a union of balls, and each ball's part of them.
inline measures measure(std::span<const double> xyz, std::span<const double> radius, const options &how = {}) {
  return workspace(xyz, radius, how).measure();
}

}  // namespace hardsphere

#endif  // C++20
#endif
