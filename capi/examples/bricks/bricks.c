/* A crystal that no memory holds: copies of a molecule in bricks of cells, made on the fly and computed one by one.
 *   bricks FILE.xyzr AX BY CZ  NX NY NZ  CELLS [FOLDER [PART PARTS]]      x y z r on each line
 * The cell has the sides AX, BY and CZ; there are NX NY NZ of them, and a brick has CELLS along each axis. There may be
 * 2^21 bricks along an axis, and less than 2^31 in all. Components, voids, Euler number, area and volume of all are
 * those that one piece would have. Ctrl-C stops it. With a FOLDER, which has to be there, summaries of finished bricks
 * are kept in it, and another run goes on from these. Several runs at a time, on one machine or many, with PART 0 to
 * PARTS - 1, make some of the bricks each and print nothing; a last run without PART merges them. */
#include <hardsphere_workspace.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../../clients/brick_summaries.h"
#include "../read_balls.h"

enum { LONGEST_PATH = 4096 };

static volatile sig_atomic_t interrupted = 0;
static void interrupt(int number) {
  (void)number;
  interrupted = 1;
}
static int32_t HSP_CALL proceed(void *context) {
  (void)context;
  return interrupted;
}
static const hsp_executor stopping = {sizeof stopping, 1, NULL, NULL, proceed};

/* A summary of the bricks from `place` on in the order of work. */
struct block {
  brick_summary summary;
  uint64_t place;
};

struct crystal {
  struct balls molecule;
  double side[3], low[3], high[3]; /* of the cell; the box around the centres of the molecule */
  double largest_radius;
  int cells[3], size, bricks[3];
  const char *folder;
  uint32_t part, parts;
  hsp_workspace work;
  struct balls balls; /* of the brick that is computed, with those around it */
  uint64_t *id;
  uint32_t *owner;
  uint32_t room;
};

static uint32_t brick_at(const struct crystal *crystal, const int cell[3]) {
  uint32_t brick = 0;
  for (int k = 0; k < 3; ++k) brick = brick * (uint32_t)crystal->bricks[k] + (uint32_t)(cell[k] / crystal->size);
  return brick;
}

static int reserve(struct crystal *crystal, uint32_t more) {
  if (crystal->room - crystal->balls.count >= more) return 1;
  const uint32_t room = 2 * crystal->balls.count + more;
  double *xyz = realloc(crystal->balls.xyz, sizeof(double[3]) * room);
  if (xyz != NULL) crystal->balls.xyz = xyz;
  double *radius = realloc(crystal->balls.radius, sizeof *radius * room);
  if (radius != NULL) crystal->balls.radius = radius;
  uint64_t *id = realloc(crystal->id, sizeof *id * room);
  if (id != NULL) crystal->id = id;
  uint32_t *owner = realloc(crystal->owner, sizeof *owner * room);
  if (owner != NULL) crystal->owner = owner;
  if (xyz == NULL || radius == NULL || id == NULL || owner == NULL) return 0;
  crystal->room = room;
  return 1;
}

/* The molecule in a cell; of another brick the balls within a box. */
static int add_copy(struct crystal *crystal, const int cell[3], const double low[3], const double high[3],
                    uint32_t brick) {
  const struct balls *const molecule = &crystal->molecule;
  const uint32_t owner = brick_at(crystal, cell);
  uint64_t number = 0;
  for (int k = 0; k < 3; ++k) number = number * (uint64_t)crystal->cells[k] + (uint64_t)cell[k];
  if (!reserve(crystal, molecule->count)) return 0;
  for (uint32_t m = 0; m < molecule->count; ++m) {
    const uint32_t i = crystal->balls.count;
    double *const centre = crystal->balls.xyz + 3 * (size_t)i;
    int near = 1;
    for (int k = 0; k < 3; ++k) {
      centre[k] = molecule->xyz[3 * (size_t)m + (size_t)k] + cell[k] * crystal->side[k];
      near = near && low[k] <= centre[k] && centre[k] <= high[k];
    }
    if (!near && owner != brick) continue;
    crystal->balls.radius[i] = molecule->radius[m];
    crystal->id[i] = number * molecule->count + m;
    crystal->owner[i] = owner;
    ++crystal->balls.count;
  }
  return 1;
}

/* The balls of a brick and all within two largest radii of the box around them, by id. */
static int make_brick(struct crystal *crystal, const int first[3], uint32_t brick) {
  double low[3], high[3];
  int from[3], to[3], cell[3];
  crystal->balls.count = 0;
  for (int k = 0; k < 3; ++k) {
    const double reach = 2 * crystal->largest_radius, side = crystal->side[k];
    const int last = crystal->size < crystal->cells[k] - first[k] ? first[k] + crystal->size : crystal->cells[k];
    low[k] = first[k] * side + crystal->low[k] - reach - 1e-6 * side;
    high[k] = (last - 1) * side + crystal->high[k] + reach + 1e-6 * side;
    /* Cells whose molecule reaches into that. */
    for (from[k] = first[k]; from[k] > 0 && (from[k] - 1) * side + crystal->high[k] >= low[k];) --from[k];
    for (to[k] = last; to[k] < crystal->cells[k] && to[k] * side + crystal->low[k] <= high[k];) ++to[k];
  }
  for (cell[0] = from[0]; cell[0] < to[0]; ++cell[0]) {
    for (cell[1] = from[1]; cell[1] < to[1]; ++cell[1]) {
      for (cell[2] = from[2]; cell[2] < to[2]; ++cell[2]) {
        if (!add_copy(crystal, cell, low, high, brick)) return 0;
      }
    }
  }
  return 1;
}

static int32_t compute(struct crystal *crystal, uint32_t brick, brick_summary *summary) {
  const hsp_boundary_request asked = {sizeof asked, 0, &stopping, NULL};
  const uint32_t all = (uint32_t)(crystal->bricks[0] * crystal->bricks[1] * crystal->bricks[2]);
  const hsp_brick_request request = {sizeof request, brick, all, 0, crystal->id, crystal->owner, &stopping};
  const struct balls *const balls = &crystal->balls;
  hsp_model_options options;
  int32_t status = hsp_model_options_init(&options, sizeof options);
  options.largest_radius = crystal->largest_radius;
  if (crystal->largest_radius == 0) options.step = 1e-8; /* which would follow from the points that are there */
  if (status == HSP_OK) {
    status = hsp_workspace_set(&crystal->work, balls->count, balls->xyz, balls->radius, &options, NULL);
  }
  if (status == HSP_OK) status = hsp_workspace_boundary_with(&crystal->work, &asked);
  return status == HSP_OK ? brick_summary_make(crystal->work.boundary, &request, summary) : status;
}

/* Reads the summary of an earlier run; 0 if there is none. */
static int read_summary(const char *path, brick_summary *summary) {
  FILE *const file = fopen(path, "rb");
  if (file == NULL) return 0;
  long size = -1;
  if (fseek(file, 0, SEEK_END) == 0) size = ftell(file);
  summary->byte = size > 0 ? malloc((size_t)size) : NULL;
  summary->bytes = (size_t)size;
  rewind(file);
  const int good = summary->byte != NULL && fread(summary->byte, 1, summary->bytes, file) == summary->bytes;
  fclose(file);
  return good;
}

/* Under another name first, so that a run that dies leaves no half of one. */
static int write_summary(const char *path, const brick_summary *summary) {
  char half[LONGEST_PATH + 8];
  snprintf(half, sizeof half, "%s.half", path);
  FILE *const file = fopen(half, "wb");
  if (file == NULL) return 0;
  const int good = fwrite(summary->byte, 1, summary->bytes, file) == summary->bytes;
  return fclose(file) == 0 && good && rename(half, path) == 0;
}

static int32_t summarise(struct crystal *crystal, const int first[3], brick_summary *summary) {
  const uint32_t brick = brick_at(crystal, first);
  char path[LONGEST_PATH];
  if (crystal->folder != NULL) {
    const int length = snprintf(path, sizeof path, "%s/%u.brick", crystal->folder, (unsigned)brick);
    if (length < 0 || (size_t)length >= sizeof path) return HSP_E_SINK;
    if (read_summary(path, summary)) return HSP_OK;
  }
  if (!make_brick(crystal, first, brick)) return HSP_E_MEMORY;
  const int32_t status = compute(crystal, brick, summary);
  if (status != HSP_OK || crystal->folder == NULL || write_summary(path, summary)) return status;
  perror(path);
  return crystal->parts > 1 ? HSP_E_SINK : HSP_OK; /* of a part nothing else is left */
}

static int32_t merge(struct block *into, struct block *last) {
  uint32_t brick = HSP_NONE;
  const int32_t status = brick_summary_merge(&into->summary, &last->summary, &stopping, &brick);
  if (status != HSP_OK) {
    fprintf(stderr, "brick %ld: %s\n", brick == HSP_NONE ? -1L : (long)brick, hsp_status_text(status));
  }
  return status;
}

enum { PLACE_BITS = 21, MOST_CELLS = 1 << 29 }; /* along an axis */

/* The place of a brick on the Z-order: the bits of its three numbers by turns. */
static uint64_t place_of(const int at[3]) {
  uint64_t place = 0;
  for (int bit = PLACE_BITS - 1; bit >= 0; --bit) {
    for (int k = 0; k < 3; ++k) place = place << 1 | ((unsigned)at[k] >> bit & 1U);
  }
  return place;
}

static int by_place(const void *a, const void *b) {
  uint64_t first, second;
  memcpy(&first, a, sizeof first);
  memcpy(&second, b, sizeof second);
  return (first > second) - (first < second);
}

/* Halves, quarters and wholes of cubes of the Z-order are merged as they end, so that little waits. */
static int32_t run(struct crystal *crystal, struct block *waiting, uint32_t *count, size_t *most) {
  const uint32_t all = (uint32_t)(crystal->bricks[0] * crystal->bricks[1] * crystal->bricks[2]);
  uint64_t *const order = malloc(sizeof *order * all);
  int32_t status = order != NULL ? HSP_OK : HSP_E_MEMORY;
  for (uint32_t b = 0; b < all && order != NULL; ++b) {
    const uint32_t deep = (uint32_t)crystal->bricks[2], wide = (uint32_t)crystal->bricks[1];
    const int at[3] = {(int)(b / deep / wide), (int)(b / deep % wide), (int)(b % deep)};
    order[b] = place_of(at);
  }
  if (order != NULL) qsort(order, all, sizeof *order, by_place);
  for (uint32_t k = 0; k < all && status == HSP_OK; ++k) {
    int first[3] = {0, 0, 0};
    for (int bit = 0; bit < 3 * PLACE_BITS; ++bit) first[2 - bit % 3] |= (int)(order[k] >> bit & 1) << bit / 3;
    for (int axis = 0; axis < 3; ++axis) first[axis] *= crystal->size;
    struct block *const last = &waiting[*count];
    if (k % crystal->parts != crystal->part) continue;
    *last = (struct block){{NULL, 0}, order[k]};
    status = summarise(crystal, first, &last->summary);
    fprintf(stderr, "\r%u of %u bricks", (unsigned)(k + 1), (unsigned)all);
    if (crystal->parts > 1) {
      free(last->summary.byte);
      continue;
    }
    *count += 1;
    size_t waits = 0;
    for (uint32_t w = 0; w < *count; ++w) waits += waiting[w].summary.bytes;
    if (waits > *most) *most = waits;
    const uint64_t next = k + 1 < all ? order[k + 1] : UINT64_MAX;
    for (int level = 1; level < 64 && status == HSP_OK; ++level) {
      if (level < 63 && order[k] >> level == next >> level) break;
      while (status == HSP_OK && *count > 1 &&
             (level == 63 || waiting[*count - 2].place >> level == order[k] >> level)) {
        status = merge(&waiting[*count - 2], &waiting[*count - 1]);
        if (status == HSP_OK) *count -= 1;
      }
    }
  }
  fprintf(stderr, "\n");
  free(order);
  return status;
}

static int print_totals(const brick_summary *whole, size_t most, double seconds) {
  hsp_brick_totals t;
  uint32_t brick = HSP_NONE;
  const int32_t status = hsp_brick_get_totals(whole->byte, whole->bytes, &t, &brick);
  if (status != HSP_OK) {
    fprintf(stderr, "%s\n", hsp_status_text(status));
    return 0;
  }
  printf("%llu balls, %llu components, %llu voids, Euler number %lld\n", (unsigned long long)t.balls,
         (unsigned long long)t.components, (unsigned long long)t.voids, (long long)t.euler);
  printf("%llu vertices, %llu faces\n", (unsigned long long)t.vertices, (unsigned long long)t.faces);
  printf("area %.15g, volume %.15g, of voids %.15g\n", t.area, t.volume, t.void_volume);
  fprintf(stderr, "%.0f ns of processor time a ball, %.3f MB waited at most\n", 1e9 * seconds / (double)t.balls,
          1e-6 * (double)most);
  return 1;
}

static int prepare(struct crystal *crystal, char **argument) {
  if (!read_balls(argument[1], &crystal->molecule) || crystal->molecule.count == 0) return 0;
  uint64_t bricks = 1;
  crystal->size = atoi(argument[8]);
  if (crystal->part >= crystal->parts) return 0;
  for (int k = 0; k < 3; ++k) {
    crystal->side[k] = atof(argument[2 + k]);
    crystal->cells[k] = atoi(argument[5 + k]);
    if (!(crystal->side[k] > 0) || crystal->cells[k] < 1 || crystal->size < 1) return 0;
    if (crystal->cells[k] > MOST_CELLS) return 0;
    crystal->bricks[k] = 1 + (crystal->cells[k] - 1) / crystal->size;
    bricks *= (uint64_t)crystal->bricks[k];
    if (crystal->bricks[k] > 1 << PLACE_BITS || bricks > INT32_MAX) return 0;
    crystal->low[k] = crystal->high[k] = crystal->molecule.xyz[k];
  }
  for (uint32_t m = 0; m < crystal->molecule.count; ++m) {
    const double *const centre = crystal->molecule.xyz + 3 * (size_t)m;
    const double radius = crystal->molecule.radius[m];
    if (radius > crystal->largest_radius) crystal->largest_radius = radius;
    for (int k = 0; k < 3; ++k) {
      if (centre[k] < crystal->low[k]) crystal->low[k] = centre[k];
      if (centre[k] > crystal->high[k]) crystal->high[k] = centre[k];
    }
  }
  return 1;
}

int main(int arguments, char **argument) {
  struct crystal crystal;
  struct block waiting[3 * 21 + 1];
  uint32_t count = 0;
  size_t most = 0;
  memset(&crystal, 0, sizeof crystal);
  crystal.folder = arguments > 9 ? argument[9] : NULL;
  crystal.part = arguments == 12 ? (uint32_t)atoi(argument[10]) : 0;
  crystal.parts = arguments == 12 ? (uint32_t)atoi(argument[11]) : 1;
  if (arguments < 9 || arguments == 11 || arguments > 12 || !prepare(&crystal, argument)) {
    fprintf(stderr, "usage: bricks FILE.xyzr AX BY CZ NX NY NZ CELLS [FOLDER [PART PARTS]]\n");
    free_balls(&crystal.molecule);
    return 2;
  }
  signal(SIGINT, interrupt);
  const clock_t begin = clock();
  const int32_t status = run(&crystal, waiting, &count, &most);
  const double seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
  if (status != HSP_OK) fprintf(stderr, "%s\n", hsp_status_text(status));
  const int good = status == HSP_OK && (crystal.parts > 1 || print_totals(&waiting[0].summary, most, seconds));
  while (count > 0) free(waiting[--count].summary.byte);
  free_balls(&crystal.molecule);
  free_balls(&crystal.balls);
  free(crystal.id);
  free(crystal.owner);
  hsp_workspace_free(&crystal.work);
  return good ? 0 : 1;
}
