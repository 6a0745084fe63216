// Invariants of contacts and shares, checked from their records and the boundary: two ways to compute that have little
// in common. The tolerances are those of rounding.
#pragma once

#include "contacts/contacts.hpp"
#include "core/violation.hpp"

namespace hsp {

// Numbered as in hardsphere.h.
enum class ContactInvariant : uint32_t {
  none = 0,
  records = 1,  // each contact stands in the rows of its two balls, with numbers that it may have
  euler = 2,    // the boundary's Euler characteristic is twice that of the dual complex
  closure = 3,  // faces and contacts of a ball close its share: their vector areas sum to 0
  volume = 4,   // the shares sum to the volume of the union
};

// Where: the id of a contact or ball.
using ContactViolation = Violation<ContactInvariant>;

// O(size)
ContactViolation check_contacts(const BallSet &balls, const Boundary &boundary, const Contacts &contacts);

}  // namespace hsp
