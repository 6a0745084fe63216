/* hardsphere gate: the widest probe that gets from one point to another, or to the outside, and what stops it. */
#include <inttypes.h>
#include <math.h>

#include "commands.h"
#include "input_report.h"
#include "report.h"

static uint32_t gate_balls(const hsp_widest_probe *widest) {
  uint32_t count = 0;
  while (count < 3 && widest->gate[count] != HSP_NONE) ++count;
  return count;
}

static void print_json(const struct request *request, const struct molecule *molecule, const hsp_widest_probe *widest,
                       struct text_buffer *out) {
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"passes\": %s, \"widest_probe\": ", molecule->atoms,
                  widest->passes != 0 ? "true" : "false");
  json_number(out, widest->passes != 0 ? widest->radius : NAN);
  text_buffer_add(out, ", \"gate\": [");
  for (uint32_t k = 0; k < gate_balls(widest); ++k) {
    text_buffer_add(out, "%s%" PRIu32, k == 0 ? "" : ", ", widest->gate[k]);
  }
  text_buffer_add(out, "]");
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void print_table(const struct request *request, const struct molecule *molecule, const hsp_widest_probe *widest,
                        struct text_buffer *out) {
  static const char *const kinds[] = {"", "one ball at an end", "two balls", "three balls around a passage"};
  const uint32_t count = gate_balls(widest);
  char value[NUMBER_BYTES];
  report_heading(out, request, molecule);
  if (widest->passes == 0) {
    report_row(out, "widest probe", "none", "not even a point passes");
    return;
  }
  report_row(out, "widest probe", quantity_text(value, widest->radius, 8), "added to the radii");
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

bool command_gate(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure) {
  const double *const to = request->to.given ? request->to.xyz : NULL;
  if (!geometry_find_gate(geometry, molecule, request->from.xyz, to, failure)) return false;
  hsp_widest_probe widest;
  const int32_t status = hsp_gate_get(geometry->work.gate, &widest);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (request->json) {
    print_json(request, molecule, &widest, out);
  } else {
    print_table(request, molecule, &widest, out);
  }
  return true;
}
