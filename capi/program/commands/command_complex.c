/* hardsphere complex: the dual complex of the union, its simplices by kind, and its topology. */
#include <inttypes.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "write/report.h"

static void counts_json(const char *name, const uint32_t counts[4], struct text_buffer *out) {
  text_buffer_add(out, "\"%s\": [%" PRIu32 ", %" PRIu32 ", %" PRIu32 ", %" PRIu32 "]", name, counts[0], counts[1],
                  counts[2], counts[3]);
}

static void print_json(const struct request *request, const struct molecule *molecule, const hsp_complex *found,
                       struct text_buffer *out) {
  text_buffer_add(out, "{\"n\": %" PRIu32 ", \"simplices\": {", molecule->atoms);
  counts_json("singular", found->singular, out);
  text_buffer_add(out, ", ");
  counts_json("regular", found->regular, out);
  text_buffer_add(out, ", ");
  counts_json("interior", found->interior, out);
  text_buffer_add(out, "}, \"euler\": %" PRId32 ", \"betti\": [%" PRIu32 ", %" PRIu32 ", %" PRIu32 "]", found->euler,
                  found->betti[0], found->betti[1], found->betti[2]);
  input_report_json(out, request, molecule);
  text_buffer_add(out, "}\n");
}

static void print_table(const struct request *request, const struct molecule *molecule, const hsp_complex *found,
                        struct text_buffer *out) {
  static const char *const names[4] = {"balls", "edges", "triangles", "tetrahedra"};
  report_heading(out, request, molecule);
  report_row_count(out, "components", found->betti[0], "connected pieces of the union");
  report_row_count(out, "tunnels", found->betti[1], "independent ways through it");
  report_row_count(out, "voids", found->betti[2], "cavities enclosed by it");
  report_row_count(out, "euler", found->euler, "balls - edges + triangles - tetrahedra");
  text_buffer_add(out, "\n  %-16s  %10s  %10s  %10s  %10s\n", "simplices", "singular", "regular", "interior", "all");
  for (int d = 0; d < 4; ++d) {
    text_buffer_add(out, "  %-16s  %10" PRIu32 "  %10" PRIu32 "  %10" PRIu32 "  %10" PRIu32 "\n", names[d],
                    found->singular[d], found->regular[d], found->interior[d],
                    found->singular[d] + found->regular[d] + found->interior[d]);
  }
}

bool command_complex(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                     struct text_buffer *out, struct failure *failure) {
  if (!geometry_compute_contacts(geometry, failure)) return false;
  hsp_complex found;
  const int32_t status = hsp_contacts_get_complex(geometry->work.contacts, &found);
  if (status != HSP_OK) return failure_in_library(failure, status);
  if (request->json) {
    print_json(request, molecule, &found, out);
  } else {
    print_table(request, molecule, &found, out);
  }
  return true;
}
