// A defined state of the branch predictor that valgrind simulates.
#pragma once

namespace bench {

// Leaves every counter of valgrind's predictor saturated, in a direction that is always the same. Without it a stage
// may be charged three mispredictions a ball more or less by what ran before it: two branches that share a counter, one
// always taken and the other never, stay wrong both or one of them, as the counter began. Does nothing on other
// processors than x86-64.
void settle_branch_predictor();

}  // namespace bench
