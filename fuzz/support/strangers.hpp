// Addresses at which no live handle of the wanted kind lies: random bytes, another kind of handle, a copy of one that
// was moved, what is left of one whose memory was used for something else, a few bytes into a live one.
#pragma once

#include <hardsphere.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "fuzz_input.hpp"

namespace fuzz {

class Strangers {
 public:
  // One function of a random kind is given such an address and refuses it.
  static void call(Bytes &bytes) {
    Strangers strangers;
    const uint32_t kind = bytes.below(kinds);
    void *stranger = strangers.choose(bytes, kind);
    FUZZ_REQUIRE(call_as(kind, stranger, bytes) == HSP_E_HANDLE, "no handle, and not refused");
  }

 private:
  static constexpr uint32_t kinds = 5;  // model, boundary, topology, view, surface
  // What is copied and overwritten: every handle has as many, while gaps behind them may be poisoned.
  static constexpr size_t first_bytes = sizeof(uintptr_t);

  Strangers() {
    hsp_model *model = nullptr;
    FUZZ_REQUIRE(hsp_model_init(room(0, HSP_MODEL_BYTES(1)), HSP_MODEL_BYTES(1), 1, &model) == HSP_OK, "model");
    const hsp_boundary_limits of_boundary = {sizeof of_boundary, 1, 1, 1, 1, 0};
    const hsp_topology_limits of_topology = {sizeof of_topology, 1, 1, 4, 1, 0};
    const hsp_view_limits of_view = {sizeof of_view, 1, 1, 4};
    const hsp_surface_limits of_surface = {sizeof of_surface, 1, 1, 1, 1, 1, 1};
    hsp_boundary *boundary = nullptr;
    hsp_topology *topology = nullptr;
    hsp_view *view = nullptr;
    hsp_surface *surface = nullptr;
    size_t bytes = 0;
    FUZZ_REQUIRE(hsp_boundary_bytes(&of_boundary, &bytes) == HSP_OK, "boundary bytes");
    FUZZ_REQUIRE(hsp_boundary_init(room(1, bytes), bytes, &of_boundary, &boundary) == HSP_OK, "boundary");
    FUZZ_REQUIRE(hsp_topology_bytes(&of_topology, &bytes) == HSP_OK, "topology bytes");
    FUZZ_REQUIRE(hsp_topology_init(room(2, bytes), bytes, &of_topology, &topology) == HSP_OK, "topology");
    FUZZ_REQUIRE(hsp_view_bytes(&of_view, &bytes) == HSP_OK, "view bytes");
    FUZZ_REQUIRE(hsp_view_init(room(3, bytes), bytes, &of_view, &view) == HSP_OK, "view");
    FUZZ_REQUIRE(hsp_surface_bytes(&of_surface, &bytes) == HSP_OK, "surface bytes");
    FUZZ_REQUIRE(hsp_surface_init(room(4, bytes), bytes, &of_surface, &surface) == HSP_OK, "surface");
    live_ = {model, boundary, topology, view, surface};
  }

  void *room(size_t kind, size_t bytes) {
    memory_[kind].resize(bytes);
    return memory_[kind].data();
  }

  void *choose(Bytes &bytes, uint32_t kind) {
    auto *own = static_cast<unsigned char *>(live_[kind]);
    switch (bytes.below(5)) {
      case 0:
        other_.resize(1024);
        for (unsigned char &byte : other_) byte = static_cast<unsigned char>(bytes.below(256));
        return other_.data();
      case 1:
        return live_[(kind + 1 + bytes.below(kinds - 1)) % kinds];
      case 2:
        other_.assign(1024, 0);
        std::memcpy(other_.data(), own, first_bytes);
        return other_.data();
      case 3:
        std::memset(own, static_cast<int>(bytes.below(256)), first_bytes);
        return own;
      default:
        return own + 1 + bytes.below(7);
    }
  }

  static int32_t take_nothing(void *, const char *, size_t) { return 0; }
  // Functions that return no status say HSP_NONE.
  static int32_t status_of(uint32_t id) { return id == HSP_NONE ? HSP_E_HANDLE : HSP_OK; }

  static int32_t call_as_surface(hsp_surface *surface, Bytes &bytes) {
    hsp_surface_counts counts;
    hsp_surface_totals totals;
    hsp_surface_patch patch;
    uint32_t invariant = 0, id = 0;
    switch (bytes.below(5)) {
      case 0:
        return hsp_surface_get_counts(surface, &counts);
      case 1:
        return hsp_surface_measure(surface, &totals, nullptr, 0, nullptr);
      case 2:
        return hsp_surface_get_patches(surface, 0, 1, &patch);
      case 3:
        return status_of(hsp_surface_next(surface, 0));
      default:
        return hsp_surface_check(surface, &invariant, &id);
    }
  }

  static int32_t call_as(uint32_t kind, void *stranger, Bytes &bytes) {
    if (kind == 4) return call_as_surface(static_cast<hsp_surface *>(stranger), bytes);
    const double xyz[3] = {0.0, 0.0, 0.0};
    uint32_t needed = 0;
    if (kind == 0) {
      auto *model = static_cast<hsp_model *>(stranger);
      const double radius = 1.0;
      hsp_model_info info;
      switch (bytes.below(4)) {
        case 0:
          return hsp_model_set(model, 1, xyz, &radius, nullptr, nullptr);
        case 1:
          return hsp_model_get_info(model, &info);
        case 2:
          return hsp_query_point(model, xyz, nullptr, 0, &needed);
        default:
          return hsp_query_neighbours(model, 0, nullptr, 0, &needed);
      }
    }
    if (kind == 1) {
      auto *boundary = static_cast<hsp_boundary *>(stranger);
      hsp_boundary_counts counts;
      hsp_totals totals;
      uint32_t invariant = 0;
      switch (bytes.below(7)) {
        case 0:
          return hsp_boundary_get_counts(boundary, &counts);
        case 1:
          return hsp_boundary_get_arcs(boundary, nullptr, 0, &needed);
        case 2:
          return hsp_boundary_measure(boundary, nullptr, &totals, nullptr, nullptr, 0, nullptr);
        case 3:
          return hsp_boundary_begin(boundary, nullptr, 1, &needed);
        case 4:
          return hsp_boundary_work(boundary, bytes.below(4), bytes.below(4));
        case 5:
          return hsp_boundary_end(boundary, nullptr);
        default:
          return hsp_boundary_check(boundary, &invariant, &needed);
      }
    }
    if (kind == 2) {
      auto *topology = static_cast<hsp_topology *>(stranger);
      hsp_topology_counts counts;
      switch (bytes.below(4)) {
        case 0:
          return hsp_topology_get_counts(topology, &counts);
        case 1:
          return hsp_topology_locate(topology, xyz, &needed);
        case 2:
          return status_of(hsp_topology_onext(topology, bytes.below(8)));
        default:
          return hsp_topology_get_shells(topology, nullptr, 0, &needed);
      }
    }
    auto *view = static_cast<hsp_view *>(stranger);
    hsp_view_info info;
    switch (bytes.below(3)) {
      case 0:
        return hsp_view_get_info(view, &info);
      case 1:
        return hsp_view_get_arcs(view, nullptr, 0, &needed);
      default:
        return hsp_picture_write(view, nullptr, nullptr, nullptr, nullptr, take_nothing, nullptr, nullptr);
    }
  }

  std::array<std::vector<unsigned char>, kinds> memory_;
  std::array<void *, kinds> live_{};
  std::vector<unsigned char> other_;
};

}  // namespace fuzz
