#include "owned_handle.hpp"

namespace support {

void expect_ok(int32_t status, const char *call) {
  if (status != HSP_OK) throw std::runtime_error(std::string(call) + ": " + hsp_status_text(status));
}

OwnedModel::OwnedModel(uint32_t most_balls) {
  size_t bytes = 0;
  expect_ok(hsp_model_bytes(most_balls, &bytes), "hsp_model_bytes");
  memory_.resize(bytes);
  expect_ok(hsp_model_init(memory_.data(), bytes, most_balls, &model_), "hsp_model_init");
}

int32_t OwnedModel::set(const BallList &balls, const hsp_model_options *options, uint32_t *first_bad) {
  return hsp_model_set(model_, balls.size(), balls.xyz.data(), balls.radius.data(), options, first_bad);
}

hsp_boundary_limits default_boundary_limits(uint32_t balls) {
  hsp_boundary_limits limits;
  expect_ok(hsp_boundary_limits_init(&limits, sizeof limits, balls), "hsp_boundary_limits_init");
  return limits;
}

hsp_topology_limits topology_limits_for(const hsp_boundary *boundary) {
  hsp_topology_limits limits;
  expect_ok(hsp_topology_limits_init(&limits, sizeof limits, boundary), "hsp_topology_limits_init");
  return limits;
}

hsp_contacts_limits contacts_limits_for(const hsp_boundary *boundary) {
  hsp_contacts_limits limits;
  expect_ok(hsp_contacts_limits_init(&limits, sizeof limits, boundary), "hsp_contacts_limits_init");
  return limits;
}

}  // namespace support
