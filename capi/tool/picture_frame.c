#include "picture_frame.h"

#include <math.h>

/* A side that follows from the other one stays in the range that hsp_picture_write keeps it in. */
static double clamped(double side) {
  return side < 0.01 ? 0.01 : side > 1e6 ? 1e6 : side;
}

/* A side as it follows from the other one. In px it is whole: a last row of which a part is covered is a pale line. */
static double following_side(const hsp_picture_options *options, double side) {
  const double kept = clamped(side);
  return options->format == HSP_FORMAT_SVG && options->unit == HSP_UNIT_PX ? ceil(kept) : kept;
}

/* Both sides of the picture, where only one is given; see hsp_picture_options. */
static void find_size(const hsp_view_info *view, hsp_picture_options *options) {
  const double wide = view->high[0] - view->low[0];
  const double high = view->high[1] - view->low[1];
  const double margin = options->margin * (wide > high ? wide : high);
  const double across = wide + 2.0 * margin;
  const double upright = high + 2.0 * margin;
  const double ratio = across > 0.0 && upright > 0.0 && options->scale == 0.0 ? across / upright : 1.0;
  if (options->width == 0.0) options->width = following_side(options, options->height * ratio);
  if (options->height == 0.0) options->height = following_side(options, options->width / ratio);
}

/* A part of the picture is a picture with a fixed frame: with the scale that all of it has, about its own middle. */
static void crop(const struct drawing *drawing, const hsp_view_info *view, hsp_picture_options *options) {
  double middle[2] = {view->low[0] / 2.0 + view->high[0] / 2.0, view->low[1] / 2.0 + view->high[1] / 2.0};
  if (options->scale == 0.0) {
    const double wide = view->high[0] - view->low[0];
    const double high = view->high[1] - view->low[1];
    const double margin = options->margin * (wide > high ? wide : high);
    if (!(wide > 0.0 && high > 0.0)) return; /* nothing is seen */
    const double by_width = options->width / (wide + 2.0 * margin);
    const double by_height = options->height / (high + 2.0 * margin);
    options->scale = by_width < by_height ? by_width : by_height;
  } else {
    for (int k = 0; k < 2; ++k) {
      const double *axis = k == 0 ? view->right : view->up;
      middle[k] = 0.0;
      for (int c = 0; c < 3; ++c) middle[k] += axis[c] * (options->centre[c] - view->origin[c]);
    }
  }
  middle[0] += (drawing->crop[0] + drawing->crop[2] / 2.0 - options->width / 2.0) / options->scale;
  middle[1] += (options->height / 2.0 - drawing->crop[1] - drawing->crop[3] / 2.0) / options->scale;
  for (int c = 0; c < 3; ++c) {
    options->centre[c] = view->origin[c] + view->right[c] * middle[0] + view->up[c] * middle[1];
  }
  options->width = drawing->crop[2];
  options->height = drawing->crop[3];
}

void picture_frame_set(const struct drawing *drawing, const hsp_view_info *view, hsp_picture_options *options) {
  find_size(view, options);
  if (drawing->crop_given) crop(drawing, view, options);
}
