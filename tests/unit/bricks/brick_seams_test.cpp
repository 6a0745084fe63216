// Seams of small sets, and that both sides of each find the same names.
#include "bricks/brick_seams.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <tuple>

#include "built_boundary.hpp"

namespace {

using Name = std::tuple<uint32_t, uint32_t, uint64_t, uint64_t, uint64_t, int32_t>;

struct Seams {
  std::vector<Name> shells, components;
};

template <class Record>
std::vector<Name> names(const std::vector<uint8_t> &bytes, uint32_t count) {
  std::vector<Name> result;
  for (uint32_t k = 0; k < count; ++k) {
    const auto seam = hsp::load_record<Record>(&bytes[hsp::little_bytes<Record> * k]);
    result.emplace_back(seam.a, seam.b, seam.id[0], seam.id[1], seam.id[2], seam.sign);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Of the whole set as the model of each brick; ids are ten times the index.
Seams seams_of(const oracle::Balls &balls, const std::vector<uint32_t> &owner, uint32_t brick) {
  const BuiltBoundary built(balls);
  const uint32_t n = static_cast<uint32_t>(balls.size());
  std::vector<uint64_t> id(n);
  std::vector<uint32_t> at(n), joined(n), contact(n), near(n), label(n + 3 * built.boundary().face_count(), 0);
  std::vector<uint32_t> passed(hsp::words_of_bits(built.boundary().half_edge_count()));
  for (uint32_t k = 0; k < n; ++k) {
    id[k] = 10 * k;
    at[built.grid_index(k)] = owner[k];
  }
  const auto span = [](std::vector<uint32_t> &words) {
    return hsp::Span<uint32_t>(words.data(), static_cast<uint32_t>(words.size()));
  };
  const hsp::BrickModel model{built.grid(), built.boundary(), brick, id.data(), span(at)};
  hsp::Patience patience;
  std::vector<uint8_t> bytes(10000);
  Seams result;
  hsp::SeamList<hsp::ShellSeam> shells(bytes.data(), bytes.size());
  EXPECT_TRUE(hsp::find_shell_seams(model, patience, span(passed), span(label), shells));
  result.shells = names<hsp::ShellSeam>(bytes, shells.count());
  hsp::SeamList<hsp::ComponentSeam> components(bytes.data(), bytes.size());
  EXPECT_TRUE(
      hsp::find_component_seams(model, patience, span(label), span(joined), span(contact), span(near), components));
  result.components = names<hsp::ComponentSeam>(bytes, components.count());
  return result;
}

TEST(BrickSeams, AFreeCircle) {
  const Seams first = seams_of({{0, 0, 0, 5}, {8, 0, 0, 5}}, {0, 1}, 0);
  EXPECT_EQ(first.shells, (std::vector<Name>{{0, 1, 0, 10, 0, 0}}));
  EXPECT_EQ(first.components, (std::vector<Name>{{0, 1, 0, 0, 0, 0}}));
}

// Three balls of three bricks in two points: each two bricks have one arc, named by the lower of its two ends.
TEST(BrickSeams, PointsOfThreeBricks) {
  const oracle::Balls balls = {{0, 0, 0, 5}, {6, 0, 0, 5}, {0, 6, 0, 5}};
  for (uint32_t brick = 0; brick < 3; ++brick) {
    std::vector<Name> shells, components;
    for (uint32_t a = 0; a < 3; ++a) {
      for (uint32_t b = a + 1; b < 3; ++b) {
        if (a != brick && b != brick) continue;
        shells.emplace_back(a, b, 0, 10, 20, -1);
        components.emplace_back(a, b, 10 * a, 0, 0, 0);
      }
    }
    const Seams seams = seams_of(balls, {0, 1, 2}, brick);
    EXPECT_EQ(seams.shells, shells);
    EXPECT_EQ(seams.components, components);
  }
}

// A ring of balls cut in two: two curves, and two places where components join.
TEST(BrickSeams, ARingHasTwo) {
  const oracle::Balls ring = {{10, 0, 0, 5},  {7, 7, 0, 5},   {0, 10, 0, 5},  {-7, 7, 0, 5},
                              {-10, 0, 0, 5}, {-7, -7, 0, 5}, {0, -10, 0, 5}, {7, -7, 0, 5}};
  const std::vector<uint32_t> owner = {0, 0, 0, 0, 1, 1, 1, 1};
  const Seams seams = seams_of(ring, owner, 0);
  EXPECT_EQ(seams.shells, (std::vector<Name>{{0, 1, 0, 70, 0, 0}, {0, 1, 30, 40, 0, 0}}));
  EXPECT_EQ(seams.components, (std::vector<Name>{{0, 1, 0, 0, 0, 0}, {0, 1, 30, 0, 0, 0}}));
  EXPECT_EQ(seams_of(ring, owner, 1).shells, seams.shells);
}

TEST(BrickSeams, BothSidesFindTheSameNames) {
  support::Random random(9);
  for (int k = 0; k < 300; ++k) {
    oracle::Balls balls;
    std::vector<uint32_t> owner;
    const uint32_t bricks = static_cast<uint32_t>(random.in(2, 5));
    for (int64_t n = random.in(2, 60); n > 0; --n) {
      balls.push_back({random.in(0, 30), random.in(0, 30), random.in(0, 30), random.in(0, 7)});
      owner.push_back(random.below(bricks));
    }
    std::vector<Seams> of;
    for (uint32_t brick = 0; brick < bricks; ++brick) of.push_back(seams_of(balls, owner, brick));
    for (uint32_t a = 0; a < bricks; ++a) {
      for (uint32_t b = a + 1; b < bricks; ++b) {
        const auto between = [&](const std::vector<Name> &all) {
          std::vector<Name> some;
          for (const Name &name : all) {
            if (std::get<0>(name) == a && std::get<1>(name) == b) some.push_back(name);
          }
          EXPECT_EQ(std::adjacent_find(some.begin(), some.end()), some.end());
          return some;
        };
        ASSERT_EQ(between(of[a].shells), between(of[b].shells)) << oracle::to_text(balls);
        ASSERT_EQ(between(of[a].components), between(of[b].components)) << oracle::to_text(balls);
      }
    }
  }
}

// Balls that meet, one of each brick: their connected parts by brute force.
TEST(BrickSeams, ComponentsAsByBruteForce) {
  support::Random random(10);
  for (int k = 0; k < 300; ++k) {
    oracle::Balls balls;
    std::vector<uint32_t> owner;
    const uint32_t n = static_cast<uint32_t>(random.in(2, 50));
    for (uint32_t i = 0; i < n; ++i) {
      balls.push_back({random.in(0, 20), random.in(0, 20), random.in(0, 20), random.in(0, 4)});
      owner.push_back(random.below(4));
    }
    std::vector<Name> expected;
    for (uint32_t other = 1; other < 4; ++other) {
      std::vector<uint32_t> part(n);
      std::iota(part.begin(), part.end(), 0U);
      std::vector<uint8_t> in(n);
      for (uint32_t pass = 0; pass < n; ++pass) {
        for (uint32_t i = 0; i < n; ++i) {
          for (uint32_t j = 0; j < n; ++j) {
            if (owner[i] != 0 || owner[j] != other) continue;
            const auto d = oracle::centre_difference(balls[i], balls[j]);
            const oracle::Int128 t = balls[i].radius + balls[j].radius;
            if (oracle::dot(d, d) > t * t) continue;
            in[i] = in[j] = 1;
            part[i] = part[j] = std::min(part[i], part[j]);
          }
        }
      }
      for (uint32_t i = 0; i < n; ++i) {
        if (in[i] != 0 && part[i] == i) expected.emplace_back(0U, other, 10 * i, 0, 0, 0);
      }
    }
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(seams_of(balls, owner, 0).components, expected) << oracle::to_text(balls);
  }
}

// Seams without room are counted, and nothing is written behind the memory.
TEST(BrickSeams, ListsCountWhatTheyHaveNoRoomFor) {
  std::vector<uint8_t> bytes(100, 0xA5);
  hsp::SeamList<hsp::ShellSeam> list(bytes.data(), 99);
  for (int k = 0; k < 5; ++k) list.push({});
  EXPECT_EQ(list.count(), 5U);
  for (size_t k = 80; k < 100; ++k) EXPECT_EQ(bytes[k], 0xA5);
}

}  // namespace
