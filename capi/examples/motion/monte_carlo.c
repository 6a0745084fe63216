/* Rigid docking by Monte Carlo: a ligand wanders about a receptor by small turns and shifts, and gathers contacts.
 *   monte_carlo RECEPTOR.xyzr LIGAND.xyzr [MOVES]      x y z r on each line
 * Poses in which balls meet are refused. Of the others Metropolis takes those with more contacts, and some with fewer:
 * pairs of balls that are within `reach`. Both molecules are prepared once; each pose is one question or two. */
#include <hardsphere_workspace.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "../read_balls.h"

static const double reach = 1.0, largest_shift = 0.5, largest_turn = 0.1, temperature = 2.0;
/* All bodies that meet need lattices of one step. */
static const double step = 1e-6;

struct search {
  hsp_body *receptor, *ligand;
  hsp_body *wide_ligand; /* every radius larger by `reach` */
  unsigned long poses, clashes, accepted;
  uint64_t random;
};

/* In [-1, 1): Vigna's xorshift64*. */
static double random_number(struct search *search) {
  uint64_t x = search->random;
  x ^= x >> 12;
  x ^= x << 25;
  x ^= x >> 27;
  search->random = x;
  return (double)((x * UINT64_C(2685821657736338717)) >> 11) / 4503599627370496.0 - 1.0;
}

/* Makes a body of these balls, the probe added to all radii. *memory is to be freed, whatever is returned. */
static int32_t prepare(hsp_workspace *work, const struct balls *balls, double probe, void **memory, hsp_body **body) {
  size_t bytes = 0;
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = probe;
  options.step = step;
  if (status == HSP_OK) {
    status = hsp_workspace_set(work, balls->count, balls->xyz, balls->radius, &options, NULL);
  }
  if (status == HSP_OK) status = hsp_body_bytes(balls->count, &bytes);
  if (status != HSP_OK) return status;
  *memory = malloc(bytes);
  if (*memory == NULL) return HSP_E_MEMORY;
  status = hsp_body_init(*memory, bytes, balls->count, body);
  return status == HSP_OK ? hsp_body_set(*body, work->model) : status;
}

/* Poses turn about the origin: the ligand turns about its own middle if that is there. */
static void move_to_origin(struct balls *balls) {
  for (size_t axis = 0; axis < 3; ++axis) {
    double mean = 0.0;
    for (size_t i = 0; i < balls->count; ++i) mean += balls->xyz[3 * i + axis] / balls->count;
    for (size_t i = 0; i < balls->count; ++i) balls->xyz[3 * i + axis] -= mean;
  }
}

/* How far balls reach from the origin along +x, for a place beside the receptor. */
static double largest_x(const struct balls *balls) {
  double most = 0.0;
  for (size_t i = 0; i < balls->count; ++i) {
    const double *c = balls->xyz + 3 * i;
    const double x = sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) + balls->radius[i];
    if (x > most) most = x;
  }
  return most;
}

/* Slides the ligand along -x until it is near: no step is longer than the gap, so nothing is passed through. */
static int32_t approach(const struct search *search, hsp_pose *pose) {
  hsp_body_gap gap = {0.0, HSP_NONE, HSP_NONE};
  for (int k = 0; k < 100; ++k) {
    const int32_t status = hsp_body_gaps(search->receptor, search->ligand, 1, pose, &gap, NULL);
    if (status != HSP_OK || gap.fixed == HSP_NONE || gap.gap < reach / 2 || pose->translation[0] < 0.0) return status;
    pose->translation[0] -= gap.gap - reach / 4;
  }
  return HSP_OK;
}

/* A small turn after that of the pose, and a small shift. */
static hsp_pose neighbour_of(struct search *search, const hsp_pose *pose) {
  double turn[4], length = 0.0;
  const double *q = pose->quaternion;
  hsp_pose moved = *pose;
  turn[0] = 1.0;
  for (int k = 1; k < 4; ++k) turn[k] = largest_turn / 2 * random_number(search);
  moved.quaternion[0] = turn[0] * q[0] - turn[1] * q[1] - turn[2] * q[2] - turn[3] * q[3];
  moved.quaternion[1] = turn[0] * q[1] + turn[1] * q[0] + turn[2] * q[3] - turn[3] * q[2];
  moved.quaternion[2] = turn[0] * q[2] - turn[1] * q[3] + turn[2] * q[0] + turn[3] * q[1];
  moved.quaternion[3] = turn[0] * q[3] + turn[1] * q[2] - turn[2] * q[1] + turn[3] * q[0];
  for (int k = 0; k < 4; ++k) length += moved.quaternion[k] * moved.quaternion[k];
  for (int k = 0; k < 4; ++k) moved.quaternion[k] /= sqrt(length);
  for (int k = 0; k < 3; ++k) moved.translation[k] += largest_shift * random_number(search);
  return moved;
}

/* Whether balls meet in a pose, and how many pairs are within reach if none do. */
static int32_t score(struct search *search, const hsp_pose *pose, uint32_t *clash, uint32_t *contacts) {
  hsp_body_overlap overlap = {0.0, 0, 0};
  int32_t status = hsp_body_hits(search->receptor, search->ligand, 1, pose, clash, NULL);
  if (status == HSP_OK && *clash == 0) {
    status = hsp_body_overlaps(search->receptor, search->wide_ligand, 1, pose, &overlap, NULL);
  }
  *contacts = overlap.pairs;
  ++search->poses;
  return status;
}

static int32_t wander(struct search *search, hsp_pose pose, unsigned long moves) {
  uint32_t clash = 0, contacts = 0, most = 0;
  int32_t status = score(search, &pose, &clash, &contacts);
  hsp_pose best = pose;
  most = contacts;
  const clock_t start = clock();
  for (unsigned long k = 0; k < moves && status == HSP_OK; ++k) {
    uint32_t found = 0;
    const hsp_pose moved = neighbour_of(search, &pose);
    status = score(search, &moved, &clash, &found);
    if (status != HSP_OK) break;
    if (clash != 0) {
      ++search->clashes;
      continue;
    }
    const double chance = exp(((double)found - (double)contacts) / temperature);
    if (found < contacts && (random_number(search) + 1.0) / 2 >= chance) continue;
    pose = moved;
    contacts = found;
    ++search->accepted;
    if (contacts > most) {
      most = contacts;
      best = pose;
    }
  }
  const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
  if (status != HSP_OK) return status;
  printf("%lu poses: %lu clash, %lu accepted\n", search->poses, search->clashes, search->accepted);
  printf("best: %u contacts, quaternion %.17g %.17g %.17g %.17g, translation %.17g %.17g %.17g\n", (unsigned)most,
         best.quaternion[0], best.quaternion[1], best.quaternion[2], best.quaternion[3], best.translation[0],
         best.translation[1], best.translation[2]);
  if (seconds > 0) printf("%.0f poses a second\n", (double)search->poses / seconds);
  return HSP_OK;
}

int main(int count, char **arguments) {
  struct balls receptor = {0, NULL, NULL}, ligand = {0, NULL, NULL};
  hsp_workspace work = {0};
  void *memory[3] = {NULL, NULL, NULL};
  struct search search = {NULL, NULL, NULL, 0, 0, 0, UINT64_C(1994)};
  if (count < 3 || count > 4) {
    fprintf(stderr, "usage: monte_carlo RECEPTOR.xyzr LIGAND.xyzr [MOVES]\n");
    return 2;
  }
  const unsigned long moves = count == 4 ? strtoul(arguments[3], NULL, 10) : 100000;
  int done = read_balls(arguments[1], &receptor) && read_balls(arguments[2], &ligand);
  if (done) {
    move_to_origin(&receptor);
    move_to_origin(&ligand);
    hsp_pose pose = {{1, 0, 0, 0}, {largest_x(&receptor) + largest_x(&ligand), 0, 0}};
    int32_t status = prepare(&work, &receptor, 0.0, &memory[0], &search.receptor);
    if (status == HSP_OK) status = prepare(&work, &ligand, 0.0, &memory[1], &search.ligand);
    if (status == HSP_OK) status = prepare(&work, &ligand, reach, &memory[2], &search.wide_ligand);
    if (status == HSP_OK) status = approach(&search, &pose);
    if (status == HSP_OK) status = wander(&search, pose, moves);
    if (status != HSP_OK) fprintf(stderr, "monte_carlo: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  for (int k = 0; k < 3; ++k) free(memory[k]);
  hsp_workspace_free(&work);
  free_balls(&receptor);
  free_balls(&ligand);
  return done ? 0 : 1;
}
