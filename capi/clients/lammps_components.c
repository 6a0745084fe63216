/* Components and voids of all atoms by LAMMPS's own decomposition: own atoms and ghosts as each rank has them.
 *   mpirun -np N lammps_components INPUT RADIUS ...      a radius for each type of atom
 * INPUT is LAMMPS's and makes the atoms, with tags, in a box that is not periodic. Prints the same bytes for each N. To
 * compile, with the LAMMPS of Debian:
 *   mpicc -std=c99 -DLAMMPS_SMALLBIG lammps_components.c -llammps $(pkg-config --cflags --libs hardsphere) -o found */
#define LAMMPS_LIB_MPI /* else lammps_open is not declared */
#include <hardsphere_workspace.h>
#include <lammps/library.h>
#include <mpi.h>
#include <string.h>

#include "brick_summaries.h"

static int rank, ranks;

static void stop_if(int bad, const char *why) {
  if (!bad) return;
  fprintf(stderr, "lammps_components: %s\n", why);
  MPI_Abort(MPI_COMM_WORLD, 1);
}

/* Ghosts that reach two largest radii, and a number for each atom that LAMMPS brings to them: the rank that owns it. */
static void number_owners(void *lammps, double largest_radius) {
  double low[3], high[3], tilt[3];
  int periodic[3], may_change;
  char line[64];
  lammps_extract_box(lammps, low, high, &tilt[0], &tilt[1], &tilt[2], periodic, &may_change);
  stop_if(periodic[0] || periodic[1] || periodic[2], "images have no tags of their own: the box must not be periodic");
  /* A little more, for what rounding to the lattice adds. */
  snprintf(line, sizeof line, "comm_modify cutoff %.17g", 2.000001 * largest_radius);
  lammps_command(lammps, line);
  lammps_command(lammps, "fix owner all property/atom i_owner ghost yes");
  lammps_command(lammps, "run 0 post no");
  int *const owner = lammps_extract_atom(lammps, "i_owner");
  for (int i = 0; i < lammps_extract_setting(lammps, "nlocal"); ++i) owner[i] = rank;
  lammps_command(lammps, "run 0 post no");
}

struct tagged {
  int tag, at; /* at: the atom's place in LAMMPS's arrays */
};
static int by_tag(const void *a, const void *b) {
  const struct tagged *const first = a, *const second = b;
  return (first->tag > second->tag) - (first->tag < second->tag);
}

/* This rank's brick: own atoms and ghosts in the order of tags. */
static int32_t summarise(void *lammps, const double *radius_of_type, double largest_radius, brick_summary *summary) {
  const uint32_t all = (uint32_t)lammps_extract_setting(lammps, "nall");
  const int *const tag = lammps_extract_atom(lammps, "id"), *const type = lammps_extract_atom(lammps, "type"),
                   *const owner_of = lammps_extract_atom(lammps, "i_owner");
  double **const x = lammps_extract_atom(lammps, "x");
  const size_t room = (size_t)all + 1;
  struct tagged *const order = malloc(room * sizeof *order);
  double *const xyz = malloc(4 * room * sizeof *xyz), *const radius = xyz + 3 * room;
  uint64_t *const id = malloc(room * sizeof *id);
  uint32_t *const owner = malloc(room * sizeof *owner);
  stop_if(order == NULL || xyz == NULL || id == NULL || owner == NULL, "out of memory");
  for (uint32_t i = 0; i < all; ++i) order[i] = (struct tagged){tag[i], (int)i};
  qsort(order, all, sizeof *order, by_tag);
  for (uint32_t k = 0; k < all; ++k) {
    const int i = order[k].at;
    memcpy(xyz + 3 * (size_t)k, x[i], 3 * sizeof *xyz);
    radius[k] = radius_of_type[type[i]];
    id[k] = (uint64_t)tag[i];
    owner[k] = (uint32_t)owner_of[i];
  }
  hsp_workspace work = {0};
  hsp_model_options options;
  const hsp_brick_request request = {
      .struct_size = sizeof request, .brick = (uint32_t)rank, .bricks = (uint32_t)ranks, .id = id, .owner = owner};
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.largest_radius = largest_radius;
  if (status == HSP_OK) status = hsp_workspace_set(&work, all, xyz, radius, &options, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary(&work);
  if (status == HSP_OK) status = brick_summary_make(work.boundary, &request, summary);
  hsp_workspace_free(&work);
  free(order);
  free(xyz);
  free(id);
  free(owner);
  return status;
}

int main(int count, char **arguments) {
  char *quiet[] = {(char *)"lammps", (char *)"-screen", (char *)"none", (char *)"-log", (char *)"none"};
  double radius_of_type[64] = {0}, largest_radius = 0;
  brick_summary summary = {NULL, 0};
  hsp_brick_totals totals;
  MPI_Init(&count, &arguments);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  stop_if(count < 3 || count > 65, "usage: lammps_components INPUT RADIUS ...");
  for (int type = 1; type < count - 1; ++type) {
    radius_of_type[type] = strtod(arguments[type + 1], NULL);
    if (radius_of_type[type] > largest_radius) largest_radius = radius_of_type[type];
  }
  void *const lammps = lammps_open(5, quiet, MPI_COMM_WORLD, NULL);
  lammps_file(lammps, arguments[1]);
  stop_if(lammps_extract_setting(lammps, "ntypes") != count - 2, "a radius for each type of atom, please");
  number_owners(lammps, largest_radius);
  int32_t status = summarise(lammps, radius_of_type, largest_radius, &summary);
  if (status != HSP_OK) summary.bytes = 0; /* which no rank takes for a summary */
  const uint64_t sent = brick_summary_reduce(&summary, MPI_COMM_WORLD);
  uint64_t figures[2] = {sent, (uint64_t)lammps_extract_setting(lammps, "nghost")}, sums[2];
  MPI_Reduce(figures, sums, 2, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
  if (rank == 0 && status == HSP_OK) status = hsp_brick_get_totals(summary.byte, summary.bytes, &totals, NULL);
  stop_if(status != HSP_OK, hsp_status_text(status));
  if (rank == 0) {
    printf("%llu atoms, %llu components, %llu voids, Euler number %lld, area %.17g, volume %.17g\n",
           (unsigned long long)totals.balls, (unsigned long long)totals.components, (unsigned long long)totals.voids,
           (long long)totals.euler, totals.area, totals.volume);
    fprintf(stderr, "%d ranks, %llu ghosts, %llu bytes of summaries\n", ranks, (unsigned long long)sums[1],
            (unsigned long long)sums[0]);
  }
  lammps_close(lammps);
  free(summary.byte);
  MPI_Finalize();
  return 0;
}
