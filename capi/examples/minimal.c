/* Area and volume of a water molecule as a water probe (1.4 angstrom) sees it, without any allocation. */
#include <hardsphere.h>
#include <stdio.h>

static unsigned char model_memory[HSP_MODEL_BYTES(3)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(3, 3, 16, 8)];

int main(void) {
  const double xyz[3][3] = {{0.000, 0.000, 0.117}, {0.000, 0.757, -0.471}, {0.000, -0.757, -0.471}}; /* O H H */
  const double radius[3] = {1.52, 1.10, 1.10};

  hsp_model_options options;
  hsp_model_options_init(&options, sizeof options);
  options.probe = 1.4;

  hsp_model *model;
  int32_t status = hsp_model_init(model_memory, sizeof model_memory, 3, &model);
  if (status == HSP_OK) status = hsp_model_set(model, 3, &xyz[0][0], radius, &options, NULL);

  hsp_boundary_limits limits = {
      .struct_size = sizeof limits, .balls = 3, .neighbours = 3, .vertices = 16, .circles = 8};
  hsp_boundary *boundary;
  hsp_boundary_counts counts;
  hsp_totals totals;
  if (status == HSP_OK) status = hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary);
  if (status == HSP_OK) status = hsp_boundary_compute(boundary, model, NULL);
  if (status == HSP_OK) status = hsp_boundary_get_counts(boundary, &counts);
  if (status == HSP_OK) status = hsp_boundary_measure(boundary, NULL, &totals, NULL, NULL, 0, NULL);

  if (status != HSP_OK) {
    fprintf(stderr, "minimal: %s\n", hsp_status_text(status));
    return 1;
  }
  printf("area %.6f angstrom^2, volume %.6f angstrom^3, %u vertices\n", totals.area, totals.volume,
         (unsigned)counts.vertices);
  return 0;
}
