#include "measure/edge_kernel.hpp"

namespace hsp {

double sum_edges(const BallOfSet &ball, const ArcBatch &arcs) {
  return EdgeKernel<baseline_lanes>::sum_edges(ball, arcs);
}
EdgeSums differentiate_edges(double radius, const ArcBatch &arcs, double weight, EdgeBatch &edges) {
  return EdgeKernel<baseline_lanes>::differentiate(radius, arcs, weight, edges);
}

}  // namespace hsp
