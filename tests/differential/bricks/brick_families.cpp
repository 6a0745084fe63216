#include "brick_families.hpp"

#include <array>
#include <cmath>

namespace {

using support::Random;

class Family {
 public:
  Family(Random &random, BrickSet &set)
      : random_(random), set_(set), scale_(std::array{1.0, 1e3, 1e6, 1e8}[random.below(4)]) {}

  void soup() {
    set_.family = "soup";
    const int64_t n = random_.in(0, 300);
    const double box = std::cbrt(static_cast<double>(n) + 1) * std::array{1.0, 1.5, 2.2, 3.5}[random_.below(4)];
    for (int64_t k = 0; k < n; ++k) add_in(box, 0.4 + 0.9 * random_.fraction());
  }
  void dense_soup() {
    set_.family = "dense soup with holes";
    const int64_t n = random_.in(200, 900);
    const double box = std::cbrt(static_cast<double>(n)) * 1.05;
    for (int64_t k = 0; k < n; ++k) add_in(box, 0.85);
  }
  void small_integers() {
    set_.family = "small integers";
    const int64_t n = random_.in(1, 120), box = random_.in(3, 12), r = random_.in(1, 3);
    for (int64_t k = 0; k < n; ++k) add_at(box, box, box, random_.in(1, r));
  }
  void equal_balls() {
    set_.family = "equal balls";
    const int64_t n = random_.in(1, 60), box = random_.in(2, 8);
    for (int64_t k = 0; k < n; ++k) {
      add_at(box, box, box, random_.in(1, 2));
      for (int64_t copies = random_.in(0, 2); copies > 0; --copies) set_.balls.push_back(set_.balls.back());
    }
  }
  // Of radius 7 all eight spheres of a box meet in its middle.
  void lattice() {
    set_.family = "lattice 4 6 12";
    const int64_t m = random_.in(2, 4), r = std::array<int64_t, 5>{7, 6, 8, 2, 3}[random_.below(5)];
    for_box(m, m, m, [&](int64_t x, int64_t y, int64_t z) {
      if (random_.fraction() > 0.15) set_.balls.push_back({4 * x, 6 * y, 12 * z, r});
    });
  }
  void cubic() {
    set_.family = "cubic with voids";
    const int64_t m = random_.in(3, 6), r = std::array<int64_t, 4>{5, 7, 8, 6}[random_.below(4)];
    for_box(m, m, m, [&](int64_t x, int64_t y, int64_t z) {
      if (random_.fraction() > 0.08) set_.balls.push_back({10 * x, 10 * y, 10 * z, r});
    });
  }
  // Distances are 6, 8 and 10 along the axes; half of that of neighbours across is 5 sqrt 2.
  void face_centred() {
    set_.family = "face-centred";
    const int64_t m = random_.in(2, 5), r = random_.in(4, 9);
    for_box(2 * m, 2 * m, m, [&](int64_t x, int64_t y, int64_t z) {
      if ((x + y + z) % 2 == 0 && random_.fraction() > 0.1) set_.balls.push_back({6 * x, 8 * y, 10 * z, r});
    });
  }
  void nested_shells() {
    set_.family = "nested shells";
    const int64_t layers = random_.in(1, 2);
    for (int64_t k = 1; k <= layers; ++k) add_shell(4.5 * static_cast<double>(k) - 0.7, 1.0, 0, 0, 0);
    if (random_.fraction() < 0.7) add(0.3, 0, 0.4, 1.2);
    if (random_.fraction() < 0.5) add(0.3, 0, -1.9, 0.8);
    if (random_.fraction() < 0.3) add(0.3, 0, -1.9, 0);
    if (layers == 2 && random_.fraction() < 0.5) add(6, 0, 0, 0.5);
    if (random_.fraction() < 0.3) add_shell(3.0, 0.9, 15, 1, 2);
    if (random_.fraction() < 0.4) set_.balls.erase(set_.balls.begin() + random_.in(0, last()));
  }
  void large_and_small() {
    set_.family = "large and small";
    for (int64_t n = random_.in(1, 150); n > 0; --n) {
      const bool large = random_.fraction() < 0.06;
      add_in(14, large ? 4 + 4 * random_.fraction() : 0.2 + 0.6 * random_.fraction());
    }
  }
  void flat() {
    set_.family = "flat";
    const bool line = random_.fraction() < 0.3;
    for (int64_t n = random_.in(1, 60); n > 0; --n) add_at(20, line ? 0 : 20, 0, random_.in(0, 4));
  }
  void tangent_chain() {
    set_.family = "tangent chains";
    std::array<int64_t, 3> at{};
    int64_t r = random_.in(1, 9);
    for (int64_t n = random_.in(1, 80); n > 0; --n) {
      set_.balls.push_back({at[0], at[1], at[2], r});
      const int64_t next = random_.in(1, 9), far = random_.one_in(5) ? std::abs(r - next) : r + next;
      at[random_.below(3)] += random_.one_in(2) ? far : -far;
      r = next;
    }
  }
  void points() {
    set_.family = "points and tiny balls";
    for (int64_t n = random_.in(1, 80); n > 0; --n) add_at(8, 8, 8, random_.in(0, 2));
  }

 private:
  [[nodiscard]] int64_t last() const { return static_cast<int64_t>(set_.balls.size()) - 1; }
  void add(double x, double y, double z, double r) {
    set_.balls.push_back(
        {std::llround(scale_ * x), std::llround(scale_ * y), std::llround(scale_ * z), std::llround(scale_ * r)});
  }
  void add_in(double box, double r) {
    const double x = box * random_.fraction(), y = box * random_.fraction(), z = box * random_.fraction();
    add(x, y, z, r);
  }
  void add_at(int64_t x, int64_t y, int64_t z, int64_t r) {
    const int64_t at_x = random_.in(0, x), at_y = random_.in(0, y), at_z = random_.in(0, z);
    set_.balls.push_back({at_x, at_y, at_z, r});
  }
  // Points so dense that balls around them close it.
  void add_shell(double radius, double ball, double x, double y, double z) {
    const double turn = 2.399963229728653, full = 12.566370614359172;
    const int n = static_cast<int>(full * radius * radius / (1.2 * ball * ball)) + 4;
    for (int k = 0; k < n; ++k) {
      const double t = 1 - 2 * (k + 0.5) / n, s = std::sqrt(1 - t * t);
      add(x + radius * s * std::cos(k * turn), y + radius * s * std::sin(k * turn), z + radius * t, ball);
    }
  }
  template <class Visit>
  static void for_box(int64_t width, int64_t depth, int64_t height, Visit visit) {
    for (int64_t x = 0; x < width; ++x)
      for (int64_t y = 0; y < depth; ++y)
        for (int64_t z = 0; z < height; ++z) visit(x, y, z);
  }

  Random &random_;
  BrickSet &set_;
  const double scale_;
};

}  // namespace

BrickSet random_brick_set(Random &random) {
  static constexpr std::array families = {&Family::soup,         &Family::dense_soup,    &Family::small_integers,
                                          &Family::equal_balls,  &Family::lattice,       &Family::cubic,
                                          &Family::face_centred, &Family::nested_shells, &Family::large_and_small,
                                          &Family::flat,         &Family::tangent_chain, &Family::points};
  BrickSet set;
  Family family(random, set);
  (family.*families[random.below(families.size())])();
  if (random.fraction() < 0.3) {
    const int64_t far = INT64_C(1) << 40, x = random.in(-1, 1), y = random.in(-1, 1), z = random.in(-1, 1);
    for (oracle::LatticeBall &ball : set.balls) {
      ball.x += far * x;
      ball.y += far * y;
      ball.z += far * z;
    }
  }
  return set;
}
