/* hardsphere gate: the widest probe that gets from one point to another, or to the outside, and what stops it. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/space_geometry.h"
#include "commands/void_list.h"
#include "write/report.h"

/* Where the way begins and ends. */
struct ends {
  double from[3];
  double to[3];
  bool inside; /* it ends at that point, not outside */
};

static uint32_t gate_balls(const hsp_widest_probe *widest) {
  uint32_t count = 0;
  while (count < 3 && widest->gate[count] != HSP_NONE) ++count;
  return count;
}

static void print_json(const struct request *request, const struct molecule *molecule, const struct ends *ends,
                       const hsp_widest_probe *widest, struct text_buffer *out) {
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"passes\": %s, \"widest_probe\": ", molecule->atoms,
                  widest->passes != 0 ? "true" : "false");
  json_number(out, widest->passes != 0 ? widest->radius : NAN);
  text_buffer_add(out, ", \"gate\": [");
  for (uint32_t k = 0; k < gate_balls(widest); ++k) {
    text_buffer_add(out, "%s%" PRIu32, k == 0 ? "" : ", ", widest->gate[k]);
  }
  text_buffer_add(out, "], \"from\": ");
  json_vector(out, ends->from);
  text_buffer_add(out, ", \"to\": ");
  if (ends->inside) {
    json_vector(out, ends->to);
  } else {
    text_buffer_add(out, "null");
  }
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void row_end(const char *name, const struct molecule *molecule, const struct place *place, const double point[3],
                    struct text_buffer *out) {
  char shown[4][NUMBER_BYTES];
  char value[4 * NUMBER_BYTES];
  if (place->of_void == 0) return;
  snprintf(value, sizeof value, "%s %s %s  void %s", coordinate_text(shown[0], molecule->format, point[0]),
           coordinate_text(shown[1], molecule->format, point[1]), coordinate_text(shown[2], molecule->format, point[2]),
           count_text(shown[3], (int64_t)place->of_void));
  report_row(out, name, value, "");
}

static void print_table(const struct request *request, const struct molecule *molecule, const struct ends *ends,
                        const hsp_widest_probe *widest, struct text_buffer *out) {
  static const char *const kinds[] = {"", "one ball at an end", "two balls", "three balls around a passage"};
  const uint32_t count = gate_balls(widest);
  char value[NUMBER_BYTES];
  report_heading(out, request, molecule);
  row_end("from", molecule, &request->from, ends->from, out);
  row_end("to", molecule, &request->to, ends->to, out);
  if (widest->passes == 0) {
    report_row(out, "widest probe", "none", "not even a point passes");
    return;
  }
  char remark[40];
  snprintf(remark, sizeof remark, "%s, added to the radii", molecule->format->unit);
  report_row(out, "widest probe", quantity_text(value, widest->radius, 8), remark);
  report_row_count(out, "gate", count, kinds[count]);
  if (count == 0) return;
  const struct ball_columns columns = ball_columns_of(molecule);
  text_buffer_add(out, "\n");
  report_ball_titles(out, columns);
  text_buffer_add(out, "\n");
  for (uint32_t k = 0; k < count; ++k) {
    report_ball(out, columns, molecule, widest->gate[k]);
    text_buffer_add(out, "\n");
  }
}

/* The points that were named; what they are of voids is found in the molecule grown by the probe, and then the model is
 * the molecule's own. */
static bool find_ends(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct ends *ends, struct failure *failure) {
  const struct place *const places[2] = {&request->from, &request->to};
  double *const points[2] = {ends->from, ends->to};
  bool grown = false;
  for (int k = 0; k < 2; ++k) {
    memcpy(points[k], places[k]->point.xyz, sizeof ends->from);
    if (places[k]->of_void == 0) continue;
    grown = true;
    if (!void_list_point(geometry, molecule, request->probe, places[k]->of_void, k == 0 ? "--from" : "--to", points[k],
                         failure)) {
      return false;
    }
  }
  ends->inside = request->to.point.given;
  return !grown || request->probe == 0.0 || geometry_set_model(geometry, molecule, 0.0, 0.0, failure);
}

bool command_gate(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure) {
  struct ends ends;
  if (!find_ends(request, molecule, geometry, &ends, failure)) return false;
  if (!geometry_find_gate(geometry, molecule, ends.from, ends.inside ? ends.to : NULL, failure)) return false;
  hsp_widest_probe widest;
  const int32_t status = hsp_gate_get(geometry->work.gate, &widest);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (request->json) {
    print_json(request, molecule, &ends, &widest, out);
  } else {
    print_table(request, molecule, &ends, &widest, out);
  }
  return true;
}
