// Computations that ask their caller whether to go on, stopped at each of their questions.
#pragma once

#include <gtest/gtest.h>

#include "core/executor.hpp"
#include "core/status.hpp"
#include "lattice_ball.hpp"

// Requires that build(executor) asks at least `fewest` questions, that it can be stopped at each of the `last` last
// ones, and that it succeeds again in the end.
template <class Build>
void expect_stops_at_questions(uint32_t fewest, uint32_t last, Build build) {
  struct Caller {
    uint32_t stop_at, asked;
    hsp::Executor executor() {
      return {1, nullptr, this, [](void *context) {
                auto *const own = static_cast<Caller *>(context);
                return own->asked++ < own->stop_at;
              }};
    }
  };
  Caller patient{UINT32_MAX, 0};
  ASSERT_EQ(build(patient.executor()), hsp::Status::ok);
  ASSERT_GE(patient.asked, fewest);
  for (uint32_t question = patient.asked > last ? patient.asked - last : 0; question < patient.asked; ++question) {
    Caller once{question, 0};
    EXPECT_EQ(build(once.executor()), hsp::Status::stopped) << question;
    EXPECT_EQ(once.asked, question + 1);
  }
  ASSERT_EQ(build(hsp::Executor()), hsp::Status::ok);
}

// A row in which each ball meets only its neighbours: one shell, with more circles, faces and cut arcs than the library
// works on between two questions.
inline oracle::Balls long_row(int balls) {
  oracle::Balls row;
  for (int k = 0; k < balls; ++k) row.push_back({150 * k, 3 * k, 40 * k, 100});
  return row;
}
