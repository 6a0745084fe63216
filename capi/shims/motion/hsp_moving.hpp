// The inside of the handle hsp_moving.
#pragma once

#include "handle_memory.hpp"
#include "moving/moving_balls.hpp"

struct hsp_moving {
  using Builder = hsp::MovingBalls;
  static constexpr auto kind = hsp::capi::HandleKind::moving;
  using Given = hsp_moving_limits;
  using Limits = hsp::capi::LimitFields<hsp::MovingLimits, Given, offsetof(Given, balls), offsetof(Given, neighbours)>;

  uintptr_t tag;
  Builder builder;
  bool complete = false;

  bool has_results() const { return complete; }
};
