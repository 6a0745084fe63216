// Products of vectors whose components are small integers, so that every result is exact.
#pragma once

#include "cases.hpp"
#include "core/vec3.hpp"

namespace cases {

struct Product {
  hsp::Vec3 a, b;
  double dot;
  hsp::Vec3 cross;
};
constexpr Product products[] = {{{1, 0, 0}, {0, 1, 0}, 0, {0, 0, 1}},       {{0, 1, 0}, {0, 0, 1}, 0, {1, 0, 0}},
                                {{0, 0, 1}, {1, 0, 0}, 0, {0, 1, 0}},       {{0, 1, 0}, {1, 0, 0}, 0, {0, 0, -1}},
                                {{2, 3, 5}, {7, 11, 13}, 112, {-16, 9, 1}}, {{-1, 4, 2}, {-2, 8, 4}, 42, {0, 0, 0}}};

inline uint32_t products_of_vectors() {
  return first_failing(products, [](const Product &c) {
    const hsp::Vec3 n = hsp::cross(c.a, c.b);
    const hsp::Vec3 sum = hsp::combine(2.0, c.a, -3.0, c.b);
    return hsp::dot(c.a, c.b) == c.dot && n.x == c.cross.x && n.y == c.cross.y && n.z == c.cross.z &&
           sum.x == 2 * c.a.x - 3 * c.b.x && sum.y == 2 * c.a.y - 3 * c.b.y && sum.z == 2 * c.a.z - 3 * c.b.z;
  });
}

inline constexpr Check core_vec3[] = {{"products_of_vectors", products_of_vectors}};

}  // namespace cases
