#include "visible_families.hpp"

#include <cmath>
#include <random>
#include <string>

namespace bench {
namespace {

// The same numbers with every standard library.
class Random {
 public:
  // In [0, 1).
  double next() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_{1994};
};

void add(Balls &balls, double x, double y, double z, double radius) {
  balls.xyz.insert(balls.xyz.end(), {x, y, z});
  balls.radius.push_back(radius);
}

}  // namespace

Balls random_balls(uint32_t count) {
  constexpr double volume_of_one = 10;  // cubic Angstrom: proteins have one atom, without hydrogen, in 18 to 20
  const double side = std::cbrt(volume_of_one * count);
  Random random;
  Balls balls;
  balls.name = "random_" + std::to_string(count);
  for (uint32_t i = 0; i < count; ++i) {
    const double x = side * random.next();
    const double y = side * random.next();
    const double z = side * random.next();
    add(balls, x, y, z, 1 + random.next());
  }
  return balls;
}

// Neighbours in a row overlap, those of different rows do not. The shifts make all views general ones.
Balls crossing_rows(uint32_t rows) {
  constexpr double in_row = 0.9;
  constexpr double between_rows = 1.5;
  Balls balls;
  balls.name = "crossing_rows_" + std::to_string(2 * rows * rows);
  for (uint32_t row = 0; row < rows; ++row) {
    for (uint32_t k = 0; k < rows; ++k) {
      add(balls, between_rows * row + 0.011 * k, in_row * k + 0.003 * row, 10 + 0.001 * row + 0.0007 * k, 0.6);
      add(balls, in_row * k + 0.013 * row, between_rows * row + 0.007 * k, 0.0013 * row + 0.0009 * k, 0.6);
    }
  }
  return balls;
}

Balls deep_stack(uint32_t count) {
  Balls balls;
  Random random;
  balls.name = "deep_stack_" + std::to_string(count);
  for (uint32_t i = 0; i < count; ++i) {
    const double radius = 1 + 10.0 * (count - i) / count;
    const double x = 1.0 / count * random.next();
    const double y = 1.0 / count * random.next();
    add(balls, x, y, 20.0 * i, radius);
  }
  return balls;
}

}  // namespace bench
