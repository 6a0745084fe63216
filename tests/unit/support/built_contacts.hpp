// Contacts over any balls, in memory of their own.
#pragma once

#include "boundary/boundary_builder.hpp"
#include "built_grid.hpp"
#include "contacts/contacts_builder.hpp"

class BuiltContacts {
 public:
  // Radii are without the probe; a step of 1 leaves whole numbers as they are, 0 lets the set choose.
  explicit BuiltContacts(const support::BallList &balls, double probe = 0.0, double step = 1.0, uint32_t simplices = 0)
      : built_(balls, probe, step), status_(built_.status()) {
    if (status_ != hsp::Status::ok) return;
    const uint32_t n = balls.size();
    status_ = boundary_memory_.build(boundary_, hsp::BoundaryLimits{n, 8, 8, 8, 0}, grid());
    if (status_ != hsp::Status::ok) return;
    hsp::ContactLimits limits{n, boundary_.needed().neighbours, 4, simplices, simplices};
    status_ = contacts_memory_.build(contacts_, limits, grid(), boundary(), neighbours());
  }

  hsp::Status status() const { return status_; }
  const hsp::CubeGrid &grid() const { return built_.grid(); }
  const hsp::BallSet &balls() const { return grid().balls(); }
  const hsp::Boundary &boundary() const { return boundary_.boundary(); }
  const hsp::Contacts &contacts() const { return contacts_.contacts(); }
  hsp::ContactsBuilder &builder() { return contacts_; }
  uint32_t neighbours() const { return boundary_.needed().neighbours; }

  // The contact of two balls, named by the caller's indices; null if they have none.
  const hsp::ContactRecord *between(uint32_t a, uint32_t b) const {
    const uint32_t first = grid().grid_index(a);
    for (const uint32_t id : contacts().row(first)) {
      if (contacts().contact(id).other(first) == grid().grid_index(b)) return &contacts().contact(id);
    }
    return nullptr;
  }
  // The contact's area, in the unit of length of the input.
  double area(uint32_t a, uint32_t b) const {
    const hsp::ContactRecord *const contact = between(a, b);
    return contact == nullptr ? -1.0 : balls().lattice.area(contact->area);
  }
  double cell(uint32_t i) const { return balls().lattice.volume(contacts().share_volume(grid().grid_index(i))); }
  double total_area() const {
    double sum = 0.0;
    for (uint32_t id = 0; id < contacts().contact_count(); ++id) sum += contacts().contact(id).area;
    return balls().lattice.area(sum);
  }

 private:
  BuiltGrid built_;
  CarvedMemory boundary_memory_, contacts_memory_;
  hsp::BoundaryBuilder boundary_;
  hsp::ContactsBuilder contacts_;
  hsp::Status status_;
};
