#include "hsp_model.hpp"
#include "caller_executor.hpp"
#include "core/small_code.hpp"
#include "model_options.hpp"

using namespace hsp::capi;

namespace {

void clear(hsp_model &model) {
  uint32_t first_bad = 0;
  static_cast<void>(model.grid.build(hsp::BallInput{}, first_bad));
  model.take_digest();
}

// asked: the status of the other arguments. Out of line, as two functions call it.
HSP_APART_UNLESS_SMALL int32_t set(hsp_model *model, const hsp::BallInput &given, const hsp_model_options *options,
                                   int32_t asked, hsp::Patience patience, uint32_t *first_bad) {
  if (const int32_t status = check_handle(model); status != HSP_OK) return name_none(status, first_bad);
  uint32_t ignored = 0;
  uint32_t &bad = first_bad != nullptr ? *first_bad : ignored;
  hsp::BallInput input;
  const auto refuse = [&](int32_t status) {
    clear(*model);
    model->complete = false;
    bad = HSP_NONE;
    return status;
  };
  if (const int32_t status = versions_first(asked, get_input(given.n, given.xyz, given.radius, options, input));
      status != HSP_OK)
    return refuse(status);
  if (input.n > model->grid.capacity()) return refuse(HSP_E_CAPACITY);
  const hsp::Status status = model->grid.build(input, bad, patience);
  model->take_digest();
  model->complete = status == hsp::Status::ok;
  return to_c(status);
}

}  // namespace

uint32_t hsp_model_max_balls(void) {
  return hsp::max_count;
}

int32_t hsp_model_bytes(uint32_t balls, size_t *bytes) {
  if (bytes == nullptr) return HSP_E_ARGUMENT;
  if (balls > HSP_MAX_BALLS) return HSP_E_RANGE;
  return get_bytes<hsp_model>(balls, bytes);
}

int32_t hsp_model_init(void *memory, size_t bytes, uint32_t balls, hsp_model **model) {
  LibraryArithmetic arithmetic;
  if (memory == nullptr || model == nullptr) return HSP_E_ARGUMENT;
  if (balls > HSP_MAX_BALLS) return HSP_E_RANGE;
  const int32_t status = init(memory, bytes, balls, model);
  if (status != HSP_OK) return status;
  clear(**model);
  return HSP_OK;
}

int32_t hsp_model_options_init(hsp_model_options *options, uint32_t struct_size) {
  return write_struct(default_model_options(), options, struct_size);
}

int32_t hsp_model_set(hsp_model *model, uint32_t n, const double *xyz, const double *radius,
                      const hsp_model_options *options, uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  return set(model, {n, xyz, radius}, options, HSP_OK, hsp::Patience(), first_bad);
}

int32_t hsp_model_set_with(hsp_model *model, uint32_t n, const double *xyz, const double *radius,
                           const hsp_model_request *request, uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  hsp_model_request asked;
  Executor executor(arithmetic);
  const int32_t status = read_request(request, asked, executor);
  return set(model, {n, xyz, radius}, asked.options, status, hsp::Patience(&executor), first_bad);
}

int32_t hsp_model_get_info(const hsp_model *model, hsp_model_info *info) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(model, info == nullptr); status != HSP_OK) return status;
  const hsp::BallSet &balls = model->balls();
  const hsp::CubeSlots &slots = model->grid.slots();
  info->balls = balls.n;
  info->cubes = model->grid.cubes();
  info->table_slots = slots.size();
  info->longest_probe = slots.longest_search();
  info->step = balls.lattice.step();
  info->probe = balls.lattice.length(static_cast<double>(balls.probe_steps));
  info->largest_radius = balls.lattice.length(static_cast<double>(balls.largest_radius));
  const int64_t smallest = balls.smallest_radius;
  info->largest_rounding = smallest == hsp::no_radius ? 0.0 : smallest == 0 ? 1.0 : 0.5 / static_cast<double>(smallest);
  info->reserved[0] = info->reserved[1] = 0;
  return HSP_OK;
}

int32_t hsp_model_get_balls(const hsp_model *model, double *xyz, double *radius, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(model); status != HSP_OK) return status;
  const hsp::BallSet &balls = model->balls();
  const bool wanted = xyz != nullptr || radius != nullptr;
  if (!fits(wanted, capacity, balls.n, needed)) return HSP_E_CAPACITY;
  for (uint32_t i = 0; wanted && i < balls.n; ++i) {
    const hsp::exact::Lattice &lattice = balls.lattice;
    const double centre[3] = {lattice.length(balls.x[i]), lattice.length(balls.y[i]), lattice.length(balls.z[i])};
    put_vector(centre, xyz, balls.caller[i]);
    if (radius != nullptr) radius[balls.caller[i]] = lattice.length(balls.r[i]);
  }
  return HSP_OK;
}
