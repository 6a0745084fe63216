#include "periodic/windings.hpp"

#include <utility>

namespace hsp {
namespace {

// Numbers up to this have products whose sums are below 2^63.
constexpr int64_t largest_entry = INT32_MAX;

bool is_small(const int64_t (&v)[3]) {
  for (const int64_t x : v) {
    if (x > largest_entry || -x > largest_entry) return false;
  }
  return true;
}

// v - times w.
void subtract(int64_t (&v)[3], int64_t times, const int64_t (&w)[3]) {
  for (int k = 0; k < 3; ++k) v[k] -= times * w[k];
}

constexpr int64_t common_divisor(int64_t a, int64_t b) {
  while (b != 0) {
    const int64_t rest = a % b;
    a = b;
    b = rest;
  }
  return a < 0 ? -a : a;
}

}  // namespace

// The columns of pivots ascend from row to row. In each column with a pivot Euclid's algorithm makes the generator's
// number 0.
bool WindingLattice::add(const int64_t (&generator)[3]) {
  int64_t v[3] = {generator[0], generator[1], generator[2]};
  if (!is_small(v)) return false;
  if (holds_all_shifts()) return true;
  int64_t rows[4][3] = {};
  for (uint32_t r = 0; r < rank; ++r) {
    for (int k = 0; k < 3; ++k) rows[r][k] = row[r][k];
  }
  uint32_t at = 0;
  for (int column = 0; column < 3; ++column) {
    if (at < rank && rows[at][column] != 0) {
      while (v[column] != 0) {
        subtract(rows[at], rows[at][column] / v[column], v);
        if (!is_small(rows[at])) return false;
        std::swap(v, rows[at]);
      }
      ++at;
    } else if (v[column] != 0) {
      // Rows behind the last one are 0, and then v is.
      for (uint32_t r = rank; r > at; --r) std::swap(rows[r], rows[r - 1]);
      std::swap(v, rows[at]);
      ++rank;
      ++at;
    }
  }
  for (uint32_t r = 0; r < rank; ++r) {
    int column = 0;
    while (rows[r][column] == 0) ++column;
    if (rows[r][column] < 0) {
      for (int64_t &x : rows[r]) x = -x;
    }
    const int64_t pivot = rows[r][column];
    for (uint32_t above = 0; above < r; ++above) {
      int64_t times = rows[above][column] / pivot;
      if (rows[above][column] - times * pivot < 0) --times;
      subtract(rows[above], times, rows[r]);
      if (!is_small(rows[above])) return false;
    }
  }
  for (uint32_t r = 0; r < rank; ++r) {
    for (int k = 0; k < 3; ++k) row[r][k] = static_cast<int32_t>(rows[r][k]);
  }
  return true;
}

// The index is the greatest common divisor of the minors of the highest order.
uint64_t WindingLattice::copies() const {
  if (rank == 0) return 1;
  int64_t divisor = 0;
  if (rank == 1) {
    for (const int32_t x : row[0]) divisor = common_divisor(divisor, x);
  } else if (rank == 2) {
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const int64_t minor = int64_t{row[0][k]} * row[1][next] - int64_t{row[0][next]} * row[1][k];
      divisor = common_divisor(divisor, minor);
    }
  } else {
    uint64_t product = 1;
    for (int k = 0; k < 3; ++k) {
      const auto pivot = static_cast<uint64_t>(row[k][k]);
      if (product > UINT64_MAX / pivot) return 0;
      product *= pivot;
    }
    return product;
  }
  return static_cast<uint64_t>(divisor);
}

void Windings::carve(Workspace &workspace, uint32_t balls) {
  n_ = 0;
  workspace.take_each(balls, parent_, offset_, lattice_, component_, first_);
}

void Windings::reset(uint32_t balls) {
  n_ = balls;
  for (uint32_t i = 0; i < balls; ++i) {
    parent_[i] = i;
    offset_[i] = {{0, 0, 0}};
    lattice_[i] = {};
  }
}

void Windings::reset(Span<const uint32_t> root, Span<const uint32_t> ball) {
  reset(root.size());
  const Span<uint32_t> lowest = component_;  // first used for the lowest ball of each set
  for (uint32_t k = 0; k < n_; ++k) lowest[k] = no_id;
  for (uint32_t k = 0; k < n_; ++k) {
    if (ball[k] < lowest[root[k]]) lowest[root[k]] = ball[k];
  }
  for (uint32_t k = 0; k < n_; ++k) parent_[ball[k]] = lowest[root[k]];
}

// Uses path halving. The offset of a root is 0, so that the offset of a parent may always be added.
uint32_t Windings::find(uint32_t ball, Offset &offset) {
  offset = {{0, 0, 0}};
  while (parent_[ball] != ball) {
    const uint32_t parent = parent_[ball];
    Offset &own = offset_[ball];
    for (int axis = 0; axis < 3; ++axis) {
      own.k[axis] += offset_[parent].k[axis];
      offset.k[axis] += own.k[axis];
    }
    ball = parent_[ball] = parent_[parent];
  }
  return ball;
}

bool Windings::join(uint32_t i, uint32_t j, const BoxShift &shift) {
  Offset of_i, of_j;
  const uint32_t p = find(i, of_i);
  const uint32_t q = find(j, of_j);
  // If the root of i is at its place, ball i is at of_i, ball j at of_i + shift, and the root of j at `apart` from its
  // place.
  int64_t apart[3];
  for (int axis = 0; axis < 3; ++axis) apart[axis] = of_i.k[axis] + shift.k[axis] - of_j.k[axis];
  if (p == q) return (apart[0] | apart[1] | apart[2]) == 0 || lattice_[p].add(apart);
  const uint32_t root = p < q ? p : q;
  const uint32_t child = p < q ? q : p;
  parent_[child] = root;
  for (int axis = 0; axis < 3; ++axis) offset_[child].k[axis] = p < q ? apart[axis] : -apart[axis];
  const WindingLattice &added = lattice_[child];
  for (uint32_t r = 0; r < added.rank; ++r) {
    const int64_t generator[3] = {added.row[r][0], added.row[r][1], added.row[r][2]};
    if (!lattice_[root].add(generator)) return false;
  }
  return true;
}

uint32_t Windings::number() {
  uint32_t count = 0;
  for (uint32_t i = 0; i < n_; ++i) {
    if (parent_[i] == i) {
      first_[count] = i;
      component_[i] = count++;
    } else {
      Offset ignored;
      component_[i] = component_[find(i, ignored)];
    }
  }
  return count;
}

}  // namespace hsp
