// Step 2 of Section 4.2 for one ball: its free vertices with two balls later in grid order, and its free circles with a
// later ball. Each vertex and circle is decided exactly once, so that its balls cannot disagree about it.
#pragma once

#include "core/fixed_vector.hpp"
#include "sphere/cap_boxes.hpp"
#include "sphere/exposed_caps.hpp"
#include "sphere/half_edges.hpp"
#include "sphere/near_caps.hpp"

namespace hsp {

// The n-th of 0, 1, 2, .. where one of them comes before all others.
constexpr uint32_t with_one_first(uint32_t n, uint32_t one) {
  return n > one ? n : n == 0 ? one : n - 1;
}

struct CrossingPoints;

// A copy of the caps, largest first by coarse classes of size: a covered point is most likely covered by one of the
// first.
struct CapTests {
  static constexpr uint32_t group = 4;  // caps that are tested at once; the arrays are padded by one group
  Span<double> ux, uy, uz, b;
  Span<uint32_t> cap;  // index in Caps
  uint32_t count = 0;

  void carve(Workspace &workspace, uint32_t capacity);
  void fill(const Caps &caps);
  // Of some of them alone.
  void fill(const Caps &caps, Span<const uint32_t> numbers);

 private:
  template <class NumberOf>
  void fill_with(const Caps &caps, uint32_t number, NumberOf number_of);
};

class VertexFinder {
 public:
  void carve(Workspace &workspace, uint32_t capacity);

  // Of many caps those that matter, in memory of this one that is idle before the search.
  ExposedCaps exposed_caps() const { return {tests_.cap, state_}; }
  // Of many caps keeps these. False if nothing of the sphere is free.
  bool keep_exposed(Caps &caps) const { return exposed_caps().keep(ExposedCaps::Part::sphere, caps); }

  // Among caps from caps.first_later on.
  void find(const BallSet &balls, const Caps &caps, FixedVector<VertexRecord> &vertices,
            FixedVector<CircleRecord> &circles);
  // The same of very many caps, by an index of them: what meets a circle is near to its cap, or listed in boxes.
  void find(const BallSet &balls, const Caps &caps, NearCaps near, FixedVector<VertexRecord> &vertices,
            FixedVector<CircleRecord> &circles);
  void find(const BallSet &balls, const Caps &caps, CapBoxes boxes, FixedVector<VertexRecord> &vertices,
            FixedVector<CircleRecord> &circles);
  // The same, but where many pairs take long, as of spheres through one point or planes that nearly agree, only caps
  // that matter stay.
  void cull_and_find(const BallSet &balls, Caps &caps, FixedVector<VertexRecord> &vertices,
                     FixedVector<CircleRecord> &circles);
  // The parts of that: false if it gave up, as many pairs take long; then nothing is found.
  bool search(const BallSet &balls, const Caps &caps, bool may_give_up, FixedVector<VertexRecord> &vertices,
              FixedVector<CircleRecord> &circles);
  // On the circle of the last cap alone.
  void find_on_last(const BallSet &balls, const Caps &caps, FixedVector<VertexRecord> &vertices,
                    FixedVector<CircleRecord> &circles);

  // Parts of find, for callers that find the rest otherwise: start, then any pairs j < k and any circles j of later
  // caps.
  void start(const Caps &caps);
  void decide_pair(const BallSet &balls, const Caps &caps, uint32_t j, uint32_t k, FixedVector<VertexRecord> &vertices);
  void decide_circle(const Caps &caps, uint32_t j, FixedVector<CircleRecord> &circles) const;
  // Whether so many pairs since the start took more than the first formula, each with all caps, that it is quicker to
  // keep exposed caps first.
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

  // State of a cap during the loop over pairs; bits.
  static constexpr uint8_t crossed = 1;  // its circle crosses another one, so it is not a free circle
  static constexpr uint8_t covered = 2;  // its circle lies inside another cap, so it has no free point at all

  static constexpr uint32_t effort_of_integers = 32;  // for a pair; by the better formula 1

  CapTests tests_;
  Span<uint8_t> state_;
  uint32_t effort_ = 0;        // for pairs by more than the first formula: 1 each, more by integers
  uint32_t hint_[2] = {0, 0};  // the groups of test caps that covered the last p- and p+
  uint32_t holder_ = 0;        // the test cap that by integers covered the last one
};

}  // namespace hsp
