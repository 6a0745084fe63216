#include "commands/viewing.h"

bool viewing_check(const struct viewing *viewing, struct failure *failure) {
  for (int axis = 0; axis < 3; ++axis) {
    const double angle = viewing->rotate.xyz[axis];
    if (angle > 1e6 || angle < -1e6) {
      return failure_in_usage(failure, "--rotate: angles must be between -1000000 and 1000000 degrees");
    }
  }
  return true;
}

bool viewing_is_given(const struct viewing *viewing) {
  return viewing->automatic || viewing->view.given || viewing->up.given || viewing->rotate.given;
}
