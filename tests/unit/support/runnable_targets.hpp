// The targets whose kernels this processor runs (lanes/target.hpp).
#pragma once

#include <vector>

#include "lanes/target.hpp"

inline std::vector<hsp::Target> runnable_targets() {
  std::vector<hsp::Target> found{hsp::Target::baseline};
  if (hsp::best_target() != hsp::Target::baseline) found.push_back(hsp::best_target());
  return found;
}
