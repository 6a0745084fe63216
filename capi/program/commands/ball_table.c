#include "commands/ball_table.h"

#include <math.h>
#include <string.h>

static double magnitude(double value) {
  return value < 0.0 ? -value : value;
}

/* Columns are easier to compare if all their numbers are written alike: with six decimals, unless the largest of a
 * gradient would not fit or would hardly show; then in powers of ten. */
static int decimals_of(const struct gradient *gradient, uint32_t atoms) {
  double largest = 0.0;
  for (size_t i = 0; i < 3 * (size_t)atoms; ++i) {
    if (magnitude(gradient->centre[i]) > largest) largest = magnitude(gradient->centre[i]);
  }
  for (size_t i = 0; i < atoms; ++i) {
    if (magnitude(gradient->radius[i]) > largest) largest = magnitude(gradient->radius[i]);
  }
  return largest == 0.0 || (largest >= 1e-2 && largest < 1e7) ? 6 : -8;
}

static void add(struct ball_table *made, struct column column, const double *values) {
  const int k = made->table.count++;
  made->columns[k] = column;
  made->values[k] = values;
}

/* Columns of derivatives: for programs ordered by the kind of the derivative, for persons by the quantity. */
static void add_derivatives(struct ball_table *made, const struct measurement *measurement) {
  static const char *const gradients[] = {"area_gradient", "volume_gradient", "weighted_gradient", "windowed_gradient"};
  static const char *const by_radius[] = {"area_dr", "volume_dr", "weighted_dr", "windowed_dr"};
  static const char *const titles[] = {"dA/dx dA/dy dA/dz", "dV/dx dV/dy dV/dz", "dW/dx dW/dy dW/dz",
                                       "dM/dx dM/dy dM/dz"};
  static const char *const titles_by_radius[] = {"dA/dr", "dV/dr", "dW/dr", "dM/dr"};
  enum { WIDTH = 15, QUANTITIES = 4 };
  const struct gradient *const of[QUANTITIES] = {&measurement->of_area, &measurement->of_volume,
                                                 &measurement->of_weighted_area, &measurement->of_windowed_area};
  for (int first = 0; first < QUANTITIES; first += 2) {
    const int behind = first + 2 < QUANTITIES ? first + 2 : QUANTITIES;
    for (int k = first; k < behind; ++k) {
      const struct column column = {gradients[k], NULL, NULL, 0, COLUMN_GRADIENT, 0};
      if (of[k]->centre != NULL) add(made, column, of[k]->centre);
    }
    for (int k = first; k < behind; ++k) {
      const struct column column = {by_radius[k], NULL, NULL, 0, COLUMN_DERIVATIVE, 0};
      if (of[k]->radius != NULL) add(made, column, of[k]->radius);
    }
  }
  for (int k = 0; k < QUANTITIES; ++k) {
    if (of[k]->centre == NULL) continue;
    const int decimals = decimals_of(of[k], made->rows.molecule->atoms);
    add(made, (struct column){NULL, NULL, titles[k], WIDTH, COLUMN_GRADIENT, decimals}, of[k]->centre);
    add(made, (struct column){NULL, NULL, titles_by_radius[k], WIDTH, COLUMN_DERIVATIVE, decimals}, of[k]->radius);
  }
}

static double free_share(const struct ball_table *made, size_t ball) {
  const double four_pi = 12.566370614359172;
  const double radius = made->rows.molecule->radius[ball] + made->probe;
  const double whole = four_pi * radius * radius;
  return whole > 0.0 ? 100.0 * (made->area[ball] / whole) : (double)NAN;
}

static bool row_of(const void *of, size_t row, union cell cells[MOST_COLUMNS], char text[CELL_BYTES]) {
  const struct ball_table *const made = of;
  (void)text;
  const bool blocks = made->part != NULL && made->part[row] == 0;
  if (blocks && !made->lists_blocking) return false;
  for (int k = 0; k < made->table.count; ++k) {
    const enum column_kind kind = made->columns[k].kind;
    if (kind == COLUMN_POINT || kind == COLUMN_GRADIENT) {
      cells[k].vector = made->values[k] + 3 * row;
    } else if (blocks && (kind == COLUMN_SHARE || made->values[k] == made->area || made->values[k] == made->weight)) {
      cells[k].quantity = (double)NAN;
    } else {
      cells[k].quantity = kind == COLUMN_SHARE ? free_share(made, row) : made->values[k][row];
    }
  }
  return true;
}

void ball_table_make(const struct molecule *molecule, const struct measurement *measurement, double probe,
                     struct ball_table *made) {
  memset(made, 0, sizeof *made);
  made->rows = ball_rows_of(molecule, NULL);
  made->area = measurement->area;
  made->weight = measurement->weights;
  made->part = measurement->part;
  /* They change the area of a part, too, if they move. */
  made->lists_blocking = measurement->of_area.centre != NULL;
  made->probe = probe;
  made->table = (struct table){made->columns, 0, molecule->format, molecule->atoms, made, row_of, ball_rows_lead};
  /* Only in CSV: in JSON the ball has its centre. */
  add(made, (struct column){NULL, "x,y,z", NULL, 0, COLUMN_POINT, 0}, molecule->xyz);
  add(made, (struct column){NULL, "radius", NULL, 0, COLUMN_QUANTITY, 0}, molecule->radius);
  add(made, (struct column){"area", NULL, "free area", 14, COLUMN_QUANTITY, 4}, measurement->area);
  add(made, (struct column){NULL, NULL, "free", 8, COLUMN_SHARE, 1}, NULL);
  if (measurement->weights != NULL) {
    add(made, (struct column){"weight", NULL, NULL, 0, COLUMN_QUANTITY, 0}, measurement->weights);
  }
  add_derivatives(made, measurement);
}
