/* One large set of balls split among the ranks of MPI: each reads its slab of the file with a halo, and computes
 * boundary, areas, volume and gradient of its own balls. The bits do not depend on the number of ranks.
 *   mpirun -np 4 split_mpi FILE.xyzr [check]       x y z r on each line
 *
 * Space is cut along x into layers as thick as the largest ball is wide, so that a ball meets none beyond the next
 * layer. A rank owns whole layers, with about as many balls as the others; its halo is one layer on either side. Two
 * things make the bits the same:
 *   1. All ranks name the same largest radius, hence have the same lattice and cubes. There a ball with all its
 *      neighbours gives the same bits whatever else there is.
 *   2. Totals are sums over the balls of a layer, then over the layers, by a tree that depends on their numbers alone.
 * With `check` each rank also computes all balls at once, and compares its own. */
#include <hardsphere_workspace.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Facts that all ranks know: layers of the file, and how many balls are in each. */
struct layers {
  double first_x, thickness, largest_radius, origin[3]; /* the origin of volumes: the file's first ball */
  uint32_t count;
  uint64_t *balls;
};

/* The balls of a rank, its own and those of the halo, in the order of the file, and what is found of them. */
struct part {
  uint32_t first_layer, end_layer; /* its own */
  uint32_t count, room;
  double *xyz, *radius;
  uint32_t *layer;
  uint64_t *place; /* in the file */
  double *area, *area_centre, *vector_area;
};

static void *need(void *memory) {
  if (memory == NULL) {
    fprintf(stderr, "split_mpi: out of memory\n");
    MPI_Abort(MPI_COMM_WORLD, 1);
    exit(1);
  }
  return memory;
}

/* The file from its beginning, a ball for each call: 1; 0 at the end; -1 if a line is no ball. */
static int next_ball(FILE *file, double ball[4]) {
  char line[512];
  while (fgets(line, sizeof line, file) != NULL) {
    line[strcspn(line, "#")] = '\0';
    if (line[strspn(line, " \t\r\n")] == '\0') continue;
    return sscanf(line, "%lf %lf %lf %lf", &ball[0], &ball[1], &ball[2], &ball[3]) == 4 ? 1 : -1;
  }
  return 0;
}

static uint32_t layer_of(const struct layers *layers, double x) {
  return layers->thickness > 0 ? (uint32_t)((x - layers->first_x) / layers->thickness) : 0;
}

/* Two passes over the file that keep no ball: its extent, then how many balls each layer has. Ranks that had an index
 * of the file would need neither. */
static int find_layers(FILE *file, struct layers *layers) {
  double ball[4], last_x = 0;
  int got;
  for (uint64_t n = 0; (got = next_ball(file, ball)) == 1; ++n) {
    if (n == 0) memcpy(layers->origin, ball, sizeof layers->origin);
    if (n == 0 || ball[0] < layers->first_x) layers->first_x = ball[0];
    if (n == 0 || ball[0] > last_x) last_x = ball[0];
    if (ball[3] > layers->largest_radius) layers->largest_radius = ball[3];
  }
  if (got < 0) return 0;
  /* A little more than the width, for what rounding to the lattice adds to radii and coordinates. */
  layers->thickness = 2 * layers->largest_radius * (1 + 1e-6);
  layers->count = layer_of(layers, last_x) + 1;
  layers->balls = need(calloc(layers->count, sizeof *layers->balls));
  rewind(file);
  while (next_ball(file, ball) == 1) ++layers->balls[layer_of(layers, ball[0])];
  return 1;
}

/* The first layer of a rank: as many balls are before it as are due to the ranks before. */
static uint32_t first_layer_of(const struct layers *layers, int rank, int ranks) {
  uint64_t all = 0, before = 0;
  for (uint32_t k = 0; k < layers->count; ++k) all += layers->balls[k];
  uint32_t layer = 0;
  while (layer < layers->count && (before + layers->balls[layer] / 2) * (uint64_t)ranks < all * (uint64_t)rank)
    before += layers->balls[layer++];
  return rank == ranks ? layers->count : layer;
}

/* Keep the balls of the layers first .. end - 1 and of one more on either side. */
static void read_part(FILE *file, const struct layers *layers, uint32_t first, uint32_t end, struct part *part) {
  memset(part, 0, sizeof *part);
  part->first_layer = first, part->end_layer = end;
  for (uint32_t k = first > 0 ? first - 1 : 0; first < end && k < layers->count && k <= end; ++k)
    part->room += (uint32_t)layers->balls[k];
  const size_t room = (size_t)part->room + 1;
  part->xyz = need(malloc(3 * room * sizeof *part->xyz));
  part->radius = need(malloc(room * sizeof *part->radius));
  part->layer = need(malloc(room * sizeof *part->layer));
  part->place = need(malloc(room * sizeof *part->place));
  part->area = need(malloc(room * sizeof *part->area));
  part->area_centre = need(malloc(3 * room * sizeof *part->area_centre));
  part->vector_area = need(malloc(3 * room * sizeof *part->vector_area));
  rewind(file);
  double ball[4];
  for (uint64_t place = 0; part->count < part->room && next_ball(file, ball) == 1; ++place) {
    const uint32_t layer = layer_of(layers, ball[0]);
    if (layer + 1 < first || layer > end) continue;
    const uint32_t i = part->count++;
    memcpy(part->xyz + 3 * (size_t)i, ball, 3 * sizeof *ball);
    part->radius[i] = ball[3];
    part->layer[i] = layer;
    part->place[i] = place;
  }
}

static int is_own(const struct part *part, uint32_t i) {
  return part->layer[i] >= part->first_layer && part->layer[i] < part->end_layer;
}

static int32_t compute(const struct layers *layers, struct part *part) {
  hsp_workspace work = {0};
  hsp_model_options options;
  const uint32_t n = part->count;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.largest_radius = layers->largest_radius;
  if (status == HSP_OK) status = hsp_workspace_set(&work, n, part->xyz, part->radius, &options, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary(&work);
  if (status == HSP_OK) status = hsp_boundary_measure(work.boundary, NULL, NULL, part->area, NULL, n, NULL);
  if (status == HSP_OK) {
    hsp_derivatives_outputs outputs = {.struct_size = sizeof outputs,
                                       .capacity = n,
                                       .area_centre = part->area_centre,
                                       .volume_centre = part->vector_area};
    status = hsp_boundary_get_derivatives(work.boundary, NULL, &outputs);
  }
  hsp_workspace_free(&work);
  return status;
}

/* The sum of a tree whose shape depends on the number of terms alone; the terms are used up. */
static double sum_of(double *terms, size_t count) {
  for (size_t step = 1; step < count; step *= 2) {
    for (size_t k = 0; k + step < count; k += 2 * step) terms[k] += terms[k + step];
  }
  return count > 0 ? terms[0] : 0;
}

/* Sums over each layer of a rank, balls in the file's order: area, and volume by the divergence theorem. */
static void sum_layers(const struct layers *layers, const struct part *part, double *area, double *volume) {
  double *terms = need(malloc(2 * ((size_t)part->count + 1) * sizeof *terms));
  for (uint32_t layer = part->first_layer; layer < part->end_layer; ++layer) {
    size_t n = 0;
    double *of_volume = terms + part->count;
    for (uint32_t i = 0; i < part->count; ++i) {
      if (part->layer[i] != layer) continue;
      const double *c = part->xyz + 3 * (size_t)i, *v = part->vector_area + 3 * (size_t)i, *o = layers->origin;
      terms[n] = part->area[i];
      of_volume[n++] =
          (part->radius[i] * part->area[i] + (c[0] - o[0]) * v[0] + (c[1] - o[1]) * v[1] + (c[2] - o[2]) * v[2]) / 3;
    }
    area[layer - part->first_layer] = sum_of(terms, n);
    volume[layer - part->first_layer] = sum_of(of_volume, n);
  }
  free(terms);
}

/* Send numbers of the own layers to rank 0, which has room for all layers. */
static void gather(const struct layers *layers, double *own, int count, double *all) {
  int rank, ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  int *counts = need(malloc(2 * (size_t)ranks * sizeof *counts));
  for (int k = 0; k < ranks; ++k) {
    counts[ranks + k] = (int)first_layer_of(layers, k, ranks);
    counts[k] = (int)first_layer_of(layers, k + 1, ranks) - counts[ranks + k];
  }
  MPI_Gatherv(own, count, MPI_DOUBLE, all, counts, counts + ranks, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  free(counts);
}

/* Whether the own balls of a part have the same bits in the whole. */
static int same_bits(const struct part *part, const struct part *whole) {
  for (uint32_t i = 0; i < part->count; ++i) {
    const size_t own = i, all = (size_t)part->place[i];
    if (!is_own(part, i)) continue;
    if (memcmp(part->area + own, whole->area + all, sizeof(double)) != 0 ||
        memcmp(part->area_centre + 3 * own, whole->area_centre + 3 * all, 3 * sizeof(double)) != 0 ||
        memcmp(part->vector_area + 3 * own, whole->vector_area + 3 * all, 3 * sizeof(double)) != 0)
      return 0;
  }
  return 1;
}

static void free_part(struct part *part) {
  void *all[] = {part->xyz, part->radius, part->layer, part->place, part->area, part->area_centre, part->vector_area};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; ++k) free(all[k]);
}

/* All ranks. Returns whether all went well. */
static int run(FILE *file, int check) {
  int rank, ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  struct layers layers = {0};
  if (!find_layers(file, &layers)) {
    if (rank == 0) fprintf(stderr, "split_mpi: expected x y z r on each line\n");
    return 0;
  }
  struct part part, whole;
  read_part(file, &layers, first_layer_of(&layers, rank, ranks), first_layer_of(&layers, rank + 1, ranks), &part);
  const int32_t status = compute(&layers, &part);
  if (status != HSP_OK) fprintf(stderr, "split_mpi: rank %d: %s\n", rank, hsp_status_text(status));
  int good = status == HSP_OK, all_good = 0;
  MPI_Allreduce(&good, &all_good, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD);
  if (all_good) {
    const size_t own_layers = part.end_layer - part.first_layer;
    double *sums = need(calloc(2 * (own_layers + layers.count), sizeof *sums));
    double *area = sums, *volume = area + own_layers, *all_area = volume + own_layers,
           *all_volume = all_area + layers.count;
    sum_layers(&layers, &part, area, volume);
    gather(&layers, area, (int)own_layers, all_area);
    gather(&layers, volume, (int)own_layers, all_volume);
    uint64_t of_rank[2] = {0, 0}, of_all[2] = {0, 0}; /* balls, and those of the halo */
    for (uint32_t i = 0; i < part.count; ++i) ++of_rank[!is_own(&part, i)];
    MPI_Reduce(of_rank, of_all, 2, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
    if (rank == 0) {
      printf("%llu balls, area %.17g, volume %.17g\n", (unsigned long long)of_all[0], sum_of(all_area, layers.count),
             sum_of(all_volume, layers.count));
      fprintf(stderr, "%d ranks, %u layers, %llu balls in halos\n", ranks, (unsigned)layers.count,
              (unsigned long long)of_all[1]);
    }
    free(sums);
  }
  if (all_good && check) {
    read_part(file, &layers, 0, layers.count, &whole);
    good = compute(&layers, &whole) == HSP_OK && same_bits(&part, &whole);
    if (!good) fprintf(stderr, "split_mpi: rank %d has other bits than the whole\n", rank);
    free_part(&whole);
    MPI_Allreduce(&good, &all_good, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD);
  }
  free_part(&part);
  free(layers.balls);
  return all_good;
}

int main(int count, char **arguments) {
  MPI_Init(&count, &arguments);
  int done = 0;
  if (count < 2 || count > 3 || (count == 3 && strcmp(arguments[2], "check") != 0)) {
    fprintf(stderr, "usage: split_mpi FILE.xyzr [check]\n");
  } else {
    FILE *file = fopen(arguments[1], "r");
    if (file == NULL) {
      perror(arguments[1]);
    } else {
      done = run(file, count == 3);
      fclose(file);
    }
  }
  MPI_Finalize();
  return done ? 0 : 1;
}
