#include "draw/view_axes.h"

#include <math.h>
#include <string.h>

#include "draw/principal_axes.h"
#include "read/molecule.h"
#include "read/stopping.h"
#include "read/vectors.h"

/* False: there is no direction in it. Divided by its largest coordinate first, so that no square overflows. */
static bool make_unit(double v[3]) {
  double largest = 0.0;
  for (int k = 0; k < 3; ++k) largest = fabs(v[k]) > largest ? fabs(v[k]) : largest;
  if (!(largest > 0.0)) return false;
  for (int k = 0; k < 3; ++k) v[k] /= largest;
  const double length = vector_length(v);
  for (int k = 0; k < 3; ++k) v[k] /= length;
  return true;
}

/* The axes that the library would take, see hsp_view_options: y, else z upwards where nothing better is known. */
static void complete_axes(const double towards[3], const double up[3], double axis[3][3]) {
  static const double upright[2][3] = {{0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const double least = 1e-8; /* of a sine */
  double given[3];
  memcpy(axis[2], towards, sizeof axis[2]);
  make_unit(axis[2]);
  memcpy(given, up, sizeof given);
  make_unit(given);
  cross(given, axis[2], axis[0]);
  for (int k = 0; k < 2 && dot(axis[0], axis[0]) < least * least; ++k) cross(upright[k], axis[2], axis[0]);
  make_unit(axis[0]);
  cross(axis[2], axis[0], axis[1]);
}

/* Turns the balls, hence the viewer the other way. */
static int32_t turn(double axis[3][3], double x, double y, double z) {
  hsp_view_options turned;
  int32_t status = hsp_view_options_init(&turned, (uint32_t)sizeof turned);
  if (status == HSP_OK) status = hsp_view_options_turn(&turned, x, y, z);
  if (status != HSP_OK) return status;
  double up[3], towards[3];
  for (int c = 0; c < 3; ++c) {
    up[c] = turned.up[0] * axis[0][c] + turned.up[1] * axis[1][c] + turned.up[2] * axis[2][c];
    towards[c] = turned.towards[0] * axis[0][c] + turned.towards[1] * axis[1][c] + turned.towards[2] * axis[2][c];
  }
  memcpy(axis[1], up, sizeof up);
  memcpy(axis[2], towards, sizeof towards);
  cross(up, towards, axis[0]);
  return HSP_OK;
}

int32_t viewing_axes(const struct viewing *viewing, const struct molecule *molecule, double axis[3][3]) {
  static const double upright[3] = {0.0, 1.0, 0.0};
  const double *up = viewing->up.given ? viewing->up.xyz : upright;
  int32_t status = HSP_OK;
  if (viewing->view.given) {
    complete_axes(viewing->view.xyz, up, axis);
  } else {
    principal_axes(molecule, axis);
    if (viewing->up.given) {
      const double towards[3] = {axis[2][0], axis[2][1], axis[2][2]};
      complete_axes(towards, up, axis);
    }
  }
  if (viewing->rotate.given) {
    status = turn(axis, viewing->rotate.xyz[0], viewing->rotate.xyz[1], viewing->rotate.xyz[2]);
  }
  if (status == HSP_OK && viewing->spin != 0.0) status = turn(axis, 0.0, viewing->spin, 0.0);
  return status;
}

int32_t viewing_options(const struct viewing *viewing, const struct molecule *molecule, hsp_view_options *options) {
  double axis[3][3];
  int32_t status = hsp_view_options_init(options, (uint32_t)sizeof *options);
  if (status != HSP_OK) return status;
  options->executor = stopping_executor();
  if (viewing->view.given && !viewing->rotate.given && viewing->spin == 0.0) {
    memcpy(options->towards, viewing->view.xyz, sizeof options->towards);
    if (viewing->up.given) memcpy(options->up, viewing->up.xyz, sizeof options->up);
    return HSP_OK;
  }
  status = viewing_axes(viewing, molecule, axis);
  memcpy(options->up, axis[1], sizeof options->up);
  memcpy(options->towards, axis[2], sizeof options->towards);
  return status;
}
