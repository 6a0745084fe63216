#include "hsp_moving.hpp"

#include "caller_executor.hpp"
#include "core/sorting.hpp"
#include "gradient_arrays.hpp"
#include "hsp_model.hpp"

using namespace hsp::capi;

namespace {

hsp_moving_ball to_record(const hsp::MovingBalls &balls, uint32_t i) {
  const hsp::MovingBall &record = balls.record(i);
  const hsp::exact::LatticeBall placed = balls.placed(i);
  const hsp::exact::Lattice &lattice = balls.lattice();
  const hsp::BallMeasure measure = balls.measure(i);
  const hsp::EnergyGradient gradient = balls.gradient(i);
  hsp_moving_ball result{};
  const int64_t centre[3] = {placed.centre.x, placed.centre.y, placed.centre.z};
  for (int k = 0; k < 3; ++k) {
    result.centre[k] = lattice.length(static_cast<double>(centre[k]));
    result.d_centre[k] = gradient.centre[k];
  }
  result.radius = lattice.length(static_cast<double>(placed.radius));
  result.area = measure.area;
  result.volume_term = measure.volume;
  result.d_radius = gradient.radius;
  result.faces = record.faces;
  result.flags = record.contained ? HSP_BALL_CONTAINED : 0;
  result.gradient_flags = gradient.one_sided ? HSP_GRADIENT_ONE_SIDED : 0;
  return result;
}

// Inlined, so that a program that passes no request does not link the code for requests. asked: the status of the
// request.
[[gnu::always_inline]] inline int32_t set(hsp_moving *moving, const hsp_model *model, int32_t asked,
                                          const hsp_gradient_request &given, hsp::Patience patience,
                                          hsp_moving_limits *limits, uint32_t *first_bad) {
  if (const int32_t status = check_handle(moving); status != HSP_OK) return status;
  moving->complete = false;
  const int32_t refused = first_failure(check_handle(model), check_struct(limits), asked);
  if (name_none(refused, first_bad) != HSP_OK) return refused;
  if (!model->has_results()) return HSP_E_STATE;
  const hsp::IdRange all{0, model->balls().n};
  if (const int32_t status = check_weights(given.sigma, all, first_bad); status != HSP_OK) return status;
  if (!hsp::is_finite(given.tension) || !hsp::is_finite(given.pressure)) return HSP_E_NOT_FINITE;
  const hsp::EnergyTerms terms{{given.sigma, to_touching_balls(given.tangency)}, given.tension, given.pressure};
  return finish(*moving, moving->builder.set(model->grid, terms, patience), limits);
}

[[gnu::always_inline]] inline int32_t move(hsp_moving *moving, int32_t asked, const hsp::BallMoves &moves,
                                           hsp::Patience patience, hsp_moving_limits *limits, uint32_t *first_bad) {
  const int32_t refused = first_failure(first_failure(check_handle(moving), check_struct(limits)), asked,
                                        moves.ball == nullptr && moves.count > 0 ? HSP_E_ARGUMENT : HSP_OK);
  if (name_none(refused, first_bad) != HSP_OK) return refused;
  if (!moving->has_results()) return HSP_E_STATE;
  uint32_t bad = HSP_NONE;
  const hsp::Status status = moving->builder.move(moves, bad, patience);
  if (first_bad != nullptr) *first_bad = bad;
  hand_back_limits(*moving, status, limits);
  return to_c(status);
}

}  // namespace

HSP_HANDLE_BY_BALLS(hsp_moving);

int32_t hsp_moving_set(hsp_moving *moving, const hsp_model *model, const double *sigma, double tension, double pressure,
                       uint32_t tangency, hsp_moving_limits *limits, uint32_t *first_bad) {
  LibraryArithmetic arithmetic(tension, pressure);
  const int32_t asked = is_tangency(tangency) ? HSP_OK : HSP_E_ARGUMENT;
  const hsp_gradient_request given{sizeof given, tangency, tension, pressure, sigma, nullptr};
  return set(moving, model, asked, given, hsp::Patience(), limits, first_bad);
}

int32_t hsp_moving_set_with(hsp_moving *moving, const hsp_model *model, const hsp_gradient_request *request,
                            hsp_moving_limits *limits, uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  GradientRequest asked(arithmetic);
  const int32_t status = asked.read(request);
  return set(moving, model, status, asked.given, hsp::Patience(&asked.executor), limits, first_bad);
}

int32_t hsp_moving_move(hsp_moving *moving, uint32_t count, const uint32_t *ball, const double *xyz,
                        const double *radius, hsp_moving_limits *limits, uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  return move(moving, HSP_OK, {count, ball, xyz, radius}, hsp::Patience(), limits, first_bad);
}

int32_t hsp_moving_move_with(hsp_moving *moving, uint32_t count, const uint32_t *ball, const double *xyz,
                             const double *radius, const hsp_moving_request *request, hsp_moving_limits *limits,
                             uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  hsp_moving_request asked;
  Executor executor(arithmetic);
  const int32_t status = read_request(request, asked, executor);
  return move(moving, status, {count, ball, xyz, radius}, hsp::Patience(&executor), limits, first_bad);
}

int32_t hsp_moving_undo(hsp_moving *moving) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(moving); status != HSP_OK) return status;
  return moving->has_results() ? to_c(moving->builder.undo()) : HSP_E_STATE;
}

int32_t hsp_moving_get_info(const hsp_moving *moving, hsp_moving_info *info) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(moving, info == nullptr); status != HSP_OK) return status;
  const hsp::MovingBalls &balls = moving->builder;
  const hsp::MovingCounts &counts = balls.counts();
  const hsp::exact::Lattice &lattice = balls.lattice();
  *info = {lattice.step(),
           lattice.length(static_cast<double>(balls.probe_steps())),
           lattice.length(static_cast<double>(balls.largest_radius())),
           counts.half_edges / 3,
           counts.half_edges / 2,
           counts.circle_sides / 2,
           counts.faces,
           counts.loops,
           balls.size(),
           counts.exposed,
           counts.contained,
           counts.components,
           balls.changed_count(),
           0};
  return HSP_OK;
}

int32_t hsp_moving_measure(const hsp_moving *moving, hsp_totals *totals, double *area, double *volume_term,
                           uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(moving); status != HSP_OK) return status;
  const hsp::MovingBalls &balls = moving->builder;
  const bool wanted = area != nullptr || volume_term != nullptr;
  if (!fits(wanted, capacity, balls.size(), needed)) return HSP_E_CAPACITY;
  for (uint32_t i = 0; wanted && i < balls.size(); ++i) {
    const hsp::BallMeasure own = balls.measure(i);
    if (area != nullptr) area[i] = own.area;
    if (volume_term != nullptr) volume_term[i] = own.volume;
  }
  if (totals != nullptr) {
    const hsp::BallMeasure all = balls.totals();
    *totals = {all.area, all.volume, {0, 0}};
  }
  return HSP_OK;
}

int32_t hsp_moving_gradient(const hsp_moving *moving, hsp_energy *energy, double *d_centre, double *d_radius,
                            uint32_t *flags, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(moving); status != HSP_OK) return status;
  const hsp::MovingBalls &balls = moving->builder;
  const GradientArrays arrays{d_centre, d_radius, flags};
  if (!fits(arrays.any(), capacity, balls.size(), needed)) return HSP_E_CAPACITY;
  for (uint32_t i = 0; arrays.any() && i < balls.size(); ++i) arrays.put(i, balls.gradient(i));
  if (energy != nullptr) *energy = to_c(balls.energy());
  return HSP_OK;
}

int32_t hsp_moving_get_balls(const hsp_moving *moving, uint32_t count, const uint32_t *ball, hsp_moving_ball *out) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(moving, count > 0 && (ball == nullptr || out == nullptr)); status != HSP_OK)
    return status;
  const hsp::MovingBalls &balls = moving->builder;
  for (uint32_t k = 0; k < count; ++k) {
    if (ball[k] >= balls.size()) return HSP_E_ID;
  }
  for (uint32_t k = 0; k < count; ++k) out[k] = to_record(balls, ball[k]);
  return HSP_OK;
}

int32_t hsp_moving_get_changed(const hsp_moving *moving, uint32_t *balls, uint32_t capacity, uint32_t *needed) {
  const int32_t status = check_request(moving, balls, capacity, needed,
                                       [](const hsp_moving &handle) { return handle.builder.changed_count(); });
  if (status != HSP_OK) return status;
  uint32_t written = 0;
  moving->builder.visit_changed([&](uint32_t ball) { balls[written++] = ball; });
  hsp::sort_in_place(hsp::Span<uint32_t>(balls, written), [](uint32_t a, uint32_t b) { return a < b; });
  return HSP_OK;
}

int32_t hsp_moving_get_model(const hsp_moving *moving, hsp_model *model) {
  LibraryArithmetic arithmetic;
  if (const int32_t refused = first_failure(check_handle(moving), check_handle(model)); refused != HSP_OK)
    return refused;
  if (!moving->has_results()) return HSP_E_STATE;
  const hsp::Status status = moving->builder.write(model->grid);
  if (status == hsp::Status::ok) model->take_digest();
  return to_c(status);
}
