// Colours of pieces: fog by depths at which its share is a power of two, shades that are shared, and lines.
#pragma once

#include <initializer_list>

#include "small_picture.hpp"

namespace cases {

// Balls side by side, seen along the z axis: the first is the farthest one, the second the nearest.
constexpr SmallBall at_depths[] = {{0, 0, 0, 10},    {100, 0, 160, 10}, {200, 0, 150, 10},
                                   {300, 0, 70, 10}, {400, 0, 150, 10}, {500, 0, 159, 10}};
constexpr uint32_t at_depths_count = 6;
// (distance from the nearest / that of the farthest)^(5/4): 1, 0, (1/16)^(5/4) = 1/32, (9/16)^(5/4), 1/32 again, almost
// 0.
constexpr double shares[] = {1, 0, .03125, .48713928962874675, .03125, .00175732};

// The painted piece of a ball of the input.
inline uint32_t piece_of(uint32_t input) {
  const hsp::View &view = small_view().view();
  for (uint32_t p = 0; p < view.pieces.size(); ++p) {
    if (small_view().balls().caller[view.pieces[p].ball] == input) return p;
  }
  return hsp::no_id;
}

class PaintOf {
 public:
  PaintOf(const hsp::PictureOptions &options, const uint32_t *colour)
      : input_(picture_input(colour)),
        page_(hsp::lay_out(input_, options)),
        paint_(input_, options, page_, small_view().scratch()) {}
  const hsp::Paint &paint() const { return paint_; }

 private:
  hsp::PictureInput input_;
  hsp::Page page_;
  hsp::Paint paint_;
};

// A colour as three channels between two others, rounded.
inline bool lies_between(uint32_t colour, uint32_t a, uint32_t b, double share_of_b) {
  for (uint32_t shift = 0; shift < 24; shift += 8) {
    const double from = a >> shift & 255, to = b >> shift & 255;
    if (!near(colour >> shift & 255, from + (to - from) * share_of_b, .5 + 1e-3)) return false;
  }
  return colour >> 24 == 0;
}

constexpr uint32_t own_colours[] = {0x102030, 0xFFFFFF, 0x0080FF, 0xE0C0A0, 0x0080FF, 0x000000};
struct Fog {
  double fog;
  uint32_t background;
};
constexpr Fog fogs[] = {{0, 0xFFFFFF}, {1, 0xFFFFFF}, {1, 0x000000}, {.3, 0xFFFFFF}, {.5, 0x4080C0}};

inline uint32_t flat_colours_fade() {
  return first_failing(fogs, [](const Fog &c) {
    if (!small_view().succeeds(at_depths, at_depths_count)) return false;
    hsp::PictureOptions options;
    options.fog = c.fog;
    options.background = c.background;
    for (const bool given : {false, true}) {
      const PaintOf of(options, given ? own_colours : nullptr);
      if (!of.paint().flat() || of.paint().shades() != 0 || of.paint().background() != c.background) return false;
      for (uint32_t k = 0; k < at_depths_count; ++k) {
        const uint32_t own = given ? own_colours[k] : 0xD2CDC3;  // what all are that have no colour
        if (!lies_between(of.paint().flat_colour(piece_of(k)), own, c.background, c.fog * shares[k])) return false;
      }
    }
    return true;
  });
}

// Lines keep three tenths of their colour at the farthest ball; levels are tenths.
inline uint32_t lines_fade_less() {
  return first_failing(fogs, [](const Fog &c) {
    if (!small_view().succeeds(at_depths, at_depths_count)) return false;
    hsp::PictureOptions options;
    options.fog = c.fog;
    options.background = c.background;
    options.outline_colour = 0x804020;
    const PaintOf of(options, nullptr);
    for (uint32_t k = 0; k < at_depths_count; ++k) {
      const uint32_t level = of.paint().fog_level(piece_of(k));
      const double expected = c.fog > 0 ? shares[k] : 0;
      if (!near(level / 10.0, expected, .05 + 1e-9)) return false;
      if (!lies_between(of.paint().line_colour(level), 0x804020, c.background, .7 * c.fog * level / 10)) return false;
    }
    const hsp::View &view = small_view().view();
    for (uint32_t p = 1; p < view.pieces.size(); ++p) {
      if (of.paint().fog_level(p) > of.paint().fog_level(p - 1)) return false;
    }
    options.outline = 0;
    return of.paint().lines_along() && !PaintOf(options, nullptr).paint().lines_along();
  });
}

// How many shades there are: one for each colour and level of fog.
struct Shades {
  uint32_t colour[6];
  double fog;
  uint32_t expected;
};
constexpr Shades shade_sets[] = {{{1, 2, 3, 4, 5, 6}, 0, 6}, {{7, 7, 7, 7, 7, 7}, 0, 1},  {{7, 9, 9, 7, 7, 7}, 0, 2},
                                 {{7, 7, 7, 7, 7, 7}, 1, 3}, {{1, 2, 2, 3, 2, 2}, .1, 3}, {{1, 2, 3, 4, 3, 2}, .1, 4},
                                 {{1, 2, 3, 4, 5, 6}, 1, 6}, {{9, 8, 7, 6, 5, 4}, .5, 6}};

inline uint32_t shades_are_shared() {
  return first_failing(shade_sets, [](const Shades &c) {
    if (!small_view().succeeds(at_depths, at_depths_count)) return false;
    hsp::PictureOptions options;
    options.format = hsp::PictureFormat::eps;
    options.style = hsp::PictureStyle::soft;
    options.fog = c.fog;
    const PaintOf of(options, c.colour);
    const hsp::Paint &paint = of.paint();
    if (paint.flat() || paint.shades() != c.expected) return false;
    for (uint32_t k = 0; k < at_depths_count; ++k) {
      for (uint32_t l = 0; l < at_depths_count; ++l) {
        const uint32_t p = piece_of(k), r = piece_of(l);
        const bool same = c.colour[k] == c.colour[l] && paint.fog_level(p) == paint.fog_level(r);
        if ((paint.shade_of(p) == paint.shade_of(r)) != same || paint.shade_of(p) >= c.expected) return false;
      }
    }
    return true;
  });
}

// Lit by a headlight the middle of a ball has its own colour, and its rim .36 of it; both are then mixed with fog. Soft
// light makes its first stop lighter and its last one darker.
inline uint32_t shades_are_lit() {
  return first_failing(fogs, [](const Fog &c) {
    if (!small_view().succeeds(at_depths, at_depths_count)) return false;
    hsp::PictureOptions options;
    options.fog = c.fog;
    options.background = c.background;
    options.format = hsp::PictureFormat::eps;
    options.style = hsp::PictureStyle::headlight;
    const PaintOf headlight(options, own_colours);
    // Both use the same scratch memory, and find the same shades there.
    options.style = hsp::PictureStyle::soft;
    const PaintOf soft(options, own_colours);
    for (uint32_t k = 0; k < at_depths_count; ++k) {
      const uint32_t p = piece_of(k), own = own_colours[k];
      const double share = c.fog * headlight.paint().fog_level(p) / 10;
      const auto shade = [p](const hsp::Paint &paint, uint32_t stop) {
        return paint.shade_colour(paint.shade_of(p), stop);
      };
      const uint32_t last = headlight.paint().shading().intervals();
      if (!lies_between(shade(headlight.paint(), 0), own, c.background, share)) return false;
      for (uint32_t shift = 0; shift < 24; shift += 8) {
        const double rim = .36 * (own >> shift & 255), far = c.background >> shift & 255;
        if (!near(shade(headlight.paint(), last) >> shift & 255, rim + (far - rim) * share, .5 + 1e-9)) return false;
        const uint32_t first_soft = shade(soft.paint(), 0) >> shift & 255;
        const uint32_t last_soft = shade(soft.paint(), soft.paint().shading().intervals()) >> shift & 255;
        if (first_soft < last_soft || (first_soft == last_soft && share < 1)) return false;
      }
    }
    return true;
  });
}

// Colour with light over it is the shade of other formats: up to rounding for the headlight, nearly for soft light.
inline uint32_t lights_make_shades() {
  return first_failing(fogs, [](const Fog &c) {
    if (!small_view().succeeds(at_depths, at_depths_count)) return false;
    for (const auto style : {hsp::PictureStyle::headlight, hsp::PictureStyle::soft}) {
      hsp::PictureOptions options;
      options.fog = c.fog;
      options.background = c.background;
      options.style = style;
      for (uint32_t k = 0; k < at_depths_count; ++k) {
        const uint32_t p = piece_of(k);
        options.format = hsp::PictureFormat::svg;
        const PaintOf light(options, own_colours);
        const uint32_t unlit = light.paint().unlit_colour(p), level = light.paint().fog_level(p);
        if (!lies_between(unlit, own_colours[k], c.background, c.fog * level / 10)) return false;
        options.format = hsp::PictureFormat::eps;
        const PaintOf shade(options, own_colours);
        for (uint32_t stop = 0; stop <= shade.paint().shading().intervals(); ++stop) {
          const hsp::Shading::Glaze glaze = light.paint().glaze(level, stop);
          const uint32_t expected = shade.paint().shade_colour(shade.paint().shade_of(p), stop);
          for (int channel = 0; channel < 3; ++channel) {
            const int shift = 16 - 8 * channel;
            const double laid =
                (unlit >> shift & 255) * (1 - glaze.opacity) + glaze.colour.channel[channel] * glaze.opacity;
            const double most = style == hsp::PictureStyle::soft ? 6 : 1 + 1e-9;
            if (!near(laid, expected >> shift & 255, most)) return false;
          }
        }
      }
    }
    return true;
  });
}

inline constexpr Check picture_paint[] = {{"flat_colours_fade", flat_colours_fade},
                                          {"lines_fade_less", lines_fade_less},
                                          {"shades_are_shared", shades_are_shared},
                                          {"shades_are_lit", shades_are_lit},
                                          {"lights_make_shades", lights_make_shades}};

}  // namespace cases
