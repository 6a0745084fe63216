// Answers of the checks of structures: the first invariant that is violated, and the record that violates it.
#pragma once

#include "core/status.hpp"

namespace hsp {

// Invariant: an enumeration as in hardsphere.h, in which `none` is 0. id: of the record that violates the invariant;
// no_id if none does.
template <class Invariant>
struct Violation {
  Invariant invariant = Invariant::none;
  uint32_t id = no_id;
};

// A base of checks that keeps the first violation.
template <class Invariant>
class FirstViolation {
 protected:
  bool holds() const { return violation_.invariant == Invariant::none; }
  // Always false, for functions that say whether an invariant holds.
  bool fail(Invariant invariant, uint32_t id) {
    if (holds()) violation_ = {invariant, id};
    return false;
  }

  Violation<Invariant> violation_;
};

}  // namespace hsp
