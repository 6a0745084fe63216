#include "commands/periodic_result.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "commands/unit_cell.h"
#include "write/report.h"

static bool find_box(const struct request *request, const struct molecule *molecule, struct periodic_result *result,
                     struct failure *failure) {
  double *const box = result->box;
  if (request->box.source == BOX_GIVEN) {
    memcpy(box, request->box.vector, sizeof request->box.vector);
    return true;
  }
  const struct box_record *own = &molecule->frame.box;
  if (!own->given) {
    return failure_in_input(failure, 0, "--box %s: the %s has no box", request->box.without_copies ? "p1" : "file",
                            molecule->frame.number > 0 ? "frame" : "file");
  }
  memcpy(box, own->vector, sizeof own->vector);
  result->turned = own->turned;
  if (molecule->frame.number == 0) result->symmetry = &molecule->symmetry;
  return true;
}

bool periodic_result_make(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                          struct periodic_result *result, struct failure *failure) {
  memset(result, 0, sizeof *result);
  if (!find_box(request, molecule, result, failure)) return false;
  if (!geometry_compute_periodic(geometry, molecule, request->probe, result->box, failure)) return false;
  const hsp_periodic *const periodic = result->periodic = geometry->periodic;
  uint32_t needed = 0;
  int32_t status = hsp_periodic_get_counts(periodic, &result->counts);
  if (status == HSP_OK) status = hsp_periodic_measure(periodic, &result->totals, NULL, NULL, 0, NULL);
  if (status != HSP_OK) return failure_in_library(failure, status);
  result->windings = calloc((size_t)result->counts.components + 1, sizeof *result->windings);
  if (result->windings == NULL) return failure_of_memory(failure);
  status = hsp_periodic_get_windings(periodic, result->windings, result->counts.components, &needed);
  if (status == HSP_OK) {
    status = hsp_periodic_gradient(periodic, NULL, 1.0, 0.0, HSP_TANGENT_OVERLAP, NULL, NULL, NULL, NULL,
                                   result->strain_area, NULL, 0, NULL, NULL);
  }
  if (status == HSP_OK) {
    status = hsp_periodic_gradient(periodic, NULL, 0.0, 1.0, HSP_TANGENT_OVERLAP, NULL, NULL, NULL, NULL,
                                   result->strain_volume, NULL, 0, NULL, NULL);
  }
  return status == HSP_OK || failure_in_library(failure, status);
}

void periodic_result_free(struct periodic_result *result) {
  free(result->windings);
  memset(result, 0, sizeof *result);
}

static void nine_numbers(const char *name, const double numbers[9], struct text_buffer *out) {
  text_buffer_add(out, ", \"%s\": [", name);
  for (int k = 0; k < 9; ++k) {
    if (k > 0) text_buffer_add(out, ", ");
    json_number(out, numbers[k]);
  }
  text_buffer_add(out, "]");
}

void periodic_result_json(const struct periodic_result *result, struct text_buffer *out) {
  nine_numbers("box", result->box, out);
  text_buffer_add(out, ", \"box_turned\": %s", result->turned ? "true" : "false");
  if (result->symmetry != NULL) unit_cell_json(result->symmetry, out);
  text_buffer_add(out, ", \"box_volume\": ");
  json_number(out, result->totals.box_volume);
  text_buffer_add(out, ", \"free_volume\": ");
  json_number(out, result->totals.free_volume);
  text_buffer_add(out, ", \"windings\": [");
  for (uint32_t c = 0; c < result->counts.components; ++c) {
    const hsp_winding *winding = &result->windings[c];
    text_buffer_add(out, "%s{\"balls\": %" PRIu32 ", \"directions\": %" PRIu32 ", \"copies\": ", c == 0 ? "" : ", ",
                    winding->balls, winding->directions);
    if (winding->copies == HSP_NONE) {
      text_buffer_add(out, "null");
    } else {
      text_buffer_add(out, "%" PRIu32, winding->copies);
    }
    text_buffer_add(out, ", \"rows\": [");
    for (uint32_t r = 0; r < winding->directions; ++r) {
      const int32_t *row = winding->row + 3 * r;
      text_buffer_add(out, "%s[%" PRId32 ", %" PRId32 ", %" PRId32 "]", r == 0 ? "" : ", ", row[0], row[1], row[2]);
    }
    text_buffer_add(out, "]}");
  }
  text_buffer_add(out, "]");
  nine_numbers("strain_area", result->strain_area, out);
  nine_numbers("strain_volume", result->strain_volume, out);
}

void periodic_result_rows(const struct periodic_result *result, const char *unit, struct text_buffer *out) {
  enum { DECIMALS = 10 };
  char value[NUMBER_BYTES];
  uint32_t endless[4] = {0};
  for (uint32_t c = 0; c < result->counts.components; ++c) ++endless[result->windings[c].directions];
  if (result->symmetry != NULL) unit_cell_row(result->symmetry, out);
  if (result->turned) report_row(out, "box", "turned, and the atoms with it, so that its first vector is along x", "");
  text_buffer_add(out, "  %-16s %s %s^3\n", "box volume", quantity_text(value, result->totals.box_volume, DECIMALS),
                  unit);
  text_buffer_add(out, "  %-16s %s %s^3, of the box less that of the union\n", "free volume",
                  quantity_text(value, result->totals.free_volume, DECIMALS), unit);
  report_row_count(out, "components", result->counts.components, "connected pieces of the union");
  static const char *const remarks[] = {"of them that go on for ever in one direction", "in two directions",
                                        "in three directions"};
  static const char *const names[] = {"endless lines", "endless layers", "endless nets"};
  for (int k = 0; k < 3; ++k) {
    if (endless[k + 1] > 0) report_row_count(out, names[k], endless[k + 1], remarks[k]);
  }
}
