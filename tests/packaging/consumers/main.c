/* A user's program: the area of two unit balls at distance 1, whose caps are known; a centre that is not a number. */
#include <hardsphere.h>
#include <math.h>
#include <stdio.h>

int main(void) {
  static unsigned char model_memory[HSP_MODEL_BYTES(2)];
  static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(2, 2, 80, 20)];
  static const double xyz[6] = {0, 0, 0, 1, 0, 0};
  static const double radius[2] = {1, 1};
  static const double nowhere[3] = {0, NAN, 0};
  const double expected = 6 * acos(-1.0); /* 2 (4 pi - 2 pi / 2) */
  hsp_model *model;
  hsp_boundary *boundary;
  hsp_boundary_limits limits;
  hsp_totals totals;
  if (hsp_abi() != HSP_ABI_NUMBER || hsp_version() < HSP_VERSION_NUMBER) return 2;
  if (hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, 2) != HSP_OK) return 3;
  limits.vertices = 80;
  limits.circles = 20;
  if (hsp_model_init(model_memory, sizeof model_memory, 2, &model) != HSP_OK) return 4;
  if (hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary) != HSP_OK) return 5;
  if (hsp_model_set(model, 2, xyz, radius, NULL, NULL) != HSP_OK) return 6;
  if (hsp_boundary_compute(boundary, model, NULL) != HSP_OK) return 7;
  if (hsp_boundary_measure(boundary, NULL, &totals, NULL, NULL, 0, NULL) != HSP_OK) return 8;
  printf("C: area %.15g\n", totals.area);
  if (hsp_model_set(model, 1, nowhere, radius, NULL, NULL) != HSP_E_NOT_FINITE) return 9;
  return fabs(totals.area - expected) < 1e-12 ? 0 : 1;
}
