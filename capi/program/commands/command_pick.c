/* hardsphere pick: the ball that is seen at a point of the view plane. */
#include <inttypes.h>
#include <stdio.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "draw/view_geometry.h"
#include "write/report.h"

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Points of the file's own coordinates, turned; the map has its origin among the balls. */
static int32_t pick(const hsp_map *map, const double at[2], hsp_map_sight *sight) {
  hsp_map_info info;
  int32_t status = hsp_map_get_info(map, &info);
  if (status != HSP_OK) return status;
  status = hsp_map_pick(map, at[0] - dot(info.origin, info.right), at[1] - dot(info.origin, info.up), sight);
  if (status == HSP_OK) sight->depth += dot(info.origin, info.towards);
  return status;
}

static void print_json(const struct request *request, const struct molecule *molecule, const hsp_map_sight *sight,
                       struct text_buffer *out) {
  if (sight->ball == HSP_NONE) {
    text_buffer_add(out, "{\"ball\": null, \"depth\": null");
  } else {
    text_buffer_add(out, "{\"ball\": %" PRIu32 ", \"depth\": ", sight->ball);
    json_number(out, sight->depth);
  }
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void print_table(const struct request *request, const struct molecule *molecule, const hsp_map_sight *sight,
                        struct text_buffer *out) {
  report_heading(out, request, molecule);
  text_buffer_add(out, "  %-16s at %.10g %.10g %s\n", "seen", request->at.xyz[0], request->at.xyz[1],
                  molecule->format->unit);
  if (sight->ball == HSP_NONE) {
    report_row(out, "ball", "none", "the background");
    return;
  }
  char value[NUMBER_BYTES];
  char remark[80];
  snprintf(remark, sizeof remark, "%s, towards the viewer", molecule->format->unit);
  report_row(out, "depth", quantity_text(value, sight->depth, 6), remark);
  const struct ball_columns columns = ball_columns_of(molecule);
  text_buffer_add(out, "\n");
  report_ball_titles(out, columns);
  text_buffer_add(out, "\n");
  report_ball(out, columns, molecule, sight->ball);
  text_buffer_add(out, "\n");
}

bool command_pick(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                  struct text_buffer *out, struct failure *failure) {
  hsp_map_sight sight;
  if (!geometry_compute_map(geometry, &request->viewing, molecule, failure)) return false;
  const int32_t status = pick(geometry->work.map, request->at.xyz, &sight);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (request->json) {
    print_json(request, molecule, &sight, out);
  } else {
    print_table(request, molecule, &sight, out);
  }
  return true;
}
