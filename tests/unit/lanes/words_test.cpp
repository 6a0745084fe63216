// Words of every target that the processor has, by their operations on one number at a time.
#include <gtest/gtest.h>

#include <string>

#include "runnable_targets.hpp"
#include "words_checks.hpp"

namespace {

TEST(Words, AreThoseOfOneNumberAtATime) {
  if constexpr (!hsp::has_lanes) {
    GTEST_SKIP() << "this build has none";
  } else {
    for (const hsp::Target target : runnable_targets()) {
      const char *wrong = "not asked";
      hsp::check_words(target, wrong);
      EXPECT_EQ(std::string(wrong == nullptr ? "" : wrong), "") << "target " << static_cast<int>(target);
    }
  }
}

}  // namespace
