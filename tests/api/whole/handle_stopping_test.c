/* All that asks whether to go on, stopped at some of its questions. */
#include "check.h"
#include "stopping_sweep.h"

int main(void) {
  stopping_sweep(0, 1);
  return check_report();
}
