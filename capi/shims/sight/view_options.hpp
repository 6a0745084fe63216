// The part common to views and maps: the direction of view, and the conversion of view coordinates to the caller's
// unit.
#pragma once

#include "caller_executor.hpp"
#include "conversion.hpp"
#include "versioned_struct.hpp"
#include "view/view_frame.hpp"

namespace hsp::capi {

// A function, so that the archive has no symbol for it.
constexpr hsp_view_options default_view_options() {
  return {
      sizeof(hsp_view_options), HSP_PIECES_OUTSIDE_FARTHER, 0, 0, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, nullptr, nullptr};
}

// Options as a program gives them, completed; null means defaults.
inline int32_t read_request(const hsp_view_options *given, hsp_view_options &complete, Executor &executor) {
  complete = default_view_options();
  if (given == nullptr) return HSP_OK;
  if (const int32_t status = read_struct(given, default_view_options(), complete); status != HSP_OK) return status;
  if (complete.reserved != 0 || complete.unused != nullptr) return HSP_E_VERSION;
  if (const int32_t status = executor.read(complete.executor); status != HSP_OK) return status;
  const bool known = complete.pieces <= HSP_PIECES_OUTSIDE_ALL && (complete.flags & ~HSP_VIEW_ALL_BALLS) == 0;
  return known ? HSP_OK : HSP_E_ARGUMENT;
}

inline ViewDirection direction_of(const hsp_view_options &options) {
  ViewDirection direction{};
  for (int k = 0; k < 3; ++k) {
    direction.towards[k] = options.towards[k];
    direction.up[k] = options.up[k];
  }
  return direction;
}

// Lengths of a view in the caller's unit.
struct ViewLengths {
  const exact::Lattice &lattice;

  double operator()(double steps) const { return lattice.length(steps); }
  void point(const double steps[2], double out[2]) const {
    out[0] = lattice.length(steps[0]);
    out[1] = lattice.length(steps[1]);
  }
};

// The frame of a view, for an info that has one.
template <class Info>
void put_frame(const ViewLengths &length, const ViewFrame &frame, Info &info) {
  to_array(frame.origin, info.origin);
  for (double &coordinate : info.origin) coordinate = length(coordinate);
  to_array(frame.right, info.right);
  to_array(frame.up, info.up);
  to_array(frame.towards, info.towards);
}

}  // namespace hsp::capi
