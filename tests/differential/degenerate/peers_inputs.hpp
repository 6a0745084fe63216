// The degenerate list of peers: inputs on which programs for the same task fail, what is right there, and what the
// peers do.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ball_list.hpp"
#include "degenerate_set.hpp"

namespace degenerate {

using support::BallList;

// The test that decides whether a result is right.
enum class Arbiter {
  formula,    // area and volume of `right`
  slices,     // quadrature over slices of the balls as rounded to the lattice
  reference,  // area and volume of `right`, computed once by another program's quadrature over slices
  status      // the documented status, and first_bad
};

struct Right {
  Arbiter arbiter = Arbiter::slices;
  long double area = 0;
  long double volume = 0;
  int32_t status = 0;
  uint32_t first_bad = 0xFFFFFFFFU;
};

struct PeersRow {
  std::string input;
  BallList balls;
  Right right;
  Topology topology;  // components, voids, shells, Euler characteristic of the union
  // The results of others, as measured in the versions that the test prints; "ok" is right to 1e-9.
  std::string voronota_lt;
  std::string alpha_mol;
  std::string libarvo;
  std::string free_sasa;
};

// crambin: its atoms with van der Waals radii, in angstrom.
std::vector<PeersRow> peers_rows(const BallList &crambin);

// Crambin alone, to which its rows are compared: 14 digits of another program's quadrature over slices, and the
// boundary by brute force. A slow test computes them again.
inline constexpr long double crambin_area = 4247.6562115516L;
inline constexpr long double crambin_volume = 3571.7031090322L;
inline constexpr uint32_t crambin_vertices = 898;
inline constexpr Topology crambin_topology{1, 0, 1, -68};

}  // namespace degenerate
