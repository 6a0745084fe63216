#include "commands/image_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read/number.h"
#include "read/vectors.h"

/* In angstrom. No two atoms are nearer to each other than `shortest`. Places nearer than `same_place` are the same: it
 * is three times the rounding of PDB files, and more than the difference of numbers with many digits by several
 * programs. */
static const double shortest = 0.5, same_place = 0.01;

enum { MOST_CELLS = 1000, MOST_BUCKETS = 1 << 22 };

static int64_t cell_of(double fraction, int64_t cells) {
  const double inside = fraction - floor(fraction);
  const int64_t cell = (int64_t)(inside * (double)cells);
  return cell < cells ? cell : cells - 1; /* inside may be 1 by rounding; NaN and infinity go into any cell */
}

static size_t bucket_of(const struct image_table *table, const int64_t cell[3]) {
  uint64_t hash = 0;
  for (int k = 0; k < 3; ++k) hash = (hash ^ (uint64_t)cell[k]) * UINT64_C(0x9E3779B97F4A7C15);
  return (size_t)(hash >> 32) & (table->buckets - 1);
}

void image_table_error(const struct image_table *table, uint32_t atom, double error[3]) {
  enum { SIMPLE = 2 };
  for (int k = 0; k < 3; ++k) {
    const int decimals = table->molecule->label[atom].decimals[k];
    error[k] = decimals < SIMPLE ? 0.0 : pow(10.0, -decimals);
  }
}

static void add(struct image_table *table, uint32_t atom, const double error[3]) {
  const struct molecule *molecule = table->molecule;
  double fraction[3];
  int64_t cell[3];
  box_fractions(&molecule->frame.box, molecule->xyz + 3 * (size_t)atom, fraction);
  for (int k = 0; k < 3; ++k) cell[k] = is_finite(fraction[k]) ? cell_of(fraction[k], table->cells[k]) : 0;
  const size_t bucket = bucket_of(table, cell);
  memcpy(table->error + 3 * (size_t)atom, error, 3 * sizeof *error);
  table->next[atom] = table->first[bucket];
  table->first[bucket] = atom;
}

bool image_table_begin(struct image_table *table, const struct molecule *molecule, size_t most,
                       struct failure *failure) {
  memset(table, 0, sizeof *table);
  table->molecule = molecule;
  for (int k = 0; k < 3; ++k) {
    const double across = box_distance(&molecule->frame.box, k);
    table->cells[k] = across >= MOST_CELLS ? MOST_CELLS : across >= 1.0 ? (int64_t)across : 1;
  }
  table->buckets = 64;
  while (table->buckets < most && table->buckets < MOST_BUCKETS) table->buckets *= 2;
  table->first = malloc(table->buckets * sizeof *table->first);
  table->next = malloc((most + 1) * sizeof *table->next);
  table->error = malloc((most + 1) * 3 * sizeof *table->error);
  if (table->first == NULL || table->next == NULL || table->error == NULL) return failure_of_memory(failure);
  for (size_t k = 0; k < table->buckets; ++k) table->first[k] = UINT32_MAX;
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    double error[3];
    image_table_error(table, i, error);
    add(table, i, error);
  }
  return true;
}

void image_table_add_last(struct image_table *table, const double error[3]) {
  add(table, table->molecule->atoms - 1, error);
}

static bool coincide(const struct image_table *table, uint32_t atom, const double fraction[3], const double error[3]) {
  const struct box_record *box = &table->molecule->frame.box;
  const double *const own = table->error + 3 * (size_t)atom;
  double apart[3], way[3];
  bool explained = true;
  box_fractions(box, table->molecule->xyz + 3 * (size_t)atom, apart);
  for (int k = 0; k < 3; ++k) {
    apart[k] -= fraction[k];
    apart[k] -= floor(apart[k] + 0.5);
    explained = explained && fabs(apart[k]) <= own[k] + error[k];
  }
  box_point(box, apart, way);
  const double most = explained ? shortest : same_place;
  return dot(way, way) <= most * most;
}

bool image_table_has(const struct image_table *table, const double fraction[3], const double error[3],
                     struct element_symbol element) {
  int64_t middle[3];
  for (int k = 0; k < 3; ++k) {
    if (!is_finite(fraction[k])) return false;
    middle[k] = cell_of(fraction[k], table->cells[k]);
  }
  for (int n = 0; n < 27; ++n) {
    const int64_t step[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
    int64_t cell[3];
    for (int k = 0; k < 3; ++k) cell[k] = (middle[k] + step[k] + table->cells[k]) % table->cells[k];
    for (uint32_t atom = table->first[bucket_of(table, cell)]; atom != UINT32_MAX; atom = table->next[atom]) {
      const bool same = strcmp(table->molecule->label[atom].element.text, element.text) == 0;
      if (same && coincide(table, atom, fraction, error)) return true;
    }
  }
  return false;
}

void image_table_free(struct image_table *table) {
  free(table->first);
  free(table->next);
  free(table->error);
}
