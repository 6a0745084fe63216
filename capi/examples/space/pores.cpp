// The work of pores.c by hardsphere.hpp: cavities for any probe, how they open, and how large pockets are.
//   pores                    a cage with two rooms
//   pores FILE.xyzr [N]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <hardsphere.hpp>

#include "../read_balls.hpp"

namespace {

// A lattice of 5 by 3 by 3 places without two of them.
Balls rooms() {
  Balls balls;
  for (int place = 0; place < 45; ++place) {
    const int x = place / 9, y = place / 3 % 3, z = place % 3;
    if (x % 2 == 1 && y == 1 && z == 1) continue;
    balls.xyz.insert(balls.xyz.end(), {2.0 * x, 2.0 * y, 2.0 * z});
    balls.radius.push_back(x == 2 ? 1.15 : 1.2);
  }
  return balls;
}

// Free space that a probe of the radius of the birth fits in, until one of the radius of the death gets out of it.
void print_classes(hsp_pores *pores, const hsp_pores_counts &counts, size_t most) {
  auto maxima = hardsphere::range(hsp_pores_get_maxima, pores, 0, counts.maxima);
  std::printf("%u maxima, %u gates, %u cavities that nothing reaches\n", counts.maxima, counts.gates, counts.cavities);
  std::ranges::stable_sort(maxima, {}, [](const hsp_pore_maximum &m) { return m.death - m.radius; });
  maxima.resize(std::min(maxima.size(), most));
  for (const hsp_pore_maximum &m : maxima) {
    std::printf("a probe of %.4f fits at %.4f %.4f %.4f", m.radius, m.xyz[0], m.xyz[1], m.xyz[2]);
    if (m.gate == HSP_NONE) {
      std::printf(", and no point gets out\n");
      continue;
    }
    const hsp_pore_gate gate = hardsphere::range(hsp_pores_get_gates, pores, m.gate, 1)[0];
    std::printf(", one of %.4f gets %s between balls %u, %u and %u\n", m.death,
                m.parent == HSP_PORE_OUTSIDE ? "out" : "into a wider place", gate.ball[0], gate.ball[1], gate.ball[2]);
  }
}

// From the widest place the three best ways out, each by another bottleneck.
void print_tunnels(hardsphere::workspace &work, const hsp_pore_maximum &widest) {
  std::vector<uint32_t> avoided;
  while (avoided.size() < 3) {
    hsp_tunnel tunnel{};
    work.run(hsp_workspace_tunnel, nullptr, &widest.xyz[0], nullptr, avoided.data(),
             static_cast<uint32_t>(avoided.size()), &tunnel);
    if (tunnel.there == 0) return;
    std::printf("way out %zu: radius %.4f, length %.4f, %u gates\n", avoided.size() + 1, tunnel.radius, tunnel.length,
                tunnel.gates);
    if (tunnel.gate == HSP_NONE) return;
    avoided.push_back(tunnel.gate);
  }
}

// Balls with plugs, in the mouths of pockets or in leaks.
size_t plug(const hsp_pores *pores, hardsphere::workspace &plugged) {
  uint32_t count = 0;
  const int32_t status = hsp_pores_get_plugged_balls(pores, nullptr, nullptr, 0, &count);
  if (status != HSP_E_CAPACITY) hardsphere::check(status);
  std::vector<double> xyz(3 * size_t{count}), radius(count);
  hardsphere::check(hsp_pores_get_plugged_balls(pores, xyz.data(), radius.data(), count, &count));
  plugged.set(xyz, radius);
  return count;
}

// Where a point fits that a probe of some radius does not get to: plugged anew while there are leaks.
void print_pockets(hsp_pores *pores, double wide) {
  uint32_t count = 0;
  hardsphere::check(hsp_pores_find_pockets(pores, 0, wide, &count));
  const auto pockets = hardsphere::range(hsp_pores_get_pockets, pores, 0, count);
  std::vector<hsp_pore_pocket_size> sizes(count);
  hardsphere::workspace plugged;
  for (size_t before = 0, balls = plug(pores, plugged); balls > before;) {
    hsp_pores *found = plugged.pores();
    hardsphere::check(hsp_pores_measure_pockets(pores, found, plugged.boundary(), sizes.data(), count, nullptr));
    before = balls;
    balls = plug(found, plugged);
  }
  for (uint32_t k = 0; k < count; ++k) {
    std::printf("pocket for probes up to %.4f, %u mouths up to %.4f: ", pockets[k].radius, pockets[k].mouths,
                pockets[k].mouth);
    if (sizes[k].closed == 0) {
      std::printf("its mouths cannot be closed\n");
    } else {
      std::printf("volume %.4f, area %.4f\n", sizes[k].volume, sizes[k].area);
    }
  }
}

}  // namespace

int main(int count, char **arguments) try {
  Balls balls = count > 1 ? Balls{} : rooms();
  if (count > 1) add_balls(balls, arguments[1]);
  hardsphere::workspace work(balls.xyz, balls.radius);
  hsp_pores *pores = work.pores();
  hsp_pores_counts counts{};
  hardsphere::check(hsp_pores_get_counts(pores, &counts));
  print_classes(pores, counts, count > 2 ? std::strtoul(arguments[2], nullptr, 10) : 10);
  if (counts.maxima > 0) print_tunnels(work, hardsphere::range(hsp_pores_get_maxima, pores, 0, 1)[0]);
  print_pockets(work->pores, 0.3);
  return 0;
} catch (const std::exception &failure) {
  std::fprintf(stderr, "pores: %s\n", failure.what());
  return 1;
}
