#include "draw/spinning.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/ball_and_stick.h"
#include "draw/view_axes.h"
#include "read/vectors.h"

/* Pictures as the library makes them without a scale. */
static const double default_margin = 0.03;

/* The extent of the balls along an axis: centres, each with its radius on both sides. */
struct extent {
  double low, high;
};

static double radius_of(const struct drawing *drawing, const struct molecule *molecule, double probe, uint32_t ball) {
  const double radius = molecule->radius[ball] + probe;
  return drawing_is_of_sticks(drawing) ? radius * ball_and_stick_size(drawing) : radius;
}

static struct extent extent_of(const struct drawing *drawing, const struct molecule *molecule, double probe,
                               const double axis[3]) {
  struct extent extent = {0.0, 0.0};
  bool any = false;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const double radius = radius_of(drawing, molecule, probe, i);
    if (!(radius > 0.0)) continue;
    const double at = dot(axis, molecule->xyz + 3 * (size_t)i);
    if (!any || at - radius < extent.low) extent.low = at - radius;
    if (!any || at + radius > extent.high) extent.high = at + radius;
    any = true;
  }
  return extent;
}

static double middle(struct extent extent) {
  return extent.low / 2.0 + extent.high / 2.0;
}

/* How far balls reach from the upright axis through the point (x, z). */
static double reach_of(const struct drawing *drawing, const struct molecule *molecule, double probe, double axis[3][3],
                       double x, double z) {
  double reach = 0.0;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    const double radius = radius_of(drawing, molecule, probe, i);
    if (!(radius > 0.0)) continue;
    const double across = dot(axis[0], molecule->xyz + 3 * (size_t)i) - x;
    const double away = dot(axis[2], molecule->xyz + 3 * (size_t)i) - z;
    const double far_end = sqrt(across * across + away * away) + radius;
    if (far_end > reach) reach = far_end;
  }
  return reach;
}

int32_t spinning_fix_frame(struct drawing *drawing, const struct molecule *molecule, double probe) {
  double axis[3][3];
  if (drawing->scale > 0.0) return HSP_OK;
  const int32_t status = viewing_axes(&drawing->viewing, molecule, axis);
  if (status != HSP_OK) return status;
  const double x = middle(extent_of(drawing, molecule, probe, axis[0]));
  const double z = middle(extent_of(drawing, molecule, probe, axis[2]));
  const struct extent upright = extent_of(drawing, molecule, probe, axis[1]);
  const double wide = 2.0 * reach_of(drawing, molecule, probe, axis, x, z);
  const double high = upright.high - upright.low;
  const double margin = drawing->margin >= 0.0 ? drawing->margin : default_margin;
  const double across = wide + 2.0 * margin * (wide > high ? wide : high);
  const double tall = high + 2.0 * margin * (wide > high ? wide : high);
  const bool some = across > 0.0 && tall > 0.0;
  if (drawing->width < 0.0 && drawing->height < 0.0) drawing->width = drawing_default_width(drawing);
  if (drawing->width < 0.0) drawing->width = some ? drawing->height * (across / tall) : drawing->height;
  if (drawing->height < 0.0) drawing->height = some ? drawing->width * (tall / across) : drawing->width;
  const double by_width = drawing->width / across;
  const double by_height = drawing->height / tall;
  drawing->scale = !some ? 1.0 : by_width < by_height ? by_width : by_height;
  drawing->margin = -1.0;
  drawing->centre.given = true;
  for (int k = 0; k < 3; ++k) {
    drawing->centre.xyz[k] = x * axis[0][k] + middle(upright) * axis[1][k] + z * axis[2][k];
  }
  return HSP_OK;
}

const char *spinning_name(const char *out, int picture) {
  const char *slash = strrchr(out, '/');
  const char *point = strrchr(slash == NULL ? out : slash + 1, '.');
  const size_t length = strlen(out);
  const size_t stem = point == NULL ? length : (size_t)(point - out);
  static char *name;
  free(name);
  name = malloc(length + 16);
  if (name == NULL) return NULL;
  memcpy(name, out, stem);
  snprintf(name + stem, length + 16 - stem, "-%03d%s", picture, out + stem);
  return name;
}
