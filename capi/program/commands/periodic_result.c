#include "commands/periodic_result.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "commands/unit_cell.h"
#include "write/report.h"

bool periodic_result_find_box(const struct request *request, const struct molecule *molecule,
                              struct periodic_result *result, struct failure *failure) {
  double *const box = result->box;
  if (request->box.source == BOX_GIVEN) {
    memcpy(box, request->box.vector, sizeof request->box.vector);
    return true;
  }
  const struct box_record *own = &molecule->frame.box;
  if (!own->given) {
    const bool faulty = own->fault != NULL;
    return failure_in_input(failure, 0, "--box %s: the %s has no box%s%s", request->box.without_copies ? "p1" : "file",
                            molecule->frame.number > 0 ? "frame" : "file", faulty ? " that can be taken: " : "",
                            faulty ? own->fault : "");
  }
  memcpy(box, own->vector, sizeof own->vector);
  if (molecule->frame.number == 0) result->symmetry = &molecule->symmetry;
  return true;
}

bool periodic_result_make(const struct request *request, const struct molecule *molecule, const double *weights,
                          struct geometry *geometry, struct periodic_result *result, struct failure *failure) {
  memset(result, 0, sizeof *result);
  if (!periodic_result_find_box(request, molecule, result, failure)) return false;
  if (!geometry_compute_periodic(geometry, molecule, request->probe, 0.0, result->box, failure)) return false;
  const hsp_periodic *const periodic = result->periodic = geometry->periodic;
  uint32_t needed = 0;
  int32_t status = hsp_periodic_get_counts(periodic, &result->counts);
  if (status == HSP_OK) status = hsp_periodic_measure(periodic, &result->totals, NULL, NULL, 0, NULL);
  if (status != HSP_OK) return failure_in_library(failure, status);
  result->windings = calloc((size_t)result->counts.components + 1, sizeof *result->windings);
  if (result->windings == NULL) return failure_of_memory(failure);
  status = hsp_periodic_get_windings(periodic, result->windings, result->counts.components, &needed);
  const hsp_gradient_request area = {.struct_size = sizeof area, .tension = 1.0, .sigma = weights};
  const hsp_gradient_request volume = {.struct_size = sizeof volume, .pressure = 1.0};
  hsp_energy energy;
  hsp_periodic_gradient_outputs outputs = {
      .struct_size = sizeof outputs, .energy = &energy, .d_strain = result->strain_area};
  if (status == HSP_OK) status = hsp_periodic_get_gradient(periodic, &area, &outputs);
  if (status == HSP_OK && weights != NULL) result->totals.area = energy.area;
  outputs.d_strain = result->strain_volume;
  if (status == HSP_OK) status = hsp_periodic_get_gradient(periodic, &volume, &outputs);
  return status == HSP_OK || failure_in_library(failure, status);
}

void periodic_result_free(struct periodic_result *result) {
  free(result->windings);
  memset(result, 0, sizeof *result);
}

void directions_json(struct text_buffer *out, uint32_t directions, uint32_t copies, const int32_t row[9]) {
  text_buffer_add(out, "\"directions\": %" PRIu32 ", \"copies\": ", directions);
  json_number(out, copies == HSP_NONE ? (double)NAN : copies);
  text_buffer_add_text(out, ", \"rows\": [");
  for (uint32_t r = 0; r < directions; ++r) {
    text_buffer_add(out, "%s[%" PRId32 ", %" PRId32 ", %" PRId32 "]", r == 0 ? "" : ", ", row[3 * r], row[3 * r + 1],
                    row[3 * r + 2]);
  }
  text_buffer_add_text(out, "]");
}

static void record_windings(struct record *record, const struct periodic_result *result) {
  struct text_buffer *const out = record->out;
  if (!record_key(record, "windings")) return;
  text_buffer_add_text(out, "[");
  for (uint32_t c = 0; c < result->counts.components; ++c) {
    const hsp_winding *winding = &result->windings[c];
    text_buffer_add(out, "%s{\"balls\": %" PRIu32 ", ", c == 0 ? "" : ", ", winding->balls);
    directions_json(out, winding->directions, winding->copies, winding->row);
    text_buffer_add_text(out, "}");
  }
  text_buffer_add_text(out, "]");
}

void periodic_result_record_box(struct record *record, const struct periodic_result *result) {
  record_numbers(record, "box", result->box, 9);
  if (result->symmetry != NULL) unit_cell_record(record, result->symmetry);
}

void periodic_result_record(struct record *record, const struct periodic_result *result) {
  static const char *const remarks[] = {"of them that go on for ever in one direction", "in two directions",
                                        "in three directions"};
  static const char *const names[] = {"endless lines", "endless layers", "endless nets"};
  enum { DECIMALS = 10 };
  const int width = record->width;
  uint32_t endless[4] = {0};
  for (uint32_t c = 0; c < result->counts.components; ++c) ++endless[result->windings[c].directions];
  periodic_result_record_box(record, result);
  record->width = 0;
  record_number(record, "box_volume", "box volume", result->totals.box_volume, DECIMALS, "@^3");
  record_number(record, "free_volume", "free volume", result->totals.free_volume, DECIMALS,
                "@^3, of the box less that of the union");
  record->width = VALUE_WIDTH;
  record_count(record, NULL, "components", result->counts.components, "connected pieces of the union");
  for (int k = 0; k < 3; ++k) {
    if (endless[k + 1] > 0) record_count(record, NULL, names[k], endless[k + 1], remarks[k]);
  }
  record->width = width;
  record_windings(record, result);
  record_numbers(record, "strain_area", result->strain_area, 9);
  record_numbers(record, "strain_volume", result->strain_volume, 9);
}
