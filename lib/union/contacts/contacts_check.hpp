// Checks invariants of contacts and shares, from their records and from the boundary. The two are computed in ways that
// have little in common. The tolerances are bounds of rounding.
#pragma once

#include "contacts/contacts.hpp"
#include "core/violation.hpp"

namespace hsp {

// Numbered as in hardsphere.h.
enum class ContactInvariant : uint32_t {
  none = 0,
  records = 1,  // each contact is in the rows of its two balls, and its numbers are within their ranges
  euler = 2,    // the boundary's Euler characteristic is twice that of the dual complex
  closure = 3,  // the vector areas of a ball's faces and contacts, which bound its share, sum to 0
  volume = 4,   // the shares sum to the volume of the union
};

// The invariant, and the id of the contact or ball that violates it.
using ContactViolation = Violation<ContactInvariant>;

// O(size)
ContactViolation check_contacts(const BallSet &balls, const Boundary &boundary, const Contacts &contacts);

}  // namespace hsp
