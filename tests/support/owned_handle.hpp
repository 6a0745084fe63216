// Handles of the C interface that own their memory. Those with limits take more memory until their computation
// succeeds.
#pragma once

#include <hardsphere.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "ball_list.hpp"

namespace support {

// Throws std::runtime_error with the call's name and the status text unless the status is HSP_OK.
void expect_ok(int32_t status, const char *call);

class OwnedModel {
 public:
  explicit OwnedModel(uint32_t most_balls);

  // The status of hsp_model_set. `options` and `first_bad` may be null.
  [[nodiscard]] int32_t set(const BallList &balls, const hsp_model_options *options, uint32_t *first_bad = nullptr);

  hsp_model *get() const { return model_; }

 private:
  std::vector<unsigned char> memory_;
  hsp_model *model_ = nullptr;
};

// Kinds of handles with limits. By the header so many enlargements by what a handle asks for lead to success.
struct BoundaryKind {
  using Handle = hsp_boundary;
  using Limits = hsp_boundary_limits;
  static constexpr int enlargements = 2;
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours, &Limits::vertices, &Limits::circles};
  static constexpr const char *name = "hsp_boundary";
  static constexpr auto bytes = hsp_boundary_bytes;
  static constexpr auto init = hsp_boundary_init;
};
struct SurfaceKind {
  using Handle = hsp_surface;
  using Limits = hsp_surface_limits;
  static constexpr int enlargements = 4;
  static constexpr std::array limits = {&Limits::vertices, &Limits::faces, &Limits::neighbours,
                                        &Limits::pieces,   &Limits::arcs,  &Limits::cusped_circles};
  static constexpr const char *name = "hsp_surface";
  static constexpr auto bytes = hsp_surface_bytes;
  static constexpr auto init = hsp_surface_init;
};
struct MeshKind {
  using Handle = hsp_mesh;
  using Limits = hsp_mesh_limits;
  static constexpr int enlargements = 20;
  static constexpr std::array limits = {&Limits::balls, &Limits::curves, &Limits::vertices, &Limits::triangles,
                                        &Limits::points};
  static constexpr const char *name = "hsp_mesh";
  static constexpr auto bytes = hsp_mesh_bytes;
  static constexpr auto init = hsp_mesh_init;
};
struct TopologyKind {
  using Handle = hsp_topology;
  using Limits = hsp_topology_limits;
  static constexpr int enlargements = 3;
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours, &Limits::edges, &Limits::cut_arcs};
  static constexpr const char *name = "hsp_topology";
  static constexpr auto bytes = hsp_topology_bytes;
  static constexpr auto init = hsp_topology_init;
};
struct ContactsKind {
  using Handle = hsp_contacts;
  using Limits = hsp_contacts_limits;
  static constexpr int enlargements = 3;
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours, &Limits::contacts};
  static constexpr const char *name = "hsp_contacts";
  static constexpr auto bytes = hsp_contacts_bytes;
  static constexpr auto init = hsp_contacts_init;
};
struct ViewKind {
  using Handle = hsp_view;
  using Limits = hsp_view_limits;
  static constexpr int enlargements = 3;
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours, &Limits::arcs};
  static constexpr const char *name = "hsp_view";
  static constexpr auto bytes = hsp_view_bytes;
  static constexpr auto init = hsp_view_init;
};
struct MapKind {
  using Handle = hsp_map;
  using Limits = hsp_map_limits;
  static constexpr int enlargements = 12;
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours, &Limits::edges};
  static constexpr const char *name = "hsp_map";
  static constexpr auto bytes = hsp_map_bytes;
  static constexpr auto init = hsp_map_init;
};
struct SticksKind {
  using Handle = hsp_sticks;
  using Limits = hsp_sticks_limits;
  static constexpr int enlargements = 12;
  static constexpr std::array limits = {&Limits::balls, &Limits::sticks, &Limits::pairs, &Limits::edges};
  static constexpr const char *name = "hsp_sticks";
  static constexpr auto bytes = hsp_sticks_bytes;
  static constexpr auto init = hsp_sticks_init;
};
struct CellsKind {
  using Handle = hsp_cells;
  using Limits = hsp_cells_limits;
  static constexpr int enlargements = 6;
  static constexpr std::array limits = {&Limits::cubes,       &Limits::entries,    &Limits::cells,
                                        &Limits::adjacencies, &Limits::landmarks,  &Limits::facets,
                                        &Limits::corners,     &Limits::cube_balls, &Limits::cube_corners};
  static constexpr const char *name = "hsp_cells";
  static constexpr auto bytes = hsp_cells_bytes;
  static constexpr auto init = hsp_cells_init;
};
struct PathsKind {
  using Handle = hsp_paths;
  using Limits = hsp_paths_limits;
  static constexpr int enlargements = 7;
  static constexpr std::array limits = {&Limits::cubes,        &Limits::entries, &Limits::cells,   &Limits::adjacencies,
                                        &Limits::landmarks,    &Limits::facets,  &Limits::corners, &Limits::cube_balls,
                                        &Limits::cube_corners, &Limits::points};
  static constexpr const char *name = "hsp_paths";
  static constexpr auto bytes = hsp_paths_bytes;
  static constexpr auto init = hsp_paths_init;
};
struct GateKind {
  using Handle = hsp_gate;
  using Limits = hsp_gate_limits;
  static constexpr int enlargements = 40;
  static constexpr std::array limits = {&Limits::balls,       &Limits::cubes,       &Limits::entries, &Limits::cells,
                                        &Limits::adjacencies, &Limits::landmarks,   &Limits::facets,  &Limits::corners,
                                        &Limits::cube_balls,  &Limits::cube_corners};
  static constexpr const char *name = "hsp_gate";
  static constexpr auto bytes = hsp_gate_bytes;
  static constexpr auto init = hsp_gate_init;
};
struct PeriodicKind {
  using Handle = hsp_periodic;
  using Limits = hsp_periodic_limits;
  static constexpr int enlargements = 5;
  static constexpr std::array limits = {&Limits::balls,    &Limits::images,  &Limits::neighbours,
                                        &Limits::vertices, &Limits::circles, &Limits::contacts};
  static constexpr const char *name = "hsp_periodic";
  static constexpr auto bytes = hsp_periodic_bytes;
  static constexpr auto init = hsp_periodic_init;
};
struct MovingKind {
  using Handle = hsp_moving;
  using Limits = hsp_moving_limits;
  static constexpr int enlargements = 2;
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours};
  static constexpr const char *name = "hsp_moving";
  static constexpr auto bytes = hsp_moving_bytes;
  static constexpr auto init = hsp_moving_init;
};

// A handle of such a kind. Calls that fail throw std::runtime_error.
template <class Kind>
class OwnedHandle {
 public:
  using Limits = typename Kind::Limits;
  using Handle = typename Kind::Handle;

  // Memory for these limits. What was computed is lost.
  void take(const Limits &limits) {
    size_t bytes = 0;
    expect(Kind::bytes(&limits, &bytes), "_bytes");
    std::vector<unsigned char>().swap(memory_);
    memory_.resize(bytes);
    expect(Kind::init(memory_.data(), bytes, &limits, &handle_), "_init");
  }

  // `compute` takes the handle and the limits that its computation hands back, and returns its status. It is called
  // again, with more memory, as long as limits are too small.
  template <class Compute>
  void compute(Compute compute) {
    for (int left = Kind::enlargements;; --left) {
      Limits limits{};
      limits.struct_size = sizeof limits;
      const int32_t status = compute(handle_, &limits);
      if (status != HSP_E_CAPACITY || left == 0) {
        expect(status, "_compute");
        needed_ = limits;
        return;
      }
      take(limits);
    }
  }

  // The limits that the last computation needed.
  const Limits &needed() const { return needed_; }

  Handle *get() const { return handle_; }
  size_t bytes() const { return memory_.size(); }

 private:
  static void expect(int32_t status, const char *function) {
    if (status != HSP_OK) expect_ok(status, (std::string(Kind::name) + function).c_str());
  }

  Limits needed_{};
  std::vector<unsigned char> memory_;
  Handle *handle_ = nullptr;
};

using OwnedBoundary = OwnedHandle<BoundaryKind>;
using OwnedSurface = OwnedHandle<SurfaceKind>;
using OwnedTopology = OwnedHandle<TopologyKind>;
using OwnedContacts = OwnedHandle<ContactsKind>;
using OwnedPeriodic = OwnedHandle<PeriodicKind>;
using OwnedView = OwnedHandle<ViewKind>;
using OwnedMap = OwnedHandle<MapKind>;

hsp_boundary_limits default_boundary_limits(uint32_t balls);
hsp_surface_limits surface_limits_for(const hsp_boundary *boundary);
hsp_topology_limits topology_limits_for(const hsp_boundary *boundary);
hsp_contacts_limits contacts_limits_for(const hsp_boundary *boundary);
hsp_view_limits default_view_limits(uint32_t balls);
hsp_map_limits default_map_limits(uint32_t balls);

// All records of a getter, which is called with (Record *out, uint32_t capacity, uint32_t *needed).
template <class Record, class Getter>
std::vector<Record> all_records(Getter getter, const char *call) {
  uint32_t needed = 0;
  const int32_t status = getter(static_cast<Record *>(nullptr), 0U, &needed);
  if (status != (needed == 0 ? HSP_OK : HSP_E_CAPACITY)) {
    expect_ok(status, call);
    throw std::runtime_error(std::string(call) + ": a capacity of 0 was accepted");
  }
  std::vector<Record> records(needed);
  expect_ok(getter(records.data(), needed, &needed), call);
  return records;
}

}  // namespace support
