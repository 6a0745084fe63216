#include "draw/picture_frame.h"

#include <math.h>

/* A side that follows from the other one stays in the range that hsp_picture_write keeps it in. */
static double clamped(double side) {
  return side < 0.01 ? 0.01 : side > 1e6 ? 1e6 : side;
}

/* A side that follows from the other one. In px it is a whole number: a last row that is only partly covered would be a
 * pale line. */
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

/* Find the place in the view of the point in the middle of a fixed frame. */
static void find_middle(const hsp_view_info *view, const hsp_picture_options *options, double middle[2]) {
  for (int k = 0; k < 2; ++k) {
    const double *axis = k == 0 ? view->right : view->up;
    middle[k] = 0.0;
    for (int c = 0; c < 3; ++c) middle[k] += axis[c] * (options->centre[c] - view->origin[c]);
  }
}

/* A part of the picture is a picture with a fixed frame: with the scale that all of it has, about its own middle. */
static void crop(const double part[4], const hsp_view_info *view, hsp_picture_options *options) {
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
    find_middle(view, options, middle);
  }
  middle[0] += (part[0] + part[2] / 2.0 - options->width / 2.0) / options->scale;
  middle[1] += (options->height / 2.0 - part[1] - part[3] / 2.0) / options->scale;
  for (int c = 0; c < 3; ++c) {
    options->centre[c] = view->origin[c] + view->right[c] * middle[0] + view->up[c] * middle[1];
  }
  options->width = part[2];
  options->height = part[3];
}

/* The size of letters as a part of the page; the columns for labels and the strip for scale bar and legend in sizes of
 * letters. */
static const double letter_share = 1.0 / 45.0, widest_page = 1.4; /* in heights, of that size */
static const double column_letters = 6.5;
static const double strip_letters = 2.4;

/* If both sides of the page are given, as for slides, letters are not larger than on a page that is less wide. */
static double letter_of(double width, double height) {
  if (!(width > 0.0)) return letter_share * height;
  return letter_share * (height > 0.0 && widest_page * height < width ? widest_page * height : width);
}

/* A picture without a fixed frame is drawn smaller, with room for text on its sides and below. */
static void make_room(const struct drawing *drawing, const hsp_view_info *view, hsp_picture_options *options,
                      struct picture_frame *frame) {
  const double letter = letter_of(options->width, options->height);
  const double column = drawing->label >= 0 ? column_letters * letter : 0.0;
  const double strip = drawing->scale_bar || drawing->legend ? strip_letters * letter : 0.0;
  if (options->width > 0.0) options->width -= 2.0 * column;
  if (options->height > 0.0) options->height = clamped(options->height - ceil(strip));
  find_size(view, options);
  const double part[4] = {-column, 0.0, options->width + 2.0 * column, options->height + ceil(strip)};
  crop(part, view, options);
  frame->column = column;
  frame->strip = strip;
}

void picture_frame_set(const struct drawing *drawing, const hsp_view_info *view, hsp_picture_options *options,
                       struct picture_frame *frame) {
  static const double px_per_millimetre = 96.0 / 25.4;
  const bool fixed = options->scale > 0.0 || drawing->crop_given;
  const bool both = options->width > 0.0 && options->height > 0.0;
  *frame = (struct picture_frame){.column = 0.0, .strip = 0.0};
  if (drawing_is_annotated(drawing) && !fixed) {
    make_room(drawing, view, options, frame);
  } else {
    find_size(view, options);
    if (drawing->crop_given || drawing_is_annotated(drawing)) {
      const double whole[4] = {0.0, 0.0, options->width, options->height};
      crop(drawing->crop_given ? drawing->crop : whole, view, options);
    }
  }
  const double unit = options->unit == HSP_UNIT_MM ? px_per_millimetre : 1.0;
  double middle[2];
  find_middle(view, options, middle);
  frame->width = options->width * unit;
  frame->height = options->height * unit;
  frame->column *= unit;
  frame->strip *= unit;
  frame->letter = letter_of(frame->width, both ? frame->height : 0.0);
  frame->scale = options->scale * unit;
  frame->x = frame->width / 2.0 - frame->scale * middle[0];
  frame->y = frame->height / 2.0 + frame->scale * middle[1];
}

struct page_axes picture_frame_axes(const struct picture_frame *frame, const hsp_view_info *view) {
  const double *const axis[3] = {view->right, view->up, view->towards};
  struct page_axes axes = {.origin = {frame->x, frame->y, 0.0}};
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k) {
      axes.row[row][k] = (row == 1 ? -frame->scale : frame->scale) * axis[row][k];
      axes.origin[row] -= axes.row[row][k] * view->origin[k];
    }
  }
  return axes;
}
