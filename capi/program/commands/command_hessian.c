/* hardsphere hessian: second derivatives of a surface energy by all coordinates, as a sparse matrix. */
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/radius_window.h"
#include "commands/second_derivatives.h"
#include "read/number.h"
#include "read/weights.h"
#include "write/report.h"

/* All that is printed. */
struct findings {
  const struct request *request;
  struct second_derivatives rows;
  uint32_t *one_sided, *singular; /* balls with these flags */
  uint32_t one_sided_count, singular_count;
};

static double factor_of(double given) {
  return is_finite(given) ? given : 0.0;
}

bool check_hessian(struct request *request, struct failure *failure) {
  const bool of_area = is_finite(request->hessian.tension);
  if (!of_area && !is_finite(request->hessian.pressure)) {
    return failure_in_usage(failure, "hessian needs --tension T or --pressure P; see hardsphere hessian --help");
  }
  const char *const lone = request->window > 0.0 ? "--window" : request->weights != NULL ? "--weights" : NULL;
  return of_area || lone == NULL || failure_in_usage(failure, "%s is of areas: it needs --tension", lone);
}

static void print(struct record *record, const void *of) {
  const struct findings *const found = of;
  const struct request *const request = found->request;
  const struct second_derivatives *const rows = &found->rows;
  const uint32_t atoms = rows->first == NULL ? 0 : record->molecule->atoms;
  const uint32_t entries = rows->first == NULL ? 0 : rows->first[atoms];
  record_atoms(record);
  record_number(record, "tension", NULL, factor_of(request->hessian.tension), 0, "");
  record_number(record, "pressure", NULL, factor_of(request->hessian.pressure), 0, "");
  record_number(record, "window", NULL, request->window, 0, "");
  record_counts(record, "one_sided", found->one_sided, found->one_sided_count);
  record_counts(record, "singular", found->singular, found->singular_count);
  record_counts(record, "first", rows->first, rows->first == NULL ? 0 : atoms + 1);
  record_counts(record, "ball", rows->ball, entries);
  if (!record_key(record, "block")) return;
  text_buffer_add_text(record->out, "[");
  for (size_t k = 0; k < entries; ++k) {
    if (k > 0) text_buffer_add_text(record->out, ", ");
    json_numbers(record->out, rows->block + 9 * k, 9);
  }
  text_buffer_add_text(record->out, "]");
}

/* Add the heading of all tables, as comments. */
static void add_heading(const struct request *request, const struct molecule *molecule, struct text_buffer *out) {
  struct text_buffer heading = TEXT_BUFFER_EMPTY;
  report_heading(&heading, request, molecule);
  out->out_of_memory = out->out_of_memory || heading.out_of_memory;
  for (const char *line = heading.text; line != NULL && line[0] != '\0'; line += strcspn(line, "\n") + 1) {
    const size_t length = strcspn(line, "\n");
    if (length == 0) continue;
    text_buffer_add_text(out, "% ");
    text_buffer_append(out, line, length + 1);
  }
  text_buffer_free(&heading);
}

static void add_remarks(const struct findings *found, const struct molecule *molecule, struct text_buffer *out) {
  const struct request *const request = found->request;
  text_buffer_add_text(out, "% second derivatives of ");
  text_buffer_add_exact(out, factor_of(request->hessian.tension));
  text_buffer_add(out, " x %sarea + ", request->weights != NULL ? "weighted " : "");
  text_buffer_add_exact(out, factor_of(request->hessian.pressure));
  text_buffer_add(out, " x volume by x, y and z of one ball after the other, lengths in %s\n", molecule->format->unit);
  if (request->window > 0.0) {
    text_buffer_add_text(out, "% the area is its mean over a window of radii, to either side by ");
    text_buffer_add_exact(out, request->window);
    text_buffer_add_text(out, request->weights != NULL ? " x weight\n" : "\n");
  }
  if (found->one_sided_count > 0) {
    text_buffer_add(out, "%% touching balls %lu: their derivatives are one-sided, as if touching balls overlapped\n",
                    (unsigned long)found->one_sided_count);
  }
  if (found->singular_count > 0) {
    text_buffer_add(out,
                    "%% singular balls %lu: a vertex lies in the plane of three centres, where areas have no second "
                    "derivatives\n",
                    (unsigned long)found->singular_count);
  }
}

/* The lower triangle, row by row. */
static void add_matrix(const struct second_derivatives *rows, uint32_t atoms, struct text_buffer *out) {
  uint64_t numbers = 0;
  for (uint32_t i = 0; i < atoms; ++i) {
    for (uint32_t k = rows->first[i]; k < rows->first[i + 1]; ++k) {
      numbers += rows->ball[k] < i ? 9 : rows->ball[k] == i ? 6 : 0;
    }
  }
  for (int k = 0; k < 2; ++k) {
    text_buffer_add_count(out, 3 * (uint64_t)atoms);
    text_buffer_add_character(out, ' ');
  }
  text_buffer_add_count(out, numbers);
  text_buffer_add_character(out, '\n');
  for (uint32_t i = 0; i < atoms; ++i) {
    for (uint64_t p = 0; p < 3; ++p) {
      for (uint32_t k = rows->first[i]; k < rows->first[i + 1] && rows->ball[k] <= i; ++k) {
        for (uint64_t q = 0; q < (rows->ball[k] == i ? p + 1 : 3); ++q) {
          text_buffer_add_count(out, 3 * (uint64_t)i + p + 1);
          text_buffer_add_character(out, ' ');
          text_buffer_add_count(out, 3 * (uint64_t)rows->ball[k] + q + 1);
          text_buffer_add_character(out, ' ');
          text_buffer_add_exact(out, rows->block[9 * (size_t)k + 3 * p + q]);
          text_buffer_add_character(out, '\n');
        }
      }
    }
  }
}

struct side_of_window {
  struct second_derivatives *rows;
  uint32_t atoms;
  double tension;
};

static bool add_side(void *of, const struct geometry *side, double factor, struct failure *failure) {
  const struct side_of_window *const window = of;
  const hsp_gradient_request request = {.struct_size = sizeof request, .pressure = factor * window->tension};
  return second_derivatives_add(window->rows, side, window->atoms, &request, failure);
}

static bool find_rows(const struct request *request, const struct molecule *molecule, const double *weights,
                      struct geometry *geometry, struct second_derivatives *rows, struct failure *failure) {
  const bool windowed = request->window > 0.0;
  const double tension = factor_of(request->hessian.tension), pressure = factor_of(request->hessian.pressure);
  if (!windowed || pressure != 0.0) {
    const hsp_gradient_request whole = {
        .struct_size = sizeof whole, .tension = windowed ? 0.0 : tension, .pressure = pressure, .sigma = weights};
    if (!geometry_compute_boundary(geometry, failure)) return false;
    progress_show(&geometry->progress, "computing derivatives");
    if (!second_derivatives_add(rows, geometry, molecule->atoms, &whole, failure)) return false;
  }
  if (!windowed) return true;
  const struct radius_window window = {request->probe, request->window, weights};
  struct side_of_window side = {rows, molecule->atoms, tension};
  return radius_window_for_each_side(&window, molecule, geometry, add_side, &side, failure);
}

static bool are_finite(const struct second_derivatives *rows, uint32_t atoms, struct failure *failure) {
  for (size_t k = 0; k < 9 * (size_t)rows->first[atoms]; ++k) {
    if (!is_finite(rows->block[k])) {
      return failure_in_input(failure, 0, "second derivatives are too large for a number: take smaller factors");
    }
  }
  return true;
}

/* The balls that have a flag, ascending. */
static uint32_t list_flagged(const struct second_derivatives *rows, uint32_t atoms, uint32_t flag, uint32_t *list) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < atoms; ++i) {
    if ((rows->flags[i] & flag) != 0) list[count++] = i;
  }
  return count;
}

void describe_hessian(const struct request *request, struct record *record) {
  const struct findings none = {.request = request};
  print(record, &none);
}

bool command_hessian(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct text_buffer *out, struct failure *failure) {
  struct findings found = {.request = request};
  const uint32_t atoms = molecule->atoms;
  double *weights = NULL;
  uint32_t *const lists = malloc((2 * (size_t)atoms + 1) * sizeof *lists);
  bool done = lists != NULL || failure_of_memory(failure);
  done = done && (request->weights == NULL || weights_read(request->weights, "weight", atoms, &weights, failure)) &&
         find_rows(request, molecule, weights, geometry, &found.rows, failure) &&
         are_finite(&found.rows, atoms, failure);
  if (done) {
    found.one_sided = lists;
    found.singular = lists + atoms;
    found.one_sided_count = list_flagged(&found.rows, atoms, HSP_GRADIENT_ONE_SIDED, found.one_sided);
    found.singular_count = list_flagged(&found.rows, atoms, HSP_HESSIAN_SINGULAR, found.singular);
    progress_show(&geometry->progress, "making the table");
    if (request->json) {
      report(request, molecule, print, &found, out);
    } else {
      text_buffer_add_text(out, "%%MatrixMarket matrix coordinate real symmetric\n");
      add_heading(request, molecule, out);
      add_remarks(&found, molecule, out);
      add_matrix(&found.rows, atoms, out);
    }
  }
  second_derivatives_free(&found.rows);
  free(weights);
  free(lists);
  return done;
}
