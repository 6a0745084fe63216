#include "curvature/edge_kernel.hpp"

namespace hsp::HSP_TARGET {

double sum_edges(const BallOfSet &ball, const ArcBatch &arcs) {
  return EdgeKernel<register_lanes>::sum_edges(ball, arcs);
}
EdgeSums differentiate_edges(double radius, const ArcBatch &arcs, double weight, EdgeBatch &edges) {
  return EdgeKernel<register_lanes>::differentiate(radius, arcs, weight, edges);
}
bool are_multiples(const double *numbers, uint32_t count, double unit) {
  return EdgeKernel<register_lanes>::are_multiples(numbers, count, unit);
}

}  // namespace hsp::HSP_TARGET
