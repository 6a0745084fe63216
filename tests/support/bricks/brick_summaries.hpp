// Bricks by the interface: models of parts of a set, their summaries, and merges, for tests and fuzz harnesses.
#pragma once

#include <hardsphere_workspace.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace support {

using Summary = std::vector<uint8_t>;

inline void need(int32_t status, const char *call) {
  if (status != HSP_OK) throw std::runtime_error(std::string(call) + ": " + hsp_status_text(status));
}

// Balls in lattice steps, each with its id in the whole and the brick that owns it.
struct OwnedBalls {
  std::vector<double> xyz, radius;
  std::vector<uint64_t> id;
  std::vector<uint32_t> owner;

  [[nodiscard]] uint32_t size() const { return static_cast<uint32_t>(radius.size()); }
  [[nodiscard]] int64_t at(uint32_t i, int axis) const {
    return static_cast<int64_t>(xyz[3 * size_t{i} + static_cast<size_t>(axis)]);
  }
  [[nodiscard]] int64_t r(uint32_t i) const { return static_cast<int64_t>(radius[i]); }
  void push(const double *centre, double r, uint64_t name, uint32_t of) {
    xyz.insert(xyz.end(), centre, centre + 3);
    radius.push_back(r);
    id.push_back(name);
    owner.push_back(of);
  }
  // The balls i with in[i] != 0, in their order.
  [[nodiscard]] OwnedBalls part(const std::vector<uint8_t> &in) const {
    OwnedBalls result;
    for (uint32_t i = 0; i < size(); ++i) {
      if (in[i] != 0) result.push(&xyz[3 * size_t{i}], radius[i], id[i], owner[i]);
    }
    return result;
  }
};

// Model and boundary of one brick after the other, in the same memory.
class BrickMaker {
 public:
  BrickMaker() = default;
  BrickMaker(const BrickMaker &) = delete;
  BrickMaker &operator=(const BrickMaker &) = delete;
  ~BrickMaker() { hsp_workspace_free(&work_); }

  void compute(const OwnedBalls &balls, double largest_radius) {
    hsp_model_options options;
    need(hsp_model_options_init(&options, sizeof options), "options");
    options.step = 1;
    options.largest_radius = largest_radius;
    need(hsp_workspace_set(&work_, balls.size(), balls.xyz.data(), balls.radius.data(), &options, nullptr), "set");
    need(hsp_workspace_boundary(&work_), "boundary");
  }
  // The summary of the boundary that was computed last.
  [[nodiscard]] Summary summarise(const OwnedBalls &balls, uint32_t brick, uint32_t bricks, uint32_t flags) {
    hsp_brick_request request{};
    request.struct_size = sizeof request;
    request.brick = brick;
    request.bricks = bricks;
    request.flags = flags;
    request.id = balls.id.data();
    request.owner = balls.owner.data();
    calls_ = 0;
    for (;;) {
      size_t bytes = memory_.size();
      const int32_t status = hsp_brick_summarise(work_.boundary, &request, memory_.data(), &bytes, nullptr);
      ++calls_;
      if (status == HSP_OK) return {memory_.begin(), memory_.begin() + static_cast<std::ptrdiff_t>(bytes)};
      if (status != HSP_E_CAPACITY || bytes <= memory_.size()) need(status, "summarise");
      // Exactly as many bytes as are needed, so that a write behind them shows.
      Summary(bytes).swap(memory_);
    }
  }
  [[nodiscard]] uint32_t calls() const { return calls_; }
  void forget_memory() { Summary().swap(memory_); }
  hsp_workspace &work() { return work_; }

 private:
  hsp_workspace work_{};
  Summary memory_;
  uint32_t calls_ = 0;
};

// HSP_OK, or what is wrong.
inline int32_t merge(const Summary &a, const Summary &b, Summary &merged, uint32_t *brick = nullptr) {
  size_t bytes = 0;
  int32_t status = hsp_brick_merge(a.data(), a.size(), b.data(), b.size(), nullptr, nullptr, &bytes, brick);
  if (status != HSP_E_CAPACITY) return status;
  Summary memory(bytes);
  status = hsp_brick_merge(a.data(), a.size(), b.data(), b.size(), nullptr, memory.data(), &bytes, brick);
  if (status == HSP_OK) merged.assign(memory.begin(), memory.begin() + static_cast<std::ptrdiff_t>(bytes));
  return status;
}

inline int32_t get_totals(const Summary &summary, hsp_brick_totals &totals, uint32_t *brick = nullptr) {
  std::memset(&totals, 0, sizeof totals);
  return hsp_brick_get_totals(summary.data(), summary.size(), &totals, brick);
}

inline std::vector<hsp_brick_shell> shells_of(const Summary &summary) {
  uint32_t needed = 0;
  const int32_t status = hsp_brick_get_shells(summary.data(), summary.size(), nullptr, 0, &needed, nullptr);
  if (status != HSP_E_CAPACITY) need(status, "shells");
  std::vector<hsp_brick_shell> shells(needed);
  need(hsp_brick_get_shells(summary.data(), summary.size(), shells.data(), needed, &needed, nullptr), "shells");
  return shells;
}

// Both structs have no padding.
inline bool same_bits(const hsp_brick_totals &a, const hsp_brick_totals &b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
inline bool same_bits(const std::vector<hsp_brick_shell> &a, const std::vector<hsp_brick_shell> &b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

}  // namespace support
