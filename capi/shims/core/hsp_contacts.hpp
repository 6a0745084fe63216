// The inside of the handle hsp_contacts.
#pragma once

#include "contacts/contacts_builder.hpp"
#include "hsp_boundary.hpp"
#include "source.hpp"

struct hsp_contacts {
  using Builder = hsp::ContactsBuilder;
  static constexpr auto kind = hsp::capi::HandleKind::contacts;
  using Given = hsp_contacts_limits;
  using Limits =
      hsp::capi::LimitFields<hsp::ContactLimits, Given, offsetof(Given, balls), offsetof(Given, neighbours),
                             offsetof(Given, contacts), offsetof(Given, triangles), offsetof(Given, tetrahedra)>;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_boundary> boundary{};
  bool complete = false;

  // Whether results may be read: computed, and neither the boundary nor the model has changed since.
  bool has_results() const { return complete && boundary.is_unchanged(); }
  const hsp::Contacts &structure() const { return builder.contacts(); }
  const hsp::CubeGrid &grid() const { return boundary->model->grid; }
  const hsp::BallSet &balls() const { return boundary->balls(); }
};
