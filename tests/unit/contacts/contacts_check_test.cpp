// The laws of contacts notice records that are broken. That whole ones obey them is seen with every set of the
// builder's tests.
#include "contacts/contacts_check.hpp"

#include <gtest/gtest.h>

#include "built_contacts.hpp"
#include "lattice_lengths.hpp"
#include "random_balls.hpp"

namespace {

using hsp::ContactInvariant;

class ContactsCheckTest : public testing::Test {
 protected:
  static support::BallList balls() {
    oracle::RandomSource random(95);
    return oracle::in_lengths(oracle::loose_balls(random, 30), 1);
  }
  hsp::ContactViolation check() const {
    return hsp::check_contacts(built_.balls(), built_.boundary(), built_.contacts());
  }
  hsp::ContactArrays &arrays() { return built_.builder().arrays(); }

  BuiltContacts built_{balls()};
};

TEST_F(ContactsCheckTest, AcceptsWhatWasBuilt) {
  ASSERT_EQ(built_.status(), hsp::Status::ok);
  EXPECT_EQ(check().invariant, ContactInvariant::none);
  EXPECT_EQ(check().id, hsp::no_id);
}

TEST_F(ContactsCheckTest, SeesAContactInNoRow) {
  arrays().row[0] = arrays().row[1];
  EXPECT_EQ(check().invariant, ContactInvariant::records);
}

// Each place of each row: a contact of other balls there, or the one before it again.
TEST_F(ContactsCheckTest, SeesEveryPlaceOfARow) {
  const uint32_t places = 2 * built_.contacts().contact_count();
  ASSERT_GT(places, 10U);
  for (uint32_t k = 0; k < places; ++k) {
    for (const uint32_t from : {k > 0 ? k - 1 : places - 1, (k + places / 2) % places}) {
      const uint32_t there = arrays().row[k];
      if (arrays().row[from] == there) continue;
      arrays().row[k] = arrays().row[from];
      EXPECT_EQ(check().invariant, ContactInvariant::records) << k << ' ' << from;
      arrays().row[k] = there;
    }
  }
  EXPECT_EQ(check().invariant, ContactInvariant::none);
}

TEST_F(ContactsCheckTest, SeesNumbersThatNoContactHas) {
  const double area = arrays().contacts[3].area;
  arrays().contacts[3].area = -area - 1.0;
  EXPECT_EQ(check().invariant, ContactInvariant::records);
  EXPECT_EQ(check().id, 3U);
  arrays().contacts[3].area = 0.0 / (area - area);
  EXPECT_EQ(check().invariant, ContactInvariant::records);
}

TEST_F(ContactsCheckTest, SeesAWrongCount) {
  ++arrays().simplices.of[3][2];
  EXPECT_EQ(check().invariant, ContactInvariant::euler);
}

TEST_F(ContactsCheckTest, SeesAnAreaThatIsALittleOff) {
  arrays().contacts[5].area *= 1.0 + 1e-9;
  EXPECT_EQ(check().invariant, ContactInvariant::closure);
}

TEST_F(ContactsCheckTest, SeesAVolumeThatIsALittleOff) {
  arrays().share_volume[7] *= 1.0 + 1e-8;
  EXPECT_EQ(check().invariant, ContactInvariant::volume);
}

// The first and the last one, too.
TEST_F(ContactsCheckTest, SeesEveryContactThatIsImpossible) {
  const uint32_t count = built_.contacts().contact_count();
  ASSERT_GT(count, 20U);
  for (uint32_t id = 0; id < count; ++id) {
    const hsp::ContactRecord right = arrays().contacts[id];
    for (double hsp::ContactRecord::*number : {&hsp::ContactRecord::area, &hsp::ContactRecord::rim}) {
      for (const double wrong : {-1.0, 1e300}) {
        arrays().contacts[id].*number = wrong;
        EXPECT_EQ(check().invariant, ContactInvariant::records);
        EXPECT_EQ(check().id, id);
        arrays().contacts[id] = right;
      }
    }
  }
}

TEST_F(ContactsCheckTest, SeesEveryAreaThatIsALittleOff) {
  for (uint32_t id = 0; id < built_.contacts().contact_count(); ++id) {
    const hsp::ContactRecord right = arrays().contacts[id];
    arrays().contacts[id].area += 1e-4;
    EXPECT_EQ(check().invariant, ContactInvariant::closure);
    EXPECT_EQ(check().id, right.ball[0]);
    arrays().contacts[id] = right;
  }
}

}  // namespace
