#include "viewing.h"

#include <stddef.h>
#include <string.h>

#include "molecule.h"
#include "principal_axes.h"

static bool take_view(struct viewing *viewing, struct option_reader *reader, const char *value) {
  const char *word = value != NULL ? value : reader->left > 0 ? reader->rest[0] : "";
  if (strcmp(word, "auto") == 0) {
    if (value == NULL) option_next(reader);
    if (!viewing->automatic && !viewing->view.given) {
      viewing->automatic = true;
      return true;
    }
  } else if (!viewing->automatic) {
    return option_vector(reader, "--view", value, true, &viewing->view);
  }
  return failure_in_usage(reader->failure, "--view is given twice");
}

bool viewing_take_option(struct viewing *viewing, struct option_reader *reader, const char *argument, bool *known) {
  const char *value = NULL;
  *known = true;
  if (option_is(argument, "--view", &value)) return take_view(viewing, reader, value);
  if (option_is(argument, "--rotate", &value)) return option_vector(reader, "--rotate", value, false, &viewing->rotate);
  if (option_is(argument, "--up", &value)) return option_vector(reader, "--up", value, true, &viewing->up);
  *known = false;
  return true;
}

bool viewing_check(const struct viewing *viewing, struct failure *failure) {
  const bool view = viewing->view.given || viewing->automatic;
  if (viewing->rotate.given && (view || viewing->up.given)) {
    return failure_in_usage(failure, "one way to look at it: either --rotate or --view and --up");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double angle = viewing->rotate.xyz[axis];
    if (angle > 1e6 || angle < -1e6) {
      return failure_in_usage(failure, "--rotate: angles must be between -1000000 and 1000000 degrees");
    }
  }
  return true;
}

int32_t viewing_options(const struct viewing *viewing, const struct molecule *molecule, hsp_view_options *options) {
  const int32_t status = hsp_view_options_init(options, (uint32_t)sizeof *options);
  if (status != HSP_OK) return status;
  if (viewing->view.given) memcpy(options->towards, viewing->view.xyz, sizeof options->towards);
  if (viewing->automatic) {
    double axis[3][3];
    principal_axes(molecule->xyz, molecule->atoms, axis);
    memcpy(options->up, axis[1], sizeof options->up);
    memcpy(options->towards, axis[2], sizeof options->towards);
  }
  if (viewing->up.given) memcpy(options->up, viewing->up.xyz, sizeof options->up);
  if (!viewing->rotate.given) return HSP_OK;
  const double *angle = viewing->rotate.xyz;
  return hsp_view_options_turn(options, angle[0], angle[1], angle[2]);
}
