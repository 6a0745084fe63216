// Handles of the C interface that own their memory: models, boundaries, topologies and contacts. A handle with limits
// takes more memory until its computation succeeds. The handles of each component have a file of their own,
// owned_*.hpp.
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

// Kinds of handles with limits. most_enlargements is a promise of the header: a computation succeeds after its limits
// were raised at most so often to what the handle asked for.
template <class HandleOfKind, class LimitsOfKind, int most_enlargements, auto bytes_of_limits, auto init_of_kind>
struct KindOf {
  using Handle = HandleOfKind;
  using Limits = LimitsOfKind;
  static constexpr int enlargements = most_enlargements;
  static constexpr auto bytes = bytes_of_limits;
  static constexpr auto init = init_of_kind;
};
struct BoundaryKind : KindOf<hsp_boundary, hsp_boundary_limits, 2, hsp_boundary_bytes, hsp_boundary_init> {
  static constexpr const char *name = "hsp_boundary";
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours, &Limits::vertices, &Limits::circles};
};
struct TopologyKind : KindOf<hsp_topology, hsp_topology_limits, 3, hsp_topology_bytes, hsp_topology_init> {
  static constexpr const char *name = "hsp_topology";
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours, &Limits::edges, &Limits::cut_arcs};
  static size_t most_bytes(const Limits &most) {
    return HSP_TOPOLOGY_BYTES(most.balls, most.neighbours, most.edges, most.cut_arcs);
  }
};
struct ContactsKind : KindOf<hsp_contacts, hsp_contacts_limits, 3, hsp_contacts_bytes, hsp_contacts_init> {
  static constexpr const char *name = "hsp_contacts";
  static constexpr std::array limits = {&Limits::balls, &Limits::neighbours, &Limits::contacts};
  static size_t most_bytes(const Limits &most) {
    return HSP_CONTACTS_BYTES(most.balls, most.neighbours, most.contacts, most.triangles, most.tetrahedra);
  }
};

// A handle of such a kind. Calls that fail throw std::runtime_error.
template <class Kind>
class OwnedHandle {
 public:
  using Limits = typename Kind::Limits;
  using Handle = typename Kind::Handle;

  // Memory for these limits. Earlier results are lost.
  void take(const Limits &limits) {
    size_t bytes = 0;
    expect(Kind::bytes(&limits, &bytes), "_bytes");
    std::vector<unsigned char>().swap(memory_);
    memory_.resize(bytes);
    expect(Kind::init(memory_.data(), bytes, &limits, &handle_), "_init");
  }

  // `compute` takes the handle and the struct for the limits that the computation hands back, and returns the status.
  // It is called again, with more memory, as long as limits are too small.
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
    if (status == HSP_OK) return;
    std::string name = Kind::name;  // g++ 12 warns of a sum in large units
    name += function;
    expect_ok(status, name.c_str());
  }

  Limits needed_{};
  std::vector<unsigned char> memory_;
  Handle *handle_ = nullptr;
};

using OwnedBoundary = OwnedHandle<BoundaryKind>;
using OwnedTopology = OwnedHandle<TopologyKind>;
using OwnedContacts = OwnedHandle<ContactsKind>;

hsp_boundary_limits default_boundary_limits(uint32_t balls);
hsp_topology_limits topology_limits_for(const hsp_boundary *boundary);
hsp_contacts_limits contacts_limits_for(const hsp_boundary *boundary);

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
