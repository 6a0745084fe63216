// A model of a set of balls in memory of exactly the size that is asked for, so that a sanitizer sees every byte
// beyond.
#pragma once

#include <hardsphere.h>

#include "fuzz_input.hpp"

namespace fuzz {

inline hsp_model_options options_of(const ScaledBalls &set) {
  hsp_model_options options;
  FUZZ_REQUIRE(hsp_model_options_init(&options, sizeof options) == HSP_OK, "options");
  options.probe = set.length(set.probe_steps);
  options.step = set.step();
  return options;
}

class CheckedModel {
 public:
  CheckedModel(const ScaledBalls &set, size_t misalignment) {
    const support::BallList list = set.in_lengths();
    const hsp_model_options options = options_of(set);
    size_t bytes = 0;
    uint32_t bad = 0;
    FUZZ_REQUIRE(hsp_model_bytes(set.n(), &bytes) == HSP_OK, "size");
    FUZZ_REQUIRE(bytes <= HSP_MODEL_BYTES(set.n()), "hsp_model_bytes, property 1");
    memory_.assign(misalignment + bytes, 0xC3);
    FUZZ_REQUIRE(hsp_model_init(memory_.data() + misalignment, bytes, set.n(), &model_) == HSP_OK, "init");
    FUZZ_REQUIRE(hsp_model_set(model_, list.size(), list.xyz.data(), list.radius.data(), &options, &bad) == HSP_OK,
                 "set");
    FUZZ_REQUIRE(bad == HSP_NONE, "first_bad after HSP_OK");
  }
  CheckedModel(const CheckedModel &) = delete;
  CheckedModel &operator=(const CheckedModel &) = delete;

  hsp_model *get() const { return model_; }

 private:
  std::vector<uint8_t> memory_;
  hsp_model *model_ = nullptr;
};

}  // namespace fuzz
