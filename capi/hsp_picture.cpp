#include "hsp_map.hpp"
#include "hsp_sticks.hpp"
#include "hsp_view.hpp"
#include "picture/palettes.hpp"
#include "picture/picture.hpp"
#include "visibility/map_paths.hpp"

using hsp::capi::is_live;

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
          HSP_ADDRESS(select.memory),
          select.memory_bytes};
}

bool has_centre(const hsp_picture_options &options) {
  return options.centre[0] != 0.0 || options.centre[1] != 0.0 || options.centre[2] != 0.0;
}

bool is_valid(const hsp_picture_options &options) {
  return options.format <= HSP_FORMAT_PDF && options.style <= HSP_STYLE_SOFT && options.unit <= HSP_UNIT_MM &&
         (options.flags & ~(HSP_PICTURE_NO_IDS | HSP_PICTURE_NO_BACKGROUND)) == 0 && options.reserved == 0 &&
         !(options.width == 0.0 && options.height == 0.0) && !(options.scale == 0.0 && has_centre(options)) &&
         options.outline_colour <= largest_colour && options.background <= largest_colour &&
         (options.memory != 0 || options.memory_bytes == 0) && options.memory <= UINTPTR_MAX &&
         options.memory_bytes <= SIZE_MAX;
}

bool is_finite(const hsp_picture_options &options) {
  return hsp::is_finite(options.width) && hsp::is_finite(options.height) && hsp::is_finite(options.margin) &&
         hsp::is_finite(options.outline) && hsp::is_finite(options.fog) && hsp::is_finite(options.scale) &&
         hsp::is_finite(options.centre[0]) && hsp::is_finite(options.centre[1]) && hsp::is_finite(options.centre[2]);
}

bool is_in_range(const hsp_picture_options &options) {
  const auto within = [](double value, double low, double high) { return low <= value && value <= high; };
  return within(options.width, 0.0, longest) && within(options.height, 0.0, longest) &&
         within(options.margin, 0.0, largest_margin) && options.outline <= longest && within(options.fog, 0.0, 1.0) &&
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
          reinterpret_cast<void *>(static_cast<uintptr_t>(options.memory)),
          static_cast<size_t>(options.memory_bytes)};
}

// Of one call: all but where its paths are from.
struct Call {
  const uint32_t *colour;
  const hsp_picture_options *options;
  const char *title;
  const char *description;
  hsp_sink sink;
  void *context;
  uint64_t *bytes;
};

// write(options, taken) writes the picture of a handle with results.
template <class Handle, class Write>
int32_t write_checked(const Handle *handle, const Call &call, Write write) {
  if (call.bytes != nullptr) *call.bytes = 0;
  if (!is_live(handle) || call.sink == nullptr) return HSP_E_ARGUMENT;
  hsp_picture_options wanted = defaults();
  if (call.options != nullptr && !(hsp::capi::read_struct(call.options, defaults(), wanted) && is_valid(wanted))) {
    return HSP_E_ARGUMENT;
  }
  // Without results the number of colours is not known.
  const bool ready = handle->has_results();
  if (ready && call.colour != nullptr && !are_colours(call.colour, handle->balls().n)) return HSP_E_ARGUMENT;
  if (!is_finite(wanted)) return HSP_E_NOT_FINITE;
  if (!is_in_range(wanted)) return HSP_E_RANGE;
  if (wanted.memory != 0 && wanted.memory_bytes < HSP_PICTURE_MEMORY) return HSP_E_MEMORY;
  if (!ready) return HSP_E_STATE;
  uint64_t taken = 0;
  const hsp::Status status = write(from_c(wanted), taken);
  if (call.bytes != nullptr) *call.bytes = taken;
  return hsp::capi::to_c(status);
}

}  // namespace

namespace hsp::capi {

// It ended with `reserved` in version 0.1.
template <>
constexpr bool is_earlier_size<hsp_picture_options>(uint32_t size) {
  return size == 72;
}

}  // namespace hsp::capi

int32_t hsp_picture_options_init(hsp_picture_options *options, uint32_t struct_size) {
  return hsp::capi::write_struct(defaults(), options, struct_size) ? HSP_OK : HSP_E_ARGUMENT;
}

uint32_t hsp_palette_colour(uint32_t palette, uint32_t atomic_number, uint32_t chain) {
  const bool known = palette <= HSP_PALETTE_CHAIN;
  return hsp::palette_colour(known ? static_cast<hsp::Palette>(palette) : hsp::Palette::soft, atomic_number, chain);
}

int32_t hsp_picture_write(hsp_view *view, const uint32_t *colour, const hsp_picture_options *options, const char *title,
                          const char *description, hsp_sink sink, void *context, uint64_t *bytes) {
  const Call call{colour, options, title, description, sink, context, bytes};
  return write_checked(view, call, [&](const hsp::PictureOptions &wanted, uint64_t &taken) {
    return hsp::write_picture({view->balls(), hsp::paths_of(view->structure()), colour, title, description}, wanted,
                              view->builder.scratch(), sink, context, taken);
  });
}

int32_t hsp_picture_write_map(hsp_map *map, const uint32_t *colour, const hsp_picture_options *options,
                              const char *title, const char *description, hsp_sink sink, void *context,
                              uint64_t *bytes) {
  const Call call{colour, options, title, description, sink, context, bytes};
  return write_checked(map, call, [&](const hsp::PictureOptions &wanted, uint64_t &taken) {
    const hsp::MapPaths paths(map->balls(), map->structure(), map->builder.scratch());
    return hsp::write_picture({map->balls(), paths.paths(), colour, title, description}, wanted,
                              map->builder.more_scratch(), sink, context, taken);
  });
}

int32_t hsp_picture_write_sticks(hsp_sticks *sticks, const uint32_t *colour, const hsp_picture_options *options,
                                 const char *title, const char *description, hsp_sink sink, void *context,
                                 uint64_t *bytes) {
  const Call call{colour, options, title, description, sink, context, bytes};
  return write_checked(sticks, call, [&](const hsp::PictureOptions &wanted, uint64_t &taken) {
    return hsp::write_picture({sticks->balls(), sticks->builder.paths(), colour, title, description}, wanted,
                              sticks->builder.scratch(), sink, context, taken);
  });
}
