#include "hardsphere.h"

namespace {

// Memory for a model and, behind it, a boundary.
struct Division {
  size_t model = 0, boundary = 0;
};

int32_t divide(const hsp_boundary_limits &limits, Division &bytes) {
  int32_t status = hsp_model_bytes(limits.balls, &bytes.model);
  if (status == HSP_OK) status = hsp_boundary_bytes(&limits, &bytes.boundary);
  return status == HSP_OK && bytes.boundary > SIZE_MAX - bytes.model ? HSP_E_RANGE : status;
}

int32_t make_model(uint32_t n, const double *xyz, const double *radius, double probe, void *memory, size_t bytes,
                   hsp_model *&model) {
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = probe;
  if (status == HSP_OK) status = hsp_model_init(memory, bytes, n, &model);
  return status == HSP_OK ? hsp_model_set(model, n, xyz, radius, &options, nullptr) : status;
}

}  // namespace

int32_t hsp_areas_bytes(uint32_t n, size_t *bytes) {
  if (bytes == nullptr) return HSP_E_ARGUMENT;
  hsp_boundary_limits limits;
  Division needed;
  int32_t status = hsp_boundary_limits_init(&limits, sizeof limits, n);
  if (status == HSP_OK) status = divide(limits, needed);
  if (status == HSP_OK) *bytes = needed.model + needed.boundary;
  return status;
}

int32_t hsp_areas(uint32_t n, const double *xyz, const double *radius, double probe, void *memory, size_t *bytes,
                  hsp_totals *totals, double *area) {
  if (bytes == nullptr || (memory == nullptr && *bytes > 0)) return HSP_E_ARGUMENT;
  if (n > 0 && (xyz == nullptr || radius == nullptr)) return HSP_E_ARGUMENT;
  hsp_boundary_limits limits;
  hsp_model *model = nullptr;
  int32_t status = hsp_boundary_limits_init(&limits, sizeof limits, n);
  while (status == HSP_OK) {
    Division needed;
    status = divide(limits, needed);
    if (status != HSP_OK) break;
    if (*bytes < needed.model || *bytes - needed.model < needed.boundary) {
      *bytes = needed.model + needed.boundary;
      return HSP_E_CAPACITY;
    }
    if (model == nullptr) status = make_model(n, xyz, radius, probe, memory, needed.model, model);
    hsp_boundary *boundary = nullptr;
    auto *const behind = static_cast<unsigned char *>(memory) + needed.model;
    if (status == HSP_OK) status = hsp_boundary_init(behind, needed.boundary, &limits, &boundary);
    if (status == HSP_OK) status = hsp_boundary_compute(boundary, model, &limits);
    if (status == HSP_OK) return hsp_boundary_measure(boundary, nullptr, totals, area, nullptr, n, nullptr);
    if (status == HSP_E_CAPACITY) status = HSP_OK;  // try again, if there is room for the larger limits
  }
  return status;
}
