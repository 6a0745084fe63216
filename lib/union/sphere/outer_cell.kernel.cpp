#include "sphere/outer_cell.hpp"
#include "lanes/wide.hpp"

namespace hsp::HSP_TARGET {
namespace {

using CellLanes = Wide<double, register_lanes>;
using FloatLanes = Wide<float, register_floats>;

}  // namespace

uint32_t caps_that_may_cut(const OuterCell &cell, CapBatch &caps, uint32_t asked) {
  constexpr uint32_t n = CellLanes::lanes;
  static_assert(CapBatch::most % (2 * n) == 0);
  uint32_t cut = 0;
  for (uint32_t k = 0; k < CapBatch::most; k += 2 * n) {
    if ((asked >> k & ((1U << 2 * n) - 1U)) == 0) continue;
    // Two registers at a time: one product does not wait for the other.
    const CellLanes::Real x[2] = {CellLanes::load(caps.ux + k), CellLanes::load(caps.ux + k + n)},
                          y[2] = {CellLanes::load(caps.uy + k), CellLanes::load(caps.uy + k + n)},
                          z[2] = {CellLanes::load(caps.uz + k), CellLanes::load(caps.uz + k + n)};
    CellLanes::Real most[2] = {CellLanes::all(-8.0), CellLanes::all(-8.0)};
    for (uint32_t v = 0; v < cell.vertices; ++v) {
      const CellLanes::Real vx = CellLanes::all(cell.x[v]), vy = CellLanes::all(cell.y[v]),
                            vz = CellLanes::all(cell.z[v]), error = CellLanes::all(cell.error[v]);
      for (uint32_t half = 0; half < 2; ++half) {
        most[half] = CellLanes::larger(
            CellLanes::fused(x[half], vx, CellLanes::fused(y[half], vy, CellLanes::fused(z[half], vz, error))),
            most[half]);
      }
    }
    for (uint32_t half = 0; half < 2; ++half) {
      const uint32_t first = k + half * n;
      const CellLanes::Real b = CellLanes::load(caps.b + first);
      CellLanes::store(caps.depth + first, most[half] - b);
      cut |= static_cast<uint32_t>(CellLanes::set_lanes(~(b > most[half]))) << first;
    }
  }
  return cut & asked;
}

uint32_t float_caps_that_may_cut(const OuterCell &cell, const FloatCaps &caps, uint32_t count, uint32_t *numbers,
                                 uint32_t &deepest) {
  // PROOFS.md, section 7, has this bound for depths in floats.
  constexpr float doubt = 0x1p-16F;
  constexpr uint32_t n = FloatLanes::lanes;
  float x[OuterCell::room], y[OuterCell::room], z[OuterCell::room];
  for (uint32_t v = 0; v < cell.vertices; ++v) {
    x[v] = static_cast<float>(cell.x[v]);
    y[v] = static_cast<float>(cell.y[v]);
    z[v] = static_cast<float>(cell.z[v]);
  }
  uint32_t found = 0;
  float most_depth = -8.0F;
  for (uint32_t k = 0; k < count; k += n) {
    const FloatLanes::Real ux = FloatLanes::load(caps.x + k), uy = FloatLanes::load(caps.y + k),
                           uz = FloatLanes::load(caps.z + k), b = FloatLanes::load(caps.b + k) - doubt;
    FloatLanes::Real most = FloatLanes::all(-8.0F);
    for (uint32_t v = 0; v < cell.vertices; ++v) {
      most = FloatLanes::larger(
          FloatLanes::fused(ux, FloatLanes::all(x[v]),
                            FloatLanes::fused(uy, FloatLanes::all(y[v]), uz * FloatLanes::all(z[v]))),
          most);
    }
    uint32_t bits = static_cast<uint32_t>(FloatLanes::set_lanes(~(b > most)));
    if (bits == 0) continue;
    const FloatLanes::Real depth = most - b;
    for (; bits != 0; bits &= bits - 1) {
      const uint32_t lane = static_cast<uint32_t>(__builtin_ctz(bits));
      if (depth[lane] > most_depth) {
        most_depth = depth[lane];
        deepest = k + lane;
      }
      numbers[found++] = k + lane;
    }
  }
  return found;
}

VertexSides sides_of_vertices(const OuterCell &cell, const OuterCell::Plane &plane) {
  constexpr uint32_t n = CellLanes::lanes;
  const CellLanes::Real x = CellLanes::all(plane.ux), y = CellLanes::all(plane.uy), z = CellLanes::all(plane.uz),
                        b = CellLanes::all(plane.b);
  uint64_t outside[2] = {0, 0}, decided[2] = {0, 0};
  for (uint32_t v = 0; v < cell.vertices; v += n) {
    const CellLanes::Real depth = CellLanes::fused(
        x, CellLanes::load(cell.x + v),
        CellLanes::fused(y, CellLanes::load(cell.y + v), CellLanes::fused(z, CellLanes::load(cell.z + v), -b)));
    const CellLanes::Real error = CellLanes::load(cell.error + v);
    const uint64_t is_outside = CellLanes::set_lanes(depth > error);
    outside[v / 64] |= is_outside << v % 64;
    decided[v / 64] |= (is_outside | CellLanes::set_lanes(depth < -error)) << v % 64;
  }
  const uint32_t vertices = cell.vertices;
  const uint64_t all[2] = {vertices < 64 ? (uint64_t{1} << vertices) - 1 : ~uint64_t{0},
                           vertices < 64 ? 0 : (uint64_t{1} << (vertices - 64)) - 1};
  return {{outside[0] & all[0], outside[1] & all[1]}, {all[0] & ~decided[0], all[1] & ~decided[1]}};
}

}  // namespace hsp::HSP_TARGET
