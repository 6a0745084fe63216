// Handles that are computed from a boundary alone.
#pragma once

#include "caller_executor.hpp"
#include "hsp_boundary.hpp"

namespace hsp::capi {

// Computes the request's results. The handle is without results where that fails.
template <class Handle, class Request>
int32_t compute_from_boundary(Handle *handle, const hsp_boundary *boundary, const Request *request,
                              typename Handle::Given *limits) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(handle); status != HSP_OK) return status;
  handle->complete = false;
  Request asked;
  Executor executor(arithmetic);
  if (const int32_t status =
          first_failure(check_handle(boundary), check_struct(limits), read_request(request, asked, executor));
      status != HSP_OK)
    return status;
  if (!boundary->has_results()) return HSP_E_STATE;
  const Status status = handle->builder.build(boundary->model->grid, boundary->structure(),
                                              boundary->builder.needed().neighbours, Patience(&executor));
  handle->boundary.set(boundary);
  return finish(*handle, status, limits);
}

}  // namespace hsp::capi
