/* LAMMPS by its library interface, with a surface energy through `fix external`, on any number of ranks.
 *   mpirun -np N lammps_sasa TENSION bits            position, area and force of each atom, in hexadecimals
 *   mpirun -np 1 lammps_sasa TENSION quotients       the worst difference of forces from quotients, and the largest;
 *                                                    then of the virial from quotients by the box
 *   mpirun -np N lammps_sasa TENSION run DT STEPS    NVE: how far the total energy goes, root mean square
 * 512 atoms with forces of Lennard-Jones in a periodic box; units real. To compile, with the LAMMPS of Debian:
 *   mpicc -std=c99 -DLAMMPS_SMALLBIG lammps_sasa.c -llammps $(pkg-config --cflags --libs hardsphere) -o lammps_sasa */
#define LAMMPS_LIB_MPI /* else lammps_open is not declared */
#include <lammps/library.h>
#include <math.h>
#include <mpi.h>
#include <stdio.h>

#include "surface_forces.h"

static const double radius_of_type[2] = {0, 2.0};

struct client {
  void *lammps;
  surface_forces surface;
  double *radius, *force;   /* force: of the last call, [own][3], LAMMPS's */
  double energy, virial[6]; /* of all ranks; xx yy zz xy xz yz */
  uint32_t own, room;
};

/* LAMMPS calls it in every step, after it has brought ghosts up to date. */
static void add_forces(void *pointer, int64_t step, int own, int *tags, double **x, double **f) {
  struct client *c = pointer;
  const uint32_t all = (uint32_t)lammps_extract_setting(c->lammps, "nall");
  const int *type = lammps_extract_atom(c->lammps, "type");
  static const int place[6] = {0, 4, 8, 1, 2, 5};
  double energy = 0, own_sums[7] = {0}, sums[7];
  (void)step, (void)tags;
  c->own = (uint32_t)own;
  if (all > c->room) {
    c->room = all + all / 4;
    double *const larger = realloc(c->radius, c->room * sizeof(double));
    if (larger == NULL) {
      fprintf(stderr, "lammps_sasa: %s\n", hsp_status_text(HSP_E_MEMORY));
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
    c->radius = larger;
  }
  for (uint32_t i = 0; i < all; ++i) c->radius[i] = radius_of_type[type[i]];
  if (own > 0) { /* else there is no x[0] */
    const int32_t status = surface_forces_compute(&c->surface, c->own, all, x[0], c->radius, &energy);
    if (status != HSP_OK) {
      fprintf(stderr, "lammps_sasa: %s\n", hsp_status_text(status));
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
    c->force = f[0];
    for (int k = 0; k < 3 * own; ++k) f[0][k] = -c->surface.gradient[k];
    for (int k = 0; k < 6; ++k) own_sums[1 + k] = -c->surface.strain[place[k]];
  }
  own_sums[0] = energy;
  MPI_Allreduce(own_sums, sums, 7, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  c->energy = sums[0];
  memcpy(c->virial, sums + 1, sizeof c->virial);
  lammps_fix_external_set_energy_global(c->lammps, "surface", c->energy);
  lammps_fix_external_set_virial_global(c->lammps, "surface", c->virial);
}

static void set_up(struct client *c, const char *dt) {
  static const char *const lines[] = {"units real",
                                      "atom_style atomic",
                                      "atom_modify map array sort 0 0",
                                      "lattice sc 4.4",
                                      "region box prism 0 8 0 8 0 8 0 0 0",
                                      "create_box 1 box",
                                      "create_atoms 1 box",
                                      "mass 1 14.027",
                                      "displace_atoms all random 0.4 0.4 0.4 4711 units box",
                                      "pair_style lj/cut 10.0",
                                      "pair_coeff 1 1 0.0914 3.95",
                                      "pair_modify shift yes",
                                      "neighbor 2.0 bin",
                                      "neigh_modify every 1 delay 0 check yes",
                                      "thermo_style one",
                                      "thermo_modify norm no",
                                      NULL};
  char line[100];
  for (const char *const *next = lines; *next != NULL; ++next) lammps_command(c->lammps, *next);
  if (c->surface.tension != 0) {
    lammps_command(c->lammps, "fix surface all external pf/callback 1 1");
    lammps_command(c->lammps, "fix_modify surface energy yes virial yes");
    lammps_set_fix_external_callback(c->lammps, "surface", add_forces, c);
    /* Nothing evaluates it: LAMMPS ends a run whose ghosts reach less far than this cutoff and the skin. */
    snprintf(line, sizeof line, "compute ghosts all rdf 1 cutoff %.17g",
             2 * (c->surface.largest_radius + c->surface.probe));
    lammps_command(c->lammps, line);
  }
  snprintf(line, sizeof line, "timestep %s", dt);
  lammps_command(c->lammps, line);
}

/* Tags depend on the number of ranks here: a row begins with the atom's position, for sorting. Every number is of one
 * rank, so that nothing is rounded where they are gathered as a sum. */
static void print_bits(struct client *c, int rank) {
  const int atoms = (int)lammps_get_natoms(c->lammps);
  double *own = calloc(14 * (size_t)atoms, sizeof(double)), *all = own + 7 * (size_t)atoms;
  int before = 0, mine;
  lammps_command(c->lammps, "run 0 post no");
  double **x = lammps_extract_atom(c->lammps, "x");
  mine = (int)c->own;
  MPI_Exscan(&mine, &before, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  for (uint32_t i = 0; i < c->own; ++i) {
    double *row = own + 7 * ((size_t)(rank == 0 ? 0 : before) + i);
    for (int k = 0; k < 3; ++k) {
      row[k] = x[i][k];
      row[4 + k] = c->force[3 * i + (uint32_t)k];
    }
    row[3] = c->surface.area[i];
  }
  MPI_Reduce(own, all, 7 * atoms, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  for (int i = 0; rank == 0 && i < 7 * atoms; ++i) printf("%a%c", all[i], i % 7 == 6 ? '\n' : ' ');
  free(own);
}

/* The box and all atoms in it strained to either side, and back. */
static void print_box_quotients(struct client *c, double h) {
  static const char *const axes[6] = {"x", "y", "z", "xy", "xz", "yz"};
  double known[6], worst = 0, largest = 0;
  lammps_command(c->lammps, "run 0 post no");
  memcpy(known, c->virial, sizeof known);
  for (int k = 0; k < 6; ++k) {
    double energy[2];
    for (int side = 0; side < 4; ++side) { /* there and back, there and back */
      const double strain = side / 2 == 0 ? -h : h;
      const double there = k < 3 ? 1 + strain : strain * 8 * 4.4;
      char line[100];
      snprintf(line, sizeof line, "change_box all %s %s %.17g remap units box", axes[k], k < 3 ? "scale" : "delta",
               side % 2 == 0 ? there
               : k < 3       ? 1 / there
                             : -there);
      lammps_command(c->lammps, line);
      if (side % 2 == 0) {
        lammps_command(c->lammps, "run 0 post no");
        energy[side / 2] = c->energy;
      }
    }
    worst = fmax(worst, fabs(known[k] + (energy[1] - energy[0]) / (2 * h)));
    largest = fmax(largest, fabs(known[k]));
  }
  printf("%.3e %.6f\n", worst, largest);
}

static void print_quotients(struct client *c) {
  const int atoms = (int)lammps_get_natoms(c->lammps);
  const double h = 1e-4;
  double *x = malloc(6 * (size_t)atoms * sizeof(double)), *force = x + 3 * (size_t)atoms, worst = 0, largest = 0;
  lammps_command(c->lammps, "run 0 post no");
  lammps_gather_atoms(c->lammps, (char *)"x", 1, 3, x);
  memcpy(force, c->force, 3 * (size_t)atoms * sizeof(double));
  const int *tags = lammps_extract_atom(c->lammps, "id");
  int *tag = malloc((size_t)atoms * sizeof(int));
  memcpy(tag, tags, (size_t)atoms * sizeof(int));
  for (int i = 0; i < atoms; i += 37) {
    double *moved = x + 3 * (tag[i] - 1) + i % 3, energy[2];
    const double kept = *moved;
    for (int side = 0; side < 2; ++side) {
      *moved = kept + (side == 0 ? -h : h);
      lammps_scatter_atoms(c->lammps, (char *)"x", 1, 3, x);
      lammps_command(c->lammps, "run 0 post no");
      energy[side] = c->energy;
    }
    *moved = kept;
    worst = fmax(worst, fabs(force[3 * i + i % 3] + (energy[1] - energy[0]) / (2 * h)));
    largest = fmax(largest, fabs(force[3 * i + i % 3]));
  }
  printf("%.3e %.6f\n", worst, largest);
  free(tag);
  free(x);
  print_box_quotients(c, h);
}

static void print_run(struct client *c, int rank, long steps) {
  double squares = 0;
  lammps_command(c->lammps, "velocity all create 100 4711 loop geom");
  lammps_command(c->lammps, "fix nve all nve");
  lammps_command(c->lammps, "run 0 post no");
  const double first = lammps_get_thermo(c->lammps, "etotal");
  const long blocks = 40;
  char line[100];
  snprintf(line, sizeof line, "run %ld pre no post no", steps / blocks);
  for (long k = 0; k < blocks; ++k) {
    lammps_command(c->lammps, line);
    const double away = lammps_get_thermo(c->lammps, "etotal") - first;
    squares += away * away;
  }
  if (rank == 0) printf("%.6f\n", sqrt(squares / (double)blocks));
}

int main(int count, char **arguments) {
  char *quiet[] = {(char *)"lammps_sasa", (char *)"-screen", (char *)"none", (char *)"-log", (char *)"none"};
  struct client c;
  int rank;
  MPI_Init(&count, &arguments);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (count < 3 || (arguments[2][0] == 'r' && count < 5)) {
    fprintf(stderr, "usage: lammps_sasa TENSION bits | quotients | run DT STEPS\n");
    return 2;
  }
  memset(&c, 0, sizeof c);
  c.surface.tension = strtod(arguments[1], NULL);
  c.surface.probe = 1.4;
  c.surface.largest_radius = 2.0;
  c.surface.with_strain = 1; /* 0 where nothing asks for pressure or its virial: a third of the time less */
  c.lammps = lammps_open(5, quiet, MPI_COMM_WORLD, NULL);
  set_up(&c, count > 3 ? arguments[3] : "1.0");
  switch (arguments[2][0]) {
    case 'b':
      print_bits(&c, rank);
      break;
    case 'q':
      print_quotients(&c);
      break;
    default:
      print_run(&c, rank, strtol(arguments[4], NULL, 10));
  }
  lammps_close(c.lammps);
  surface_forces_free(&c.surface);
  free(c.radius);
  MPI_Finalize();
  return 0;
}
