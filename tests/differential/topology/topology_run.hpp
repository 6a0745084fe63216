// Topologies of the C interface that own their memory, with their boundary and model.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "flood_fill.hpp"
#include "library_run.hpp"

// The topology of lattice balls. Calls that fail throw
// std::runtime_error.
class LibraryTopology {
 public:
  explicit LibraryTopology(const oracle::Balls &balls, double step = 1);

  [[nodiscard]] hsp_topology *handle() const { return topology_.get(); }
  [[nodiscard]] const LibraryBoundary &boundary() const { return boundary_; }

  [[nodiscard]] hsp_topology_counts counts() const;
  [[nodiscard]] std::vector<hsp_topology_vertex> vertices() const;
  [[nodiscard]] std::vector<hsp_topology_edge> edges() const;
  [[nodiscard]] std::vector<hsp_simple_face> faces() const;
  [[nodiscard]] std::vector<hsp_shell> shells() const;
  [[nodiscard]] std::vector<hsp_component> components() const;
  [[nodiscard]] std::vector<hsp_region> cells() const;
  [[nodiscard]] std::vector<uint32_t> cell_shells(uint32_t cell) const;
  [[nodiscard]] std::vector<uint32_t> cell_balls(uint32_t cell) const;
  [[nodiscard]] std::vector<uint32_t> scan(uint32_t shell) const;

  // The four numbers of every edge.
  struct QuadEdges {
    std::vector<std::array<uint32_t, 4>> onext;
    std::vector<std::array<uint32_t, 4>> origin;
  };
  [[nodiscard]] QuadEdges quad_edges() const;

  // The cell of a lattice point, HSP_NONE in a ball. Points are whole lattice steps.
  [[nodiscard]] uint32_t cell_of(const oracle::LatticePoint &point) const;

 private:
  double step_;
  LibraryBoundary boundary_;
  support::OwnedTopology topology_;
};
