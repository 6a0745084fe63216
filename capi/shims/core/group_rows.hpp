// The conversion of contacts between groups at the C interface, for unions in free space and in boxes.
#pragma once

#include "contacts/contact_groups.hpp"
#include "conversion.hpp"

namespace hsp::capi {

// lattice: the input's.
inline int32_t put_groups(const ContactGroups &groups, const exact::Lattice &lattice, hsp_group_contact *out,
                          uint32_t capacity, uint32_t *needed) {
  uint32_t count = 0;
  groups.visit([&count](const GroupContact &) { ++count; });
  if (const int32_t status = check_output(capacity, count, needed); status != HSP_OK) return status;
  groups.visit([&](const GroupContact &sum) {
    *out++ = {lattice.area(sum.area), lattice.length(sum.rim), {sum.group[0], sum.group[1]}, sum.contacts, 0};
  });
  return HSP_OK;
}

}  // namespace hsp::capi
