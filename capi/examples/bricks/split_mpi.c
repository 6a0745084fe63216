/* One set of balls split among the ranks of MPI, in memory: a brick for each, areas of its own balls, and components,
 * voids, Euler number, area and volume of the whole. The bits do not depend on the number of ranks.
 *   mpirun -np 4 split_mpi FILE.xyzr [AREAS | check]       x y z r on each line
 *
 * Ranks begin with any balls, as rank 0 has read them. Space is cut in two across its longest extent, and each half
 * again, by samples of all ranks. One exchange takes each ball to its owner and to all others whose region it may reach
 * into. Each rank then computes its brick; summaries go down a binary tree as they are, and merge.
 * With AREAS the area of each ball goes to that file, 8 bytes each in the order of the balls, by all ranks at once.
 * With `check` each rank also computes all balls by itself, and compares its own and the totals. */
#include <hardsphere_workspace.h>
#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../clients/brick_summaries.h"
#include "../read_balls.h"

struct ball {
  double xyz[3], radius;
  uint64_t id; /* its place in the file */
  uint32_t owner, reserved;
};

struct region { /* low <= c < high */
  double low[3], high[3];
};

/* A brick with the balls around it, by id; what is found of each ball. */
struct part {
  uint32_t count;
  double *xyz, *radius, *area, *area_centre;
  uint64_t *id;
  uint32_t *owner;
};

static int rank, ranks;
static MPI_Datatype of_ball;
static double largest_radius; /* of all balls */
/* Where all are points: it would follow from those that are there. */
static const double step_of_points = 1e-8;

static void *need(void *memory) {
  if (memory == NULL) {
    fprintf(stderr, "split_mpi: out of memory\n");
    MPI_Abort(MPI_COMM_WORLD, 1);
    exit(1);
  }
  return memory;
}

/* ---- balls, from rank 0 to all ranks ---------------------------------------------------------------------------- */

static int share_of(uint64_t all, int k) {
  return (int)(all * (uint64_t)(k + 1) / (uint64_t)ranks - all * (uint64_t)k / (uint64_t)ranks);
}

/* Whether all have a place. A ball that has none is in no region, so that no rank would take it. */
static int have_places(const struct balls *balls) {
  for (uint32_t i = 0; i < balls->count; ++i) {
    const double *const centre = balls->xyz + 3 * (size_t)i;
    if (isfinite(centre[0]) && isfinite(centre[1]) && isfinite(centre[2])) continue;
    fprintf(stderr, "split_mpi: ball %u: %s\n", (unsigned)i, hsp_status_text(HSP_E_NOT_FINITE));
    return 0;
  }
  return 1;
}

/* So many balls for each rank; NULL if the file is not read. */
static struct ball *first_balls(const char *path, uint64_t *all, int *counts, int *places) {
  struct balls read = {0, NULL, NULL};
  struct ball *from = NULL;
  int good = 1;
  if (rank == 0) {
    good = read_balls(path, &read) && have_places(&read);
    from = need(calloc((size_t)read.count + 1, sizeof *from));
    for (uint32_t i = 0; i < read.count; ++i) {
      memcpy(from[i].xyz, read.xyz + 3 * (size_t)i, sizeof from[i].xyz);
      from[i].radius = read.radius[i];
      from[i].id = i;
    }
    *all = read.count;
    free_balls(&read);
  }
  MPI_Bcast(&good, 1, MPI_INT, 0, MPI_COMM_WORLD);
  MPI_Bcast(all, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  for (int k = 0; k < ranks; ++k) {
    counts[k] = share_of(*all, k);
    places[k] = k > 0 ? places[k - 1] + counts[k - 1] : 0;
  }
  struct ball *const own = need(malloc(((size_t)counts[rank] + 1) * sizeof *own));
  MPI_Scatterv(from, counts, places, of_ball, own, counts[rank], of_ball, 0, MPI_COMM_WORLD);
  free(from);
  if (good) return own;
  free(own);
  return NULL;
}

/* ---- regions ----------------------------------------------------------------------------------------------------- */

enum { SAMPLES = 1024 }; /* of each rank */
static int sorted_axis;
static int by_axis(const void *a, const void *b) {
  const double first = ((const double *)a)[sorted_axis], second = ((const double *)b)[sorted_axis];
  return (first > second) - (first < second);
}

/* Cuts the region of the ranks first .. end - 1 in proportion to their numbers. */
static void bisect(double (*sample)[3], size_t count, int first, int end, struct region region, struct region *of) {
  if (end - first == 1) {
    of[first] = region;
    return;
  }
  const int middle = first + (end - first) / 2;
  double longest = -1;
  int axis = 0;
  for (int k = 0; k < 3; ++k) {
    double low = INFINITY, high = -INFINITY;
    for (size_t s = 0; s < count; ++s) low = fmin(low, sample[s][k]), high = fmax(high, sample[s][k]);
    if (high - low > longest) longest = high - low, axis = k;
  }
  sorted_axis = axis;
  qsort(sample, count, sizeof *sample, by_axis);
  size_t below = count * (size_t)(middle - first) / (size_t)(end - first);
  const double cut = count > 0 ? sample[below][axis] : 0;
  while (below > 0 && sample[below - 1][axis] == cut) --below; /* those on the cut belong above it */
  struct region low = region, high = region;
  low.high[axis] = high.low[axis] = cut;
  bisect(sample, below, first, middle, low, of);
  bisect(sample + below, count - below, middle, end, high, of);
}

static struct region *find_regions(const struct ball *own, int count) {
  struct region *const of = need(malloc((size_t)ranks * sizeof *of));
  double(*sample)[3] = need(malloc((size_t)(ranks + 1) * SAMPLES * sizeof *sample)),
  (*mine)[3] = sample + ranks * SAMPLES;
  size_t found = 0;
  for (int s = 0; s < SAMPLES; ++s) {
    mine[s][0] = mine[s][1] = mine[s][2] = NAN;
    if (count > 0) memcpy(mine[s], own[(size_t)s * (size_t)count / SAMPLES].xyz, sizeof mine[s]);
  }
  MPI_Allgather(mine[0], 3 * SAMPLES, MPI_DOUBLE, sample[0], 3 * SAMPLES, MPI_DOUBLE, MPI_COMM_WORLD);
  for (int s = 0; s < ranks * SAMPLES; ++s) {
    if (!isnan(sample[s][0])) memmove(sample[found++], sample[s], sizeof *sample);
  }
  const struct region all = {{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
  bisect(sample, found, 0, ranks, all, of);
  free(sample);
  return of;
}

static int reaches(const struct ball *ball, const struct region *region, double reach) {
  int within = 1;
  for (int k = 0; k < 3; ++k)
    within = within && region->low[k] - reach <= ball->xyz[k] && ball->xyz[k] < region->high[k] + reach;
  return within;
}

/* ---- the exchange ------------------------------------------------------------------------------------------------ */

static int by_id(const void *a, const void *b) {
  const uint64_t first = ((const struct ball *)a)->id, second = ((const struct ball *)b)->id;
  return (first > second) - (first < second);
}

static struct part part_of(const struct ball *balls, uint32_t count) {
  const size_t room = (size_t)count + 1;
  struct part part = {count, NULL, NULL, NULL, NULL, NULL, NULL};
  part.xyz = need(malloc(3 * room * sizeof *part.xyz));
  part.radius = need(malloc(room * sizeof *part.radius));
  part.area = need(malloc(room * sizeof *part.area));
  part.area_centre = need(malloc(3 * room * sizeof *part.area_centre));
  part.id = need(malloc(room * sizeof *part.id));
  part.owner = need(malloc(room * sizeof *part.owner));
  for (uint32_t i = 0; i < count; ++i) {
    memcpy(part.xyz + 3 * (size_t)i, balls[i].xyz, sizeof balls[i].xyz);
    part.radius[i] = balls[i].radius;
    part.id[i] = balls[i].id;
    part.owner[i] = balls[i].owner;
  }
  return part;
}

static void free_part(struct part *part) {
  void *all[] = {part->xyz, part->radius, part->area, part->area_centre, part->id, part->owner};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; ++k) free(all[k]);
}

/* Each ball to its owner, and to the ranks in whose regions it may meet a ball: two largest radii, and a little more
 * for what rounding to the lattice adds. */
static struct part exchange(struct ball *own, int count, const struct region *region) {
  const double reach = largest_radius > 0 ? 2 * largest_radius * (1 + 1e-6) : 2 * step_of_points;
  int *const out = need(calloc(4 * (size_t)ranks, sizeof *out)), *const in = out + ranks, *const out_at = in + ranks,
             *const in_at = out_at + ranks;
  struct ball *to = NULL;
  for (int pass = 0; pass < 2; ++pass) { /* first they are counted */
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < ranks; ++k) {
        if (reaches(&own[i], &region[k], 0)) own[i].owner = (uint32_t)k;
      }
      for (int k = 0; k < ranks; ++k) {
        if (!reaches(&own[i], &region[k], reach)) continue;
        if (pass == 1) to[out_at[k] + out[k]] = own[i];
        ++out[k];
      }
    }
    if (pass == 1) break;
    MPI_Alltoall(out, 1, MPI_INT, in, 1, MPI_INT, MPI_COMM_WORLD);
    for (int k = 1; k < ranks; ++k) {
      out_at[k] = out_at[k - 1] + out[k - 1];
      in_at[k] = in_at[k - 1] + in[k - 1];
    }
    to = need(malloc(((size_t)out_at[ranks - 1] + (size_t)out[ranks - 1] + 1) * sizeof *to));
    memset(out, 0, (size_t)ranks * sizeof *out);
  }
  const size_t got = (size_t)in_at[ranks - 1] + (size_t)in[ranks - 1];
  struct ball *const balls = need(malloc((got + 1) * sizeof *balls));
  MPI_Alltoallv(to, out, out_at, of_ball, balls, in, in_at, of_ball, MPI_COMM_WORLD);
  qsort(balls, got, sizeof *balls, by_id);
  const struct part part = part_of(balls, (uint32_t)got);
  free(out);
  free(to);
  free(balls);
  return part;
}

/* ---- a brick ----------------------------------------------------------------------------------------------------- */

static int32_t compute(struct part *part, uint32_t brick, uint32_t bricks, brick_summary *summary) {
  hsp_workspace work = {0};
  hsp_model_options options;
  const uint32_t n = part->count;
  hsp_derivatives_outputs outputs = {.struct_size = sizeof outputs, .capacity = n, .area_centre = part->area_centre};
  hsp_brick_request request = {
      .struct_size = sizeof request, .brick = brick, .bricks = bricks, .id = part->id, .owner = part->owner};
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.largest_radius = largest_radius;
  if (largest_radius == 0) options.step = step_of_points;
  if (status == HSP_OK) status = hsp_workspace_set(&work, n, part->xyz, part->radius, &options, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary(&work);
  if (status == HSP_OK) status = hsp_boundary_measure(work.boundary, NULL, NULL, part->area, NULL, n, NULL);
  if (status == HSP_OK) status = hsp_boundary_get_derivatives(work.boundary, NULL, &outputs);
  *summary = (brick_summary){NULL, 0};
  if (status == HSP_OK) status = brick_summary_make(work.boundary, &request, summary);
  hsp_workspace_free(&work);
  if (status != HSP_OK) {
    fprintf(stderr, "split_mpi: rank %d: %s\n", rank, hsp_status_text(status));
    summary->bytes = 0; /* which no rank takes for a summary */
  }
  return status;
}

/* ---- results ----------------------------------------------------------------------------------------------------- */

/* Areas of own balls to their places in a file, by all ranks at once. */
static int write_areas(const char *path, const struct part *part) {
  MPI_File file;
  MPI_Datatype places;
  int *const at = need(malloc(((size_t)part->count + 1) * sizeof *at)), own = 0;
  double *const area = need(malloc(((size_t)part->count + 1) * sizeof *area));
  for (uint32_t i = 0; i < part->count; ++i) {
    if (part->owner[i] != (uint32_t)rank) continue;
    at[own] = (int)part->id[i];
    area[own++] = part->area[i];
  }
  int good =
      MPI_File_open(MPI_COMM_WORLD, path, MPI_MODE_CREATE | MPI_MODE_WRONLY, MPI_INFO_NULL, &file) == MPI_SUCCESS;
  if (good) {
    MPI_Type_create_indexed_block(own, 1, at, MPI_DOUBLE, &places);
    MPI_Type_commit(&places);
    MPI_File_set_size(file, 0);
    MPI_File_set_view(file, 0, MPI_DOUBLE, places, "native", MPI_INFO_NULL);
    good = MPI_File_write_all(file, area, own, MPI_DOUBLE, MPI_STATUS_IGNORE) == MPI_SUCCESS;
    good = MPI_File_close(&file) == MPI_SUCCESS && good;
    MPI_Type_free(&places);
  }
  if (!good) fprintf(stderr, "split_mpi: rank %d cannot write %s\n", rank, path);
  free(at);
  free(area);
  return good;
}

/* All balls on each rank, in one piece. */
static int is_as_in_one_piece(const struct ball *first, int *counts, int *places, uint64_t n, const struct part *part,
                              const hsp_brick_totals *totals) {
  struct ball *const all = need(malloc(((size_t)n + 1) * sizeof *all));
  brick_summary summary;
  hsp_brick_totals of_one;
  MPI_Allgatherv(first, counts[rank], of_ball, all, counts, places, of_ball, MPI_COMM_WORLD);
  for (uint64_t i = 0; i < n; ++i) all[i].owner = 0;
  struct part whole = part_of(all, (uint32_t)n);
  free(all);
  int same = compute(&whole, 0, 1, &summary) == HSP_OK;
  memset(&of_one, 0, sizeof of_one);
  same = same && hsp_brick_get_totals(summary.byte, summary.bytes, &of_one, NULL) == HSP_OK;
  if (rank == 0) same = same && memcmp(&of_one, totals, sizeof of_one) == 0;
  for (uint32_t i = 0; i < part->count && same; ++i) {
    const size_t in_all = (size_t)part->id[i], here = i;
    if (part->owner[i] != (uint32_t)rank) continue;
    same = memcmp(part->area + here, whole.area + in_all, sizeof(double)) == 0 &&
           memcmp(part->area_centre + 3 * here, whole.area_centre + 3 * in_all, 3 * sizeof(double)) == 0;
  }
  if (!same) fprintf(stderr, "split_mpi: rank %d has other bits than one piece\n", rank);
  free(summary.byte);
  free_part(&whole);
  return same;
}

/* All ranks. Returns whether all went well. */
static int run(const char *path, const char *further) {
  int *const counts = need(malloc(2 * (size_t)ranks * sizeof *counts)), *const places = counts + ranks;
  uint64_t n = 0, figures[2] = {0, 0}, sums[2] = {0, 0};
  struct ball *const first = first_balls(path, &n, counts, places);
  if (first == NULL) {
    free(counts);
    return 0;
  }
  for (int i = 0; i < counts[rank]; ++i) largest_radius = fmax(largest_radius, first[i].radius);
  MPI_Allreduce(MPI_IN_PLACE, &largest_radius, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  struct region *const region = find_regions(first, counts[rank]);
  struct part part = exchange(first, counts[rank], region);
  for (uint32_t i = 0; i < part.count; ++i) figures[0] += part.owner[i] != (uint32_t)rank;
  brick_summary summary;
  hsp_brick_totals totals;
  int good = compute(&part, (uint32_t)rank, (uint32_t)ranks, &summary) == HSP_OK;
  figures[1] = brick_summary_reduce(&summary, MPI_COMM_WORLD);
  MPI_Reduce(figures, sums, 2, MPI_UINT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
  memset(&totals, 0, sizeof totals);
  if (rank == 0) {
    good = good && hsp_brick_get_totals(summary.byte, summary.bytes, &totals, NULL) == HSP_OK;
    if (good) {
      printf("%llu balls, area %.17g, volume %.17g, %llu components, %llu voids, Euler number %lld\n",
             (unsigned long long)totals.balls, totals.area, totals.volume, (unsigned long long)totals.components,
             (unsigned long long)totals.voids, (long long)totals.euler);
      fprintf(stderr, "%d ranks, %llu balls in halos, %llu bytes of summaries\n", ranks, (unsigned long long)sums[0],
              (unsigned long long)sums[1]);
    }
  }
  int all_good = 0;
  MPI_Allreduce(&good, &all_good, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD);
  if (all_good && further != NULL) {
    good = strcmp(further, "check") == 0 ? is_as_in_one_piece(first, counts, places, n, &part, &totals)
                                         : write_areas(further, &part);
    MPI_Allreduce(&good, &all_good, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD);
  }
  free(summary.byte);
  free_part(&part);
  free(region);
  free(first);
  free(counts);
  return all_good;
}

int main(int count, char **arguments) {
  MPI_Init(&count, &arguments);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  MPI_Type_contiguous((int)sizeof(struct ball), MPI_BYTE, &of_ball);
  MPI_Type_commit(&of_ball);
  int done = 0;
  if (count < 2 || count > 3) {
    fprintf(stderr, "usage: split_mpi FILE.xyzr [AREAS | check]\n");
  } else {
    done = run(arguments[1], count == 3 ? arguments[2] : NULL);
  }
  MPI_Type_free(&of_ball);
  MPI_Finalize();
  return done ? 0 : 1;
}
