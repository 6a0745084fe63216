#include "draw/mesh_creases.h"

#include <math.h>
#include <stdlib.h>

#include "read/growing_array.h"

/* A line is moved aside at its ends, along this length in widths. */
static const double taper = 6.0;

void creases_add(struct creases *creases, const struct crease *crease) {
  creases->out_of_memory = creases->out_of_memory ||
                           !array_append(&creases->crease, &creases->count, &creases->room, crease, sizeof *crease);
}

void creases_free(struct creases *creases) {
  free(creases->crease);
}

/* Ends have numbers: the ends of crease i are 2 i and 2 i + 1. */
struct chains {
  struct crease *crease;
  size_t ends;
  size_t *next; /* [ends], the end there of the only other crease between the same patches; else NOTHING */
  double *way;  /* [ends], the distance to the beginning of a contour, or to the end of a line */
  bool *above;  /* [ends], whether the edge of the area is on the other side of the crease there */
};

#define NOTHING SIZE_MAX

struct place {
  uint32_t vertex, patch[2];
  size_t end;
};

static int compare_places(const struct place *a, const struct place *b) {
  if (a->vertex != b->vertex) return a->vertex < b->vertex ? -1 : 1;
  if (a->patch[0] != b->patch[0]) return a->patch[0] < b->patch[0] ? -1 : 1;
  return (a->patch[1] > b->patch[1]) - (a->patch[1] < b->patch[1]);
}

static int compare(const void *left, const void *right) {
  const struct place *a = left;
  const struct place *b = right;
  const int order = compare_places(a, b);
  return order != 0 ? order : (a->end > b->end) - (a->end < b->end);
}

static bool find_next(const struct chains *chains) {
  struct place *const place = calloc(chains->ends + 1, sizeof *place);
  if (place == NULL) return false;
  for (size_t i = 0; i < chains->ends; ++i) {
    const struct crease *const crease = &chains->crease[i / 2];
    place[i] = (struct place){crease->vertex[i % 2], {crease->patch[0], crease->patch[1]}, i};
    chains->next[i] = NOTHING;
  }
  qsort(place, chains->ends, sizeof *place, compare);
  for (size_t i = 0, behind = 0; i < chains->ends; i = behind) {
    for (behind = i + 1; behind < chains->ends && compare_places(&place[i], &place[behind]) == 0;) ++behind;
    if (behind - i != 2) continue;
    chains->next[place[i].end] = place[i + 1].end;
    chains->next[place[i + 1].end] = place[i].end;
  }
  free(place);
  return true;
}

static double length_of(const struct crease *crease) {
  const double x = crease->at[1][0] - crease->at[0][0], y = crease->at[1][1] - crease->at[0][1];
  return sqrt(x * x + y * y);
}

/* The patch of the contour at an end, 0 or 1, or -1 if there is none. */
static int nearer_at(const struct chains *chains, size_t end, const uint32_t *nearer) {
  const struct crease *const crease = &chains->crease[end / 2];
  const uint32_t patch = nearer[crease->vertex[end % 2]];
  return patch == NO_PATCH ? -1 : patch == crease->patch[0] ? 0 : patch == crease->patch[1] ? 1 : -1;
}

static void choose(const struct chains *chains, const uint32_t *nearer, const uint64_t *points) {
  for (size_t end = 0; end < chains->ends; ++end) {
    struct crease *const crease = &chains->crease[end / 2];
    if (!crease->known) crease->over = points[crease->patch[1]] > points[crease->patch[0]] ? 1 : 0;
    chains->way[end] = INFINITY;
  }
  for (size_t begin = 0; begin < chains->ends; ++begin) {
    const int over = nearer_at(chains, begin, nearer);
    double length = 0.0;
    for (size_t end = begin; over >= 0 && end != NOTHING; end = chains->next[end ^ 1]) {
      struct crease *const crease = &chains->crease[end / 2];
      const double middle = length + length_of(crease) / 2.0;
      if (middle >= chains->way[end / 2]) break;
      chains->way[end / 2] = middle;
      if (!crease->known) crease->over = over;
      length += length_of(crease);
    }
  }
}

static bool goes_on(const struct chains *chains, size_t end) {
  const size_t next = chains->next[end];
  return next != NOTHING && chains->crease[next / 2].over == chains->crease[end / 2].over;
}

static void set_way(const struct chains *chains, size_t end, double way, bool above) {
  if (way >= chains->way[end]) return;
  chains->way[end] = way;
  chains->above[end] = above;
}

/* Find for each end of a crease the distance to the end of its line, as far as it is less than `longest`. */
static void find_ways(const struct chains *chains, const uint32_t *nearer, double longest) {
  for (size_t end = 0; end < chains->ends; ++end) chains->way[end] = INFINITY;
  for (size_t begin = 0; begin < chains->ends; ++begin) {
    const struct crease *const first = &chains->crease[begin / 2];
    if (goes_on(chains, begin) || nearer_at(chains, begin, nearer) == first->over) continue;
    const bool above = first->painted == first->over;
    double length = 0.0;
    for (size_t end = begin;; end = chains->next[end ^ 1]) {
      set_way(chains, end, length, above);
      length += length_of(&chains->crease[end / 2]);
      set_way(chains, end ^ 1, length, above);
      if (length >= longest || !goes_on(chains, end ^ 1)) break;
    }
  }
}

/* The direction from a crease to its first patch at an end: a unit vector, the mean for the edges that meet there. */
static void find_aside(const struct chains *chains, size_t end, double aside[2]) {
  const size_t next = goes_on(chains, end) ? chains->next[end] : end;
  double sum[2] = {0.0, 0.0};
  for (int k = 0; k < 2; ++k) {
    const struct crease *const crease = &chains->crease[(k == 0 ? end : next) / 2];
    const double length = length_of(crease);
    if (!(length > 0.0)) continue;
    sum[0] += (crease->at[1][1] - crease->at[0][1]) / length;
    sum[1] -= (crease->at[1][0] - crease->at[0][0]) / length;
  }
  const double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1]);
  for (int axis = 0; axis < 2; ++axis) aside[axis] = length > 0.0 ? sum[axis] / length : 0.0;
}

static void set_lines(const struct chains *chains, const double width[2]) {
  for (size_t end = 0; end < chains->ends; ++end) {
    struct crease *const crease = &chains->crease[end / 2];
    const double share = fmax(1.0 - chains->way[end] / (taper * width[0]), 0.0);
    const double least = crease->known ? (width[0] - width[1]) / 2.0 : 0.0;
    const double most = (width[0] - (chains->above[end] ? width[1] : -width[1])) / 2.0;
    const double by = (crease->over == 0 ? 1.0 : -1.0) * (least + share * (most - least));
    double aside[2];
    find_aside(chains, end, aside);
    for (int axis = 0; axis < 2; ++axis) {
      crease->line[end % 2][axis] = crease->at[end % 2][axis] + by * aside[axis];
    }
  }
}

bool creases_choose(struct creases *creases, const uint32_t *nearer, const uint64_t *points, const double width[2]) {
  const size_t ends = 2 * creases->count;
  const struct chains chains = {creases->crease, ends, calloc(ends + 1, sizeof *chains.next),
                                calloc(ends + 1, sizeof *chains.way), calloc(ends + 1, sizeof *chains.above)};
  const bool enough = chains.next != NULL && chains.way != NULL && chains.above != NULL && !creases->out_of_memory &&
                      find_next(&chains);
  if (enough) {
    choose(&chains, nearer, points);
    find_ways(&chains, nearer, taper * width[0]);
    set_lines(&chains, width);
  }
  free(chains.next);
  free(chains.way);
  free(chains.above);
  return enough;
}
