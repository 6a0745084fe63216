// A user's program: the area of two unit balls at distance 1, whose caps are known.
#include <hardsphere.h>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  const std::vector<double> xyz{0, 0, 0, 1, 0, 0};
  const std::vector<double> radius{1, 1};
  const auto n = static_cast<uint32_t>(radius.size());
  size_t bytes = 0;
  if (hsp_model_bytes(n, &bytes) != HSP_OK) return 2;
  std::vector<unsigned char> model_memory(bytes);
  hsp_model *model = nullptr;
  if (hsp_model_init(model_memory.data(), model_memory.size(), n, &model) != HSP_OK) return 3;
  hsp_boundary_limits limits{};
  if (hsp_boundary_limits_init(&limits, sizeof limits, n) != HSP_OK) return 4;
  if (hsp_boundary_bytes(&limits, &bytes) != HSP_OK) return 5;
  std::vector<unsigned char> boundary_memory(bytes);
  hsp_boundary *boundary = nullptr;
  if (hsp_boundary_init(boundary_memory.data(), boundary_memory.size(), &limits, &boundary) != HSP_OK) return 6;
  if (hsp_model_set(model, n, xyz.data(), radius.data(), nullptr, nullptr) != HSP_OK) return 7;
  if (hsp_boundary_compute(boundary, model, nullptr) != HSP_OK) return 8;
  hsp_totals totals{};
  if (hsp_boundary_measure(boundary, nullptr, &totals, nullptr, nullptr, 0, nullptr) != HSP_OK) return 9;
  std::printf("C++: area %.15g\n", totals.area);
  return std::fabs(totals.area - 6 * std::acos(-1.0)) < 1e-12 ? 0 : 1;
}
