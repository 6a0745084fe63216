// The work of interface.c by hardsphere.hpp: what two chains lose of their surfaces, and which atoms touch most.
//   interface FIRST.xyzr SECOND.xyzr [PROBE]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <hardsphere.hpp>
#include <tuple>

#include "read_balls.hpp"

int main(int count, char **arguments) try {
  if (count != 3 && count != 4) {
    std::fprintf(stderr, "usage: interface FIRST.xyzr SECOND.xyzr [PROBE]\n");
    return 2;
  }
  const hardsphere::options how{.probe = count == 4 ? std::strtod(arguments[3], nullptr) : 1.4};
  Balls chain[2], both;
  hardsphere::workspace work;
  double alone[2], together[2] = {0, 0};
  for (int c = 0; c < 2; ++c) {
    add_balls(chain[c], arguments[c + 1]);
    add_balls(both, arguments[c + 1]);
    alone[c] = work.set(chain[c].xyz, chain[c].radius, how).measure().total.area;
  }
  const size_t first = chain[0].radius.size();
  const std::vector<double> area = work.set(both.xyz, both.radius, how).measure().area;
  std::vector<uint32_t> group(area.size() + 1);  // which has an address where there are no balls
  for (size_t i = 0; i < area.size(); ++i) {
    group[i] = i < first ? 0 : 1;
    together[group[i]] += area[i];
  }
  const auto groups = hardsphere::all(hsp_contacts_group, work.contacts(), group.data());
  const hsp_group_contact between = groups.empty() ? hsp_group_contact{} : groups[0];
  auto pairs = hardsphere::all(hsp_contacts_get_pairs, work.contacts());
  std::erase_if(pairs, [=](const hsp_contact &pair) { return pair.ball[0] >= first || pair.ball[1] < first; });
  std::ranges::sort(pairs, {},
                    [](const hsp_contact &pair) { return std::tuple(-pair.area, pair.ball[0], pair.ball[1]); });

  std::printf("chain   atoms         alone      together        buried\n");
  for (int c = 0; c < 2; ++c) {
    std::printf("%5d %7zu %13.6f %13.6f %13.6f\n", c + 1, chain[c].radius.size(), alone[c], together[c],
                alone[c] - together[c]);
  }
  std::printf("buried in all %.6f\n", alone[0] - together[0] + (alone[1] - together[1]));
  std::printf("contact area %.6f in %u pairs of atoms, %.6f of its border on the surface\n", between.area,
              between.contacts, between.rim);
  pairs.resize(std::min<size_t>(pairs.size(), 10));
  for (const hsp_contact &pair : pairs) {
    std::printf("%u of the first, %zu of the second: area %.6f, distance %.6f\n", pair.ball[0], pair.ball[1] - first,
                pair.area, pair.distance);
  }
  return 0;
} catch (const std::exception &failure) {
  std::fprintf(stderr, "interface: %s\n", failure.what());
  return 1;
}
