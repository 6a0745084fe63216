// The inside of the handle hsp_contacts.
#pragma once

#include "contacts/contacts_builder.hpp"
#include "hsp_boundary.hpp"

struct hsp_contacts : hsp::capi::FromBoundary<hsp::ContactsBuilder> {
  static constexpr auto kind = hsp::capi::HandleKind::contacts;
  using Given = hsp_contacts_limits;
  using Limits =
      hsp::capi::LimitFields<hsp::ContactLimits, Given, offsetof(Given, balls), offsetof(Given, neighbours),
                             offsetof(Given, contacts), offsetof(Given, triangles), offsetof(Given, tetrahedra)>;

  const hsp::Contacts &structure() const { return builder.contacts(); }
  const hsp::CubeGrid &grid() const { return boundary->model->grid; }
};
