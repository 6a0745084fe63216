// A model of a set of balls in memory of exactly the size that is asked for, so that a sanitizer sees every byte
// beyond.
#pragma once

#include <hardsphere.h>

#include "fuzz_input.hpp"

namespace fuzz {

inline hsp_model_options options_of(const BallSet &set) {
  hsp_model_options options;
  FUZZ_REQUIRE(hsp_model_options_init(&options, sizeof options) == HSP_OK, "options");
  options.probe = set.length(set.probe_steps);
  options.step = set.step();
  return options;
}

class CheckedModel {
 public:
  CheckedModel(const BallSet &set, size_t misalignment) {
    const std::vector<double> xyz = set.xyz(), radius = set.radius();
    const hsp_model_options options = options_of(set);
    size_t bytes = 0;
    uint32_t bad = 0;
    FUZZ_REQUIRE(hsp_model_bytes(set.n(), &bytes) == HSP_OK, "size");
    FUZZ_REQUIRE(bytes <= HSP_MODEL_BYTES(set.n()), "hsp_model_bytes, property 1");
    memory_.assign(misalignment + bytes, 0xC3);
    FUZZ_REQUIRE(hsp_model_init(memory_.data() + misalignment, bytes, set.n(), &model_) == HSP_OK, "init");
    FUZZ_REQUIRE(hsp_model_set(model_, set.n(), xyz.data(), radius.data(), &options, &bad) == HSP_OK, "set");
    FUZZ_REQUIRE(bad == HSP_NONE, "first_bad after HSP_OK");
  }
  CheckedModel(const CheckedModel &) = delete;
  CheckedModel &operator=(const CheckedModel &) = delete;

  hsp_model *get() const { return model_; }

 private:
  std::vector<uint8_t> memory_;
  hsp_model *model_ = nullptr;
};

inline int64_t squared_distance(const std::array<int64_t, 3> &a, const std::array<int64_t, 3> &b) {
  int64_t sum = 0;
  for (size_t axis = 0; axis < 3; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return sum;
}

}  // namespace fuzz
