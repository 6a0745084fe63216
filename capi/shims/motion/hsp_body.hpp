// The inside of the handle hsp_body.
#pragma once

#include "handle_memory.hpp"
#include "poses/sphere_tree.hpp"

struct hsp_body {
  using Builder = hsp::SphereTree;
  static constexpr auto kind = hsp::capi::HandleKind::body;

  uintptr_t tag;
  Builder tree;
  bool complete = true;  // whether the tree holds the balls that were set; if not it has none

  bool has_results() const { return complete; }
};
