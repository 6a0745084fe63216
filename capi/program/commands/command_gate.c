/* hardsphere gate: the widest probe that gets from one point to another, or to the outside, and the balls that stop a
 * wider one. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "commands/space_geometry.h"
#include "commands/void_list.h"
#include "write/ball_label.h"

/* The beginning and the end of the way. */
struct ends {
  double from[3];
  double to[3];
  bool inside; /* it ends at that point, not outside */
};

static void print_end(struct record *record, const char *name, const struct place *place, const double point[3]) {
  const struct file_format *const format = record->molecule->format;
  char shown[4][NUMBER_BYTES];
  char value[4 * NUMBER_BYTES];
  if (place->of_void == 0) return;
  snprintf(value, sizeof value, "%s %s %s  void %s", coordinate_text(shown[0], format, point[0]),
           coordinate_text(shown[1], format, point[1]), coordinate_text(shown[2], format, point[2]),
           count_text(shown[3], (int64_t)place->of_void));
  record_text(record, NULL, name, value, "");
}

/* The values that are printed. */
struct found {
  const struct request *request;
  struct ends ends;
  struct widest_probe widest;
};

static void print(struct record *record, const void *of) {
  const struct found *const found = of;
  const struct ends *const ends = &found->ends;
  const struct widest_probe *const widest = &found->widest;
  const bool passes = widest->passes;
  const char *const kind = widest->balls == 0   ? ""
                           : widest->balls == 1 ? "one ball at an end"
                                                : "three balls around a passage";
  print_end(record, "from", &found->request->gate.from, ends->from);
  print_end(record, "to", &found->request->gate.to, ends->to);
  record_atoms(record);
  record_whether(record, "passes", NULL, passes, "");
  if (!passes) record_text(record, NULL, "widest probe", "none", "not even a point passes");
  record_number(record, "widest_probe", passes ? "widest probe" : NULL, passes ? widest->radius : (double)NAN, 8,
                "@, added to the radii");
  if (passes) record_count(record, NULL, "gate", widest->balls, kind);
  record_counts(record, "gate", widest->gate, widest->balls);
  record_numbers(record, "from", ends->from, 3);
  record_numbers(record, "to", ends->inside ? ends->to : NULL, 3);
  if (record->form == FOR_PERSONS && widest->balls > 0) {
    ball_rows_print(record->molecule, widest->gate, widest->balls, record->out);
  }
}

/* Find the points that the request names. Points of voids are found in the molecule grown by the probe; afterwards the
 * model is that of the molecule itself. */
static bool find_ends(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                      struct ends *ends, struct failure *failure) {
  const struct place *const places[2] = {&request->gate.from, &request->gate.to};
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
  ends->inside = request->gate.to.point.given;
  return !grown || request->probe == 0.0 || geometry_set_model(geometry, molecule, 0.0, 0.0, failure);
}

void describe_gate(const struct request *request, struct record *record) {
  const struct found none = {.request = request};
  print(record, &none);
}

bool command_gate(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure) {
  struct found found = {.request = request};
  struct ends *const ends = &found.ends;
  if (!find_ends(request, molecule, geometry, ends, failure)) return false;
  const double *const to = ends->inside ? ends->to : NULL;
  if (!geometry_find_widest(geometry, molecule, ends->from, to, &found.widest, failure)) return false;
  report(request, molecule, print, &found, out);
  return true;
}
