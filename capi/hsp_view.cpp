#include "conversion.hpp"
#include "core/elementary.hpp"
#include "view/view_builder.hpp"

namespace {

using hsp::capi::has_results;

int32_t check_limits(const hsp_view_limits *limits) {
  if (limits == nullptr || limits->struct_size != sizeof(hsp_view_limits)) return HSP_E_ARGUMENT;
  const bool representable =
      limits->balls <= HSP_MAX_BALLS && limits->neighbours <= HSP_MAX_BALLS && limits->arcs <= HSP_MAX_BALLS;
  return representable ? HSP_OK : HSP_E_RANGE;
}

hsp_view *carve(hsp::Workspace &workspace, const hsp_view_limits &limits, hsp::ViewBuilder &builder) {
  const hsp::Span<hsp_view> handle = workspace.take<hsp_view>(1);
  builder.carve(workspace, {limits.balls, limits.neighbours, limits.arcs});
  return handle.data();
}

bool is_valid(const hsp_view_options &options) {
  return options.struct_size == sizeof(hsp_view_options) && options.pieces <= HSP_PIECES_OUTSIDE_ALL &&
         (options.flags & ~HSP_VIEW_ALL_BALLS) == 0 && options.reserved == 0;
}

// The unit vector of an angle in degrees; quarter turns are exact.
hsp::SinCos direction_of_degrees(double degrees) {
  const double turns = degrees / 360.0;
  const double whole = static_cast<double>(static_cast<int64_t>(turns));
  const double quarters = (degrees - whole * 360.0) / 90.0;
  if (quarters == static_cast<double>(static_cast<int64_t>(quarters))) {
    switch (static_cast<int64_t>(quarters) & 3) {
      case 0:
        return {1.0, 0.0};
      case 1:
        return {0.0, 1.0};
      case 2:
        return {-1.0, 0.0};
      default:
        return {0.0, -1.0};
    }
  }
  return hsp::sin_cos(quarters * (hsp::pi / 2));
}

}  // namespace

int32_t hsp_view_limits_init(hsp_view_limits *limits, uint32_t struct_size, uint32_t balls) {
  if (limits == nullptr || struct_size != sizeof(hsp_view_limits)) return HSP_E_ARGUMENT;
  if (balls > (HSP_MAX_BALLS - 64) / 12) return HSP_E_RANGE;
  *limits = {struct_size, balls, balls < 256 ? balls : 256, 12 * balls + 64};
  return HSP_OK;
}

int32_t hsp_view_bytes(const hsp_view_limits *limits, size_t *bytes) {
  if (bytes == nullptr) return HSP_E_ARGUMENT;
  if (const int32_t status = check_limits(limits); status != HSP_OK) return status;
  hsp::Workspace measure;
  hsp::ViewBuilder builder;
  carve(measure, *limits, builder);
  if (measure.bytes() == 0) return HSP_E_RANGE;
  *bytes = measure.bytes();
  return HSP_OK;
}

int32_t hsp_view_init(void *memory, size_t bytes, const hsp_view_limits *limits, hsp_view **view) {
  if (memory == nullptr || view == nullptr) return HSP_E_ARGUMENT;
  size_t required = 0;
  if (const int32_t status = hsp_view_bytes(limits, &required); status != HSP_OK) return status;
  if (bytes < required) return HSP_E_MEMORY;
  hsp::Workspace workspace(memory, bytes);
  hsp::ViewBuilder builder;
  hsp_view *handle = carve(workspace, *limits, builder);
  *handle = {builder, nullptr, 0, false, false};
  *view = handle;
  return HSP_OK;
}

int32_t hsp_view_options_init(hsp_view_options *options, uint32_t struct_size) {
  if (options == nullptr || struct_size != sizeof(hsp_view_options)) return HSP_E_ARGUMENT;
  *options = {struct_size, HSP_PIECES_OUTSIDE_FARTHER, 0, 0, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}};
  return HSP_OK;
}

// The balls are to_view by R = R_z R_y R_x; seen from them, the viewer's axes are the rows of R.
int32_t hsp_view_options_turn(hsp_view_options *options, double x, double y, double z) {
  if (options == nullptr || options->struct_size != sizeof(hsp_view_options)) return HSP_E_ARGUMENT;
  if (!hsp::is_finite(x) || !hsp::is_finite(y) || !hsp::is_finite(z)) return HSP_E_NOT_FINITE;
  constexpr double most = 1e6;
  if (std::fabs(x) > most || std::fabs(y) > most || std::fabs(z) > most) return HSP_E_RANGE;
  const hsp::SinCos a = direction_of_degrees(x);
  const hsp::SinCos b = direction_of_degrees(y);
  const hsp::SinCos c = direction_of_degrees(z);
  const double towards[3] = {-b.sine, b.cosine * a.sine, b.cosine * a.cosine};
  const double up[3] = {c.sine * b.cosine, c.sine * b.sine * a.sine + c.cosine * a.cosine,
                        c.sine * b.sine * a.cosine - c.cosine * a.sine};
  for (int k = 0; k < 3; ++k) {
    options->towards[k] = towards[k];
    options->up[k] = up[k];
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
    if (!has_results(*boundary)) return HSP_E_STATE;
    if (boundary->model != model) return HSP_E_ARGUMENT;
  }
  const hsp::Status status =
      view->builder.build(model->grid, boundary == nullptr ? nullptr : &boundary->builder.boundary(), request);
  view->model = model;
  view->revision = model->revision;
  return hsp::capi::remember(*view, status);
}

int32_t hsp_view_get_needed(const hsp_view *view, hsp_view_limits *needed) {
  if (view == nullptr || needed == nullptr) return HSP_E_ARGUMENT;
  if (!view->attempted) return HSP_E_STATE;
  const hsp::ViewLimits &limits = view->builder.needed();
  *needed = {sizeof(hsp_view_limits), limits.balls, limits.neighbours, limits.arcs};
  return HSP_OK;
}
