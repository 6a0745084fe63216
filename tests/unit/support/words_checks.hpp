// Checks of lanes/words.hpp, a kernel apart from the test.
#pragma once

#include "lanes/target.hpp"

namespace hsp {

// Sets it to null, or to what is wrong.
HSP_KERNEL(void, check_words, (const char *&wrong), (wrong))

}  // namespace hsp
