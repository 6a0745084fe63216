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

static void print_json(const struct request *request, const struct molecule *molecule, const struct findings *found,
                       struct text_buffer *out) {
  const struct measurement *measurement = &found->measurement;
  text_buffer_add(out, "{");
  json_frame(out, &molecule->frame);
  text_buffer_add(out, "\"n\": %" PRIu32 ", \"area\": ", molecule->atoms);
  json_number(out, measurement->totals.area);
  text_buffer_add(out, ", \"volume\": ");
  json_number(out, measurement->totals.volume);
  if (measurement->box.periodic != NULL) periodic_result_json(&measurement->box, out);
  if (request->curvature) {
    text_buffer_add(out, ", \"mean_curvature\": ");
    json_number(out, measurement->curvatures.mean);
    text_buffer_add(out, ", \"gauss_curvature\": ");
    json_number(out, measurement->curvatures.gauss);
  }
  if (request->excluded_surface) {
    text_buffer_add(out, ", \"surface\": \"ses\", %s\"convex_area\": ", request->outer ? "\"outer\": true, " : "");
    json_number(out, measurement->surface.convex_area);
    text_buffer_add(out, ", \"saddle_area\": ");
    json_number(out, measurement->surface.saddle_area);
    text_buffer_add(out, ", \"concave_area\": ");
    json_number(out, measurement->surface.concave_area);
  }
  if (measurement->weights != NULL) {
    text_buffer_add(out, ", \"weighted_area\": ");
    json_number(out, measurement->weighted_area);
  }
  if (request->polar) {
    text_buffer_add(out, ", \"polar_area\": ");
    json_number(out, measurement->polar_area);
    text_buffer_add(out, ", \"apolar_area\": ");
    json_number(out, measurement->apolar_area);
    text_buffer_add(out, ", \"other_area\": ");
    json_number(out, measurement->other_area);
  }
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
  char value[NUMBER_BYTES];
  report_heading(out, request, molecule);
  text_buffer_add(out, "  %-16s %s %s^2\n", "area", quantity_text(value, measurement->totals.area, TOTAL_DECIMALS),
                  unit);
  text_buffer_add(out, "  %-16s %s %s^3\n", "volume", quantity_text(value, measurement->totals.volume, TOTAL_DECIMALS),
                  unit);
  if (measurement->box.periodic != NULL) periodic_result_rows(&measurement->box, unit, out);
  if (request->curvature) {
    text_buffer_add(out, "  %-16s %s %s, integrated over the boundary\n", "mean curvature",
                    quantity_text(value, measurement->curvatures.mean, TOTAL_DECIMALS), unit);
    text_buffer_add(out, "  %-16s %s, 2 pi times its Euler characteristic\n", "gauss curvature",
                    quantity_text(value, measurement->curvatures.gauss, TOTAL_DECIMALS));
  }
  if (request->excluded_surface) {
    text_buffer_add(out, "  %-16s %s %s^2, where the probe touches one atom\n", "convex area",
                    quantity_text(value, measurement->surface.convex_area, TOTAL_DECIMALS), unit);
    text_buffer_add(out, "  %-16s %s %s^2, where it touches two\n", "saddle area",
                    quantity_text(value, measurement->surface.saddle_area, TOTAL_DECIMALS), unit);
    text_buffer_add(out, "  %-16s %s %s^2, where it touches three\n", "concave area",
                    quantity_text(value, measurement->surface.concave_area, TOTAL_DECIMALS), unit);
  }
  if (measurement->weights != NULL) {
    text_buffer_add(out, "  %-16s %s, the sum of weight x %s\n", "weighted area",
                    quantity_text(value, measurement->weighted_area, TOTAL_DECIMALS),
                    request->excluded_surface ? "share of the area" : "free area");
  }
  if (request->polar) {
    text_buffer_add(out, "  %-16s %s %s^2, of nitrogen and oxygen\n", "polar area",
                    quantity_text(value, measurement->polar_area, TOTAL_DECIMALS), unit);
    text_buffer_add(out, "  %-16s %s %s^2, of carbon, sulfur and selenium\n", "apolar area",
                    quantity_text(value, measurement->apolar_area, TOTAL_DECIMALS), unit);
    text_buffer_add(out, "  %-16s %s %s^2, of all others\n", "other area",
                    quantity_text(value, measurement->other_area, TOTAL_DECIMALS), unit);
  }
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

/* A row of the table of frames. */
struct row {
  const char *name[20];
  double value[20];
  size_t columns;
};

static void add_column(struct row *row, const char *name, double value) {
  row->name[row->columns] = name;
  row->value[row->columns++] = value;
}

static struct row row_of(const struct request *request, const struct findings *found) {
  const struct measurement *measurement = &found->measurement;
  struct row row = {.columns = 0};
  add_column(&row, "area", measurement->totals.area);
  add_column(&row, "volume", measurement->totals.volume);
  if (measurement->box.periodic != NULL) {
    add_column(&row, "box_volume", measurement->box.totals.box_volume);
    add_column(&row, "free_volume", measurement->box.totals.free_volume);
  }
  if (request->curvature) {
    add_column(&row, "mean_curvature", measurement->curvatures.mean);
    add_column(&row, "gauss_curvature", measurement->curvatures.gauss);
  }
  if (request->excluded_surface) {
    add_column(&row, "convex_area", measurement->surface.convex_area);
    add_column(&row, "saddle_area", measurement->surface.saddle_area);
    add_column(&row, "concave_area", measurement->surface.concave_area);
  }
  if (measurement->weights != NULL) add_column(&row, "weighted_area", measurement->weighted_area);
  if (request->polar) {
    add_column(&row, "polar_area", measurement->polar_area);
    add_column(&row, "apolar_area", measurement->apolar_area);
    add_column(&row, "other_area", measurement->other_area);
  }
  if (request->interface != NULL) {
    add_column(&row, "first_alone", found->interface.side[0].alone);
    add_column(&row, "second_alone", found->interface.side[1].alone);
    add_column(&row, "together", found->interface.together);
    add_column(&row, "buried", found->interface.buried);
  }
  return row;
}

static void print_frame(const struct request *request, const struct molecule *molecule, const struct findings *found,
                        struct text_buffer *out) {
  const struct row row = row_of(request, found);
  if (molecule->frame.first) {
    csv_frame_titles(out);
    for (size_t k = 0; k < row.columns; ++k) {
      text_buffer_add(out, "%s%s", row.name[k], k + 1 < row.columns ? "," : "\n");
    }
  }
  csv_frame(out, molecule);
  for (size_t k = 0; k < row.columns; ++k) {
    csv_number(out, row.value[k]);
    text_buffer_add(out, "%s", k + 1 < row.columns ? "," : "\n");
  }
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
