#include "peers/cgal_alpha_complex.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fixed_alpha_shape_3.h>
#include <CGAL/Fixed_alpha_shape_cell_base_3.h>
#include <CGAL/Fixed_alpha_shape_vertex_base_3.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/version.h>

#include <vector>

namespace bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plain = CGAL::Regular_triangulation_3<Kernel>;
using VertexBase = CGAL::Fixed_alpha_shape_vertex_base_3<Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using CellBase = CGAL::Fixed_alpha_shape_cell_base_3<Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Triangulation = CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using AlphaShape = CGAL::Fixed_alpha_shape_3<Triangulation>;

std::vector<Kernel::Weighted_point_3> weighted_points(const support::BallList &balls, double probe) {
  std::vector<Kernel::Weighted_point_3> points;
  for (size_t i = 0; i < balls.size(); ++i) {
    const double radius = balls.radius[i] + probe;
    points.emplace_back(Kernel::Point_3(balls.xyz[3 * i], balls.xyz[3 * i + 1], balls.xyz[3 * i + 2]), radius * radius);
  }
  return points;
}

}  // namespace

size_t cgal_regular_triangulation(const support::BallList &balls, double probe) {
  const auto points = weighted_points(balls, probe);
  return Plain(points.begin(), points.end()).number_of_vertices();
}

AlphaComplexSize cgal_alpha_complex(const support::BallList &balls, double probe) {
  const auto points = weighted_points(balls, probe);
  Triangulation triangulation(points.begin(), points.end());
  const AlphaShape shape(triangulation, 0);  // takes the triangulation over
  AlphaComplexSize size;
  for (auto facet = shape.finite_facets_begin(); facet != shape.finite_facets_end(); ++facet) {
    const auto kind = shape.classify(*facet);
    size.boundary_vertices += kind == AlphaShape::SINGULAR ? 2 : kind == AlphaShape::REGULAR ? 1 : 0;
  }
  return size;
}

std::string cgal_release() {
  return CGAL_VERSION_STR;
}

}  // namespace bench
