/* A user's program with one query: which of two unit balls contain a point. */
#include <hardsphere.h>
#include <stdio.h>

int main(void) {
  static unsigned char memory[HSP_MODEL_BYTES(2)];
  static const double xyz[6] = {0, 0, 0, 1, 0, 0}, radius[2] = {1, 1}, point[3] = {-0.5, 0, 0};
  uint32_t ids[2], hits = 0;
  hsp_model *model;
  if (hsp_model_init(memory, sizeof memory, 2, &model) != HSP_OK) return 2;
  if (hsp_model_set(model, 2, xyz, radius, NULL, NULL) != HSP_OK) return 3;
  if (hsp_query_point(model, point, ids, 2, &hits) != HSP_OK) return 4;
  printf("%u hit, ball %u\n", (unsigned)hits, (unsigned)ids[0]);
  return hits == 1 && ids[0] == 0 ? 0 : 1;
}
