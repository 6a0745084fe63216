#include "picture/paint.hpp"

#include "core/first_index.hpp"
#include "core/sorting.hpp"
#include "picture/depth_shares.hpp"

namespace hsp {
namespace {

// Lines keep more of their colour than balls do.
constexpr double fog_on_lines = 0.7;

}  // namespace

Paint::Paint(const PictureInput &input, const PictureOptions &options, const Page &page, Span<uint32_t> scratch)
    : input_(input),
      style_(options.style),
      lines_(page.line > 0.0),
      along_(lines_ && !input.paths.have_own_lines()),
      fog_(options.fog),
      background_(options.background),
      outline_(options.outline_colour),
      farthest_(page.farthest),
      nearest_(page.nearest),
      shading_(options.style == PictureStyle::soft) {
  if (!flat() && (options.format == PictureFormat::eps || options.format == PictureFormat::pdf)) find_shades(scratch);
}

void Paint::find_shades(Span<uint32_t> scratch) {
  const uint32_t paths = input_.paths.size();
  for (uint32_t p = 0; p < paths; ++p) scratch[p] = key_of(p);
  sort_ascending(scratch.part(0, paths));
  uint32_t distinct = 0;
  for (uint32_t p = 0; p < paths; ++p) {
    if (p == 0 || scratch[p] != scratch[distinct - 1]) scratch[distinct++] = scratch[p];
  }
  shades_ = scratch.part(0, distinct);
}

double Paint::fog_share(uint32_t path) const {
  const double depth = input_.paths.frame().centre_of(input_.balls, input_.paths.ball_of(path)).z;
  return share_of_fog(nearest_, farthest_, depth);
}

uint32_t Paint::fog_level(uint32_t path) const {
  return fog_ > 0.0 ? static_cast<uint32_t>(fog_levels * fog_share(path) + 0.5) : 0;
}

uint32_t Paint::flat_colour(uint32_t path) const {
  if (!flat()) return lit_colour(key_of(path), shading_.intervals() / 2);
  return mixed(input_.colour_of(input_.paths.ball_of(path)), background_, fog(path));
}

uint32_t Paint::faded_line(uint32_t colour, uint32_t level) const {
  return mixed(colour, background_, fog_on_lines * fog_ * level / fog_levels);
}

uint32_t Paint::key_of(uint32_t path) const {
  return fog_level(path) << 24 | input_.colour_of(input_.paths.ball_of(path));
}

uint32_t Paint::shade_of(uint32_t path) const {
  const uint32_t key = key_of(path);
  return first_index(0, shades_.size(), [this, key](uint32_t shade) { return shades_[shade] >= key; });
}

uint32_t Paint::unlit_colour(uint32_t path) const {
  return mixed(input_.colour_of(input_.paths.ball_of(path)), background_, fog_ * fog_level(path) / fog_levels);
}

// With fog f and background b: (c m + w)(1 - f) + b f = (c (1 - f) + b f) m + a (K (1 - f) + b f), as w = a K.
Shading::Glaze Paint::glaze(uint32_t level, uint32_t stop) const {
  const Shading::Glaze glaze = shading_.glaze(stop);
  return {mixed(glaze.colour, unpacked(background_), fog_ * level / fog_levels), glaze.opacity};
}

uint32_t Paint::lit_colour(uint32_t key, uint32_t stop) const {
  const Rgb lit = shading_.lit(unpacked(key & 0xFFFFFF), stop);
  return packed(mixed(lit, unpacked(background_), fog_ * (key >> 24) / fog_levels));
}

}  // namespace hsp
