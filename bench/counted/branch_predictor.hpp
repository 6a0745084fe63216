// A defined state of the branch predictor that valgrind simulates.
#pragma once

namespace bench {

// Leaves every counter of valgrind's predictor saturated, always in the same direction. Without it a stage may have
// three mispredictions a ball more or less, depending on the code that ran before: if two branches share a counter, one
// always taken and the other never, the counter's first state decides whether one or both of them stay mispredicted.
// Does nothing on processors other than x86-64.
void settle_branch_predictor();

}  // namespace bench
