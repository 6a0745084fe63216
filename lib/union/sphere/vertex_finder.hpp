// Step 2 of Section 4.2 for one ball: finds its free vertices with two balls that are later in grid order, and its free
// circles with one later ball. So each vertex and each circle is decided once, at the first of its balls, and its balls
// cannot disagree about it.
#pragma once

#include "core/fixed_vector.hpp"
#include "sphere/cap_boxes.hpp"
#include "sphere/exposed_caps.hpp"
#include "sphere/half_edges.hpp"
#include "sphere/near_caps.hpp"

namespace hsp {

// The n-th number of 0, 1, 2, .. if the number `one` is moved to the front.
constexpr uint32_t with_one_first(uint32_t n, uint32_t one) {
  return n > one ? n : n == 0 ? one : n - 1;
}

struct CrossingPoints;

// A copy of the caps for testing points, sorted by coarse classes of size, the largest first: a covered point is most
// likely covered by a large cap.
struct CapTests {
  static constexpr uint32_t group = 4;  // caps that are tested together; the arrays are padded by one group
  Span<double> ux, uy, uz, b;
  Span<uint32_t> cap;  // index in Caps
  uint32_t count = 0;

  void carve(Workspace &workspace, uint32_t capacity);
  void fill(const Caps &caps);
  // Copies the caps with these numbers alone.
  void fill(const Caps &caps, Span<const uint32_t> numbers);

 private:
  template <class NumberOf>
  void fill_with(const Caps &caps, uint32_t number, NumberOf number_of);
};

class VertexFinder {
 public:
  void carve(Workspace &workspace, uint32_t capacity);

  // Finds the caps that matter, in memory of this finder that is idle before the search.
  ExposedCaps exposed_caps() const { return {tests_.cap, state_}; }
  // If there are many caps, keeps those that matter. False if nothing of the sphere is free.
  bool keep_exposed(Caps &caps) const { return exposed_caps().keep(ExposedCaps::Part::sphere, caps); }

  // Finds all vertices of two later caps and all free circles of later caps; these begin at caps.first_later.
  void find(const BallSet &balls, const Caps &caps, FixedVector<VertexRecord> &vertices,
            FixedVector<CircleRecord> &circles);
  // The same for very many caps, with an index that lists the caps that may matter along one circle.
  void find(const BallSet &balls, const Caps &caps, NearCaps near, FixedVector<VertexRecord> &vertices,
            FixedVector<CircleRecord> &circles);
  void find(const BallSet &balls, const Caps &caps, CapBoxes boxes, FixedVector<VertexRecord> &vertices,
            FixedVector<CircleRecord> &circles);
  // The same, but if many pairs take long, as with spheres through one point or planes that nearly agree, the search
  // begins again with the caps that matter; `caps` keeps only these.
  void cull_and_find(const BallSet &balls, Caps &caps, FixedVector<VertexRecord> &vertices,
                     FixedVector<CircleRecord> &circles);
  // One search of cull_and_find(). False if it gave up, because many pairs take long; nothing has been added then.
  bool search(const BallSet &balls, const Caps &caps, bool may_give_up, FixedVector<VertexRecord> &vertices,
              FixedVector<CircleRecord> &circles);
  // Finds the vertices on the circle of the last cap alone, and that circle if it is free as a whole.
  void find_on_last(const BallSet &balls, const Caps &caps, FixedVector<VertexRecord> &vertices,
                    FixedVector<CircleRecord> &circles);

  // The steps of find(), for callers that decide most pairs otherwise: start(), then any pairs j < k of later caps,
  // then the circles j of any later caps.
  void start(const Caps &caps);
  void decide_pair(const BallSet &balls, const Caps &caps, uint32_t j, uint32_t k, FixedVector<VertexRecord> &vertices);
  void decide_circle(const Caps &caps, uint32_t j, FixedVector<CircleRecord> &circles) const;
  // Whether so many pairs since start() took more than the first formula, each of them tested against all caps, that it
  // is quicker to find the exposed caps first.
  bool asks_much() const { return !small_code && uint64_t{effort_} * tests_.count > 1024 * effort_of_integers; }

 private:
  struct CapIndex;
  void find_along_circles(const BallSet &balls, const Caps &caps, const CapIndex &index,
                          FixedVector<VertexRecord> &vertices, FixedVector<CircleRecord> &circles);
  void pair(const BallSet &balls, const Caps &caps, uint32_t j, uint32_t k, FixedVector<VertexRecord> &vertices);
  bool decide_points(const Caps &caps, uint32_t j, uint32_t k, const CrossingPoints &points,
                     FixedVector<VertexRecord> &vertices);
  void decide_crossing(const BallSet &balls, const Caps &caps, uint32_t j, uint32_t k,
                       FixedVector<VertexRecord> &vertices);

  // Bits of a cap's state during the loop over pairs.
  static constexpr uint8_t crossed = 1;  // its circle crosses another one, so it is not a free circle
  static constexpr uint8_t covered = 2;  // its circle lies inside another cap, so it has no free point at all

  static constexpr uint32_t effort_of_integers = 32;  // for a pair; the better formula takes 1

  CapTests tests_;
  Span<uint8_t> state_;
  uint32_t effort_ = 0;        // of all pairs that took more than the first formula
  uint32_t hint_[2] = {0, 0};  // the groups of test caps that covered the last p- and p+
  uint32_t holder_ = 0;        // the test cap that covered the last point that integers decided
};

}  // namespace hsp
