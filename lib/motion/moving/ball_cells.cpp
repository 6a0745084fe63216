#include "moving/ball_cells.hpp"

namespace hsp {

void BallCells::carve(Workspace &workspace, uint32_t balls) {
  first_ = workspace.take<uint32_t>(CubeSlots::slots_for(balls));
  link_ = workspace.take<uint32_t>(2 * static_cast<uint64_t>(balls));
  next_ = workspace.take<uint32_t>(balls);
  cube_ = workspace.take<CubeCoordinates>(balls);
}

void BallCells::clear(uint32_t balls, int64_t side, int64_t largest_small) {
  balls_ = balls;
  side_[0] = side;
  side_[1] = 2 * largest_small;
  count_[0] = count_[1] = 0;
  used_ = static_cast<uint32_t>(CubeSlots::slots_for(balls));
  for (uint32_t &first : first_.part(0, used_)) first = no_id;
  for (uint32_t ball = 0; ball < balls; ++ball) next_[ball] = ball;
}

// The link that leads to the first ball of a cube, or that would.
uint32_t &BallCells::link_to(const CubeCoordinates &cube) {
  uint32_t *link = &first_[bucket_of(linear_hash(cube))];
  for (CubePath path(cube); *link != no_id && !(cube_[*link] == cube);) link = &link_[path.link_of(*link)];
  return *link;
}

void BallCells::insert(uint32_t ball, const exact::LatticeBall &placed) {
  const uint32_t size = size_of(placed.radius);
  ++count_[size];
  cube_[ball] = cube_at(size, placed.centre);
  uint32_t &first = link_to(cube_[ball]);
  if (first == no_id) {
    first = ball;
    next_[ball] = link_[2 * ball] = link_[2 * ball + 1] = no_id;
  } else {
    next_[ball] = next_[first];
    next_[first] = ball;
  }
}

// A first ball is replaced by another one of its cube. If there is none, it is replaced by a leaf of the tree below it:
// all balls below share the bits that lead to it.
void BallCells::remove(uint32_t ball) {
  --count_[size_of(cube_[ball])];
  uint32_t &first = link_to(cube_[ball]);
  if (first != ball) {
    uint32_t before = first;
    while (next_[before] != ball) before = next_[before];
    next_[before] = next_[ball];
  } else {
    uint32_t heir = next_[ball];
    if (heir == no_id) {
      uint32_t *link = &first;
      const auto below = [this](uint32_t each) { return &link_[2 * each + (link_[2 * each] == no_id ? 1U : 0U)]; };
      while (*below(*link) != no_id) link = below(*link);
      heir = *link;
      *link = no_id;
    }
    if (heir != ball) {
      link_[2 * heir] = link_[2 * ball];
      link_[2 * heir + 1] = link_[2 * ball + 1];
      first = heir;
    }
  }
  next_[ball] = ball;
}

uint32_t BallCells::longest_way() const {
  uint32_t longest = 0;
  for (uint32_t ball = 0; ball < balls_; ++ball) {
    if (!is_there(ball)) continue;
    uint32_t length = 1;
    uint32_t at = first_[bucket_of(linear_hash(cube_[ball]))];
    for (CubePath path(cube_[ball]); !(cube_[at] == cube_[ball]); ++length) at = link_[path.link_of(at)];
    longest = length > longest ? length : longest;
  }
  return longest;
}

}  // namespace hsp
