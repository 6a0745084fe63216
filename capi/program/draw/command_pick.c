/* hardsphere pick: the ball that is seen at a point of the view plane. */
#include <math.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "draw/view_geometry.h"
#include "read/vectors.h"
#include "write/ball_label.h"

/* Points of the file's own coordinates, turned; the map has its origin among the balls. */
static int32_t pick(const hsp_map *map, const double at[2], hsp_map_sight *sight) {
  hsp_map_info info;
  int32_t status = hsp_map_get_info(map, &info);
  if (status != HSP_OK) return status;
  status = hsp_map_pick(map, at[0] - dot(info.origin, info.right), at[1] - dot(info.origin, info.up), sight);
  if (status == HSP_OK) sight->depth += dot(info.origin, info.towards);
  return status;
}

/* The values that are printed. */
struct found {
  const struct request *request;
  hsp_map_sight sight;
};

static void print(struct record *record, const void *of) {
  const struct found *const found = of;
  const hsp_map_sight *const sight = &found->sight;
  const double *const at = found->request->pick.at.xyz;
  const bool background = sight->ball == HSP_NONE;
  if (record->form == FOR_PERSONS) {
    text_buffer_add(record->out, "  %-16s at %.10g %.10g %s\n", "seen", at[0], at[1], record->molecule->format->unit);
  }
  if (background) {
    record_number(record, "ball", NULL, NAN, 0, "");
    record_text(record, NULL, "ball", "none", "the background");
  } else {
    record_count(record, "ball", NULL, sight->ball, "");
  }
  record_number(record, "depth", background ? NULL : "depth", background ? (double)NAN : sight->depth, 6,
                "@, towards the viewer");
  if (record->form == FOR_PERSONS && !background) ball_rows_print(record->molecule, &sight->ball, 1, record->out);
}

void describe_pick(const struct request *request, struct record *record) {
  const struct found none = {.request = request};
  print(record, &none);
}

bool command_pick(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure) {
  struct found found = {.request = request};
  if (!geometry_compute_map(geometry, &request->viewing, molecule, failure)) return false;
  const int32_t status = pick(geometry->work.map, request->pick.at.xyz, &found.sight);
  if (status != HSP_OK) return failure_in_library(failure, status);
  report(request, molecule, print, &found, out);
  return true;
}
