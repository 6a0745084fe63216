// Balls in periodic boxes against the same balls in many explicit copies, of which the library computes the union
// without a box: the middle copy must have the same numbers.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <vector>

#include "built_contacts.hpp"
#include "built_periodic.hpp"
#include "curvature/curvature.hpp"
#include "measure/areas.hpp"
#include "periodic/periodic_check.hpp"
#include "random_balls.hpp"

inline support::BallList balls_of(const std::vector<std::array<double, 4>> &list) {
  support::BallList balls;
  for (const auto &b : list) balls.add(b[0], b[1], b[2], b[3]);
  return balls;
}

inline void add_copy(const support::BallList &balls, const BoxVectors &box, const std::array<int, 3> &times, uint32_t i,
                     support::BallList &copies) {
  double at[3];
  for (size_t axis = 0; axis < 3; ++axis) {
    at[axis] = balls.xyz[3 * i + axis];
    for (size_t row = 0; row < 3; ++row) at[axis] += times[row] * box[3 * row + axis];
  }
  copies.add(at[0], at[1], at[2], balls.radius[i]);
}

// The balls of the middle copy first.
inline support::BallList copies_around(const support::BallList &balls, const BoxVectors &box, int range) {
  support::BallList copies = balls;
  for (int a = -range; a <= range; ++a) {
    for (int b = -range; b <= range; ++b) {
      for (int c = -range; c <= range; ++c) {
        if (a == 0 && b == 0 && c == 0) continue;
        for (uint32_t i = 0; i < balls.size(); ++i) add_copy(balls, box, {a, b, c}, i, copies);
      }
    }
  }
  return copies;
}

struct Crystal {
  support::BallList balls;
  BoxVectors box{};
};

// Whole numbers, so that everything is on the lattice, and often ties.
struct RandomCrystal : Crystal {
  RandomCrystal(oracle::RandomSource &random, bool tied, int64_t largest = 3) {
    const int64_t unit = tied ? 2 : 1000;
    const auto whole = [&](int64_t least, int64_t most) {
      return static_cast<double>(tied ? random.in(least, most) * unit : random.in(least * unit, most * unit));
    };
    box = {whole(4, 6), 0, 0, whole(-3, 3), whole(4, 6), 0, whole(-3, 3), whole(-3, 3), whole(4, 6)};
    if (random.one_in(2)) box[3] = box[6] = box[7] = 0;
    const int64_t n = random.in(1, 5);
    for (int64_t i = 0; i < n; ++i) {
      const double x = whole(-9, 9), y = whole(-9, 9), z = whole(-9, 9);
      balls.add(x, y, z, whole(1, largest));
    }
    if (random.one_in(4)) balls.add(balls.xyz[0], balls.xyz[1], balls.xyz[2], balls.radius[0]);
  }
};

inline void expect_laws(const BuiltPeriodic &built) {
  const hsp::PeriodicViolation violation = hsp::check_periodic(built.get());
  EXPECT_EQ(violation.invariant, hsp::PeriodicInvariant::none) << "ball " << violation.id;
  // Images, neighbours, vertices with circles, and contacts may each need one more try.
  EXPECT_LE(built.retries(), 4U);
}

// A contact with an image must be the same one from either of its two balls.
inline void expect_one_contact_from_both_sides(const BuiltPeriodic &built) {
  for (uint32_t i = 0; i < built.balls(); ++i) {
    built->visit_contacts_of(i, [&](const hsp::PeriodicContact &contact) {
      const hsp::BoxShift shift = built->images().shift_of(contact.other);
      const uint32_t back = built->images().find(i, hsp::BoxShift{} - shift);
      uint32_t found = 0;
      built->visit_contacts_of(built->images().ball_of(contact.other), [&](const hsp::PeriodicContact &seen) {
        if (seen.other != back) return;
        ++found;
        EXPECT_EQ(seen.record->area, contact.record->area);
        EXPECT_EQ(seen.record->rim, contact.record->rim);
        EXPECT_EQ(seen.record->chords, contact.record->chords);
        EXPECT_EQ(seen.record->code, contact.record->code);
      });
      EXPECT_EQ(found, 1U);
    });
  }
}

// Each ball must have the same counts, areas, volumes and contacts in the box as in the middle of explicit copies.
inline void expect_as_in_copies(const Crystal &crystal, int range = 4) {
  const BuiltPeriodic built(crystal.balls, crystal.box);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  expect_laws(built);
  expect_one_contact_from_both_sides(built);
  // Radii are at most 3, boxes at least 4 high along each axis, and vectors lean by as much as they are high.
  support::BallList inside;
  for (uint32_t i = 0; i < built.balls(); ++i) {
    const hsp::exact::LatticeBall ball = built->balls().ball(built->grid().grid_index(i));
    inside.add(static_cast<double>(ball.centre.x), static_cast<double>(ball.centre.y),
               static_cast<double>(ball.centre.z), static_cast<double>(ball.radius));
  }
  const BuiltContacts copies(copies_around(inside, crystal.box, range));
  ASSERT_EQ(copies.status(), hsp::Status::ok);
  for (uint32_t i = 0; i < built.balls(); ++i) {
    const uint32_t here = built->grid().grid_index(i);
    const uint32_t there = copies.grid().grid_index(i);
    EXPECT_EQ(built->boundary().half_edges(here).size(), copies.boundary().half_edges(there).size());
    EXPECT_EQ(built->boundary().circles(here).size(), copies.boundary().circles(there).size());
    EXPECT_EQ(built->boundary().loops(here).size(), copies.boundary().loops(there).size());
    EXPECT_EQ(built->boundary().faces(here).size(), copies.boundary().faces(there).size());
    EXPECT_EQ(built->boundary().is_contained(here), copies.boundary().is_contained(there));
    const double r = inside.radius[i];
    EXPECT_NEAR(built.of_ball(i).area, hsp::measure_ball(copies.balls(), copies.boundary(), there).area, 1e-10 * r * r);
    EXPECT_NEAR(built.of_ball(i).volume, copies.contacts().share_volume(there), 1e-10 * r * r * r);
    const hsp::BallCurvature curved = hsp::curvature_of_ball(built->balls(), built->boundary(), here);
    const hsp::BallCurvature as_there = hsp::curvature_of_ball(copies.balls(), copies.boundary(), there);
    EXPECT_NEAR(curved.mean, as_there.mean, 1e-10 * r);
    EXPECT_EQ(curved.gauss, as_there.gauss);
    // Contacts by the distance of the other ball.
    const auto contacts_of = [&](const hsp::BallSet &set, const hsp::Contacts &contacts, uint32_t ball) {
      std::multimap<std::array<double, 4>, const hsp::ContactRecord *> found;
      for (const uint32_t id : contacts.row(ball)) {
        const uint32_t other = contacts.contact(id).other(ball);
        const hsp::Vec3 v = set.difference(ball, other);
        found.insert({{v.x, v.y, v.z, set.r[other]}, &contacts.contact(id)});
      }
      return found;
    };
    const auto mine = contacts_of(built->balls(), built->contacts(), here);
    const auto theirs = contacts_of(copies.balls(), copies.contacts(), there);
    ASSERT_EQ(mine.size(), theirs.size());
    for (auto p = mine.begin(), q = theirs.begin(); p != mine.end(); ++p, ++q) {
      EXPECT_EQ(p->first, q->first);
      EXPECT_NEAR(p->second->area, q->second->area, 1e-10 * r * r);
      EXPECT_NEAR(p->second->rim, q->second->rim, 1e-10 * r);
      EXPECT_EQ(p->second->chords, q->second->chords);
      EXPECT_EQ(p->second->code, q->second->code);
    }
  }
}
