/* Every limit of boundaries, topologies and contacts at every value below what suffices, for sets of eight balls at
 * most. */
#include "check.h"
#include "core_sweeps.h"

int main(void) {
  CHECK(sweep_every_limit_of_core(0, 8) >= 20);
  return check_report();
}
