#include "curvature/hessian_rows.hpp"
#include "gradient_arrays.hpp"
#include "hsp_boundary.hpp"

using namespace hsp::capi;

static_assert(hsp::singular_flag == HSP_HESSIAN_SINGULAR);

int32_t hsp_boundary_get_hessian_rows(const hsp_boundary *boundary, const hsp_gradient_request *request,
                                      uint32_t *first, uint32_t *ball, double *block, uint32_t *flags,
                                      uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  GradientRequest asked(arithmetic);
  if (const int32_t status = check_handle(boundary); status != HSP_OK) return status;
  if (const int32_t status = asked.read(request); status != HSP_OK) return status;
  if (first == nullptr || (capacity > 0 && (ball == nullptr || block == nullptr))) return HSP_E_ARGUMENT;
  if (!boundary->has_results()) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const uint32_t n = grid.balls().n;
  if (!asked.are_finite(n)) return HSP_E_NOT_FINITE;
  const hsp::Boundary &structure = boundary->structure();
  hsp::find_area_row_starts(grid, structure, first);
  if (needed != nullptr) *needed = first[n];
  if (capacity < first[n]) return HSP_E_CAPACITY;
  const hsp::HessianRows rows{first, ball, block, flags};
  return hsp::find_hessian_rows(asked.executor, grid, structure, asked.terms(), rows) ? HSP_OK
                                                                                      : asked.executor.status();
}

int32_t hsp_boundary_get_hessian_product(const hsp_boundary *boundary, const hsp_gradient_request *request,
                                         const double *direction, double *product, uint32_t *flags, uint32_t capacity,
                                         uint32_t *needed) {
  LibraryArithmetic arithmetic;
  GradientRequest asked(arithmetic);
  if (const int32_t status = check_handle(boundary); status != HSP_OK) return status;
  if (const int32_t status = asked.read(request); status != HSP_OK) return status;
  if (direction == nullptr || (product == nullptr && capacity > 0)) return HSP_E_ARGUMENT;
  if (!boundary->has_areas()) return HSP_E_STATE;
  const hsp::CubeGrid &grid = boundary->model->grid;
  const uint32_t n = grid.balls().n;
  if (!asked.are_finite(n)) return HSP_E_NOT_FINITE;
  if (const int32_t status = check_weights(direction, {0, 3 * n}, nullptr); status != HSP_OK) return status;
  if (!fits(true, capacity, n, needed)) return HSP_E_CAPACITY;
  if (!hsp::multiply_by_hessian(asked.executor, grid, boundary->structure(), asked.terms(), direction, product, flags))
    return asked.executor.status();
  boundary->clear_flags_of_left_out(flags);
  return HSP_OK;
}
