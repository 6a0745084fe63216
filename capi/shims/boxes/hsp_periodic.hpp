// The inside of the handle hsp_periodic.
#pragma once

#include "handle_memory.hpp"
#include "periodic/periodic_measures.hpp"
#include "rounded_point.hpp"

struct hsp_periodic {
  using Builder = hsp::PeriodicUnion;
  static constexpr auto kind = hsp::capi::HandleKind::periodic;
  using Given = hsp_periodic_limits;
  struct Limits
      : hsp::capi::LimitFields<hsp::PeriodicLimits, Given, offsetof(Given, balls), offsetof(Given, images),
                               offsetof(Given, neighbours), offsetof(Given, vertices), offsetof(Given, circles),
                               offsetof(Given, contacts), offsetof(Given, workers)> {
    static int32_t read(const Given *given, hsp::PeriodicLimits &limits) {
      const int32_t status = LimitFields::read(given, limits);
      if (status != HSP_OK) return status;
      const bool fits = limits.balls + limits.images <= HSP_MAX_BALLS && limits.workers <= HSP_MAX_WORKERS;
      return fits ? HSP_OK : HSP_E_RANGE;
    }
  };

  uintptr_t tag;
  Builder builder;
  bool complete = false;
  uint64_t digest = 0;  // of balls and box

  uint64_t version() const { return digest; }
  bool has_results() const { return has_areas() && !builder.has_areas_alone(); }
  // Whether areas may be read.
  bool has_areas() const { return complete; }
  uint32_t balls() const { return builder.images().balls(); }
  const hsp::exact::Lattice &lattice() const { return builder.images().lattice(); }
};

namespace hsp::capi {

// A point of the caller on the lattice, turned with the box. HSP_E_NOT_FINITE, or HSP_E_RANGE beyond the lattice.
inline int32_t round_point(const PeriodicImages &images, const double *xyz, exact::Vector &point) {
  const BoxFrame &frame = images.box().frame();
  if (!frame.turns()) return round_point(images.lattice(), xyz, point);
  const Vec3 turned = frame.turned_in(xyz);
  const double own[3] = {turned.x, turned.y, turned.z};
  return round_point(images.lattice(), own, point) == HSP_OK ? HSP_OK : why_off_lattice(xyz);
}

// Writes a gradient to the caller's arrays, each of which may be null.
inline void put_box_gradient(const BoxGradient &gradient, double *d_strain, double *d_box) {
  for (int k = 0; k < 9; ++k) {
    if (d_strain != nullptr) d_strain[k] = gradient.strain.by[k];
    if (d_box != nullptr) d_box[k] = gradient.vectors.by[k];
  }
}

}  // namespace hsp::capi
