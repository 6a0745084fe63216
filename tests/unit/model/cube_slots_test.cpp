// No search is long, whatever the cubes: counted by how often a number's cube is asked for.
#include "model/cube_slots.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "colliding_cubes.hpp"

namespace {

class Slots {
  auto cube_of() {
    return [this](uint32_t number) -> const hsp::CubeCoordinates & {
      ++asked_;
      return cubes_[number];
    };
  }

 public:
  explicit Slots(uint32_t numbers) : memory_(hsp::CubeSlots::slots_for(numbers)) {
    slots_ = hsp::CubeSlots({memory_.data(), static_cast<uint32_t>(memory_.size())});
    slots_.clear(numbers);
  }

  void insert(const hsp::CubeCoordinates &cube) {
    cubes_.push_back(cube);
    slots_.insert(static_cast<uint32_t>(cubes_.size()) - 1, cube_of());
  }
  uint32_t find(const hsp::CubeCoordinates &cube) {
    asked_ = 0;
    return slots_.find(cube, hsp::linear_hash(cube), cube_of());
  }
  void expect_all() {
    for (uint32_t k = 0; k < cubes_.size(); ++k) {
      ASSERT_EQ(find(cubes_[k]), k);
      ASSERT_LE(asked_, slots_.longest_search());
    }
  }
  uint32_t asked() const { return asked_; }
  const hsp::CubeSlots &slots() const { return slots_; }

 private:
  std::vector<uint32_t> memory_;
  std::vector<hsp::CubeCoordinates> cubes_;
  hsp::CubeSlots slots_;
  uint32_t asked_ = 0;
};

TEST(CubeSlots, SearchesOfCollidingCubesAreShort) {
  for (const oracle::LatticePoint &step : oracle::colliding_steps) {
    Slots own(3000);
    for (int64_t k = -1500; k < 1500; ++k) {
      const hsp::CubeCoordinates cube{k * step[0], k * step[1], k * step[2]};
      ASSERT_EQ(hsp::linear_hash(cube), 0U);
      own.insert(cube);
      EXPECT_EQ(own.slots().is_tree(), k >= -1500 + 64);
    }
    own.expect_all();
    EXPECT_LE(own.slots().longest_search(), 64U);
    for (int64_t k = 1500; k < 3000; ++k) {
      ASSERT_EQ(own.find({k * step[0], k * step[1], k * step[2]}), hsp::no_id);
      ASSERT_LE(own.asked(), 64U);
    }
  }
}

// Cubes that share as many bits as cubes of a lattice can, and collide so that they become a tree at all.
TEST(CubeSlots, NoWayDownATreeIsLongerThanACube) {
  const oracle::LatticePoint &step = oracle::colliding_steps[0];
  Slots own(300);
  for (int64_t k = 1; k < 100; ++k) own.insert({k * step[0], k * step[1], k * step[2]});
  for (uint32_t bit = 0; bit < 52; ++bit) {
    own.insert({-(int64_t{1} << bit), 0, 0});
    own.insert({0, -(int64_t{1} << bit), 0});
    own.insert({0, 0, -(int64_t{1} << bit)});
  }
  own.expect_all();
  ASSERT_TRUE(own.slots().is_tree());
  EXPECT_GT(own.slots().longest_search(), 52U);
  EXPECT_LE(own.slots().longest_search(), hsp::CubePath::most_bits + 2);
}

// Cubes in the first slots of their probe sequences, which are all slots of another one's.
TEST(CubeSlots, WhatIsNotThereIsNotSearchedForLong) {
  constexpr uint32_t numbers = 2048;
  Slots own(numbers);
  const uint32_t size = own.slots().size();
  const hsp::CubeCoordinates absent{5, -3, 8};
  std::vector<bool> taken(size);
  hsp::CubeProbe probe(hsp::linear_hash(absent), size);
  for (uint32_t k = 0; k < numbers; ++k, probe.next()) taken[probe.slot] = true;
  for (int64_t x = 100, left = numbers; left > 0; ++x) {
    const hsp::CubeCoordinates cube{x, 0, 0};
    const uint32_t slot = hsp::CubeProbe(hsp::linear_hash(cube), size).slot;
    if (!taken[slot]) continue;
    taken[slot] = false;
    own.insert(cube);
    --left;
  }
  own.expect_all();
  EXPECT_FALSE(own.slots().is_tree());
  EXPECT_EQ(own.slots().longest_search(), 1U);
  EXPECT_EQ(own.find(absent), hsp::no_id);
  EXPECT_EQ(own.asked(), 1U);
}

// Numbers are left out whose cubes are there, as a tree is made, too.
TEST(CubeSlots, NumbersOfCubesThatAreThereAreLeftOut) {
  for (const bool collide : {false, true}) {
    constexpr uint32_t n = 600;
    const auto cube_of = [collide](uint32_t number) {
      return collide ? colliding_cube(number / 3) : hsp::CubeCoordinates{number / 3, 1, 2};
    };
    std::vector<uint32_t> memory(hsp::CubeSlots::slots_for(n));
    hsp::CubeSlots slots({memory.data(), static_cast<uint32_t>(memory.size())});
    slots.clear(n);
    for (uint32_t number = 0; number < n; ++number) {
      const hsp::CubeCoordinates cube = cube_of(number);
      const uint32_t found = slots.find(cube, hsp::linear_hash(cube), cube_of);
      ASSERT_EQ(found, number % 3 == 0 ? hsp::no_id : number - number % 3);
      if (found == hsp::no_id) slots.insert(number, cube_of);
    }
    EXPECT_EQ(slots.is_tree(), collide);
  }
}

// The order in which the grid has its cubes: all of a layer, row by row.
TEST(CubeSlots, CubesComeByZThenYThenX) {
  std::vector<hsp::CubeCoordinates> cubes;
  for (const int64_t z : {-5, 0, 7}) {
    for (const int64_t y : {-9, -1, 3}) {
      for (const int64_t x : {-2, 4, 6}) cubes.push_back({x, y, z});
    }
  }
  for (size_t a = 0; a < cubes.size(); ++a) {
    for (size_t b = 0; b < cubes.size(); ++b) EXPECT_EQ(hsp::comes_before(cubes[a], cubes[b]), a < b) << a << ' ' << b;
  }
}

}  // namespace
