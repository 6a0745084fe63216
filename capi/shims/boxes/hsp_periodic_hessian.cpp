#include "gradient_arrays.hpp"
#include "hsp_periodic.hpp"
#include "periodic/periodic_hessian.hpp"

using namespace hsp::capi;

static_assert(hsp::singular_flag == HSP_HESSIAN_SINGULAR);

int32_t hsp_periodic_get_hessian_rows(const hsp_periodic *periodic, const hsp_gradient_request *request,
                                      uint32_t *first, uint32_t *ball, double *block, uint32_t *flags,
                                      uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  GradientRequest asked(arithmetic);
  if (const int32_t status = check_handle(periodic); status != HSP_OK) return status;
  if (const int32_t status = asked.read(request); status != HSP_OK) return status;
  if (first == nullptr || (capacity > 0 && (ball == nullptr || block == nullptr))) return HSP_E_ARGUMENT;
  if (!periodic->has_areas()) return HSP_E_STATE;
  const uint32_t n = periodic->balls();
  if (!asked.are_finite(n)) return HSP_E_NOT_FINITE;
  const hsp::PeriodicUnion &structure = periodic->builder;
  if (!hsp::find_hessian_row_starts_in_box(asked.executor, structure, first)) return asked.executor.status();
  if (needed != nullptr) *needed = first[n];
  if (capacity < first[n]) return HSP_E_CAPACITY;
  hsp::EnergyTerms terms = asked.terms();
  terms.weights = hsp::weights_in_box(structure, asked.given.sigma, terms.weights.touching_balls);
  const hsp::HessianRows rows{first, ball, block, flags};
  return hsp::find_hessian_rows_in_box(asked.executor, structure, terms, rows) ? HSP_OK : asked.executor.status();
}
