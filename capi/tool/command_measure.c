/* hardsphere measure: area and volume of the union, and the free area of every ball. */
#include <inttypes.h>
#include <stdlib.h>

#include "commands.h"
#include "report.h"

/* Of totals, which are accurate to 1e-13 of their size for molecules; single balls are shown with four. */
enum { TOTAL_DECIMALS = 10 };

static void print_json(const struct molecule *molecule, const hsp_totals *totals, const double *area,
                       struct text_buffer *out) {
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"area\": ", molecule->atoms);
  json_number(out, totals->area);
  text_buffer_add(out, ", \"volume\": ");
  json_number(out, totals->volume);
  if (area != NULL) {
    text_buffer_add(out, ", \"balls\": [");
    for (uint32_t i = 0; i < molecule->atoms; ++i) {
      text_buffer_add(out, "%s{\"area\": ", i == 0 ? "" : ", ");
      json_number(out, area[i]);
      text_buffer_add(out, "}");
    }
    text_buffer_add(out, "]");
  }
  text_buffer_add(out, "}\n");
}

static void print_balls(const struct request *request, const struct molecule *molecule, const double *area,
                        struct text_buffer *out) {
  const double four_pi = 12.566370614359172;
  const struct ball_columns columns = ball_columns_of(molecule);
  text_buffer_add(out, "\n");
  report_ball_titles(out, columns);
  text_buffer_add(out, "  %14s  %8s\n", "free area", "free");
  for (uint32_t i = 0; i < molecule->atoms; ++i) {
    char value[NUMBER_BYTES];
    const double radius = molecule->radius[i] + request->probe;
    const double whole = four_pi * radius * radius;
    report_ball(out, columns, molecule, i);
    text_buffer_add(out, "  %14s", grouped_number(value, area[i], 4));
    if (whole > 0.0) {
      text_buffer_add(out, "  %6.1f %%\n", 100.0 * (area[i] / whole));
    } else {
      text_buffer_add(out, "  %8s\n", "-");
    }
  }
}

static void print_table(const struct request *request, const struct molecule *molecule, const hsp_totals *totals,
                        const double *area, struct text_buffer *out) {
  const char *unit = format_unit(molecule->format);
  char value[NUMBER_BYTES];
  report_heading(out, request, molecule);
  text_buffer_add(out, "  %-16s %s %s^2\n", "area", grouped_number(value, totals->area, TOTAL_DECIMALS), unit);
  text_buffer_add(out, "  %-16s %s %s^3\n", "volume", grouped_number(value, totals->volume, TOTAL_DECIMALS), unit);
  if (area != NULL && molecule->atoms > 0) print_balls(request, molecule, area, out);
}

bool command_measure(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_boundary(geometry, molecule, failure)) return false;
  double *area = NULL;
  if (request->per_ball) {
    area = malloc(((size_t)molecule->atoms + 1) * sizeof *area);
    if (area == NULL) return failure_of_memory(failure);
  }
  hsp_totals totals;
  const int32_t status =
      hsp_boundary_measure(geometry->boundary, &totals, area, NULL, area == NULL ? 0 : molecule->atoms);
  if (status != HSP_OK) {
    failure_in_library(failure, status);
  } else if (request->json) {
    print_json(molecule, &totals, area, out);
  } else {
    print_table(request, molecule, &totals, area, out);
  }
  free(area);
  return status == HSP_OK;
}
