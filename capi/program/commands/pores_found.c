#include "commands/pores_found.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TUNNELS = 3 };

typedef int32_t get_list(const hsp_pores *pores, uint32_t of, uint32_t *numbers, uint32_t capacity, uint32_t *needed);

static bool take_lists(const hsp_pores *pores, uint32_t things, get_list *get, struct number_lists *lists,
                       struct failure *failure) {
  lists->first = calloc((size_t)things + 1, sizeof *lists->first);
  if (lists->first == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < things; ++i) {
    uint32_t needed = 0;
    const int32_t status = get(pores, i, NULL, 0, &needed);
    if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
    lists->first[i + 1] = lists->first[i] + needed;
  }
  lists->number = calloc(lists->first[things] + 1, sizeof *lists->number);
  if (lists->number == NULL) return failure_of_memory(failure);
  for (uint32_t i = 0; i < things; ++i) {
    uint32_t needed = (uint32_t)(lists->first[i + 1] - lists->first[i]);
    const int32_t status = get(pores, i, lists->number + lists->first[i], needed, &needed);
    if (status != HSP_OK) return failure_in_library(failure, status);
  }
  return true;
}

static void free_lists(struct number_lists *lists) {
  free(lists->first);
  free(lists->number);
}

static bool take_tree(const hsp_pores *pores, struct pores_found *found, struct failure *failure) {
  hsp_pores_counts *const counts = &found->counts;
  int32_t status = hsp_pores_get_counts(pores, counts);
  if (status != HSP_OK) return failure_in_library(failure, status);
  found->maxima = calloc((size_t)counts->maxima + 1, sizeof *found->maxima);
  found->gates = calloc((size_t)counts->gates + 1, sizeof *found->gates);
  if (found->maxima == NULL || found->gates == NULL) return failure_of_memory(failure);
  status = hsp_pores_get_maxima(pores, 0, counts->maxima, found->maxima);
  if (status == HSP_OK) status = hsp_pores_get_gates(pores, 0, counts->gates, found->gates);
  if (status != HSP_OK) return failure_in_library(failure, status);
  return take_lists(pores, counts->maxima, hsp_pores_get_maximum_balls, &found->of_maxima, failure) &&
         take_lists(pores, counts->gates, hsp_pores_get_gate_balls, &found->of_gates, failure);
}

static bool take_channels(hsp_pores *pores, struct pores_found *found, struct failure *failure) {
  const uint32_t gates = found->counts.gates;
  const double probe = found->request->probe;
  found->shifts = calloc((size_t)gates + 1, sizeof *found->shifts);
  if (found->shifts == NULL) return failure_of_memory(failure);
  int32_t status = hsp_pores_get_gate_shifts(pores, 0, gates, found->shifts);
  if (status == HSP_OK) status = hsp_pores_get_percolation(pores, &found->wide);
  if (status != HSP_OK) return failure_in_library(failure, status);
  status = hsp_pores_get_channels(pores, probe, NULL, 0, &found->channel_count);
  if (status != HSP_OK && status != HSP_E_CAPACITY) return failure_in_library(failure, status);
  found->channels = calloc((size_t)found->channel_count + 1, sizeof *found->channels);
  if (found->channels == NULL) return failure_of_memory(failure);
  status = hsp_pores_get_channels(pores, probe, found->channels, found->channel_count, &found->channel_count);
  return status == HSP_OK || failure_in_library(failure, status);
}

static bool measure_pockets(const struct geometry *geometry, struct pores_found *found, struct failure *failure) {
  const struct request *const request = found->request;
  found->sizes = calloc((size_t)found->pocket_count + 1, sizeof *found->sizes);
  if (found->sizes == NULL) return failure_of_memory(failure);
  return geometry_measure_pockets(geometry, request->box.source != BOX_NONE ? found->box.box : NULL,
                                  found->pocket_count, found->sizes, failure);
}

/* List the pockets with enough persistence and volume. */
static bool list_pockets(struct pores_found *found, struct failure *failure) {
  const struct pores_request *const asked = &found->request->pores;
  found->listed = calloc((size_t)found->pocket_count + 1, sizeof *found->listed);
  if (found->listed == NULL) return failure_of_memory(failure);
  for (uint32_t p = 0; p < found->pocket_count; ++p) {
    const double volume = found->sizes[p].volume;
    if (found->pockets[p].radius - found->pockets[p].mouth < asked->persistence) continue;
    if (volume < asked->min_volume) { /* a pocket of unknown volume, NaN, may be large */
      ++found->smaller;
      continue;
    }
    found->listed[found->listed_count++] = (struct sized_pocket){p, volume >= 0.0 ? volume : -1.0};
  }
  sized_pockets_sort(found->listed, found->listed_count);
  return true;
}

static bool take_pockets(const struct geometry *geometry, struct pores_found *found, struct failure *failure) {
  const struct request *const request = found->request;
  hsp_pores *const pores = geometry->work.pores;
  uint32_t *const count = &found->pocket_count;
  int32_t status = hsp_pores_find_pockets(pores, request->probe, request->pores.pockets, count);
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--pockets: %s", geometry_reason(status));
  if (status != HSP_OK) return failure_in_library(failure, status);
  found->pockets = calloc((size_t)*count + 1, sizeof *found->pockets);
  if (found->pockets == NULL) return failure_of_memory(failure);
  status = hsp_pores_get_pockets(pores, 0, *count, found->pockets);
  if (status != HSP_OK) return failure_in_library(failure, status);
  return measure_pockets(geometry, found, failure) && list_pockets(found, failure) &&
         take_lists(pores, *count, hsp_pores_get_pocket_mouths, &found->mouths, failure) &&
         take_lists(pores, *count, hsp_pores_get_pocket_balls, &found->lining, failure) &&
         take_lists(pores, *count, hsp_pores_get_pocket_maxima, &found->of_pockets, failure);
}

/* The point that an option names, a maximum, or the widest one at an atom. */
static bool find_place(const struct molecule *molecule, const struct pores_found *found, const char *option,
                       const struct place *place, double point[3], struct failure *failure) {
  memcpy(point, place->point.xyz, sizeof place->point.xyz);
  if (place->of_maximum > found->counts.maxima) {
    return failure_in_input(failure, 0, "%s: there is no maximum %" PRIu64 " among %" PRIu32 ", from 0 on", option,
                            place->of_maximum - 1, found->counts.maxima);
  }
  if (place->of_maximum > 0) memcpy(point, found->maxima[place->of_maximum - 1].xyz, sizeof place->point.xyz);
  if (place->of_atom == 0) return true;
  const uint64_t atom = place->of_atom - 1;
  if (atom >= molecule->atoms) {
    return failure_in_input(failure, 0, "%s: there is no atom %" PRIu64 " among %" PRIu32 ", from 0 on", option, atom,
                            molecule->atoms);
  }
  const size_t *const first = found->of_maxima.first;
  for (uint32_t i = 0; i < found->counts.maxima; ++i) {
    for (size_t k = first[i]; k < first[i + 1]; ++k) {
      if (found->of_maxima.number[k] != atom) continue;
      memcpy(point, found->maxima[i].xyz, sizeof found->maxima[i].xyz);
      return true;
    }
  }
  return failure_in_input(failure, 0, "%s: atom %" PRIu64 " touches no largest probe", option, atom);
}

/* The radius of the largest probe at a point. */
static bool find_room(const hsp_pores *pores, bool boxed, const char *option, const double point[3], double *room,
                      struct failure *failure) {
  hsp_pore_place place;
  const int32_t status = hsp_pores_locate(pores, point, &place);
  if (status == HSP_E_RANGE) {
    return failure_in_input(failure, 0, "%s: the point lies beyond the lattice, 2^50 steps from 0%s", option,
                            boxed ? ", or more than 2^17 boxes away" : "");
  }
  if (status != HSP_OK) return failure_in_library(failure, status);
  *room = place.radius;
  return true;
}

static bool add_steps(const hsp_pores *pores, struct pores_found *found, struct failure *failure) {
  const uint32_t count = found->tunnels[found->tunnel_count].points;
  uint32_t needed = 0;
  struct tunnel_step *const steps = realloc(found->steps, (found->step_count + count + 1) * sizeof *steps);
  if (steps != NULL) found->steps = steps;
  hsp_tunnel_point *const points = calloc((size_t)count + 1, sizeof *points);
  if (steps == NULL || points == NULL) {
    free(points);
    return failure_of_memory(failure);
  }
  const int32_t status = hsp_pores_get_tunnel_points(pores, points, count, &needed);
  double length = 0.0;
  for (uint32_t i = 0; status == HSP_OK && i < count; ++i) {
    double square = 0.0;
    for (int axis = 0; axis < 3 && i > 0; ++axis) {
      const double way = points[i].xyz[axis] - points[i - 1].xyz[axis];
      square += way * way;
    }
    length += sqrt(square);
    steps[found->step_count++] = (struct tunnel_step){found->tunnel_count + 1, length, points[i]};
  }
  free(points);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* Find the best tunnels, each without the bottlenecks of those before it. */
static bool find_tunnels(struct geometry *geometry, const struct molecule *molecule, struct pores_found *found,
                         struct failure *failure) {
  static const char from[] = "--tunnels-from", to[] = "--tunnels-to";
  const struct request *const request = found->request;
  const hsp_pores *const pores = geometry->work.pores;
  const uint32_t most = request->pores.tunnels > 0 ? request->pores.tunnels : TUNNELS;
  const bool boxed = request->box.source != BOX_NONE;
  double room = 0.0;
  if (!find_place(molecule, found, from, &request->pores.tunnels_from, found->from, failure) ||
      !find_place(molecule, found, to, &request->pores.tunnels_to, found->to, failure) ||
      !find_room(pores, boxed, from, found->from, &found->room, failure) ||
      !find_room(pores, boxed, to, found->to, &room, failure)) {
    return false;
  }
  struct tunnel_question question = {
      .narrowest = request->probe,
      .in_box = boxed,
      .cheapest = request->pores.cheapest,
      .from = found->from,
      .to = request->pores.tunnels_to.point.given ? found->to : NULL,
      .avoided = calloc((size_t)most, sizeof *question.avoided),
  };
  found->tunnels = calloc((size_t)most, sizeof *found->tunnels);
  found->routes = calloc((size_t)most, sizeof *found->routes);
  bool done =
      (found->tunnels != NULL && found->routes != NULL && question.avoided != NULL) || failure_of_memory(failure);
  for (; done && question.count < most; ++question.count) {
    hsp_tunnel *const tunnel = &found->tunnels[question.count];
    done = geometry_find_tunnel(geometry, &question, tunnel, failure);
    if (!done || tunnel->there == 0) break;
    const int32_t status = hsp_pores_get_tunnel_route(geometry->work.pores, &found->routes[question.count]);
    done = status == HSP_OK ? add_steps(geometry->work.pores, found, failure) : failure_in_library(failure, status);
    found->tunnel_count = question.count + 1;
    if (tunnel->gate == HSP_NONE) break; /* no gate is its bottleneck: none is to be avoided */
    question.avoided[question.count] = tunnel->gate;
  }
  free(question.avoided);
  return done;
}

/* Find the regions outside the balls grown by the probe. The pores of grown balls are not those that are listed. */
static bool take_regions(struct geometry *geometry, const struct molecule *molecule, struct pores_found *found,
                         struct failure *failure) {
  const struct request *const request = found->request;
  const bool boxed = request->box.source != BOX_NONE;
  uint32_t *const count = &found->region_count;
  if (!geometry_find_regions(geometry, molecule, boxed ? found->box.box : NULL, request->probe, &found->access, count,
                             failure)) {
    return false;
  }
  found->regions = calloc((size_t)*count + 1, sizeof *found->regions);
  found->widest = calloc((size_t)*count + 1, sizeof *found->widest);
  if (found->regions == NULL || found->widest == NULL) return failure_of_memory(failure);
  const hsp_pores *const pores = geometry->work.pores;
  int32_t status = hsp_pores_get_regions(pores, 0, *count, found->regions);
  for (uint32_t i = 0; status == HSP_OK && i < *count; ++i) {
    const uint32_t maximum = found->regions[i].maximum;
    if (maximum != HSP_PORE_OUTSIDE) status = hsp_pores_get_maxima(pores, maximum, 1, &found->widest[i]);
  }
  if (status != HSP_OK) return failure_in_library(failure, status);
  return boxed || geometry_set_model(geometry, molecule, 0.0, 0.0, failure);
}

bool pores_find(const struct molecule *molecule, struct geometry *geometry, struct pores_found *found,
                struct failure *failure) {
  const struct request *const request = found->request;
  const bool boxed = request->box.source != BOX_NONE;
  return (!boxed || periodic_result_find_box(request, molecule, &found->box, failure)) &&
         (!request->pores.regions || take_regions(geometry, molecule, found, failure)) &&
         (boxed ? geometry_find_pores_in_box(geometry, molecule, found->box.box, request->probe, failure)
                : geometry_find_pores(geometry, molecule, 0.0, request->probe, failure)) &&
         take_tree(geometry->work.pores, found, failure) &&
         (!boxed || take_channels(geometry->work.pores, found, failure)) &&
         (request->pores.pockets < 0.0 || take_pockets(geometry, found, failure)) &&
         (!request->pores.tunnels_from.point.given || find_tunnels(geometry, molecule, found, failure));
}

void pores_free(struct pores_found *found) {
  free_lists(&found->of_maxima);
  free_lists(&found->of_gates);
  free_lists(&found->mouths);
  free_lists(&found->lining);
  free_lists(&found->of_pockets);
  free(found->maxima);
  free(found->gates);
  free(found->pockets);
  free(found->sizes);
  free(found->listed);
  free(found->followed);
  free(found->tunnels);
  free(found->routes);
  free(found->steps);
  free(found->shifts);
  free(found->channels);
  free(found->regions);
  free(found->widest);
}

bool pores_lists_maximum(const struct pores_found *found, size_t maximum) {
  return found->maxima[maximum].radius - found->maxima[maximum].death >= found->request->pores.persistence;
}
