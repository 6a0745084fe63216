/* Monte Carlo of single atoms: each move shifts one of them, and the energy is that of areas as a solvent probe sees
 * them, with a spring that holds every atom near its place.
 *   single_atoms MOLECULE.xyzr [MOVES]      x y z r on each line
 * A move computes the atom and those around it again, not the molecule, and one that Metropolis refuses is taken back.
 * In the end the energy is compared with that of a new model: it has the same bits. (monte_carlo.c moves whole
 * molecules against each other.) */
#include <hardsphere_workspace.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "../read_balls.h"

static const double probe = 1.4, tension = 0.0054; /* kcal/mol per angstrom^2, as is usual */
static const double spring = 1.0;                  /* kcal/mol per angstrom^2 */
static const double temperature = 0.6;             /* R T in kcal/mol at 300 K */
static const double largest_shift = 0.3;

struct walk {
  hsp_moving *moving;
  const double *start; /* where atoms are held */
  double *xyz;
  uint32_t atoms;
  unsigned long accepted;
  uint64_t random;
};

/* In [0, 1): Vigna's xorshift64*. */
static double random_number(struct walk *walk) {
  uint64_t x = walk->random;
  x ^= x >> 12;
  x ^= x << 25;
  x ^= x >> 27;
  walk->random = x;
  return (double)((x * UINT64_C(2685821657736338717)) >> 11) / 9007199254740992.0;
}

static double spring_energy(const double *at, const double *place) {
  double squared = 0.0;
  for (int k = 0; k < 3; ++k) squared += (at[k] - place[k]) * (at[k] - place[k]);
  return 0.5 * spring * squared;
}

static int32_t energy_of(const struct walk *walk, double *value) {
  hsp_energy energy = {0};
  const int32_t status = hsp_moving_gradient(walk->moving, &energy, NULL, NULL, NULL, 0, NULL);
  *value = energy.value;
  return status;
}

/* One move, which may be taken back. *surface is the energy of the areas. */
static int32_t try_move(struct walk *walk, double *surface) {
  const uint32_t atom = (uint32_t)(random_number(walk) * walk->atoms);
  double *at = walk->xyz + 3 * (size_t)atom, to[3], found = 0.0;
  const double *place = walk->start + 3 * (size_t)atom;
  for (int k = 0; k < 3; ++k) to[k] = at[k] + largest_shift * (2.0 * random_number(walk) - 1.0);
  int32_t status = hsp_moving_move(walk->moving, 1, &atom, to, NULL, NULL, NULL);
  if (status == HSP_OK) status = energy_of(walk, &found);
  if (status != HSP_OK) return status;
  const double rise = found - *surface + spring_energy(to, place) - spring_energy(at, place);
  if (rise > 0.0 && random_number(walk) >= exp(-rise / temperature)) return hsp_moving_undo(walk->moving);
  for (int k = 0; k < 3; ++k) at[k] = to[k];
  *surface = found;
  ++walk->accepted;
  return HSP_OK;
}

/* The energy of a model of the atoms as they are: computed once for all, by the same lattice and largest radius. */
static int32_t compare(hsp_workspace *work, const struct walk *walk, double surface) {
  hsp_energy energy = {0};
  hsp_boundary_counts counts;
  int32_t status = hsp_moving_get_model(walk->moving, work->model);
  if (status == HSP_OK) status = hsp_workspace_boundary(work);
  if (status == HSP_OK) status = hsp_boundary_get_counts(work->boundary, &counts);
  if (status == HSP_OK) {
    const hsp_gradient_request request = {.struct_size = sizeof request, .tension = tension};
    hsp_gradient_outputs outputs = {.struct_size = sizeof outputs, .energy = &energy};
    status = hsp_boundary_get_gradient(work->boundary, &request, &outputs);
  }
  if (status != HSP_OK) return status;
  printf("a new model has %s: %.17g kcal/mol, %u vertices, %u voids\n",
         energy.value == surface ? "the same bits" : "OTHER BITS", energy.value, (unsigned)counts.vertices,
         (unsigned)counts.voids);
  return energy.value == surface ? HSP_OK : HSP_E_CHECK;
}

static int32_t run(hsp_workspace *work, const struct balls *balls, struct walk *walk, unsigned long moves) {
  hsp_model_options options;
  double surface = 0.0, first = 0.0;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.probe = probe;
  if (status == HSP_OK) status = hsp_workspace_set(work, balls->count, balls->xyz, balls->radius, &options, NULL);
  if (status == HSP_OK) status = hsp_workspace_moving(work, NULL, tension, 0.0, HSP_TANGENT_OVERLAP, NULL);
  if (status != HSP_OK) return status;
  walk->moving = work->moving;
  status = energy_of(walk, &first);
  surface = first;
  const clock_t start = clock();
  for (unsigned long k = 0; k < moves && status == HSP_OK; ++k) status = try_move(walk, &surface);
  const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
  if (status != HSP_OK) return status;
  printf("%u atoms, %lu moves, %lu accepted: %.6f kcal/mol, before %.6f\n", (unsigned)walk->atoms, moves,
         walk->accepted, surface, first);
  if (seconds > 0) printf("%.0f moves a second\n", (double)moves / seconds);
  return compare(work, walk, surface);
}

int main(int count, char **arguments) {
  struct balls balls = {0, NULL, NULL};
  hsp_workspace work = {0};
  struct walk walk = {NULL, NULL, NULL, 0, 0, UINT64_C(1994)};
  if (count < 2 || count > 3) {
    fprintf(stderr, "usage: single_atoms MOLECULE.xyzr [MOVES]\n");
    return 2;
  }
  const unsigned long moves = count == 3 ? strtoul(arguments[2], NULL, 10) : 100000;
  int done = read_balls(arguments[1], &balls);
  if (done && balls.count == 0) {
    fprintf(stderr, "single_atoms: there are no atoms\n");
    done = 0;
  }
  if (done) {
    const size_t bytes = 3 * (size_t)balls.count * sizeof *walk.xyz;
    walk.start = balls.xyz;
    walk.atoms = balls.count;
    walk.xyz = malloc(bytes);
    if (walk.xyz != NULL) memcpy(walk.xyz, balls.xyz, bytes);
    const int32_t status = walk.xyz != NULL ? run(&work, &balls, &walk, moves) : HSP_E_MEMORY;
    if (status != HSP_OK) fprintf(stderr, "single_atoms: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  free(walk.xyz);
  hsp_workspace_free(&work);
  free_balls(&balls);
  return done ? 0 : 1;
}
