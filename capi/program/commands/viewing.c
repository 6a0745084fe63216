#include "commands/viewing.h"

bool viewing_is_given(const struct viewing *viewing) {
  return viewing->automatic || viewing->view.given || viewing->up.given || viewing->rotate.given;
}
