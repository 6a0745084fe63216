#include <initializer_list>

#include "hsp_map.hpp"
#include "hsp_sticks.hpp"
#include "hsp_view.hpp"
#include "maps/map_paths.hpp"
#include "picture/depth_shares.hpp"
#include "picture/palettes.hpp"
#include "picture/picture.hpp"

using namespace hsp::capi;

namespace {

static_assert(static_cast<uint32_t>(hsp::PictureFormat::svg) == HSP_FORMAT_SVG &&
              static_cast<uint32_t>(hsp::PictureFormat::eps) == HSP_FORMAT_EPS &&
              static_cast<uint32_t>(hsp::PictureFormat::pdf) == HSP_FORMAT_PDF);
static_assert(static_cast<uint32_t>(hsp::PictureStyle::flat) == HSP_STYLE_FLAT &&
              static_cast<uint32_t>(hsp::PictureStyle::headlight) == HSP_STYLE_HEADLIGHT &&
              static_cast<uint32_t>(hsp::PictureStyle::soft) == HSP_STYLE_SOFT);
static_assert(static_cast<uint32_t>(hsp::Palette::soft) == HSP_PALETTE_SOFT &&
              static_cast<uint32_t>(hsp::Palette::jmol) == HSP_PALETTE_JMOL &&
              static_cast<uint32_t>(hsp::Palette::chain) == HSP_PALETTE_CHAIN);

constexpr uint32_t largest_colour = 0xFFFFFF;
constexpr double longest = 1e6;
constexpr double largest_margin = 10.0;

hsp_picture_options defaults() {
  const hsp::PictureOptions select;
  return {sizeof(hsp_picture_options),
          static_cast<uint32_t>(select.format),
          static_cast<uint32_t>(select.style),
          HSP_UNIT_PX,
          select.width,
          select.height,
          select.margin,
          select.outline,
          select.fog,
          select.outline_colour,
          select.background,
          0,
          0,
          select.scale,
          {select.centre[0], select.centre[1], select.centre[2]},
          select.memory,
          select.memory_bytes,
          nullptr,
          nullptr,
          {select.ink_width[0], select.ink_width[1], select.ink_width[2]},
          {select.ink_colour[0], select.ink_colour[1], select.ink_colour[2]},
          0,
          nullptr,
          nullptr,
          nullptr,
          0};
}

bool has_centre(const hsp_picture_options &options) {
  return options.centre[0] != 0.0 || options.centre[1] != 0.0 || options.centre[2] != 0.0;
}

bool is_valid(const hsp_picture_options &options) {
  return options.format <= HSP_FORMAT_PDF && options.style <= HSP_STYLE_SOFT && options.unit <= HSP_UNIT_MM &&
         (options.flags & ~(HSP_PICTURE_NO_IDS | HSP_PICTURE_NO_BACKGROUND)) == 0 &&
         !(options.width == 0.0 && options.height == 0.0) && !(options.scale == 0.0 && has_centre(options)) &&
         options.outline_colour <= largest_colour && options.background <= largest_colour &&
         (options.memory != nullptr || options.memory_bytes == 0) && options.ink_colour[0] <= largest_colour &&
         options.ink_colour[1] <= largest_colour && options.ink_colour[2] <= largest_colour;
}

// Options as a program gives them, completed; null means defaults.
int32_t read_options(const hsp_picture_options *given, hsp_picture_options &complete) {
  complete = defaults();
  if (given == nullptr) return HSP_OK;
  if (const int32_t status = read_struct(given, defaults(), complete); status != HSP_OK) return status;
  if (complete.reserved != 0 || complete.reserved_for_ink != 0 || complete.reserved_for_sticks != 0) {
    return HSP_E_VERSION;
  }
  return is_valid(complete) ? HSP_OK : HSP_E_ARGUMENT;
}

bool is_finite(const hsp_picture_options &options) {
  return hsp::is_finite(options.width) && hsp::is_finite(options.height) && hsp::is_finite(options.margin) &&
         hsp::is_finite(options.outline) && hsp::is_finite(options.fog) && hsp::is_finite(options.scale) &&
         hsp::is_finite(options.centre[0]) && hsp::is_finite(options.centre[1]) && hsp::is_finite(options.centre[2]) &&
         hsp::is_finite(options.ink_width[0]) && hsp::is_finite(options.ink_width[1]) &&
         hsp::is_finite(options.ink_width[2]);
}

bool is_in_range(const hsp_picture_options &options) {
  const auto within = [](double value, double low, double high) { return low <= value && value <= high; };
  return within(options.width, 0.0, longest) && within(options.height, 0.0, longest) &&
         within(options.margin, 0.0, largest_margin) && options.outline <= longest && within(options.fog, 0.0, 1.0) &&
         options.ink_width[0] <= longest && options.ink_width[1] <= longest && options.ink_width[2] <= longest &&
         options.scale >= 0.0;
}

bool are_colours(const uint32_t *colour, uint32_t n) {
  for (uint32_t i = 0; i < n; ++i) {
    if (colour[i] > largest_colour) return false;
  }
  return true;
}

hsp::PictureOptions from_c(const hsp_picture_options &options) {
  return {static_cast<hsp::PictureFormat>(options.format),
          static_cast<hsp::PictureStyle>(options.style),
          options.unit == HSP_UNIT_MM,
          options.width,
          options.height,
          options.margin,
          options.outline,
          options.fog,
          options.outline_colour,
          options.background,
          (options.flags & HSP_PICTURE_NO_IDS) == 0,
          (options.flags & HSP_PICTURE_NO_BACKGROUND) == 0,
          options.scale,
          {options.centre[0], options.centre[1], options.centre[2]},
          options.memory,
          options.memory_bytes,
          {options.ink_width[0], options.ink_width[1], options.ink_width[2]},
          {options.ink_colour[0], options.ink_colour[1], options.ink_colour[2]}};
}

// The arguments of one call, without the source of its paths.
struct Call {
  LibraryArithmetic &arithmetic;
  const uint32_t *colour;
  const hsp_picture_options *options;
  const char *title;
  const char *description;
  hsp_sink sink;
  void *context;
  uint64_t *bytes;

  // A sink whose context is the call. It calls the caller's sink in the caller's floating-point environment.
  static int32_t hand_on(void *call, const char *bytes, size_t count) {
    const Call &of = *static_cast<const Call *>(call);
    const CallersArithmetic callers(of.arithmetic);
    return of.sink(of.context, bytes, count);
  }
};

// Checks that the map of the ink, if there is one, shows the same scene as a handle with results.
template <class Handle, class Map>
int32_t check_map_of_ink(const Handle &handle, const Map *map) {
  if (map == nullptr) return HSP_OK;
  if (const int32_t status = check_handle(map); status != HSP_OK) return status;
  const bool same =
      map->has_results() && map->model.is(&*handle.model) && map->structure().frame.is_same(handle.structure().frame);
  return same ? HSP_OK : HSP_E_ARGUMENT;
}
template <class Handle>
int32_t check_ink(const Handle &handle, const hsp_picture_options &options) {
  return options.ink_of_sticks != nullptr ? HSP_E_ARGUMENT : check_map_of_ink(handle, options.ink);
}
int32_t check_ink(const hsp_sticks &sticks, const hsp_picture_options &options) {
  const hsp_sticks *const map = options.ink_of_sticks;
  if (options.ink != nullptr) return HSP_E_ARGUMENT;
  if (const int32_t status = check_map_of_ink(sticks, map); status != HSP_OK || map == nullptr) return status;
  return map->map().exist && map->has_same_sticks(sticks) ? HSP_OK : HSP_E_ARGUMENT;
}

// Writes a picture of paths.
hsp::Status draw(Call &call, const hsp::BallSet &balls, const hsp_picture_options &options,
                 const hsp::PaintedPaths &paths, hsp::Span<uint32_t> scratch, uint64_t &taken) {
  hsp::PictureInput input{balls, paths, call.colour, call.title, call.description};
  if (options.ink != nullptr) input.silhouettes = hsp::silhouettes_of(options.ink->structure());
  if (options.ink_of_sticks != nullptr) input.silhouettes = hsp::silhouettes_of(options.ink_of_sticks->map());
  input.group = options.group;
  input.atom_class = options.atom_class;
  input.atom_title = options.atom_title;
  return hsp::write_picture(input, from_c(options), scratch, Call::hand_on, &call, taken);
}

template <class Handle, class WithPaths>
int32_t write_if_valid(const Handle *handle, Call &call, uint64_t &taken, WithPaths with_paths) {
  if (const int32_t status = check_handle(handle); status != HSP_OK) return status;
  hsp_picture_options wanted;
  if (const int32_t status = read_options(call.options, wanted); status != HSP_OK) return status;
  if (call.sink == nullptr) return HSP_E_ARGUMENT;
  // Without results the number of colours is not known.
  if (!handle->has_results()) return HSP_E_STATE;
  if (call.colour != nullptr && !are_colours(call.colour, handle->balls().n)) return HSP_E_ARGUMENT;
  if (const int32_t status = check_ink(*handle, wanted); status != HSP_OK) return status;
  if (!is_finite(wanted)) return HSP_E_NOT_FINITE;
  if (!is_in_range(wanted)) return HSP_E_RANGE;
  if (wanted.memory != nullptr && wanted.memory_bytes < HSP_PICTURE_MEMORY) return HSP_E_MEMORY;
  return hsp::capi::to_c(with_paths([&](const hsp::PaintedPaths &paths, hsp::Span<uint32_t> scratch) {
    return draw(call, handle->balls(), wanted, paths, scratch, taken);
  }));
}

// with_paths(write) calls write(paths, scratch memory) for a handle with results.
template <class Handle, class WithPaths>
int32_t write_checked(const Handle *handle, Call &call, WithPaths with_paths) {
  uint64_t taken = 0;
  const int32_t status = write_if_valid(handle, call, taken, with_paths);
  if (call.bytes != nullptr && status != HSP_E_HANDLE) *call.bytes = taken;
  return status;
}

}  // namespace

namespace hsp::capi {

// In version 0.1 the struct ended with `reserved`.
template <>
inline constexpr uint32_t earlier_bytes<hsp_picture_options> = 72;

}  // namespace hsp::capi

int32_t hsp_picture_options_init(hsp_picture_options *options, uint32_t struct_size) {
  return write_struct(defaults(), options, struct_size);
}

int32_t hsp_picture_ink_width(double full_width, double gap, double *width) {
  LibraryArithmetic arithmetic(full_width, gap);
  if (width == nullptr) return HSP_E_ARGUMENT;
  if (!hsp::is_finite(full_width) || !hsp::is_finite(gap)) return HSP_E_NOT_FINITE;
  if (full_width < 0.0 || gap < 0.0) return HSP_E_RANGE;
  *width = hsp::width_before_gap(full_width, gap);
  return HSP_OK;
}

int32_t hsp_picture_fog_share(double nearest, double farthest, double mean_radius, double depth, double *share) {
  LibraryArithmetic arithmetic(nearest, farthest, mean_radius, depth);
  if (share == nullptr) return HSP_E_ARGUMENT;
  for (const double number : {nearest, farthest, mean_radius, depth}) {
    if (!hsp::is_finite(number)) return HSP_E_NOT_FINITE;
  }
  if (mean_radius < 0.0) return HSP_E_RANGE;
  *share = hsp::share_of_fog(nearest, hsp::end_of_fog(nearest, farthest, mean_radius), depth);
  return HSP_OK;
}

uint32_t hsp_palette_colour(uint32_t palette, uint32_t atomic_number, uint32_t chain) {
  LibraryArithmetic arithmetic;
  const bool known = palette <= HSP_PALETTE_CHAIN;
  return hsp::palette_colour(known ? static_cast<hsp::Palette>(palette) : hsp::Palette::soft, atomic_number, chain);
}

int32_t hsp_picture_write(hsp_view *view, const uint32_t *colour, const hsp_picture_options *options, const char *title,
                          const char *description, hsp_sink sink, void *context, uint64_t *bytes) {
  LibraryArithmetic arithmetic;
  Call call{arithmetic, colour, options, title, description, sink, context, bytes};
  return write_checked(view, call,
                       [view](auto write) { return write(hsp::paths_of(view->structure()), view->builder.scratch()); });
}

int32_t hsp_picture_write_map(hsp_map *map, const uint32_t *colour, const hsp_picture_options *options,
                              const char *title, const char *description, hsp_sink sink, void *context,
                              uint64_t *bytes) {
  LibraryArithmetic arithmetic;
  Call call{arithmetic, colour, options, title, description, sink, context, bytes};
  return write_checked(map, call, [map](auto write) {
    const hsp::MapPaths paths(map->balls(), map->structure(), map->builder.scratch());
    return write(paths.paths(), map->builder.more_scratch());
  });
}

int32_t hsp_picture_write_sticks(hsp_sticks *sticks, const uint32_t *colour, const hsp_picture_options *options,
                                 const char *title, const char *description, hsp_sink sink, void *context,
                                 uint64_t *bytes) {
  LibraryArithmetic arithmetic;
  Call call{arithmetic, colour, options, title, description, sink, context, bytes};
  return write_checked(sticks, call,
                       [sticks](auto write) { return write(sticks->builder.paths(), sticks->builder.scratch()); });
}
