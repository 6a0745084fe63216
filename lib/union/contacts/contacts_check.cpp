// Checks the invariants of contacts, one after the other.
//
// As an example the three balls of contacts_builder.hpp: rows have 2 + 2 + 2 entries, twice the number of contacts.
// Their simplices have Euler's number 3 - 3 + 1 = 1, and twice that is 2, that of the boundary, which is one sphere.
#include "contacts/contacts_check.hpp"

#include "core/summation.hpp"
#include "measure/gradients.hpp"

namespace hsp {
namespace {

constexpr double tolerance = 0x1p-44;

class ContactsCheck {
 public:
  ContactsCheck(const BallSet &balls, const Boundary &boundary, const Contacts &contacts)
      : balls_(balls), boundary_(boundary), contacts_(contacts) {}

  ContactViolation run() const {
    uint64_t in_rows = 0;
    for (uint32_t i = 0; i < balls_.n; ++i) {
      in_rows += contacts_.row(i).size();
      const uint32_t misplaced = misplaced_in_row(i);
      if (misplaced != no_id) return {ContactInvariant::records, misplaced};
    }
    if (in_rows != 2 * uint64_t{contacts_.contact_count()}) return {ContactInvariant::records, 0};
    for (uint32_t id = 0; id < contacts_.contact_count(); ++id) {
      if (!is_possible(id)) return {ContactInvariant::records, id};
    }
    if (2 * contacts_.simplices().euler() != boundary_.euler()) return {ContactInvariant::euler, 0};
    return check_shares();
  }

 private:
  // A row has contacts of its ball, ascending by the other ball, so each once. If all rows are like this and have twice
  // as many entries as there are contacts, each contact is listed at both of its balls.
  uint32_t misplaced_in_row(uint32_t i) const {
    uint32_t before = no_id;
    for (const uint32_t id : contacts_.row(i)) {
      const ContactRecord &contact = contacts_.contact(id);
      if (contact.ball[0] != i && contact.ball[1] != i) return id;
      if (before != no_id && !balls_.given_before(before, contact.other(i))) return id;
      before = contact.other(i);
    }
    return no_id;
  }

  bool is_possible(uint32_t id) const {
    const ContactRecord &contact = contacts_.contact(id);
    const auto [a, b] = contact.ball;
    if (a >= b) return false;
    const double r = balls_.r[a] < balls_.r[b] ? balls_.r[a] : balls_.r[b];
    const double slack = 1.0 + tolerance * (4.0 + contact.chords);
    // Written so that a value that is not a number fails.
    return contact.area >= 0.0 && contact.area <= pi * r * r * slack && contact.rim >= 0.0 &&
           contact.rim <= 2 * pi * r * slack;
  }

  ContactViolation check_shares() const {
    TreeSum shares, union_volume;
    double scale = 0.0;
    for (uint32_t i = 0; i < balls_.n; ++i) {
      const double r = balls_.r[i];
      const BallGradient faces = gradient_of_ball(balls_, boundary_, {}, i);
      double terms = 8.0 + boundary_.half_edges(i).size() + boundary_.circles(i).size();
      Vec3 sum = faces.vector_area;
      union_volume.add(faces.measure.volume);
      for (const uint32_t id : contacts_.row(i)) {
        const ContactRecord &contact = contacts_.contact(id);
        const Vec3 v = balls_.difference(i, contact.other(i));
        sum = combine(1.0, sum, contact.area / std::sqrt(dot(v, v)), v);
        terms += 2.0 + contact.chords;
      }
      const double error = tolerance * terms * r * r;
      if (!(dot(sum, sum) <= error * error)) return {ContactInvariant::closure, i};
      const Vec3 arm = offset_from_origin(balls_, boundary_, i);
      shares.add(contacts_.share_volume(i));
      scale += error * (r + std::sqrt(dot(arm, arm)));
    }
    const double difference = shares.total() - union_volume.total();
    return std::fabs(difference) <= scale ? ContactViolation{} : ContactViolation{ContactInvariant::volume, 0};
  }

  const BallSet &balls_;
  const Boundary &boundary_;
  const Contacts &contacts_;
};

}  // namespace

ContactViolation check_contacts(const BallSet &balls, const Boundary &boundary, const Contacts &contacts) {
  return ContactsCheck(balls, boundary, contacts).run();
}

}  // namespace hsp
