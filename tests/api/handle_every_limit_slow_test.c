/* Every limit of boundaries, topologies and contacts at every value below what suffices, for larger sets. */
#include "check.h"
#include "core_sweeps.h"

int main(void) {
  CHECK(sweep_every_limit_of_core(9, BALL_SET_MOST) >= 20);
  return check_report();
}
