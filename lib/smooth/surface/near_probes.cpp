#include "surface/near_probes.hpp"

namespace hsp {
namespace {

struct Difference {
  float x, y, z;

  float along(const float (&direction)[3]) const { return x * direction[0] + y * direction[1] + z * direction[2]; }
};

bool may_cut(const ProbeSearch &search, const Difference &q, float square) {
  const float height[3] = {q.along(search.inward[0]), q.along(search.inward[1]), q.along(search.inward[2])};
  const float margin = search.margin;
  if (height[0] > -margin && height[1] > -margin && height[2] > -margin) return true;
  const float reach = square * (1.0F - square * search.inverse_square_of_reach) + 8 * margin;
  const float along[3] = {q.along(search.corner[0]), q.along(search.corner[1]), q.along(search.corner[2])};
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3;
    const int b = (k + 2) % 3;
    const float cosine = search.cosine[k];
    if (height[k] < margin && height[k] * height[k] < reach && along[b] - cosine * along[a] > -2 * margin &&
        along[a] - cosine * along[b] > -2 * margin) {
      return true;
    }
  }
  return false;
}

}  // namespace

// Those that overlap first, without branches, which nothing could predict.
uint32_t find_near_probes(ProbeSearch &search, uint32_t *found) {
  constexpr uint32_t room = ProbeSearch::room;
  Difference q[room + 1];
  float squares[room + 1];
  uint32_t near[room + 1];
  uint32_t count = 0;
  for (; search.at < search.ranges && count < room; ++search.at) {
    ProbeRange &range = search.range[search.at];
    uint32_t k = range.first;
    for (; k < range.last && count < room; ++k) {
      q[count] = {search.x[k] - search.own[0], search.y[k] - search.own[1], search.z[k] - search.own[2]};
      squares[count] = q[count].x * q[count].x + q[count].y * q[count].y + q[count].z * q[count].z;
      near[count] = search.vertex[k];
      count += static_cast<uint32_t>(squares[count] < search.square_of_reach);
    }
    range.first = k;
    if (k < range.last) break;
  }
  uint32_t kept = 0;
  for (uint32_t k = 0; k < count; ++k) {
    if (may_cut(search, q[k], squares[k])) found[kept++] = near[k];
  }
  return kept;
}

}  // namespace hsp
