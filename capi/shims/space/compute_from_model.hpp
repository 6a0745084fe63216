// Handles that are computed from a model alone.
#pragma once

#include "caller_executor.hpp"
#include "hsp_model.hpp"

namespace hsp::capi {

// Computes the request's results. The handle is without results where that fails.
template <class Handle, class Request>
int32_t compute_from_model(Handle *handle, const hsp_model *model, const Request *request,
                           typename Handle::Given *limits) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(handle); status != HSP_OK) return status;
  handle->complete = false;
  Request asked;
  Executor executor(arithmetic);
  if (const int32_t status =
          first_failure(check_handle(model), check_struct(limits), read_request(request, asked, executor));
      status != HSP_OK)
    return status;
  if (!model->has_results()) return HSP_E_STATE;
  const Status status = handle->builder.build(model->grid, Patience(&executor));
  handle->model.set(model);
  return finish(*handle, status, limits);
}

}  // namespace hsp::capi
