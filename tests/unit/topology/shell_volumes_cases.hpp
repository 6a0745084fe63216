// Areas and enclosed volumes of shells against the balls' own measures and closed forms, and the invariant about their
// signs.
#pragma once

#include "small_topology.hpp"
#include "topology/shell_volumes.hpp"

namespace cases {

inline hsp::BallMeasure shell_of(uint32_t shell) {
  SmallTopology &built = small_topology();
  return hsp::measure_shell(built.balls(), built.boundary(), built.topology(), shell);
}
inline hsp::TopologyViolation checked_volumes() {
  SmallTopology &built = small_topology();
  return hsp::check_enclosed_volumes(built.balls(), built.boundary(), built.topology());
}

struct Shells {
  uint32_t n;
  SmallBall ball[10];
  uint32_t shells, voids;
};
constexpr Shells shell_sets[] = {{1, {{5, 6, 7, 1000}}, 1, 0},
                                 {1, {{1, 2, 3, 0}}, 1, 0},
                                 {2, {{0, 0, 0, 500}, {600, 0, 0, 500}}, 1, 0},
                                 {2, {{0, 0, 0, 500}, {5000, 0, 0, 500}}, 2, 0},
                                 // Faces that are cut into several simple faces count once.
                                 {4, {{0, 0, 0, 1000}, {1000, 0, 0, 100}, {0, 1000, 0, 100}, {0, 0, -1000, 100}}, 1, 0},
                                 {3, {{0, 0, 0, 550}, {1000, 0, 0, 550}, {500, 866, 0, 550}}, 1, 0},
                                 // A cage of six around a void, with a ball in it, and beside it a pair like a lens.
                                 {9,
                                  {{1000, 0, 0, 850},
                                   {-1000, 0, 0, 850},
                                   {0, 1000, 0, 850},
                                   {0, -1000, 0, 850},
                                   {0, 0, 1000, 850},
                                   {0, 0, -1000, 850},
                                   {0, 0, 0, 100},
                                   {20000, 0, 0, 1000},
                                   {21000, 300, 0, 900}},
                                  4,
                                  1}};

// Of all shells together and of all balls: the same area and volume; positive but for voids.
inline uint32_t shells_sum_to_balls() {
  return first_failing(shell_sets, [](const Shells &c) {
    SmallTopology &built = small_topology();
    if (!built.build(c.ball, c.n) || built.topology().shell_count != c.shells) return false;
    hsp::BallMeasure of_balls, of_shells;
    for (uint32_t i = 0; i < c.n; ++i) {
      const hsp::BallMeasure own = hsp::measure_ball(built.balls(), built.boundary(), i);
      of_balls.area += own.area;
      of_balls.volume += own.volume;
    }
    uint32_t voids = 0;
    for (uint32_t s = 0; s < c.shells; ++s) {
      const hsp::BallMeasure own = shell_of(s);
      const bool is_void = built.topology().shells[s].is_void;
      if (own.area < 0.0 || (own.volume < 0.0) != is_void) return false;
      voids += is_void ? 1 : 0;
      of_shells.area += own.area;
      of_shells.volume += own.volume;
    }
    return voids == c.voids && near(of_shells.area, of_balls.area, 1e-12 * of_balls.area) &&
           near(of_shells.volume, of_balls.volume, 1e-12 * of_balls.volume) &&
           checked_volumes().invariant == hsp::TopologyInvariant::none;
  });
}

// The invariant about signs, for every shell that is said to be what it is not; a shell of no volume may be either.
inline uint32_t signs_that_are_wrong() {
  return first_failing(shell_sets, [](const Shells &c) {
    SmallTopology &built = small_topology();
    if (!built.build(c.ball, c.n)) return false;
    for (uint32_t s = 0; s < c.shells; ++s) {
      bool &is_void = built.topology().shells[s].is_void;
      const bool has_volume = shell_of(s).volume != 0.0;
      is_void = !is_void;
      const hsp::TopologyViolation found = checked_volumes();
      is_void = !is_void;
      if (has_volume != (found.invariant == hsp::TopologyInvariant::volumes)) return false;
      if (has_volume && found.id != s) return false;
    }
    return checked_volumes().invariant == hsp::TopologyInvariant::none;
  });
}

struct KnownShell {
  uint32_t n;
  SmallBall ball[4];
  double area, volume;  // in multiples of pi
};
constexpr KnownShell known_shells[] = {{1, {{5, 6, 7, 1000}}, 4e6, 4e9 / 3},
                                       {1, {{1, 2, 3, 0}}, 0, 0},
                                       // Without caps of height 200.
                                       {2, {{0, 0, 0, 500}, {600, 0, 0, 500}}, 2 * 8e5, 2 * (5e8 / 3 - 4e4 * 1300 / 3)},
                                       // Without three caps of height 5, with three of height 105.
                                       {4,
                                        {{0, 0, 0, 1000}, {1000, 0, 0, 100}, {0, 1000, 0, 100}, {0, 0, -1000, 100}},
                                        4e6 - 3 * 1e4 + 3 * 21e3,
                                        4e9 / 3 - 25 * 2995.0 + 11025 * 195.0}};

inline uint32_t shells_in_closed_form() {
  return first_failing(known_shells, [](const KnownShell &c) {
    if (!small_topology().build(c.ball, c.n)) return false;
    const hsp::BallMeasure found = shell_of(0);
    return near(found.area, c.area * hsp::pi, 1e-8) && near(found.volume, c.volume * hsp::pi, 1e-5);
  });
}

struct RegionMeasure {
  double area, volume;
  uint32_t enclosing_shell, components, shells;
};

// The cage's void holds a ball; all that is outside is one region without a volume.
inline uint32_t regions_of_a_cage() {
  const Shells &c = shell_sets[6];
  SmallTopology &built = small_topology();
  if (!built.build(c.ball, c.n) || built.topology().region_count != 2) return 0;
  RegionMeasure regions[2] = {{9, 9, 9, 9, 9}, {9, 9, 9, 9, 9}};
  hsp::measure_regions(built.balls(), built.boundary(), built.topology(), hsp::Span<RegionMeasure>(regions, 2));
  const uint32_t enclosing = regions[1].enclosing_shell;
  if (enclosing >= c.shells || !built.topology().shells[enclosing].is_void) return 1;
  const hsp::BallMeasure around = shell_of(enclosing);
  double area = 0.0;
  for (uint32_t s = 0; s < c.shells; ++s) area += shell_of(s).area;
  const bool conditions[] = {regions[0].volume == 0.0,
                             regions[0].enclosing_shell == hsp::no_id,
                             regions[0].components == 2,
                             regions[0].shells == 2,
                             regions[1].components == 1,
                             regions[1].shells == 2,
                             near(regions[1].area, around.area + 4e4 * hsp::pi, 1e-12 * around.area),
                             near(regions[1].volume, -around.volume - 4e6 / 3 * hsp::pi, -1e-12 * around.volume),
                             near(regions[0].area + regions[1].area, area, 1e-12 * area)};
  return first_false(conditions);
}

inline constexpr Check topology_shell_volumes[] = {{"shells_sum_to_balls", shells_sum_to_balls},
                                                   {"signs_that_are_wrong", signs_that_are_wrong},
                                                   {"shells_in_closed_form", shells_in_closed_form},
                                                   {"regions_of_a_cage", regions_of_a_cage}};

}  // namespace cases
