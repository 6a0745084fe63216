// Random directions, besides the cases.
#include "view_frame_cases.hpp"

#include <cmath>

#include "expect_cases.hpp"

namespace {

TEST(ViewFrame, Cases) {
  expect_cases(cases::view_view_frame);
}

TEST(ViewFrame, IsOrthonormalAndRightHanded) {
  cases::Random random(3);
  const auto component = [&random] { return 2 * random.fraction() - 1; };
  const double rounding = 8 * hsp::unit_roundoff;
  for (int k = 0; k < 20000; ++k) {
    const hsp::ViewDirection direction{{component(), component(), component()},
                                       {component(), component(), component()}};
    hsp::ViewFrame frame;
    ASSERT_EQ(hsp::look_from(direction, frame), hsp::Status::ok);
    ASSERT_NEAR(dot(frame.right, frame.right), 1.0, rounding);
    ASSERT_NEAR(dot(frame.up, frame.up), 1.0, rounding);
    ASSERT_NEAR(dot(frame.towards, frame.towards), 1.0, rounding);
    ASSERT_NEAR(dot(frame.right, frame.up), 0.0, rounding);
    ASSERT_NEAR(dot(frame.up, frame.towards), 0.0, rounding);
    ASSERT_NEAR(dot(frame.towards, frame.right), 0.0, rounding);
    const hsp::Vec3 third = hsp::cross(frame.right, frame.up);
    ASSERT_NEAR(dot(third, frame.towards), 1.0, rounding);
    // Each component within half a step of 2^-28 of the largest.
    const hsp::Vec3 asked{direction.towards[0], direction.towards[1], direction.towards[2]};
    const hsp::Vec3 off = hsp::cross(asked, frame.towards);
    ASSERT_LT(std::sqrt(dot(off, off) / dot(asked, asked)), 0x1p-28);
    ASSERT_GT(dot(asked, frame.towards), 0.0);
    ASSERT_GT(frame.up.x * direction.up[0] + frame.up.y * direction.up[1] + frame.up.z * direction.up[2], 0.0);
  }
}

}  // namespace
