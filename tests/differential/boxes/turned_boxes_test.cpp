// Boxes of any three vectors against oracles that turn nothing: all images in long doubles, explicit images in free
// space, difference quotients in the caller's frame; and boxes as molecular codes write them.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "any_box.hpp"
#include "box_records.hpp"

namespace {

using boxes::AnyBox;
using boxes::Computed;
using boxes::Derivatives;
using boxes::Factors;
using boxes::Matrix;
using boxes::Vector;
using support::Random;

// Calls visit(shift) for all multiples of the vectors that bring ball i within `reach` of a point, and some more.
template <class Visit>
void for_each_image_near(const AnyBox &set, uint32_t i, const double *point, double reach, Visit visit) {
  const Vector own = set.fractions(set.centre(i)), there = set.fractions(point);
  int32_t first[3], last[3], shift[3];
  for (size_t row = 0; row < 3; ++row) {
    const double least = there[row] - own[row], margin = reach / set.height(row);
    first[row] = static_cast<int32_t>(std::ceil(least - margin - 1e-9));
    last[row] = static_cast<int32_t>(std::floor(least + margin + 1e-9));
  }
  for (shift[0] = first[0]; shift[0] <= last[0]; ++shift[0]) {
    for (shift[1] = first[1]; shift[1] <= last[1]; ++shift[1]) {
      for (shift[2] = first[2]; shift[2] <= last[2]; ++shift[2]) visit(shift);
    }
  }
}

long double distance(const AnyBox &set, uint32_t i, const int32_t *shift, const double *point) {
  long double square = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    long double x = set.centre(i)[axis];
    for (size_t row = 0; row < 3; ++row) x += static_cast<long double>(shift[row]) * set.box[3 * row + axis];
    square += (x - point[axis]) * (x - point[axis]);
  }
  return std::sqrt(square);
}

using Hit = std::array<int64_t, 4>;
Hit hit_of(const hsp_image &image) {
  return {image.ball, image.shift[0], image.shift[1], image.shift[2]};
}

// Nothing is so near to a tie in these sets that rounding to steps of 1e-8 decides.
std::vector<Hit> brute_hits(const AnyBox &set, const double *point, double radius) {
  std::vector<Hit> hits;
  for (uint32_t i = 0; i < set.n(); ++i) {
    const double reach = set.balls.radius[i] + radius;
    for_each_image_near(set, i, point, reach + 0.01, [&](const int32_t *shift) {
      const long double far = distance(set, i, shift, point);
      EXPECT_GT(std::fabs(far - reach), 1e-7L);
      if (far <= reach) hits.push_back({i, shift[0], shift[1], shift[2]});
    });
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}

TEST(TurnedBoxes, MeetWhatIsMetInLongDoubles) {
  Random random(721);
  size_t met = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Computed computed(boxes::random_box(random, 6));
    const AnyBox &set = computed.set();
    for (int query = 0; query < 6; ++query) {
      const double at[3] = {20 * random.fraction() - 10, 20 * random.fraction() - 10, 20 * random.fraction() - 10};
      const double radius = query < 2 ? 0 : query < 4 ? 1.1 : 4.7;
      std::vector<Hit> found;
      for (const hsp_image &image : support::all_records<hsp_image>(
               [&](auto... out) { return hsp_periodic_query_ball(computed.get(), at, radius, out...); }, "query"))
        found.push_back(hit_of(image));
      EXPECT_EQ(found, brute_hits(set, at, radius));
      met += found.size();
    }
    for (uint32_t i = 0; i < set.n(); ++i) {
      std::vector<Hit> found;
      for (const hsp_image &image : support::all_records<hsp_image>(
               [&](auto... out) { return hsp_periodic_query_neighbours(computed.get(), i, out...); }, "neighbours"))
        found.push_back(hit_of(image));
      std::vector<Hit> expected = brute_hits(set, set.centre(i), set.balls.radius[i]);
      std::erase(expected, Hit{i, 0, 0, 0});
      EXPECT_EQ(found, expected);
      met += found.size();
    }
    hsp_periodic_totals totals{};
    ASSERT_EQ(hsp_periodic_measure(computed.get(), &totals, nullptr, nullptr, 0, nullptr), HSP_OK);
    EXPECT_NEAR(totals.box_volume, std::fabs(boxes::determinant(set.box)), 1e-6);
  }
  EXPECT_GT(met, 5000U);
}

double dot(const Vector &a, const Vector &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector less(const Vector &a, const Vector &b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross(const Vector &a, const Vector &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector as_vector(const double *v) {
  return {v[0], v[1], v[2]};
}
// Off the sphere of an image.
double gap(const AnyBox &set, const hsp_image &image, const double *point) {
  const Vector v = less(set.image(image.ball, image.shift), as_vector(point));
  return std::sqrt(dot(v, v)) - set.balls.radius[image.ball];
}

TEST(TurnedBoxes, HaveRecordsInTheCallersFrame) {
  Random random(722);
  size_t vertices = 0, arcs = 0, circles = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Computed computed(boxes::random_box(random, trial % 2 == 0 ? 8 : 2));
    const AnyBox &set = computed.set();
    for (const auto &vertex : support::all_records<hsp_periodic_vertex>(
             [&](auto... out) { return hsp_periodic_get_vertices(computed.get(), out...); }, "vertices")) {
      for (const hsp_image &image : vertex.image) EXPECT_NEAR(gap(set, image, vertex.xyz), 0, 1e-5);
      Vector c[3];
      for (size_t k = 0; k < 3; ++k) c[k] = set.image(vertex.image[k].ball, vertex.image[k].shift);
      const double side = dot(cross(less(c[1], c[0]), less(c[2], c[0])), less(as_vector(vertex.xyz), c[0]));
      EXPECT_GT(side * vertex.sign, 0);
      ++vertices;
    }
    const auto check_circle = [&](const auto &record) {
      const Vector a = set.image(record.image[0].ball, record.image[0].shift);
      const Vector v = less(set.image(record.image[1].ball, record.image[1].shift), a);
      const double d = std::sqrt(dot(v, v));
      for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(record.axis[k], v[k] / d, 1e-7);
      const Vector of_centre = less(as_vector(record.centre), a);
      const double r = set.balls.radius[record.image[0].ball];
      EXPECT_NEAR(dot(of_centre, of_centre) + record.radius * record.radius, r * r, 1e-6);
      const Vector beside = cross(of_centre, v);
      EXPECT_NEAR(std::sqrt(dot(beside, beside)), 0, 1e-6);
    };
    const auto all = support::all_records<hsp_periodic_vertex>(
        [&](auto... out) { return hsp_periodic_get_vertices(computed.get(), out...); }, "vertices");
    for (const auto &arc : support::all_records<hsp_periodic_arc>(
             [&](auto... out) { return hsp_periodic_get_arcs(computed.get(), out...); }, "arcs")) {
      check_circle(arc);
      // From its beginning to its end counter-clockwise about the axis.
      Vector end[2];
      for (size_t k = 0; k < 2; ++k) {
        end[k] = less(as_vector(all[arc.vertex[k].id].xyz), as_vector(arc.centre));
        for (size_t c = 0; c < 9; ++c) end[k][c % 3] += arc.vertex[k].shift[c / 3] * set.box[c];
      }
      const double sine = dot(cross(end[0], end[1]), as_vector(arc.axis)), square = arc.radius * arc.radius;
      EXPECT_NEAR(sine, square * std::sin(arc.angle), 1e-5);
      EXPECT_NEAR(dot(end[0], end[1]), square * std::cos(arc.angle), 1e-5);
      ++arcs;
    }
    for (const auto &circle : support::all_records<hsp_periodic_circle>(
             [&](auto... out) { return hsp_periodic_get_circles(computed.get(), out...); }, "circles")) {
      check_circle(circle);
      ++circles;
    }
  }
  EXPECT_GT(vertices, 400U);
  EXPECT_GT(arcs, 600U);
  EXPECT_GT(circles, 20U);
}

// Of the balls where they are, with all images that meet one of them, in free space.
std::vector<double> areas_in_free_space(const AnyBox &set) {
  support::BallList all = set.balls;
  double largest = 0;
  for (const double r : set.balls.radius) largest = std::fmax(largest, r);
  for (uint32_t i = 0; i < set.n(); ++i) {
    std::vector<Hit> taken;
    for (uint32_t j = 0; j < set.n(); ++j) {
      const double reach = set.balls.radius[i] + set.balls.radius[j] + 0.01;
      for_each_image_near(set, i, set.centre(j), reach, [&](const int32_t *shift) {
        const Hit hit{i, shift[0], shift[1], shift[2]};
        if (hit == Hit{i, 0, 0, 0} || std::find(taken.begin(), taken.end(), hit) != taken.end()) return;
        taken.push_back(hit);
        const Vector at = set.image(i, shift);
        all.add(at[0], at[1], at[2], set.balls.radius[i]);
      });
    }
  }
  support::OwnedModel model(all.size());
  EXPECT_EQ(model.set(all, nullptr), HSP_OK);
  support::OwnedBoundary boundary;
  boundary.take(support::default_boundary_limits(all.size()));
  boundary.compute([&](hsp_boundary *handle, hsp_boundary_limits *asked) {
    return hsp_boundary_compute(handle, model.get(), asked);
  });
  std::vector<double> area(all.size());
  EXPECT_EQ(hsp_boundary_measure(boundary.get(), nullptr, nullptr, area.data(), nullptr, all.size(), nullptr), HSP_OK);
  area.resize(set.n());
  return area;
}

void expect_near(const std::vector<double> &found, const std::vector<double> &expected, double error) {
  ASSERT_EQ(found.size(), expected.size());
  for (size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], error) << k;
}

TEST(TurnedBoxes, HaveTheAreasOfAllImagesInFreeSpace) {
  Random random(723);
  for (int trial = 0; trial < 60; ++trial) {
    const Computed computed(boxes::random_box(random, 7));
    expect_near(computed.areas(), areas_in_free_space(computed.set()), 1e-5);
  }
}

// Two vectors that are nearly one, or three that are nearly in a plane.
TEST(TurnedBoxes, MayBeNearlyFlat) {
  Random random(724);
  for (int trial = 0; trial < 24; ++trial) {
    AnyBox set = boxes::upright_box(random, 4);
    const double lean = trial % 2 == 0 ? 30 : 8;  // of a, to the height of b or c
    set.box[3] = trial % 4 < 2 ? lean * set.box[0] : set.box[3];
    set.box[6] = trial % 4 >= 2 ? lean * set.box[0] + 1 : set.box[6];
    set.box[7] = trial % 3 == 0 ? 9 * set.box[4] : set.box[7];
    const AnyBox turned = set.turned(boxes::random_rotation(random));
    const Computed computed(turned);
    expect_near(computed.areas(), Computed(set).areas(), 2e-4);
    if (trial % 2 != 0 && trial < 8) expect_near(computed.areas(), areas_in_free_space(turned), 2e-4);
  }
}

double quotient(const AnyBox &set, const std::function<double(const AnyBox &)> &value,
                const std::function<void(AnyBox &, double)> &change) {
  constexpr double e = 1e-3;
  double sum = 0;
  for (const auto &[times, factor] : {std::array{-2.0, 1.0}, {-1.0, -8.0}, {1.0, 8.0}, {2.0, -1.0}}) {
    AnyBox changed = set;
    change(changed, times * e);
    sum += factor * value(changed);
  }
  return sum / (12 * e);
}

// Areas bend where arcs are born or die: a few quotients across such a place are off.
struct Misses {
  int all = 0, few = 0;
  void expect(double found, double expected) {
    ++all;
    few += std::fabs(found - expected) > 3e-4 * (1 + std::fabs(expected)) ? 1 : 0;
  }
  ~Misses() { EXPECT_LE(20 * few, all); }
};

void expect_derivatives(const AnyBox &set, const Derivatives &found, const std::function<double(const AnyBox &)> &value,
                        Misses &misses) {
  for (size_t k = 0; k < 3 * size_t{set.n()}; ++k)
    misses.expect(found.centre[k], quotient(set, value, [k](AnyBox &s, double e) { s.balls.xyz[k] += e; }));
  for (uint32_t i = 0; i < set.n(); ++i)
    misses.expect(found.radius[i], quotient(set, value, [i](AnyBox &s, double e) { s.balls.radius[i] += e; }));
  for (size_t k = 0; k < 9; ++k) {
    misses.expect(found.strain[k], quotient(set, value, [k](AnyBox &s, double e) { s.strain(k / 3, k % 3, e); }));
    misses.expect(found.box[k], quotient(set, value, [k](AnyBox &s, double e) { s.change_box(k, e); }));
  }
}

TEST(TurnedBoxes, DeriveInTheCallersFrame) {
  Random random(725);
  Misses misses;
  for (int trial = 0; trial < 25; ++trial) {
    const AnyBox set = boxes::random_box(random, 4);
    const Factors factors = trial % 2 == 0 ? Factors{0, 1, 0} : Factors{1.5, -0.5, 0};
    expect_derivatives(
        set, boxes::plain_derivatives(Computed(set), factors),
        [&](const AnyBox &s) { return boxes::plain_derivatives(Computed(s), factors).value; }, misses);
  }
}

TEST(TurnedBoxes, DeriveCurvaturesInTheCallersFrame) {
  Random random(726);
  Misses misses;
  for (int trial = 0; trial < 16; ++trial) {
    const AnyBox set = boxes::random_box(random, 3);
    const Factors factors = trial % 2 == 0 ? Factors{0, 0, 1} : Factors{0.5, 0.25, -1};
    expect_derivatives(
        set, boxes::morphometric_derivatives(Computed(set), factors),
        [&](const AnyBox &s) { return boxes::morphometric_derivatives(Computed(s), factors).value; }, misses);
  }
}

// Turns that exchange axes are exact: every bit is that of the upright box.
TEST(TurnedBoxes, HaveTheBitsOfUprightOnesWhereAxesAreExchanged) {
  Random random(727);
  int turns = 0;
  for (int trial = 0; trial < 10; ++trial) {
    const AnyBox set = boxes::upright_box(random, 6);
    const Computed upright(set);
    const Factors factors{0.5, 1, -0.25};
    const Derivatives own = boxes::morphometric_derivatives(upright, factors);
    std::array<size_t, 3> axis{0, 1, 2};
    do {
      for (uint32_t signs = 0; signs < 8; ++signs) {
        Matrix turn{};
        for (size_t k = 0; k < 3; ++k) turn[3 * k + axis[k]] = (signs >> k & 1) != 0 ? -1 : 1;
        if (boxes::determinant(turn) < 0) continue;
        const AnyBox there = set.turned(turn);
        const bool reversed = there.box[1] == 0 && there.box[2] == 0 && there.box[5] == 0;
        if (reversed) continue;  // not turned, but its vectors are
        const Computed computed(there);
        EXPECT_EQ(computed.areas(), upright.areas());
        const Derivatives found = boxes::morphometric_derivatives(computed, factors);
        EXPECT_EQ(found.value, own.value);
        EXPECT_EQ(found.strain, boxes::turned_matrix(turn, own.strain));
        for (uint32_t i = 0; i < set.n(); ++i) {
          const Vector expected = boxes::product(turn, &own.centre[3 * size_t{i}]);
          for (size_t k = 0; k < 3; ++k) EXPECT_EQ(found.centre[3 * size_t{i} + k], expected[k]);
        }
        for (size_t row = 0; row < 3; ++row) {
          const Vector expected = boxes::product(turn, &own.box[3 * row]);
          for (size_t k = 0; k < 3; ++k) EXPECT_EQ(found.box[3 * row + k], expected[k]);
        }
        ++turns;
      }
    } while (std::next_permutation(axis.begin(), axis.end()));
  }
  EXPECT_GE(turns, 10 * 18);
}

// A vector that points to the other side of its axis is reversed inside: nothing but its own numbers tells.
TEST(TurnedBoxes, HaveTheBitsOfUprightOnesWhereVectorsAreReversed) {
  Random random(728);
  for (int trial = 0; trial < 20; ++trial) {
    const AnyBox set = boxes::upright_box(random, 6);
    const Computed upright(set);
    const Factors factors{0.5, 1, 0};
    const Derivatives own = boxes::plain_derivatives(upright, factors);
    const auto contacts_of = [](const Computed &computed) {
      return support::all_records<hsp_periodic_contact>(
          [&](auto... out) { return hsp_periodic_get_contacts(computed.get(), out...); }, "contacts");
    };
    for (uint32_t which = 1; which < 8; ++which) {
      AnyBox there = set;
      double sign[3];
      for (size_t row = 0; row < 3; ++row) {
        sign[row] = (which >> row & 1) != 0 ? -1 : 1;
        if (sign[row] < 0) there = there.reversed(row);
      }
      const Computed computed(there);
      EXPECT_EQ(computed.areas(), upright.areas());
      const Derivatives found = boxes::plain_derivatives(computed, factors);
      EXPECT_EQ(found.centre, own.centre);
      EXPECT_EQ(found.strain, own.strain);
      for (size_t k = 0; k < 9; ++k) EXPECT_EQ(found.box[k], sign[k / 3] * own.box[k]);
      std::vector<Hit> expected, contacts;
      for (const auto &contact : contacts_of(upright)) {
        Hit hit{contact.ball[0], contact.shift[0], contact.shift[1], contact.shift[2]};
        for (size_t row = 0; row < 3; ++row) hit[row + 1] *= static_cast<int64_t>(sign[row]);
        expected.push_back(hit);
      }
      for (const auto &contact : contacts_of(computed))
        contacts.push_back({contact.ball[0], contact.shift[0], contact.shift[1], contact.shift[2]});
      std::sort(expected.begin(), expected.end());
      std::sort(contacts.begin(), contacts.end());
      EXPECT_EQ(contacts, expected);
    }
  }
}

// A rod of balls along one vector goes on along it, whatever side it points to.
TEST(TurnedBoxes, TellWhereComponentsGoOn) {
  Random random(729);
  for (int trial = 0; trial < 30; ++trial) {
    AnyBox set;
    set.box = {8, 0, 0, 2, 9, 0, -1, 3, 10};
    const size_t row = random.below(3);
    for (int k = 0; k < 9; ++k) {
      const double at = k / 9.0;
      set.balls.add(at * set.box[3 * row], at * set.box[3 * row + 1], at * set.box[3 * row + 2], 1);
    }
    set = set.turned(boxes::random_rotation(random));
    if (trial % 2 == 0) set = set.reversed(row);
    const Computed computed(set);
    const auto windings = support::all_records<hsp_winding>(
        [&](auto... out) { return hsp_periodic_get_windings(computed.get(), out...); }, "windings");
    ASSERT_EQ(windings.size(), 1U);
    EXPECT_EQ(windings[0].directions, 1U);
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(windings[0].row[k], k == row ? 1 : 0);
  }
}

// The same crystal with the vectors that several codes give it: lengths and angles alone decide.
TEST(TurnedBoxes, TakeVectorsAsMolecularCodesWriteThem) {
  constexpr double pi = 3.14159265358979323846;
  constexpr double a = 6.2, b = 7.1, c = 8.4, alpha = 77 * pi / 180, beta = 98 * pi / 180, gamma = 113 * pi / 180;
  const double ca = std::cos(alpha), cb = std::cos(beta), cg = std::cos(gamma), sg = std::sin(gamma);
  const double root = std::sqrt(1 - ca * ca - cb * cb - cg * cg + 2 * ca * cb * cg);
  struct Convention {
    const char *name;
    Matrix box;
  };
  std::vector<Convention> conventions;
  // CIF, PDB, and LAMMPS's restricted triclinic, lx, xy ly, xz yz lz: a along x, b in the plane of x and y.
  const Matrix standard = {a, 0, 0, b * cg, b * sg, 0, c * cb, c * (ca - cb * cg) / sg, c * root / sg};
  conventions.push_back({"standard", standard});
  // GROMACS: the last line of a .gro file has xx yy zz xy xz yx yz zx zy, and b and c are reduced.
  const double gro[9] = {a, b * sg, standard[8], 0, 0, b * cg, 0, standard[6], standard[7]};
  conventions.push_back({".gro", {gro[0], gro[3], gro[4], gro[5], gro[1], gro[6], gro[7], gro[8], gro[2]}});
  // c along z, a in the plane of x and z, as crystallographers have it, too.
  const double sb = std::sin(beta), cg_star = (ca * cb - cg) / (std::sin(alpha) * sb);
  conventions.push_back({"c along z",
                         {a * sb, 0, a * cb, -b * std::sin(alpha) * cg_star,
                          b * std::sin(alpha) * std::sqrt(1 - cg_star * cg_star), b * ca, 0, 0, c}});
  // b along y, c in the plane of y and z.
  const double sa = std::sin(alpha), x = a * (cb - ca * cg) / sa;
  conventions.push_back({"b along y", {std::sqrt(a * a * sg * sg - x * x), a * cg, x, 0, b, 0, 0, c * ca, c * sa}});
  // Symmetric, as molecular dynamics with a flexible cell keeps it: the root of the metric's matrix, by Newton.
  Matrix metric{a * a, a * b * cg, a * c * cb, a * b * cg, b * b, b * c * ca, a * c * cb, b * c * ca, c * c};
  Matrix symmetric{a, 0, 0, 0, b, 0, 0, 0, c};
  for (int step = 0; step < 60; ++step) {  // h = (h + h^-1 metric) / 2
    const double d = boxes::determinant(symmetric);
    Matrix inverse, next{};
    for (size_t p = 0; p < 3; ++p) {
      for (size_t q = 0; q < 3; ++q) {
        const size_t i = (q + 1) % 3, j = (q + 2) % 3, k = (p + 1) % 3, l = (p + 2) % 3;
        inverse[3 * p + q] =
            (symmetric[3 * i + k] * symmetric[3 * j + l] - symmetric[3 * i + l] * symmetric[3 * j + k]) / d;
      }
    }
    for (size_t p = 0; p < 9; ++p) {
      for (size_t k = 0; k < 3; ++k) next[p] += inverse[3 * (p / 3) + k] * metric[3 * k + p % 3];
      next[p] = (next[p] + symmetric[p]) / 2;
    }
    symmetric = next;
  }
  conventions.push_back({"symmetric", symmetric});
  // LAMMPS's general triclinic, avec bvec cvec: any orientation, right-handed.
  Random random(730);
  AnyBox carried;
  carried.box = standard;
  conventions.push_back({"general triclinic", carried.turned(boxes::random_rotation(random)).box});

  Random places(731);
  std::vector<Vector> fraction;
  for (int i = 0; i < 12; ++i) fraction.push_back({places.fraction(), places.fraction(), places.fraction()});
  std::vector<double> expected;
  double trace = 0;
  for (const Convention &convention : conventions) {
    SCOPED_TRACE(convention.name);
    AnyBox set;
    set.box = convention.box;
    EXPECT_NEAR(boxes::determinant(set.box), a * b * c * root, 1e-9);
    for (size_t i = 0; i < fraction.size(); ++i) {
      double at[3] = {0, 0, 0};
      for (size_t k = 0; k < 9; ++k) at[k % 3] += fraction[i][k / 3] * set.box[k];
      set.balls.add(at[0], at[1], at[2], 1.1 + 0.1 * static_cast<double>(i % 5));
      set.sigma.push_back(1);
    }
    const Computed computed(set);
    const Derivatives found = boxes::plain_derivatives(computed, {0.5, 1, 0});
    if (expected.empty()) {
      expected = computed.areas();
      trace = found.strain[0] + found.strain[4] + found.strain[8];
    }
    expect_near(computed.areas(), expected, 1e-5);
    EXPECT_NEAR(found.strain[0] + found.strain[4] + found.strain[8], trace, 1e-4);
    EXPECT_NEAR(found.strain[1], found.strain[3], 1e-9);
    EXPECT_NEAR(found.strain[2], found.strain[6], 1e-9);
    EXPECT_NEAR(found.strain[5], found.strain[7], 1e-9);
  }
}

}  // namespace
