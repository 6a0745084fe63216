/* All that asks whether to go on, stopped at each of its questions once. */
#include "check.h"
#include "stopping_sweep.h"

int main(void) {
  stopping_sweep(0, STOPPING_SETS);
  return check_report();
}
