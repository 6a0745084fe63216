// Contacts between groups of balls: residues, chains, molecules. Areas and rims of all contacts between two groups are
// summed in the order in which contacts were found, which does not depend on the order of the input.
#pragma once

#include "contacts/contacts.hpp"
#include "core/sorting.hpp"

namespace hsp {

struct GroupContact {
  uint32_t group[2];      // ascending
  uint32_t contacts = 0;  // how many, each of a ball of the one group and a ball of the other
  double area = 0.0;      // in lattice steps
  double rim = 0.0;       // in lattice steps
};

// The group of each ball.
struct BallGroups {
  const uint32_t *group;            // by the caller's index; no_id for balls of no group
  const uint32_t *owner = nullptr;  // null, or for each ball in the caller's order the index of its group in `group`

  uint32_t of(const BallSet &balls, uint32_t i) const {
    const uint32_t caller = balls.caller[i];
    return group[owner == nullptr ? caller : owner[caller]];
  }
};

// The contacts between balls of different groups.
class ContactGroups {
 public:
  // Looks at the first `number` contacts alone. scratch [contacts]
  ContactGroups(const BallSet &balls, const Contacts &contacts, uint32_t number, const BallGroups &groups,
                Span<uint32_t> scratch)
      : balls_(balls), contacts_(contacts), groups_(groups) {
    uint32_t count = 0;
    for (uint32_t id = 0; id < number; ++id) {
      const Pair pair = pair_of(id);
      if (pair.low < pair.high && pair.high != no_id) scratch[count++] = id;
    }
    order_ = scratch.part(0, count);
    sort_in_place(order_, [this](uint32_t a, uint32_t b) {
      const Pair p = pair_of(a);
      const Pair q = pair_of(b);
      return p.low != q.low ? p.low < q.low : p.high != q.high ? p.high < q.high : a < b;
    });
  }

  // Calls sink(contact) with the GroupContact of every two groups that have contacts, ascending.
  template <class Sink>
  void visit(Sink sink) const {
    for (uint32_t k = 0; k < order_.size();) {
      const Pair pair = pair_of(order_[k]);
      GroupContact sum{{pair.low, pair.high}};
      for (; k < order_.size(); ++k) {
        const Pair next = pair_of(order_[k]);
        if (next.low != pair.low || next.high != pair.high) break;
        const ContactRecord &contact = contacts_.contact(order_[k]);
        ++sum.contacts;
        sum.area += contact.area;
        sum.rim += contact.rim;
      }
      sink(sum);
    }
  }

 private:
  struct Pair {
    uint32_t low, high;
  };
  Pair pair_of(uint32_t id) const {
    const ContactRecord &contact = contacts_.contact(id);
    const uint32_t a = groups_.of(balls_, contact.ball[0]);
    const uint32_t b = groups_.of(balls_, contact.ball[1]);
    return a < b ? Pair{a, b} : Pair{b, a};
  }

  const BallSet &balls_;
  const Contacts &contacts_;
  const BallGroups groups_;
  Span<uint32_t> order_;
};

}  // namespace hsp
