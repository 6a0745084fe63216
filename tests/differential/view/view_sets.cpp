#include "view_sets.hpp"

#include "degenerate_set.hpp"
#include "point_lattices.hpp"
#include "sweep_length.hpp"

namespace {

using oracle::Balls;

}  // namespace

std::vector<oracle::NamedBalls> small_views() {
  return {{"no ball", {}},
          {"one ball", {{1, 2, 3, 5}}},
          {"one ball of radius 0", {{1, 2, 3, 0}}},
          {"two apart", {{0, 0, 0, 5}, {20, 3, 1, 4}}},
          {"two that meet", {{0, 0, 0, 5}, {4, 3, 2, 4}}},
          {"two that meet at the same depth", {{0, 0, 0, 5}, {6, 0, 0, 5}}},
          {"two that meet, one straight behind the other", {{0, 0, 0, 5}, {0, 0, 4, 4}}},
          {"two equal ones that meet, one straight behind the other", {{0, 0, 0, 5}, {0, 0, 6, 5}}},
          {"two that touch", {{0, 0, 0, 5}, {6, 8, 0, 5}}},
          {"two that touch, one straight behind the other", {{0, 0, 0, 5}, {0, 0, 8, 3}}},
          {"one inside another", {{0, 0, 0, 9}, {1, 2, 3, 2}}},
          {"one touching another from inside", {{0, 0, 0, 9}, {2, 4, 4, 3}}},
          {"touching from inside at the nearest point", {{0, 0, 0, 9}, {0, 0, 6, 3}}},
          {"touching from inside on the silhouette", {{0, 0, 0, 9}, {6, 0, 0, 3}}},
          {"the same twice", {{0, 0, 0, 5}, {0, 0, 0, 5}}},
          {"the same three times, and another", {{0, 0, 0, 5}, {4, 0, 0, 3}, {0, 0, 0, 5}, {0, 0, 0, 5}}},
          {"concentric", {{0, 0, 0, 3}, {0, 0, 0, 5}, {0, 0, 0, 4}}},
          {"a point on a sphere, one in it and one outside", {{0, 0, 0, 5}, {3, 4, 0, 0}, {1, 1, 1, 0}, {9, 9, 9, 0}}},
          {"a small ball before a large one", {{0, 0, 0, 20}, {3, 2, 40, 4}}},
          {"a small ball behind a large one", {{0, 0, 40, 20}, {3, 2, 0, 4}}},
          {"a bump on the near side", {{0, 0, 0, 20}, {3, 2, 19, 4}}},
          {"a bump on the far side", {{0, 0, 0, 20}, {3, 2, -19, 4}}},
          {"a bump on the silhouette", {{0, 0, 0, 20}, {20, 0, 1, 4}}},
          {"a column of equal balls", {{0, 0, 0, 5}, {0, 0, 6, 5}, {0, 0, 12, 5}, {0, 0, 24, 5}}},
          {"discs that touch", {{0, 0, 0, 5}, {10, 0, 30, 5}, {5, 12, 70, 8}}},
          {"discs that touch from inside", {{0, 0, 0, 9}, {6, 0, 30, 3}, {-4, 0, 50, 5}}},
          {"the silhouette through another's centre", {{0, 0, 0, 5}, {5, 0, 0, 5}, {5, 0, 5, 5}}},
          {"three around a point", {{0, 0, 0, 5}, {6, 0, 0, 5}, {3, 4, 0, 5}}},
          {"a circle of two silhouettes", {{0, 0, 0, 5}, {0, 0, 3, 4}, {8, 0, 0, 5}}},  // cuts at its own equator
          {"a ring around a ball, level with it",
           {{0, 0, 0, 13}, {13, 0, 0, 8}, {-13, 0, 0, 8}, {0, 13, 0, 8}, {0, -13, 0, 8}, {5, 12, 0, 4}}},
          {"a ball with a hole seen on its front",
           {{0, 0, 0, 20}, {0, 0, -8, 19}, {12, 0, 12, 8}, {-12, 0, 12, 8}, {0, 12, 12, 8}, {0, -12, 12, 8}}}};
}

std::vector<oracle::NamedBalls> lattice_views() {
  std::vector<oracle::NamedBalls> views;
  for (const int64_t radius : {1, 2, 3, 4}) {
    const std::string suffix = ", radius " + std::to_string(radius);
    views.push_back({"cubic lattice, spacing 4" + suffix, oracle::box_lattice({4, 4, 4}, {4, 4, 4}, radius)});
    views.push_back(
        {"face-centred lattice, spacing 2" + suffix, oracle::chosen_points(5, 2, radius, oracle::is_face_centred)});
  }
  views.push_back({"slanted box lattice", oracle::slanted_lattice({3, 3, 3}, {2, 2, 2}, 9)});
  views.push_back({"on a sphere", oracle::balls_on_sphere(9, 4, 13)});
  views.push_back({"cage", oracle::cage_of_26(8, 7)});
  return views;
}

std::vector<oracle::NamedBalls> degenerate_views(size_t most_balls) {
  std::vector<oracle::NamedBalls> views = small_views();
  for (oracle::NamedBalls &view : lattice_views()) views.push_back(std::move(view));
  for (const auto &sets : {degenerate::made_sets(), degenerate::read_sets(HSP_DEGENERATE_SETS)})
    for (const degenerate::DegenerateSet &set : sets)
      if (set.balls.size() <= most_balls) views.push_back({set.name, set.balls});
  return oracle::some_of(views);
}

std::vector<Direction> even_directions() {
  return {{0, 0, 1}, {-1, 0, 0}, {0, 1, 1}, {1, 1, 1}, {1, -2, 2}};
}

std::vector<Direction> uneven_directions() {
  return {{0.3, -0.5, 0.8}, {-1, 0.123456789, 0.0567}, {1e-5, 2e-5, -1}, {-3.1, -4.7, 1.3}};
}

Balls sparse_balls(oracle::RandomSource &random, size_t n) {
  return oracle::balls_in_box(random, n, 400, 10, 60);
}

Balls mixed_balls(oracle::RandomSource &random, size_t n) {
  Balls balls;
  while (balls.size() < n) {
    const int64_t size = random.one_in(6) ? 30 : random.one_in(2) ? 10 : 3;
    balls.push_back(ball_in_box(random, 60, 1, size));
  }
  return balls;
}

Balls flat_balls(oracle::RandomSource &random, size_t n) {
  Balls balls;
  while (balls.size() < n)
    balls.push_back({random.in(-100, 100), random.in(-100, 100), random.in(0, 2), random.in(5, 25)});
  return balls;
}
