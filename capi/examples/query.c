/* Which atoms touch a probe ball? Three atoms in a row, a water probe that slides along them, and memory from malloc.
 */
#include <hardsphere.h>
#include <stdio.h>
#include <stdlib.h>

#define ATOMS 3

int main(void) {
  const double xyz[ATOMS][3] = {{0.0, 0.0, 0.0}, {1.5, 0.0, 0.0}, {3.0, 0.0, 0.0}};
  const double radius[ATOMS] = {1.70, 1.55, 1.52};
  const double probe_radius = 1.4;

  size_t bytes;
  hsp_model *model = NULL;
  int32_t status = hsp_model_bytes(ATOMS, &bytes);
  void *memory = status == HSP_OK ? malloc(bytes) : NULL;
  if (memory == NULL) return 1;
  status = hsp_model_init(memory, bytes, ATOMS, &model);
  if (status == HSP_OK) status = hsp_model_set(model, ATOMS, &xyz[0][0], radius, NULL, NULL);

  for (int step = 0; step <= 10 && status == HSP_OK; ++step) {
    const double at[3] = {0.5 * step - 1.0, 2.9, 0.0};
    uint32_t ids[ATOMS]; /* no more atoms than there are can be hit */
    uint32_t hits;
    status = hsp_query_ball(model, at, probe_radius, ids, ATOMS, &hits);
    if (status != HSP_OK) break;
    printf("probe at x = %4.1f touches", at[0]);
    for (uint32_t i = 0; i < hits; ++i) printf(" atom %u", (unsigned)ids[i]);
    printf("%s\n", hits == 0 ? " nothing" : "");
  }

  if (status != HSP_OK) fprintf(stderr, "query: %s\n", hsp_status_text(status));
  free(memory);
  return status == HSP_OK ? 0 : 1;
}
