/* hardsphere model: the figures of Section 2, and whether Theorem 2.1 holds for the molecule. */
#include <inttypes.h>
#include <math.h>

#include "commands/commands.h"
#include "commands/input_report.h"
#include "write/report.h"

static bool has_k(const hsp_packing *figures) {
  return (figures->flags & HSP_PACKING_ZERO_RADIUS) == 0;
}

static bool has_rho(const hsp_packing *figures) {
  return (figures->flags & HSP_PACKING_NO_PAIR) == 0;
}

static void print_verdict(uint32_t atoms, const hsp_packing *figures, struct text_buffer *out) {
  if (figures->flags == 0) {
    char bound[NUMBER_BYTES];
    text_buffer_add(out, "Theorem 2.1 holds with these figures: no ball meets more than 216 (k/rho)^3 = %s others.\n",
                    quantity_text(bound, floor(figures->neighbour_bound), 0));
    return;
  }
  text_buffer_add(out, "Theorem 2.1 does not apply:");
  const char *separator = " ";
  if (atoms < 2) {
    text_buffer_add(out, "%sthere are fewer than two balls, so rho has no value", separator);
    separator = "; ";
  } else if (!has_rho(figures)) {
    text_buffer_add(out, "%sall radii are 0, so rho has no value", separator);
    separator = "; ";
  }
  if ((figures->flags & HSP_PACKING_ZERO_RADIUS) != 0) {
    text_buffer_add(out, "%sa ball has radius 0, so k has no value", separator);
    separator = "; ";
  }
  if ((figures->flags & HSP_PACKING_COINCIDENT) != 0) {
    text_buffer_add(out, "%stwo centres coincide, so rho is 0", separator);
  }
  text_buffer_add(out, ".\n");
  if (atoms >= 2) {
    text_buffer_add(out, "All results stay exact; only the bounds on time and memory are lost.\n");
  }
}

static void print(struct record *record, const void *of) {
  const hsp_packing *const figures = of;
  record_atoms(record);
  record_number(record, "k", "k", has_k(figures) ? figures->k : (double)NAN, 4, "largest radius / smallest radius");
  record_number(record, "rho", "rho", has_rho(figures) ? figures->rho : (double)NAN, 4,
                "least of: distance of two centres / larger of their radii");
  record_count(record, "max_overlaps", "max overlaps", figures->max_overlaps, "most balls that one ball overlaps");
  record_number(record, "mean_overlaps", "mean overlaps", figures->mean_overlaps, 4, "balls that a ball overlaps");
  if (record->form != FOR_PERSONS) return;
  record_line(record, "");
  print_verdict(record->molecule->atoms, figures, record->out);
}

void describe_model(const struct request *request, struct record *record) {
  static const hsp_packing none;
  (void)request;
  print(record, &none);
}

bool command_model(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                   struct text_buffer *out, struct failure *failure) {
  hsp_packing figures;
  progress_show(&geometry->progress, "counting overlaps");
  const int32_t status = hsp_model_get_packing(geometry->work.model, &figures);
  if (status != HSP_OK) return failure_in_library(failure, status);
  report(request, molecule, print, &figures, out);
  return true;
}
