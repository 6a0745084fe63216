// Handles that are computed from another handle, their source.
#pragma once

#include "caller_executor.hpp"
#include "core/small_code.hpp"
#include "hsp_boundary.hpp"

namespace hsp::capi {

// Computes the results that a request asks for by build(asked, executor), which notes the source. check(asked): the
// status of further arguments. If that fails the handle has no results. Out of line: a handle may have several
// functions that compute it.
template <class Handle, class Source, class Request, class Check, class Build>
HSP_APART_UNLESS_SMALL int32_t compute_from(LibraryArithmetic &arithmetic, Handle *handle, const Source *source,
                                            const Request *request, typename Handle::Given *limits, Check check,
                                            Build build) {
  if (const int32_t status = check_handle(handle); status != HSP_OK) return status;
  handle->complete = false;
  Request asked;
  Executor executor(arithmetic);
  if (const int32_t status =
          first_failure(check_handle(source), check_struct(limits), read_request(request, asked, executor));
      status != HSP_OK)
    return status;
  if (const int32_t status = check(asked); status != HSP_OK) return status;
  if (!source->has_results()) return HSP_E_STATE;
  return finish(*handle, build(asked, executor), limits);
}
template <class Handle, class Source, class Request, class Build>
int32_t compute_from(Handle *handle, const Source *source, const Request *request, typename Handle::Given *limits,
                     Build build) {
  LibraryArithmetic arithmetic;
  return compute_from(
      arithmetic, handle, source, request, limits, [](const Request &) { return HSP_OK; }, build);
}

// Computes from a boundary alone.
template <class Handle, class Request>
int32_t compute_from_boundary(Handle *handle, const hsp_boundary *boundary, const Request *request,
                              typename Handle::Given *limits) {
  return compute_from(handle, boundary, request, limits, [&](const Request &, Executor &executor) {
    handle->boundary.set(boundary);
    return handle->builder.build(boundary->model->grid, boundary->structure(), boundary->builder.needed().neighbours,
                                 Patience(&executor));
  });
}

// Computes from a model alone.
template <class Handle, class Request>
int32_t compute_from_model(Handle *handle, const hsp_model *model, const Request *request,
                           typename Handle::Given *limits) {
  return compute_from(handle, model, request, limits, [&](const Request &, Executor &executor) {
    handle->model.set(model);
    return handle->builder.build(model->grid, Patience(&executor));
  });
}

}  // namespace hsp::capi
