// The walk of near_pairs.hpp. Like everything in kernels it has internal linkage.
#pragma once

#include <type_traits>

#include "lanes/wide_pairs.hpp"
#include "poses/near_pairs.hpp"

namespace hsp {
namespace {

class PairWalker {
 public:
  PairWalker(const SphereLevels &fixed, const SphereLevels &moving, const FloatPose &pose, PairWalk &walk)
      : fixed_(fixed), moving_(moving), pose_(pose), walk_(walk) {}

  uint32_t find() {
    while (walk_.waiting > 0) {
      // Loaded member by member, as pairs are stored: a wider load would wait for these stores.
      const SpherePair &last = walk_.pair[--walk_.waiting];
      const SpherePair pair{{last.moving[0], last.moving[1], last.moving[2], last.moving[3]},
                            last.fixed_node,
                            last.moving_node,
                            last.fixed_level,
                            last.moving_level};
      if (pair.moving_level > 1 && (pair.fixed_level <= 2 || is_small(pair))) {
        open_moving(pair);
      } else if (pair.fixed_level > 2) {
        open_fixed(pair);
      } else if (const uint32_t found = compare_leaves(pair); found > 0) {
        return found;
      }
    }
    return 0;
  }

 private:
  // One register, or two of four.
  using L = std::conditional_t<register_floats == 8, Wide<float, 8>, WidePairs<float, 4>>;
  using Eight = L::Real;
  struct Spheres {
    Eight x, y, z, r;
  };
  // Spheres in memory, to be read one by one.
  struct StoredSpheres {
    alignas(32) float x[8], y[8], z[8], r[8];

    explicit StoredSpheres(const Spheres &s) {
      L::store(x, s.x);
      L::store(y, s.y);
      L::store(z, s.z);
      L::store(r, s.r);
    }
  };

  static uint32_t lowest_bit(uint32_t bits) { return static_cast<uint32_t>(__builtin_ctz(bits)); }
  static uint32_t highest_bit(uint32_t bits) { return 31U - static_cast<uint32_t>(__builtin_clz(bits)); }

  static const SphereBlock &block(const SphereLevels &levels, uint32_t level, uint32_t k) {
    return levels.blocks[levels.first[level] + k];
  }
  static Spheres load(const SphereBlock &eight) {
    return {L::load(eight.x), L::load(eight.y), L::load(eight.z), L::load(eight.r)};
  }
  // The images of the spheres of a block, their radii larger by the slack.
  Spheres image(const SphereBlock &eight) const {
    const Spheres s = load(eight);
    const auto along = [&](int axis) {
      const float *const row = pose_.row[axis];
      return L::fused(L::all(row[0]), s.x,
                      L::fused(L::all(row[1]), s.y, L::fused(L::all(row[2]), s.z, L::all(pose_.shift[axis]))));
    };
    return {along(0), along(1), along(2), s.r + L::all(pose_.slack)};
  }
  // A bit for each sphere that is not certainly apart from another one.
  static uint32_t near(const Spheres &s, float x, float y, float z, float r) {
    const Eight dx = s.x - L::all(x), dy = s.y - L::all(y), dz = s.z - L::all(z);
    const Eight sum = s.r + L::all(r);
    return static_cast<uint32_t>(L::set_lanes(sum * sum >= L::fused(dx, dx, L::fused(dy, dy, dz * dz))));
  }
  static uint32_t near(const Spheres &s, const SphereBlock &eight, uint32_t lane) {
    return near(s, eight.x[lane], eight.y[lane], eight.z[lane], eight.r[lane]);
  }

  // Whether the sphere at rest is not much larger than the moving one. Then the moving one is opened: its cost is
  // shared by all spheres below the one at rest.
  bool is_small(const SpherePair &pair) const {
    const float radius = block(fixed_, pair.fixed_level, pair.fixed_node / 8).r[pair.fixed_node % 8];
    return radius <= 1.5F * pair.moving[3];
  }

  // Pairs are stacked so that those of lower ranks come first.
  void open_moving(const SpherePair &pair) {
    const Spheres images = image(block(moving_, pair.moving_level - 1, pair.moving_node));
    uint32_t bits = near(images, block(fixed_, pair.fixed_level, pair.fixed_node / 8), pair.fixed_node % 8);
    const StoredSpheres stored(images);
    while (bits != 0) {
      const uint32_t lane = highest_bit(bits);
      bits ^= 1U << lane;
      walk_.pair[walk_.waiting++] = {{stored.x[lane], stored.y[lane], stored.z[lane], stored.r[lane]},
                                     pair.fixed_node,
                                     8 * pair.moving_node + lane,
                                     pair.fixed_level,
                                     pair.moving_level - 1};
    }
  }

  void open_fixed(const SpherePair &pair) {
    const Spheres spheres = load(block(fixed_, pair.fixed_level - 1, pair.fixed_node));
    uint32_t bits = near(spheres, pair.moving[0], pair.moving[1], pair.moving[2], pair.moving[3]);
    while (bits != 0) {
      const uint32_t lane = highest_bit(bits);
      bits ^= 1U << lane;
      walk_.pair[walk_.waiting++] = {{pair.moving[0], pair.moving[1], pair.moving[2], pair.moving[3]},
                                     8 * pair.fixed_node + lane,
                                     pair.moving_node,
                                     pair.fixed_level - 1,
                                     pair.moving_level};
    }
  }

  // Compares the balls of a moving leaf with those of all leaves below a sphere of level 2, or below the root if that
  // is lower.
  uint32_t compare_leaves(const SpherePair &pair) {
    const SphereBlock &leaves = block(fixed_, 1, pair.fixed_node);
    const uint32_t first_leaf = 8 * pair.fixed_node;
    uint32_t bits = near(load(leaves), pair.moving[0], pair.moving[1], pair.moving[2], pair.moving[3]);
    if (bits == 0) return 0;
    const Spheres images = image(block(moving_, 0, pair.moving_node));
    const StoredSpheres stored(images);
    uint32_t found = 0;
    for (; bits != 0; bits &= bits - 1) {
      const uint32_t lane = lowest_bit(bits), leaf = first_leaf + lane;
      uint32_t movers = near(images, leaves, lane);
      if (movers == 0) continue;
      const Spheres balls = load(block(fixed_, 0, leaf));
      for (; movers != 0; movers &= movers - 1) {
        const uint32_t j = lowest_bit(movers);
        uint32_t meeting = near(balls, stored.x[j], stored.y[j], stored.z[j], stored.r[j]);
        for (; meeting != 0; meeting &= meeting - 1)
          walk_.found[found++] = {8 * leaf + lowest_bit(meeting), 8 * pair.moving_node + j};
      }
    }
    return found;
  }

  const SphereLevels &fixed_;
  const SphereLevels &moving_;
  const FloatPose &pose_;
  PairWalk &walk_;
};

}  // namespace
}  // namespace hsp
