// Second derivatives of unions in boxes against those of explicit images in free space, second differences in the
// caller's frame, a box of two copies along each vector, and the laws that the header promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "any_box.hpp"

namespace {

using boxes::AnyBox;
using boxes::Computed;
using boxes::Factors;
using boxes::Matrix;
using boxes::Vector;
using support::Random;

struct Rows {
  std::vector<uint32_t> first, ball, flags;
  std::vector<double> block;

  bool has(uint32_t i, uint32_t j) const { return at(i, j) != first[i + 1]; }
  // 0 where there is none.
  Matrix of(uint32_t i, uint32_t j) const {
    Matrix result{};
    if (has(i, j)) std::copy_n(&block[9 * size_t{at(i, j)}], 9, result.begin());
    return result;
  }
  double largest() const {
    double most = 0;
    for (const double x : block) most = std::fmax(most, std::fabs(x));
    return most;
  }

 private:
  uint32_t at(uint32_t i, uint32_t j) const {
    uint32_t entry = first[i];
    while (entry < first[i + 1] && ball[entry] != j) ++entry;
    return entry;
  }
};

template <class Call>
Rows rows_of(uint32_t n, Call call) {
  Rows rows;
  uint32_t needed = 0;
  rows.first.resize(n + 1);
  rows.flags.resize(n + 1);
  const int32_t counted = call(rows.first.data(), nullptr, nullptr, nullptr, 0, &needed);
  EXPECT_EQ(counted, needed > 0 ? HSP_E_CAPACITY : HSP_OK);
  rows.ball.resize(needed);
  rows.block.resize(9 * size_t{needed});
  EXPECT_EQ(call(rows.first.data(), rows.ball.data(), rows.block.data(), rows.flags.data(), needed, &needed), HSP_OK);
  return rows;
}

hsp_gradient_request request_of(const Factors &factors, const std::vector<double> &sigma) {
  hsp_gradient_request request{};
  request.struct_size = sizeof request;
  request.tension = factors.tension;
  request.pressure = factors.pressure;
  request.sigma = sigma.data();
  return request;
}

Rows rows_in_box(const Computed &computed, const Factors &factors) {
  const hsp_gradient_request request = request_of(factors, computed.set().sigma);
  return rows_of(computed.set().n(), [&](uint32_t *first, auto... out) {
    return hsp_periodic_get_hessian_rows(computed.get(), &request, first, out...);
  });
}

// Of the balls where they are, among all their images that are so near that they touch what meets one of them.
Rows rows_in_free_space(const AnyBox &set, const Factors &factors, std::vector<uint32_t> &owner) {
  constexpr int32_t far = 4;
  support::BallList all = set.balls;
  std::vector<double> sigma = set.sigma;
  for (uint32_t i = 0; i < set.n(); ++i) owner.push_back(i);
  for (uint32_t i = 0; i < set.n(); ++i) {
    for (int32_t k = 0; k < (2 * far + 1) * (2 * far + 1) * (2 * far + 1); ++k) {
      const int32_t shift[3] = {k % 9 - far, k / 9 % 9 - far, k / 81 - far};
      const Vector at = set.image(i, shift);
      const auto is_near = [&](uint32_t j) {
        double square = 0;
        for (size_t axis = 0; axis < 3; ++axis) square += std::pow(at[axis] - set.centre(j)[axis], 2);
        return square < 36;
      };
      bool near = false;
      for (uint32_t j = 0; j < set.n(); ++j) near = near || is_near(j);
      if (!near || (shift[0] == 0 && shift[1] == 0 && shift[2] == 0)) continue;
      all.add(at[0], at[1], at[2], set.balls.radius[i]);
      sigma.push_back(set.sigma[i]);
      owner.push_back(i);
    }
  }
  support::OwnedModel model(all.size());
  EXPECT_EQ(model.set(all, nullptr), HSP_OK);
  support::OwnedBoundary boundary;
  boundary.take(support::default_boundary_limits(all.size()));
  boundary.compute([&](hsp_boundary *handle, hsp_boundary_limits *asked) {
    return hsp_boundary_compute(handle, model.get(), asked);
  });
  const hsp_gradient_request request = request_of(factors, sigma);
  return rows_of(all.size(), [&](uint32_t *first, auto... out) {
    return hsp_boundary_get_hessian_rows(boundary.get(), &request, first, out...);
  });
}

// Balls in one box and near it, equal ones too, whose blocks come from either of them.
AnyBox near_box(Random &random, uint32_t n, bool equal) {
  AnyBox set = boxes::upright_box(random, n);
  for (uint32_t i = 0; i < n; ++i) {
    double at[3] = {0, 0, 0};
    for (size_t k = 0; k < 9; ++k)
      at[k % 3] += std::round(set.box[k] * 1e8) / 1e8 * static_cast<double>(k % 4 == 0 ? random.in(0, 999) : 0) / 1000;
    for (size_t axis = 0; axis < 3; ++axis) set.balls.xyz[3 * size_t{i} + axis] = std::round(at[axis] * 1e8) / 1e8;
    if (equal) set.balls.radius[i] = 1.625;
  }
  return set;
}

TEST(HessiansInBoxes, AreSumsOverImagesInFreeSpace) {
  Random random(741);
  size_t blocks = 0, shared = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Factors factors = trial % 3 == 0 ? Factors{1, 0, 0} : trial % 3 == 1 ? Factors{0, 1, 0} : Factors{-0.5, 2, 0};
    const AnyBox set = near_box(random, 1 + trial % 5, trial % 5 == 1 || trial % 5 == 2);
    const Rows rows = rows_in_box(Computed(set), factors);
    std::vector<uint32_t> owner;
    const Rows free = rows_in_free_space(set, factors, owner);
    for (uint32_t i = 0; i < set.n(); ++i) {
      std::vector<Matrix> sum(set.n());
      std::vector<size_t> images(set.n());
      for (uint32_t entry = free.first[i]; entry < free.first[i + 1]; ++entry) {
        ++images[owner[free.ball[entry]]];
        for (size_t k = 0; k < 9; ++k) sum[owner[free.ball[entry]]][k] += free.block[9 * size_t{entry} + k];
      }
      for (uint32_t j = 0; j < set.n(); ++j) {
        EXPECT_EQ(rows.has(i, j), images[j] > 0);
        const Matrix found = rows.of(i, j);
        for (size_t k = 0; k < 9; ++k) EXPECT_NEAR(found[k], sum[j][k], 1e-11 * (1 + free.largest())) << i << ' ' << j;
        blocks += images[j] > 0 ? 1 : 0;
        shared += i != j && images[j] > 1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(blocks, 400U);
  EXPECT_GT(shared, 60U);
}

std::vector<double> gradient_of(const AnyBox &set, const Factors &factors) {
  return boxes::plain_derivatives(Computed(set), factors).centre;
}

// Where arcs are born or die nearby quotients say nothing: those of two widths must agree.
TEST(HessiansInBoxes, AreSecondDifferencesInTheCallersFrame) {
  Random random(742);
  size_t checked = 0, left_out = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const Factors factors = trial % 2 == 0 ? Factors{1, 0, 0} : Factors{0.5, -1, 0};
    const AnyBox set = boxes::random_box(random, 4);
    const Rows rows = rows_in_box(Computed(set), factors);
    for (uint32_t j = 0; j < set.n(); ++j) {
      for (size_t axis = 0; axis < 3; ++axis) {
        const auto quotient = [&](double e) {
          AnyBox after = set, before = set;
          after.balls.xyz[3 * size_t{j} + axis] += e;
          before.balls.xyz[3 * size_t{j} + axis] -= e;
          std::vector<double> result = gradient_of(after, factors);
          const std::vector<double> less = gradient_of(before, factors);
          for (size_t k = 0; k < result.size(); ++k) result[k] = (result[k] - less[k]) / (2 * e);
          return result;
        };
        const std::vector<double> narrow = quotient(5e-4), wide = quotient(1e-3);
        for (uint32_t i = 0; i < set.n(); ++i) {
          for (size_t k = 0; k < 3; ++k) {
            const double better = narrow[3 * size_t{i} + k], worse = wide[3 * size_t{i} + k];
            const double size = 1 + std::fabs(better);
            if (std::fabs(better - worse) > 1e-3 * size) {
              ++left_out;
              continue;
            }
            EXPECT_NEAR(rows.of(i, j)[3 * k + axis], better, 3e-3 * size);
            ++checked;
          }
        }
      }
    }
  }
  EXPECT_GT(checked, 10 * left_out);
}

TEST(HessiansInBoxes, TurnWithTheCallersFrame) {
  Random random(743);
  for (int trial = 0; trial < 30; ++trial) {
    const Factors factors{0.5, 1, 0};
    const AnyBox set = boxes::upright_box(random, 5);
    const Matrix rotation = boxes::random_rotation(random);
    const Rows own = rows_in_box(Computed(set), factors), turned = rows_in_box(Computed(set.turned(rotation)), factors);
    ASSERT_EQ(own.ball, turned.ball);
    for (size_t entry = 0; entry < own.ball.size(); ++entry) {
      Matrix block, found;
      std::copy_n(&own.block[9 * entry], 9, block.begin());
      std::copy_n(&turned.block[9 * entry], 9, found.begin());
      const Matrix expected = boxes::turned_matrix(rotation, block);
      for (size_t k = 0; k < 9; ++k) EXPECT_NEAR(found[k], expected[k], 1e-4 * (1 + own.largest()));
    }
  }
}

TEST(HessiansInBoxes, AddUpOverCopiesOfTheBox) {
  Random random(744);
  for (int trial = 0; trial < 20; ++trial) {
    const Factors factors = trial % 2 == 0 ? Factors{1, 0, 0} : Factors{0.25, 1, 0};
    const AnyBox set = trial % 4 < 2 ? near_box(random, 3, true) : boxes::random_box(random, 3);
    AnyBox eight = set;
    for (int32_t copy = 1; copy < 8; ++copy) {
      const int32_t shift[3] = {copy & 1, copy >> 1 & 1, copy >> 2};
      for (uint32_t i = 0; i < set.n(); ++i) {
        const Vector at = set.image(i, shift);
        eight.balls.add(at[0], at[1], at[2], set.balls.radius[i]);
        eight.sigma.push_back(set.sigma[i]);
      }
    }
    for (double &x : eight.box) x *= 2;
    const Rows rows = rows_in_box(Computed(set), factors), copies = rows_in_box(Computed(eight), factors);
    // Turned copies are rounded each on its own.
    const double error = (trial % 4 < 2 ? 1e-11 : 1e-4) * (1 + copies.largest());
    for (uint32_t i = 0; i < set.n(); ++i) {
      for (uint32_t j = 0; j < set.n(); ++j) {
        Matrix sum{};
        for (uint32_t copy = 0; copy < 8; ++copy) {
          const Matrix part = copies.of(i, copy * set.n() + j);
          for (size_t k = 0; k < 9; ++k) sum[k] += part[k];
        }
        const Matrix found = rows.of(i, j);
        for (size_t k = 0; k < 9; ++k) EXPECT_NEAR(found[k], sum[k], error);
      }
    }
  }
}

TEST(HessiansInBoxes, AreSymmetricAndSumToZero) {
  Random random(745);
  for (int trial = 0; trial < 60; ++trial) {
    const AnyBox set = trial % 2 == 0 ? boxes::random_box(random, 6) : near_box(random, 6, true);
    const Rows rows = rows_in_box(Computed(set), {0.5, 1, 0});
    for (uint32_t i = 0; i < set.n(); ++i) {
      Matrix sum{};
      double size = 0;
      EXPECT_TRUE(std::is_sorted(&rows.ball[rows.first[i]], rows.ball.data() + rows.first[i + 1]));
      for (uint32_t j = 0; j < set.n(); ++j) {
        const Matrix block = rows.of(i, j), back = boxes::transposed(rows.of(j, i));
        EXPECT_EQ(std::memcmp(block.data(), back.data(), sizeof block), 0);
        for (size_t k = 0; k < 9; ++k) {
          sum[k] += block[k];
          size += std::fabs(block[k]);
        }
      }
      for (const double x : sum) EXPECT_NEAR(x, 0, 1e-12 * (1 + size));
    }
  }
}

// Given elsewhere, upright balls have the same bits; so have they in another order.
TEST(HessiansInBoxes, HaveTheSameBitsFromOtherImagesAndInAnyOrder) {
  Random random(746);
  for (int trial = 0; trial < 40; ++trial) {
    AnyBox set = boxes::upright_box(random, 6);
    for (double &r : set.balls.radius) r = trial % 2 == 0 ? 1.25 : r;
    const Factors factors{0.5, 1, 0};
    const Rows own = rows_in_box(Computed(set), factors);
    AnyBox moved = set;
    for (uint32_t i = 0; i < set.n(); ++i) {
      const int32_t shift[3] = {static_cast<int32_t>(random.in(-3, 3)), static_cast<int32_t>(random.in(-3, 3)),
                                static_cast<int32_t>(random.in(-3, 3))};
      const Vector at = set.image(i, shift);
      std::copy_n(at.begin(), 3, &moved.balls.xyz[3 * size_t{i}]);
    }
    const Rows there = rows_in_box(Computed(moved), factors);
    EXPECT_EQ(own.ball, there.ball);
    EXPECT_EQ(own.block, there.block);
    EXPECT_EQ(own.flags, there.flags);
    AnyBox backwards = set;
    for (uint32_t i = 0; i < set.n(); ++i) {
      const uint32_t from = set.n() - 1 - i;
      std::copy_n(set.centre(from), 3, &backwards.balls.xyz[3 * size_t{i}]);
      backwards.balls.radius[i] = set.balls.radius[from];
      backwards.sigma[i] = set.sigma[from];
    }
    const Rows reordered = rows_in_box(Computed(backwards), factors);
    for (uint32_t i = 0; i < set.n(); ++i) {
      for (uint32_t j = 0; j < set.n(); ++j)
        EXPECT_EQ(own.of(i, j), reordered.of(set.n() - 1 - i, set.n() - 1 - j)) << i << ' ' << j;
    }
  }
}

// A ball that meets nothing but its own images stays where it is without cost.
TEST(HessiansInBoxes, KnowThatABallMovesWithItsImages) {
  AnyBox set;
  set.box = {2, 0.25, 0, 0, 2.25, 0, 0.5, 0, 2.5};
  set.balls.add(0.5, 1, -7, 1.25);
  set.sigma = {1};
  const Rows rows = rows_in_box(Computed(set), {1, 1, 0});
  EXPECT_EQ(rows.ball, std::vector<uint32_t>{0});
  EXPECT_EQ(rows.block, std::vector<double>(9));
  // One that covers everything has no face.
  set.balls.radius[0] = 3;
  EXPECT_TRUE(rows_in_box(Computed(set), {1, 1, 0}).ball.empty());
}

}  // namespace
