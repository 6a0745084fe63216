// Topologies of the C interface that own their memory, with their boundary and model.
#ifndef HARDSPHERE_TESTS_TOPOLOGY_TOPOLOGY_RUN_HPP
#define HARDSPHERE_TESTS_TOPOLOGY_TOPOLOGY_RUN_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "flood_fill.hpp"
#include "library_run.hpp"

/// The topology of lattice balls, with its limits enlarged until they suffice. Calls that fail throw
/// std::runtime_error.
class LibraryTopology {
 public:
  explicit LibraryTopology(const oracle::Balls &balls, double step = 1);

  [[nodiscard]] hsp_topology *handle() const { return topology_; }
  [[nodiscard]] const LibraryBoundary &boundary() const { return boundary_; }

  [[nodiscard]] hsp_topology_counts counts() const;
  [[nodiscard]] std::vector<hsp_topology_vertex> vertices() const;
  [[nodiscard]] std::vector<hsp_topology_edge> edges() const;
  [[nodiscard]] std::vector<hsp_simple_face> faces() const;
  [[nodiscard]] std::vector<hsp_shell> shells() const;
  [[nodiscard]] std::vector<hsp_component> components() const;
  [[nodiscard]] std::vector<hsp_cell> cells() const;
  [[nodiscard]] std::vector<std::uint32_t> cell_shells(std::uint32_t cell) const;
  [[nodiscard]] std::vector<std::uint32_t> scan(std::uint32_t shell) const;

  /// The four numbers of every edge.
  struct QuadEdges {
    std::vector<std::array<std::uint32_t, 4>> onext;
    std::vector<std::array<std::uint32_t, 4>> origin;
  };
  [[nodiscard]] QuadEdges quad_edges() const;

  /// The cell of a lattice point, HSP_NONE in a ball, and the balls that contain it. Points are whole lattice steps.
  struct Place {
    std::uint32_t cell = 0;
    std::vector<std::uint32_t> balls;
  };
  [[nodiscard]] Place locate(const oracle::LatticePoint &point) const;
  [[nodiscard]] std::uint32_t cell_of(const oracle::LatticePoint &point) const;
  [[nodiscard]] bool same_cell(const oracle::LatticePoint &a, const oracle::LatticePoint &b) const;

 private:
  [[nodiscard]] std::array<double, 3> length(const oracle::LatticePoint &point) const;

  double step_;
  LibraryBoundary boundary_;
  std::vector<unsigned char> memory_;
  hsp_topology *topology_ = nullptr;
};

#endif
