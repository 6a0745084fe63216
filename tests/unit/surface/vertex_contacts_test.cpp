#include "vertex_contacts_cases.hpp"

#include "expect_cases.hpp"

TEST(VertexContacts, Cases) {
  expect_cases(cases::surface_vertex_contacts);
}
