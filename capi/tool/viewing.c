#include "viewing.h"

#include <stddef.h>
#include <string.h>

bool viewing_take_option(struct viewing *viewing, struct option_reader *reader, const char *argument, bool *known) {
  const char *value = NULL;
  *known = true;
  if (option_is(argument, "--view", &value)) return option_vector(reader, "--view", value, true, &viewing->view);
  if (option_is(argument, "--rotate", &value)) return option_vector(reader, "--rotate", value, false, &viewing->rotate);
  if (option_is(argument, "--up", &value)) return option_vector(reader, "--up", value, true, &viewing->up);
  *known = false;
  return true;
}

bool viewing_check(const struct viewing *viewing, struct failure *failure) {
  if (viewing->rotate.given && (viewing->view.given || viewing->up.given)) {
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

int32_t viewing_options(const struct viewing *viewing, hsp_view_options *options) {
  const int32_t status = hsp_view_options_init(options, (uint32_t)sizeof *options);
  if (status != HSP_OK) return status;
  if (viewing->view.given) memcpy(options->towards, viewing->view.xyz, sizeof options->towards);
  if (viewing->up.given) memcpy(options->up, viewing->up.xyz, sizeof options->up);
  if (!viewing->rotate.given) return HSP_OK;
  const double *angle = viewing->rotate.xyz;
  return hsp_view_options_turn(options, angle[0], angle[1], angle[2]);
}
