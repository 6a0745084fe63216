// Memory for one object that is carved out of a workspace, of the size that it asks for.
#pragma once

#include <vector>

#include "core/poison.hpp"
#include "core/status.hpp"
#include "core/workspace.hpp"

class CarvedMemory {
 public:
  CarvedMemory() = default;
  ~CarvedMemory() { hsp::unpoison(memory_.data(), memory_.size()); }
  CarvedMemory(const CarvedMemory &) = delete;
  CarvedMemory &operator=(const CarvedMemory &) = delete;

  // Earlier carvings lose their memory.
  template <class Carved, class... Limits>
  void carve(Carved &carved, const Limits &...limits) {
    hsp::unpoison(memory_.data(), memory_.size());
    hsp::Workspace measured;
    carved.carve(measured, limits...);
    memory_.assign(measured.bytes(), 0);
    hsp::Workspace workspace(memory_.data(), memory_.size());
    carved.carve(workspace, limits...);
  }

  // Carves the builder and builds, with larger limits until they suffice.
  template <class Builder, class Limits, class... Inputs>
  hsp::Status build(Builder &builder, Limits limits, const Inputs &...inputs) {
    for (;;) {
      carve(builder, limits);
      const hsp::Status status = builder.build(inputs...);
      if (status != hsp::Status::capacity) return status;
      limits = covering(limits, builder.needed());
    }
  }

 private:
  std::vector<unsigned char> memory_;
};
