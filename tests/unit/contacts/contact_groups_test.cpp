// Sums over pairs of groups against sums in a map.
#include "contacts/contact_groups.hpp"

#include <gtest/gtest.h>

#include <map>

#include "built_contacts.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"

namespace {

TEST(ContactGroups, SumUpTheContactsBetweenThem) {
  oracle::RandomSource random(91);
  for (int set = 0; set < 20; ++set) {
    const oracle::Balls balls = oracle::loose_balls(random, 40);
    BuiltContacts built(oracle::in_lengths(balls, 1));
    ASSERT_EQ(built.status(), hsp::Status::ok);
    std::vector<uint32_t> group(balls.size());
    for (uint32_t &g : group) {
      g = random.below(6) * 1000;
      if (g == 0) g = hsp::no_id;
    }
    struct Sum {
      uint32_t contacts = 0;
      double area = 0.0, edge = 0.0;
    };
    std::map<std::array<uint32_t, 2>, Sum> expected;
    for (uint32_t id = 0; id < built.contacts().contact_count(); ++id) {
      const hsp::ContactRecord &contact = built.contacts().contact(id);
      std::array<uint32_t, 2> pair{group[built.balls().caller[contact.ball[0]]],
                                   group[built.balls().caller[contact.ball[1]]]};
      if (pair[0] == pair[1] || pair[0] == hsp::no_id || pair[1] == hsp::no_id) continue;
      if (pair[0] > pair[1]) std::swap(pair[0], pair[1]);
      Sum &sum = expected[pair];
      ++sum.contacts;
      sum.area += contact.area;
      sum.edge += contact.rim;
    }
    auto next = expected.begin();
    const hsp::ContactGroups groups(built.balls(), built.contacts(), built.contacts().contact_count(), {group.data()},
                                    built.builder().scratch());
    groups.visit([&](const hsp::GroupContact &found) {
      ASSERT_NE(next, expected.end());
      EXPECT_EQ(found.group[0], next->first[0]);
      EXPECT_EQ(found.group[1], next->first[1]);
      EXPECT_EQ(found.contacts, next->second.contacts);
      EXPECT_EQ(found.area, next->second.area);
      EXPECT_EQ(found.rim, next->second.edge);
      ++next;
    });
    EXPECT_EQ(next, expected.end());
    EXPECT_GT(expected.size(), 5U);
  }
}

}  // namespace
