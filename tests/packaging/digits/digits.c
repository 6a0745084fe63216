/* Areas, volume and gradient of a molecule, as bits: digits FILE, whose lines are x y z r. In C99 and in C++20. */
#include <hardsphere.h>
#include <hardsphere_workspace.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { MOST = 1000 };
static double xyz[3 * MOST], radius[MOST], area[MOST], volume[MOST], gradient[3 * MOST];

static void print_bits(const double *numbers, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    uint64_t bits;
    memcpy(&bits, &numbers[k], sizeof bits);
    printf("%016" PRIX64 "\n", bits);
  }
}

int main(int argc, char **argv) {
  FILE *file = argc == 2 ? fopen(argv[1], "r") : NULL;
  if (file == NULL) return 2;
  uint32_t n = 0;
  while (n < MOST && fscanf(file, "%lf %lf %lf %lf", &xyz[3 * n], &xyz[3 * n + 1], &xyz[3 * n + 2], &radius[n]) == 4)
    ++n;
  fclose(file);

  hsp_workspace work;
  hsp_totals totals;
  memset(&work, 0, sizeof work);
  int32_t status = hsp_workspace_set(&work, n, xyz, radius, NULL, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary(&work);
  if (status == HSP_OK) status = hsp_boundary_measure(work.boundary, NULL, &totals, area, volume, n, NULL);
  if (status == HSP_OK) {
    const hsp_gradient_request request = {
        .struct_size = sizeof request, .tangency = HSP_TANGENT_OVERLAP, .tension = 1.0, .pressure = 1.0};
    hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .capacity = n, .d_centre = gradient};
    status = hsp_boundary_get_gradient(work.boundary, &request, &outputs);
  }
  hsp_workspace_free(&work);
  if (status != HSP_OK) return 1;
  print_bits(&totals.area, 1);
  print_bits(&totals.volume, 1);
  print_bits(area, n);
  print_bits(volume, n);
  print_bits(gradient, 3 * (size_t)n);
  return 0;
}
