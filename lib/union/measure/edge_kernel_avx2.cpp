#if HSP_AVX2
#include "measure/edge_kernel.hpp"

namespace hsp {

double sum_edges_avx2(const BallOfSet &ball, const ArcBatch &arcs) {
  return EdgeKernel<4>::sum_edges(ball, arcs);
}
EdgeSums differentiate_edges_avx2(double radius, const ArcBatch &arcs, double weight, EdgeBatch &edges) {
  return EdgeKernel<4>::differentiate(radius, arcs, weight, edges);
}

}  // namespace hsp
#endif
