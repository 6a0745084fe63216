#include "hsp_view.hpp"
#include "hsp_boundary.hpp"
#include "view/view_rotation.hpp"

namespace {

int32_t check_limits(const hsp_view_limits *limits) {
  if (limits == nullptr || limits->struct_size != sizeof(hsp_view_limits)) return HSP_E_ARGUMENT;
  const bool representable =
      limits->balls <= HSP_MAX_BALLS && limits->neighbours <= HSP_MAX_BALLS && limits->arcs <= HSP_MAX_BALLS;
  return representable ? HSP_OK : HSP_E_RANGE;
}

hsp::ViewLimits from_c(const hsp_view_limits &limits) {
  return {limits.balls, limits.neighbours, limits.arcs};
}

hsp_view_limits to_c(const hsp::ViewLimits &limits) {
  return {sizeof(hsp_view_limits), limits.balls, limits.neighbours, limits.arcs};
}

bool is_valid(const hsp_view_options &options) {
  return options.struct_size == sizeof(hsp_view_options) && options.pieces <= HSP_PIECES_OUTSIDE_ALL &&
         (options.flags & ~HSP_VIEW_ALL_BALLS) == 0 && options.reserved == 0;
}

}  // namespace

int32_t hsp_view_limits_init(hsp_view_limits *limits, uint32_t struct_size, uint32_t balls) {
  if (limits == nullptr || struct_size != sizeof(hsp_view_limits)) return HSP_E_ARGUMENT;
  hsp::ViewLimits defaults;
  const hsp::Status status = hsp::default_limits(balls, defaults);
  if (status == hsp::Status::ok) *limits = to_c(defaults);
  return hsp::capi::to_c(status);
}

int32_t hsp_view_bytes(const hsp_view_limits *limits, size_t *bytes) {
  if (bytes == nullptr) return HSP_E_ARGUMENT;
  if (const int32_t status = check_limits(limits); status != HSP_OK) return status;
  return hsp::capi::get_bytes<hsp_view>(from_c(*limits), bytes);
}

int32_t hsp_view_init(void *memory, size_t bytes, const hsp_view_limits *limits, hsp_view **view) {
  if (memory == nullptr || view == nullptr) return HSP_E_ARGUMENT;
  if (const int32_t status = check_limits(limits); status != HSP_OK) return status;
  return hsp::capi::init(memory, bytes, from_c(*limits), view);
}

int32_t hsp_view_options_init(hsp_view_options *options, uint32_t struct_size) {
  if (options == nullptr || struct_size != sizeof(hsp_view_options)) return HSP_E_ARGUMENT;
  *options = {struct_size, HSP_PIECES_OUTSIDE_FARTHER, 0, 0, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}};
  return HSP_OK;
}

int32_t hsp_view_options_turn(hsp_view_options *options, double x, double y, double z) {
  if (options == nullptr || options->struct_size != sizeof(hsp_view_options)) return HSP_E_ARGUMENT;
  hsp::ViewDirection direction;
  const hsp::Status status = hsp::direction_of_rotation(x, y, z, direction);
  if (status != hsp::Status::ok) return hsp::capi::to_c(status);
  for (int k = 0; k < 3; ++k) {
    options->towards[k] = direction.towards[k];
    options->up[k] = direction.up[k];
  }
  return HSP_OK;
}

int32_t hsp_view_compute(hsp_view *view, const hsp_model *model, const hsp_boundary *boundary,
                         const hsp_view_options *options) {
  if (view == nullptr) return HSP_E_ARGUMENT;
  hsp::capi::forget(*view);
  hsp::ViewRequest request;
  if (model == nullptr) return HSP_E_ARGUMENT;
  if (options != nullptr) {
    if (!is_valid(*options)) return HSP_E_ARGUMENT;
    for (int k = 0; k < 3; ++k) {
      request.direction.towards[k] = options->towards[k];
      request.direction.up[k] = options->up[k];
    }
    request.kind =
        options->pieces == HSP_PIECES_OUTSIDE_ALL ? hsp::PieceKind::outside_all : hsp::PieceKind::outside_farther;
    request.all_balls = (options->flags & HSP_VIEW_ALL_BALLS) != 0;
  }
  if (boundary == nullptr) {
    if (request.kind == hsp::PieceKind::outside_all) return HSP_E_ARGUMENT;
  } else {
    if (!boundary->has_results()) return HSP_E_STATE;
    if (boundary->model != model) return HSP_E_ARGUMENT;
  }
  const hsp::Status status =
      view->builder.build(model->grid, boundary == nullptr ? nullptr : &boundary->structure(), request);
  view->model = model;
  view->revision = model->revision;
  return hsp::capi::remember(*view, status);
}

int32_t hsp_view_get_needed(const hsp_view *view, hsp_view_limits *needed) {
  if (view == nullptr || needed == nullptr) return HSP_E_ARGUMENT;
  if (!view->attempted) return HSP_E_STATE;
  *needed = to_c(view->builder.needed());
  return HSP_OK;
}
