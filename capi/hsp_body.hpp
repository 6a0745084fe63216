// What is behind the handle hsp_body.
#pragma once

#include "handle_memory.hpp"
#include "poses/sphere_tree.hpp"

struct hsp_body {
  using Builder = hsp::SphereTree;
  static constexpr uint64_t kind = 0x626F6479;  // "body" in ASCII

  uintptr_t tag;
  Builder tree;
};
