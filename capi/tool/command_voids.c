/* hardsphere voids: the cavities that the union encloses, and the balls around them. */
#include <inttypes.h>

#include "commands.h"
#include "input_report.h"
#include "report.h"
#include "void_list.h"

static void print_json(const struct request *request, const struct molecule *molecule, const struct void_list *list,
                       struct text_buffer *out) {
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"voids\": [", molecule->atoms);
  for (uint32_t i = 0; i < list->count; ++i) {
    const struct void_cell *of = &list->voids[i];
    text_buffer_add(out, "%s{\"cell\": %" PRIu32 ", \"area\": ", i == 0 ? "" : ", ", of->cell);
    json_number(out, of->figures.area);
    text_buffer_add(out, ", \"volume\": ");
    json_number(out, of->figures.volume);
    text_buffer_add(out, ", \"components\": %" PRIu32 ", \"balls\": [", of->figures.components);
    for (uint32_t k = 0; k < of->ball_count; ++k) {
      text_buffer_add(out, "%s%" PRIu32, k == 0 ? "" : ", ", of->balls[k]);
    }
    text_buffer_add(out, "]}");
  }
  text_buffer_add(out, "]");
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void print_void(const struct molecule *molecule, struct ball_columns columns, const struct void_cell *of,
                       struct text_buffer *out) {
  char value[NUMBER_BYTES];
  const char *unit = format_unit(molecule->format);
  text_buffer_add(out, "\nvoid %" PRIu32 "\n", of->cell);
  text_buffer_add(out, "  %-16s %s %s^3\n", "volume", quantity_text(value, of->figures.volume, 6), unit);
  text_buffer_add(out, "  %-16s %s %s^2\n", "area", quantity_text(value, of->figures.area, 6), unit);
  report_row_count(out, "components", of->figures.components, "pieces of the union that lie in it");
  report_row_count(out, "balls", of->ball_count, "balls with a face on it");
  text_buffer_add(out, "\n");
  report_ball_titles(out, columns);
  text_buffer_add(out, "\n");
  for (uint32_t k = 0; k < of->ball_count; ++k) {
    report_ball(out, columns, molecule, of->balls[k]);
    text_buffer_add(out, "\n");
  }
}

static void print_table(const struct request *request, const struct molecule *molecule, const struct void_list *list,
                        struct text_buffer *out) {
  report_heading(out, request, molecule);
  report_row_count(out, "voids", list->count, "cavities enclosed by the union, largest first");
  const struct ball_columns columns = ball_columns_of(molecule);
  for (uint32_t i = 0; i < list->count; ++i) print_void(molecule, columns, &list->voids[i], out);
}

bool command_voids(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_topology(geometry, failure)) return false;
  struct void_list list;
  const bool done = void_list_make(geometry, &list, failure);
  if (done && request->json) print_json(request, molecule, &list, out);
  if (done && !request->json) print_table(request, molecule, &list, out);
  void_list_free(&list);
  return done;
}
