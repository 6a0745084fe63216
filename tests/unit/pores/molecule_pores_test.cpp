// Pores of crambin, held against a prototype in doubles with tolerances: the number of maxima and gates, the two
// classes that persist most, and where a probe from the one cavity that a water fits in gets out.
#include <gtest/gtest.h>

#include "built_pores.hpp"
#include "molecule_balls.hpp"

namespace {

struct Class {
  double birth, death;
};

TEST(Pores, OfCrambin) {
  constexpr int64_t finer = 100000;
  oracle::Balls balls = read_molecule(support::own_molecule("crambin.pdb"));
  for (auto &ball : balls) ball = {ball.x * finer, ball.y * finer, ball.z * finer, ball.radius * finer};
  const BuiltPores pores(balls, 0);
  ASSERT_EQ(pores.status(), hsp::Status::ok);
  EXPECT_EQ(pores.retries(), 0U);
  EXPECT_EQ(pores.maxima().size(), 305U);
  EXPECT_EQ(pores.gates().size(), 687U);
  std::vector<Class> classes;
  const auto unit = static_cast<double>(finer * steps_per_angstrom);
  for (const auto &maximum : pores.maxima()) {
    if (maximum.gate == hsp::no_id) continue;
    classes.push_back({maximum.point.level / unit, pores.gates()[maximum.gate].point.level / unit});
  }
  std::sort(classes.begin(), classes.end(),
            [](const Class &a, const Class &b) { return a.birth - a.death > b.birth - b.death; });
  ASSERT_GE(classes.size(), 2U);
  EXPECT_NEAR(classes[0].birth, 1.573475, 1e-6);
  EXPECT_NEAR(classes[0].death, 0.838840049, 1e-8);
  EXPECT_NEAR(classes[1].birth, 1.219429, 1e-6);
  EXPECT_NEAR(classes[1].death, 0.860246, 1e-6);
}

}  // namespace
