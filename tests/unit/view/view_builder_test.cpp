#include "view_builder_cases.hpp"

#include "built_boundary.hpp"
#include "expect_cases.hpp"
#include "stopped_at.hpp"

TEST(ViewBuilder, Cases) {
  expect_cases(cases::view_view_builder);
}

// Sorting is the last thing to do.
TEST(ViewBuilder, StopsAtTheLastQuestions) {
  constexpr uint32_t n = 8000;
  const BuiltBoundary built(long_row(n));
  ASSERT_EQ(built.status(), hsp::Status::ok);
  hsp::ViewBuilder builder;
  CarvedMemory memory;
  memory.carve(builder, hsp::ViewLimits{n, 8, 8 * n});
  expect_stops_at_questions(10, 5, [&](const hsp::Executor &executor) {
    return builder.build(built.grid(), &built.boundary(),
                         {{{0, 0, 1}, {0, 1, 0}}, hsp::PieceKind::outside_farther, false}, hsp::Patience(&executor));
  });
  EXPECT_EQ(builder.structure().pieces.size(), n);
}
