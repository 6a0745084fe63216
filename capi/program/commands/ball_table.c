#include "commands/ball_table.h"

#include "read/number.h"
#include "write/ball_label.h"
#include "write/csv.h"
#include "write/report.h"

/* The derivatives that there may be, in the order of the keys and columns. In tables each takes the four columns of
 * x, y, z and r instead. */
enum derivative_kind { BY_CENTRE, BY_RADIUS };
enum { DERIVATIVES = 6, QUANTITIES = 3, DERIVATIVE_WIDTH = 15 };

struct derivative {
  const char *quantity;
  enum derivative_kind kind;
  const double *values; /* NULL: not asked for */
};

static void list_derivatives(const struct measurement *measurement, struct derivative list[DERIVATIVES]) {
  list[0] = (struct derivative){"area", BY_CENTRE, measurement->of_area.centre};
  list[1] = (struct derivative){"volume", BY_CENTRE, measurement->of_volume.centre};
  list[2] = (struct derivative){"area", BY_RADIUS, measurement->of_area.radius};
  list[3] = (struct derivative){"volume", BY_RADIUS, measurement->of_volume.radius};
  list[4] = (struct derivative){"weighted", BY_CENTRE, measurement->of_weighted_area.centre};
  list[5] = (struct derivative){"weighted", BY_RADIUS, measurement->of_weighted_area.radius};
}

static void list_gradients(const struct measurement *measurement, const struct gradient *list[QUANTITIES]) {
  list[0] = &measurement->of_area;
  list[1] = &measurement->of_volume;
  list[2] = &measurement->of_weighted_area;
}

static void print_titles(const struct gradient *const gradients[QUANTITIES], struct text_buffer *out) {
  static const char *const titles[QUANTITIES][4] = {
      {"dA/dx", "dA/dy", "dA/dz", "dA/dr"}, {"dV/dx", "dV/dy", "dV/dz", "dV/dr"}, {"dW/dx", "dW/dy", "dW/dz", "dW/dr"}};
  for (int i = 0; i < QUANTITIES; ++i) {
    for (int k = 0; k < 4 && gradients[i]->centre != NULL; ++k) {
      text_buffer_add(out, "  %*s", DERIVATIVE_WIDTH, titles[i][k]);
    }
  }
  text_buffer_add(out, "\n");
}

static double magnitude(double value) {
  return value < 0.0 ? -value : value;
}

/* Columns are easier to compare if all their numbers are written alike: with six decimals, unless the largest of a
 * gradient would not fit or would hardly show. */
static bool suits_decimals(const struct gradient *gradient, uint32_t atoms) {
  double largest = 0.0;
  for (size_t i = 0; i < 3 * (size_t)atoms; ++i) {
    if (magnitude(gradient->centre[i]) > largest) largest = magnitude(gradient->centre[i]);
  }
  for (size_t i = 0; i < atoms; ++i) {
    if (magnitude(gradient->radius[i]) > largest) largest = magnitude(gradient->radius[i]);
  }
  return largest == 0.0 || (largest >= 1e-2 && largest < 1e7);
}

static void print_derivative(double value, bool with_decimals, struct text_buffer *out) {
  if (!is_finite(value)) {
    text_buffer_add(out, "  %*s", DERIVATIVE_WIDTH, "-");
  } else if (with_decimals) {
    text_buffer_add(out, "  %*.6f", DERIVATIVE_WIDTH, magnitude(value) < 5e-7 ? 0.0 : value); /* no "-0.000000" */
  } else {
    text_buffer_add(out, "  %*.8e", DERIVATIVE_WIDTH, value + 0.0);
  }
}

static void print_derivatives(const struct gradient *const gradients[QUANTITIES], const bool with_decimals[QUANTITIES],
                              uint32_t ball, struct text_buffer *out) {
  for (int i = 0; i < QUANTITIES; ++i) {
    if (gradients[i]->centre == NULL) continue;
    for (size_t axis = 0; axis < 3; ++axis) {
      print_derivative(gradients[i]->centre[3 * (size_t)ball + axis], with_decimals[i], out);
    }
    print_derivative(gradients[i]->radius[ball], with_decimals[i], out);
  }
  text_buffer_add(out, "\n");
}

static void print_free_part(double area, double radius, struct text_buffer *out) {
  const double four_pi = 12.566370614359172;
  const double whole = four_pi * radius * radius;
  if (whole > 0.0) {
    text_buffer_add(out, "  %6.1f %%", 100.0 * (area / whole));
  } else {
    text_buffer_add(out, "  %8s", "-");
  }
}

void ball_table_print(const struct request *request, const struct molecule *molecule,
                      const struct measurement *measurement, struct text_buffer *out) {
  const struct gradient *gradients[QUANTITIES];
  bool with_decimals[QUANTITIES];
  list_gradients(measurement, gradients);
  for (int i = 0; i < QUANTITIES; ++i) {
    with_decimals[i] = gradients[i]->centre != NULL && suits_decimals(gradients[i], molecule->atoms);
  }
  const struct ball_columns columns = ball_columns_of(molecule);
  text_buffer_add(out, "\n");
  report_ball_titles(out, columns);
  text_buffer_add(out, "  %14s  %8s", "free area", "free");
  print_titles(gradients, out);
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    char value[NUMBER_BYTES];
    report_ball(out, columns, molecule, i);
    text_buffer_add(out, "  %14s", column_text(value, molecule->format, measurement->area[i], 4));
    print_free_part(measurement->area[i], molecule->radius[i] + request->probe, out);
    print_derivatives(gradients, with_decimals, i, out);
  }
}

void ball_table_json(const struct molecule *molecule, const struct measurement *measurement, struct text_buffer *out) {
  struct derivative derivatives[DERIVATIVES];
  list_derivatives(measurement, derivatives);
  text_buffer_add(out, "[");
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    text_buffer_add(out, "%s{", i == 0 ? "" : ", ");
    ball_label_json(molecule, i, out);
    text_buffer_add(out, ", \"area\": ");
    json_number(out, measurement->area[i]);
    if (measurement->weights != NULL) {
      text_buffer_add(out, ", \"weight\": ");
      json_number(out, measurement->weights[i]);
    }
    for (const struct derivative *of = derivatives; of != derivatives + DERIVATIVES; ++of) {
      if (of->values == NULL) continue;
      text_buffer_add(out, ", \"%s_%s\": ", of->quantity, of->kind == BY_CENTRE ? "gradient" : "dr");
      if (of->kind == BY_CENTRE) {
        json_vector(out, of->values + 3 * (size_t)i);
      } else {
        json_number(out, of->values[i]);
      }
    }
    text_buffer_add(out, "}");
  }
  text_buffer_add(out, "]");
}

static void csv_header(const struct file_format *format, const struct derivative derivatives[DERIVATIVES], bool weights,
                       struct text_buffer *out) {
  ball_label_csv_titles(format, "", out);
  text_buffer_add(out, ",x,y,z,radius,area");
  if (weights) text_buffer_add(out, ",weight");
  for (const struct derivative *of = derivatives; of != derivatives + DERIVATIVES; ++of) {
    const char *name = of->quantity;
    if (of->values == NULL) continue;
    if (of->kind == BY_CENTRE) {
      text_buffer_add(out, ",%s_gradient_x,%s_gradient_y,%s_gradient_z", name, name, name);
    } else {
      text_buffer_add(out, ",%s_dr", name);
    }
  }
  text_buffer_add(out, "\n");
}

void ball_table_csv(const struct molecule *molecule, const struct measurement *measurement, struct text_buffer *out) {
  struct derivative derivatives[DERIVATIVES];
  list_derivatives(measurement, derivatives);
  csv_header(molecule->format, derivatives, measurement->weights != NULL, out);
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    ball_label_csv(molecule, i, out);
    csv_numbers(out, molecule->xyz + 3 * (size_t)i, 3);
    csv_numbers(out, &molecule->radius[i], 1);
    csv_numbers(out, &measurement->area[i], 1);
    if (measurement->weights != NULL) csv_numbers(out, &measurement->weights[i], 1);
    for (const struct derivative *of = derivatives; of != derivatives + DERIVATIVES; ++of) {
      if (of->values == NULL) continue;
      const int count = of->kind == BY_CENTRE ? 3 : 1;
      csv_numbers(out, of->values + (size_t)count * i, count);
    }
    text_buffer_add(out, "\n");
  }
}
