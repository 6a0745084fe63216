/* hardsphere measure: area and volume of the union, and what single balls, residues and chains have of it. */
#include <inttypes.h>
#include <string.h>

#include "commands/ball_table.h"
#include "commands/commands.h"
#include "commands/group_table.h"
#include "commands/input_report.h"
#include "commands/interface.h"
#include "commands/measurement.h"
#include "write/csv.h"
#include "write/output_file.h"
#include "write/pdb_output.h"
#include "write/report.h"
#include "write/table.h"

/* Of totals, which are accurate to 1e-13 of their size for molecules; single balls are shown with four. */
enum { TOTAL_DECIMALS = 10 };

/* All that is printed. */
struct findings {
  struct measurement measurement;
  struct atom_groups groups;
  struct interface interface;
};

static void interface_json(const struct interface *interface, struct text_buffer *out) {
  text_buffer_add(out, ", \"interface\": {\"groups\": [");
  for (int i = 0; i < 2; ++i) {
    const struct interface_side *side = &interface->side[i];
    text_buffer_add(out, "%s{\"atoms\": %" PRIu32 ", \"alone\": ", i == 0 ? "" : ", ", side->atoms);
    json_number(out, side->alone);
    text_buffer_add(out, ", \"together\": ");
    json_number(out, side->together);
    text_buffer_add(out, "}");
  }
  text_buffer_add(out, "], \"together\": ");
  json_number(out, interface->together);
  text_buffer_add(out, ", \"buried\": ");
  json_number(out, interface->buried);
  text_buffer_add(out, "}");
}

static void interface_line(const struct file_format *format, const char *name, uint32_t atoms, double alone,
                           double together, struct text_buffer *out) {
  char values[3][NUMBER_BYTES];
  text_buffer_add(out, "  %-8s  %9" PRIu32 "  %16s  %16s  %16s\n", name, atoms,
                  column_text(values[0], format, alone, 4), column_text(values[1], format, together, 4),
                  column_text(values[2], format, alone - together, 4));
}

static void interface_print(const char *text, const struct interface *interface, const struct file_format *format,
                            struct text_buffer *out) {
  const struct interface_side *side = interface->side;
  text_buffer_add(
      out, "\ninterface of the chains %s: areas in %s^2, of each group alone and of both without anything else\n\n",
      text, format->unit);
  text_buffer_add(out, "  %-8s  %9s  %16s  %16s  %16s\n", "group", "atoms", "alone", "together", "buried");
  interface_line(format, "first", side[0].atoms, side[0].alone, side[0].together, out);
  interface_line(format, "second", side[1].atoms, side[1].alone, side[1].together, out);
  interface_line(format, "both", side[0].atoms + side[1].atoms, side[0].alone + side[1].alone, interface->together,
                 out);
}

/* The numbers of the whole, those before the periodic box first. */
enum { MOST_TOTALS = 16, BEFORE_BOX = 2 };
static size_t list_totals(const struct request *request, const struct findings *found,
                          struct result list[MOST_TOTALS]) {
  const struct measurement *of = &found->measurement;
  size_t count = 0;
  list[count++] = (struct result){"area", "area", of->totals.area, TOTAL_DECIMALS, "@^2"};
  list[count++] = (struct result){"volume", "volume", of->totals.volume, TOTAL_DECIMALS, "@^3"};
  if (request->curvature) {
    list[count++] = (struct result){"mean_curvature", "mean curvature", of->curvatures.mean, TOTAL_DECIMALS,
                                    "@, integrated over the boundary"};
    list[count++] = (struct result){"gauss_curvature", "gauss curvature", of->curvatures.gauss, TOTAL_DECIMALS,
                                    ", 2 pi times its Euler characteristic"};
  }
  if (request->excluded_surface) {
    list[count++] = (struct result){"convex_area", "convex area", of->surface.convex_area, TOTAL_DECIMALS,
                                    "@^2, where the probe touches one atom"};
    list[count++] = (struct result){"saddle_area", "saddle area", of->surface.saddle_area, TOTAL_DECIMALS,
                                    "@^2, where it touches two"};
    list[count++] = (struct result){"concave_area", "concave area", of->surface.concave_area, TOTAL_DECIMALS,
                                    "@^2, where it touches three"};
  }
  if (of->weights != NULL) {
    list[count++] = (struct result){
        "weighted_area", "weighted area", of->weighted_area, TOTAL_DECIMALS,
        request->excluded_surface ? ", the sum of weight x share of the area" : ", the sum of weight x free area"};
  }
  if (request->polar) {
    list[count++] =
        (struct result){"polar_area", "polar area", of->polar_area, TOTAL_DECIMALS, "@^2, of nitrogen and oxygen"};
    list[count++] = (struct result){"apolar_area", "apolar area", of->apolar_area, TOTAL_DECIMALS,
                                    "@^2, of carbon, sulfur and selenium"};
    list[count++] = (struct result){"other_area", "other area", of->other_area, TOTAL_DECIMALS, "@^2, of all others"};
  }
  return count;
}

/* In a row of a frame what else has single numbers: the box behind the first totals, the interface at the end. */
static void print_frame(const struct request *request, const struct molecule *molecule, const struct findings *found,
                        struct text_buffer *out) {
  const struct periodic_result *box = &found->measurement.box;
  const struct interface *interface = &found->interface;
  struct result row[MOST_TOTALS + 6];
  size_t count = list_totals(request, found, row);
  if (box->periodic != NULL) {
    memmove(row + BEFORE_BOX + 2, row + BEFORE_BOX, (count - BEFORE_BOX) * sizeof *row);
    row[BEFORE_BOX] = (struct result){"box_volume", NULL, box->totals.box_volume, 0, ""};
    row[BEFORE_BOX + 1] = (struct result){"free_volume", NULL, box->totals.free_volume, 0, ""};
    count += 2;
  }
  if (request->interface != NULL) {
    row[count++] = (struct result){"first_alone", NULL, interface->side[0].alone, 0, ""};
    row[count++] = (struct result){"second_alone", NULL, interface->side[1].alone, 0, ""};
    row[count++] = (struct result){"together", NULL, interface->together, 0, ""};
    row[count++] = (struct result){"buried", NULL, interface->buried, 0, ""};
  }
  if (molecule->frame.first) {
    csv_frame_titles(out);
    results_csv_titles(row, count, out);
    text_buffer_add(out, "\n");
  }
  csv_frame(out, molecule);
  results_csv(row, count, out);
  text_buffer_add(out, "\n");
}

static void print_json(const struct request *request, const struct molecule *molecule, const struct findings *found,
                       struct text_buffer *out) {
  const struct measurement *measurement = &found->measurement;
  struct result totals[MOST_TOTALS];
  const size_t count = list_totals(request, found, totals);
  /* What stands between the numbers: the kind of the surface before its areas. */
  const size_t kind = BEFORE_BOX + (request->curvature ? 2 : 0);
  text_buffer_add(out, "{");
  json_frame(out, &molecule->frame);
  text_buffer_add(out, "\"n\": %" PRIu32, molecule->atoms);
  results_json(totals, BEFORE_BOX, out);
  if (measurement->box.periodic != NULL) periodic_result_json(&measurement->box, out);
  results_json(totals + BEFORE_BOX, kind - BEFORE_BOX, out);
  if (request->excluded_surface) {
    text_buffer_add(out, ", \"surface\": \"ses\"%s", request->outer ? ", \"outer\": true" : "");
  }
  results_json(totals + kind, count - kind, out);
  if (request->interface != NULL) interface_json(&found->interface, out);
  if (request_wants_balls(request)) {
    text_buffer_add(out, ", \"balls\": ");
    ball_table_json(molecule, measurement, out);
  }
  if (request->by != GROUPING_NONE) {
    text_buffer_add(out, request->by == GROUPING_RESIDUE ? ", \"residues\": " : ", \"chains\": ");
    group_table_json(molecule, &found->groups, request->relative, out);
  }
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void print_tables(const struct request *request, const struct molecule *molecule, const struct findings *found,
                         struct text_buffer *out) {
  const struct measurement *measurement = &found->measurement;
  const char *unit = molecule->format->unit;
  struct result totals[MOST_TOTALS];
  const size_t count = list_totals(request, found, totals);
  report_heading(out, request, molecule);
  results_print(totals, BEFORE_BOX, 0, unit, out);
  if (measurement->box.periodic != NULL) periodic_result_rows(&measurement->box, unit, out);
  results_print(totals + BEFORE_BOX, count - BEFORE_BOX, 0, unit, out);
  if (measurement->one_sided > 0) {
    if (request->excluded_surface) {
      report_row_count(out, "degenerate balls", measurement->one_sided,
                       "their derivatives are one-sided at best: four spheres meet in a point, or balls are equal");
    } else {
      report_row_count(out, "touching balls", measurement->one_sided,
                       "their derivatives are one-sided: as if touching balls overlapped");
    }
  }
  if (request->interface != NULL) interface_print(request->interface, &found->interface, molecule->format, out);
  if (request_wants_balls(request)) ball_table_print(request, molecule, measurement, out);
  if (request->by != GROUPING_NONE) group_table_print(molecule, &found->groups, request->relative, out);
}

static void print(const struct request *request, const struct molecule *molecule, const struct findings *found,
                  struct text_buffer *out) {
  if (request->json) {
    print_json(request, molecule, found, out);
  } else if (molecule->frame.number > 0) {
    print_frame(request, molecule, found, out);
  } else if (!request->csv) {
    print_tables(request, molecule, found, out);
  } else if (request->by == GROUPING_NONE) {
    ball_table_csv(molecule, &found->measurement, out);
  } else {
    group_table_csv(molecule, &found->groups, request->relative, out);
  }
}

bool command_measure(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct text_buffer *out, struct failure *failure) {
  struct findings found;
  memset(&found, 0, sizeof found);
  bool done = measurement_make(request, molecule, geometry, &found.measurement, failure);
  const double *area = found.measurement.area;
  if (done && request->by != GROUPING_NONE) {
    done = atom_groups_make(molecule, request->by, area, &found.groups, failure);
  }
  if (done && request->interface != NULL) {
    done = interface_measure(request->interface, molecule, request->probe, geometry, &found.interface, failure);
  }
  const bool written_only = request->pdb_out != NULL && output_is_standard(request->pdb_out);
  if (done && request_wants_balls(request)) progress_show(&geometry->progress, "making the table");
  if (done && !written_only) print(request, molecule, &found, out);
  if (done && request->pdb_out != NULL) {
    progress_show(&geometry->progress, "writing");
    done = pdb_output_write(request->file, molecule, area, request->pdb_out, failure);
  }
  atom_groups_free(&found.groups);
  measurement_free(&found.measurement);
  return done;
}
