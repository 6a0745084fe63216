#include "periodic/periodic_check.hpp"

#include "core/first_index.hpp"
#include "core/summation.hpp"
#include "measure/gradients.hpp"

namespace hsp {
namespace {

constexpr double relative_error = 0x1p-44;

class PeriodicCheck {
 public:
  explicit PeriodicCheck(const PeriodicUnion &periodic)
      : periodic_(periodic), balls_(periodic.balls()), images_(periodic.images()) {}

  // Let c_i be the places in the box and N_i the vector areas of faces. The divergence theorem in the share of each
  // ball gives 3 V = sum of r_i A_i + c_i.N_i, plus terms of the contacts. The terms of a contact of two balls in the
  // box cancel. A contact with an image, t away from its ball, leaves t.u times its area, half of it at each of its two
  // places.
  PeriodicViolation run() {
    for (uint32_t i = 0; i < images_.balls(); ++i) {
      if (const PeriodicViolation found = check_ball(i); found.invariant != PeriodicInvariant::none) return found;
    }
    const double total[3] = {outside_[0].total(), outside_[1].total(), outside_[2].total()};
    for (const double sum : total) {
      if (!(std::fabs(sum) <= error_.total())) return {PeriodicInvariant::outside, no_id};
    }
    const double difference = shares_.total() - divergence_.total() / 3;
    if (!(std::fabs(difference) <= volume_error_.total())) return {PeriodicInvariant::volume, no_id};
    return {};
  }

 private:
  PeriodicViolation check_ball(uint32_t i) {
    const uint32_t own = periodic_.grid().grid_index(i);
    const Boundary &boundary = periodic_.boundary();
    const double r = balls_.r[own];
    const BallGradient faces = gradient_of_ball(balls_, boundary, {}, own);
    double terms = 8.0 + boundary.half_edges(own).size() + boundary.circles(own).size();
    Vec3 sum = faces.vector_area;
    const Vec3 centre{balls_.x[own], balls_.y[own], balls_.z[own]};
    double divergence = r * faces.measure.area + dot(centre, faces.vector_area);
    double arm = r + std::sqrt(dot(centre, centre));
    bool is_mirrored = true;
    periodic_.visit_contacts_of(i, [&](const PeriodicContact &contact) {
      const Vec3 v = balls_.difference(own, periodic_.grid().grid_index(contact.other));
      const double scaled = contact.record->area / std::sqrt(dot(v, v));
      sum = combine(1.0, sum, scaled, v);
      terms += 2.0 + contact.record->chords;
      is_mirrored = is_mirrored && is_there_from(contact);
      if (!images_.is_image(contact.other)) return;
      const Vec3 t = to_double(images_.box().translation(images_.shift_of(contact.other)));
      divergence += 0.5 * scaled * dot(t, v);
      arm += std::sqrt(dot(t, t));
    });
    if (!is_mirrored) return {PeriodicInvariant::records, i};
    const double error = relative_error * terms * r * r;
    if (!(dot(sum, sum) <= error * error)) return {PeriodicInvariant::closure, i};
    outside_[0].add(faces.vector_area.x);
    outside_[1].add(faces.vector_area.y);
    outside_[2].add(faces.vector_area.z);
    error_.add(error);
    shares_.add(periodic_.contacts().share_volume(own));
    divergence_.add(divergence);
    volume_error_.add(error * arm);
    return {};
  }

  // Whether the same contact is there at the other ball's place in the box. The contacts of a ball ascend.
  bool is_there_from(const PeriodicContact &contact) const {
    const uint32_t other = periodic_.grid().grid_index(images_.ball_of(contact.other));
    const uint32_t back = images_.find(contact.ball, BoxShift{} - images_.shift_of(contact.other));
    const Contacts &contacts = periodic_.contacts();
    const Span<const uint32_t> row = contacts.row(other);
    const auto leads_to = [&](uint32_t k) { return balls_.caller[contacts.contact(row[k]).other(other)]; };
    const uint32_t at = first_index(0, row.size(), [&](uint32_t k) { return leads_to(k) >= back; });
    if (at == row.size() || leads_to(at) != back) return false;
    const ContactRecord &mirrored = contacts.contact(row[at]);
    return mirrored.code == contact.record->code && mirrored.chords == contact.record->chords;
  }

  const PeriodicUnion &periodic_;
  const BallSet &balls_;
  const PeriodicImages &images_;
  TreeSum outside_[3];
  TreeSum error_, shares_, divergence_, volume_error_;
};

}  // namespace

PeriodicViolation check_periodic(const PeriodicUnion &periodic) {
  return PeriodicCheck(periodic).run();
}

}  // namespace hsp
