/* The files that `pores` writes beside its output. */
#include <stdlib.h>
#include <string.h>

#include "commands/pictures.h"
#include "commands/pores_found.h"
#include "commands/tunnel_exchange.h"
#include "write/point_file.h"

static const char at_maximum[] = "MAX", at_gate[] = "GAT", on_the_way[] = "WAY";

static void add_maximum(const struct pores_found *found, uint32_t maximum, struct point *point) {
  point->atom = at_maximum;
  memcpy(point->xyz, found->maxima[maximum].xyz, sizeof point->xyz);
  point->radius = found->maxima[maximum].radius;
}

static void add_gate(const struct pores_found *found, uint32_t gate, struct point *point) {
  point->atom = at_gate;
  memcpy(point->xyz, found->gates[gate].xyz, sizeof point->xyz);
  point->radius = found->gates[gate].radius;
}

static size_t add_pocket(const struct pores_found *found, uint32_t pocket, struct point *points) {
  const struct number_lists *const maxima = &found->of_pockets, *const mouths = &found->mouths;
  const struct point of_pocket = {.residue = "PKT", .chain = 'P', .number = pocket + 1};
  size_t count = 0;
  for (size_t k = maxima->first[pocket]; k < maxima->first[pocket + 1]; ++k) {
    points[count] = of_pocket;
    add_maximum(found, maxima->number[k], &points[count++]);
  }
  for (size_t k = mouths->first[pocket]; k < mouths->first[pocket + 1]; ++k) {
    points[count] = of_pocket;
    add_gate(found, mouths->number[k], &points[count++]);
  }
  return count;
}

/* Write the points of the lists for persons, in the frame of the file. */
static bool write_points(const struct pores_found *found, struct failure *failure) {
  const struct request *const request = found->request;
  const uint32_t maxima = found->counts.maxima, gates = found->counts.gates, pockets = found->pocket_count;
  const bool others = request->pores.gates || request->pores.pockets >= 0.0 || request->pores.tunnels_from.point.given;
  const size_t of_pockets = pockets == 0 ? 0 : found->of_pockets.first[pockets] + found->mouths.first[pockets];
  struct point *const points = calloc((size_t)maxima + gates + of_pockets + found->step_count + 1, sizeof *points);
  if (points == NULL) return failure_of_memory(failure);
  size_t count = 0;
  for (uint32_t i = 0; i < maxima && !others; ++i) {
    if (!pores_lists_maximum(found, i)) continue;
    points[count] = (struct point){.residue = at_maximum, .chain = 'M', .number = i};
    add_maximum(found, i, &points[count++]);
  }
  for (uint32_t i = 0; i < gates && request->pores.gates; ++i) {
    points[count] = (struct point){.residue = at_gate, .chain = 'G', .number = i};
    add_gate(found, i, &points[count++]);
  }
  for (uint32_t i = 0; i < found->listed_count; ++i)
    count += add_pocket(found, found->listed[i].pocket, points + count);
  for (size_t i = 0; i < found->step_count; ++i) {
    const struct tunnel_step *const step = &found->steps[i];
    const hsp_tunnel_point *const at = &step->point;
    points[count] = (struct point){
        .atom = at->maximum != HSP_NONE ? at_maximum
                : at->gate != HSP_NONE  ? at_gate
                                        : on_the_way,
        .residue = "TUN",
        .chain = 'T',
        .number = step->tunnel,
        .radius = at->radius,
        .joined = i > 0 && found->steps[i - 1].tunnel == step->tunnel,
    };
    memcpy(points[count++].xyz, at->xyz, sizeof at->xyz);
  }
  const bool done = point_file_write(points, count, request->pores.points, failure);
  free(points);
  return done;
}

bool pores_write_files(const struct pores_found *found, const struct molecule *molecule, struct failure *failure) {
  const struct request *const request = found->request;
  return (request->pores.points == NULL || write_points(found, failure)) &&
         (request->pores.tunnels_out == NULL ||
          tunnel_exchange_write(found, molecule, request->pores.tunnels_out, failure)) &&
         (request->pores.profile == NULL || pictures.tunnels(found, molecule, request->pores.profile, failure)) &&
         (request->pores.tree == NULL || pictures.classes(found, molecule, request->pores.tree, failure));
}
