// The search of one ball with several caps at a time.
//
// As an example the memory for 100 neighbours. It is one array of 18 rows, each of 100 numbers and some spare ones, up
// to a multiple of 8:
//   caps, by_size, large, exposed      four rows each: x, y, z and b
//   exposed_cap, crossed               one row each, of a number for each cap
#include "sphere/lane_search.hpp"

#include <initializer_list>

namespace hsp {

uint32_t SearchInLanes::count_few_clusters(Target target, const BallSet &balls, uint32_t i, const uint32_t *others,
                                           uint32_t n) {
  if (n > most_few_caps) return 0;
  uint32_t near[most_few_caps + spare_ids];
  float caps[4][most_few_caps + FloatCaps::spare];
  for (uint32_t k = 0; k < n; ++k) near[k] = others[k];
  FewCaps found;
  return make_float_caps(target, arrays_of(balls), i, near, n, {caps[0], caps[1], caps[2], caps[3]}) &&
                 find_few_in_floats(target, caps[0], caps[1], caps[2], caps[3], n, n, found)
             ? found.clusters
             : 0;
}

void SearchInLanes::carve(Workspace &workspace, uint32_t neighbours) {
  target_ = workspace.target();
  enabled = neighbours <= PairSweep::most_caps;
  // Rows of whole vectors. Where there are so many neighbours that a span does not know the size of all rows, there is
  // no search in lanes.
  struct OfEachRow {
    float number[18];
  };
  const size_t row = (neighbours + FloatCaps::spare + 7) / 8 * 8;
  const Span<OfEachRow> rows = workspace.take<OfEachRow>(row);
  rows_ = {reinterpret_cast<float *>(rows.data()), 18 * rows.size()};
  uncrossed_ = workspace.take<uint32_t>(neighbours);
  if (rows_.empty()) return;
  float *next = rows_.data();
  for (FloatCaps *const caps : {&sweep_.caps, &sweep_.by_size, &sweep_.large, &sweep_.exposed}) {
    *caps = {next, next + row, next + 2 * row, next + 3 * row};
    next += 4 * row;
  }
  sweep_.exposed_cap = next;
  sweep_.crossed = next + row;
}

Span<uint32_t> SearchInLanes::take_candidates(Workspace &workspace, uint32_t neighbours) {
  // The number of balls in a cube and those around it has no limit. The volume of these cubes is some six times that in
  // which the neighbours of one ball lie.
  const uint32_t most = neighbours <= PairSweep::most_caps ? neighbours : PairSweep::most_caps;
  const uint64_t room = 8 * (uint64_t{most} + 32);
  return workspace.take<uint32_t>(CandidatesInLanes::number_of_arrays * room);
}

bool SearchInLanes::start_cube(const CubeGrid &grid, uint32_t cube, const CubeBlock &block) {
  levels_ = block.levels;
  if (levels_ != nullptr) return enabled;
  return enabled && candidates_.start_cube(grid, cube, grid.balls_in(cube).first, block);
}

bool SearchInLanes::start_block(const BallSet &balls, const CubeBlock &block, uint32_t first_own,
                                const double (&centre)[3], double side) {
  levels_ = nullptr;
  return enabled && candidates_.start_block(balls, block, first_own, centre, side);
}

bool SearchInLanes::gather(const BallSet &balls, uint32_t i, Caps &caps, DisjointSets *components,
                           const uint32_t *selected) {
  uint32_t *const near = caps.ball.data();
  uint32_t earlier = 0;
  const uint32_t found = levels_ != nullptr ? levels_->find_neighbours(balls, i, near, caps.capacity())
                                            : candidates_.near(i, near, caps.capacity(), earlier);
  if (found > caps.capacity()) return false;
  for (; levels_ != nullptr && earlier < found && near[earlier] < i; ++earlier) {
  }
  if (selected != nullptr) earlier = put_selected_first(earlier, selected, caps.ball);
  if (!make_float_caps(target_, arrays_of(balls), i, near, found, sweep_.caps)) return false;
  caps.take_circles(balls, i, found, earlier, components);
  return true;
}

bool SearchInLanes::find_few(Caps &caps, FewCaps &found) {
  const FloatCaps &f = sweep_.caps;
  if (floats && find_few_in_floats(target_, f.x, f.y, f.z, f.b, caps.count, caps.first_later, found)) return true;
  caps.make_doubles();
  if (!doubles) return false;
  const uint32_t read = 2 * caps.count <= most_few_caps ? most_few_caps / 2 : most_few_caps;
  for (uint32_t k = caps.count; k < read; ++k) {
    caps.ux[k] = caps.uy[k] = caps.uz[k] = 0.0;
    caps.b[k] = 4.0;
  }
  return find_few_in_doubles(target_, caps.ux.data(), caps.uy.data(), caps.uz.data(), caps.b.data(), caps.count,
                             caps.first_later, found);
}

bool SearchInLanes::keep_exposed(Caps &caps, ExposedCaps exposed) {
  const FloatCaps &f = sweep_.caps;
  if (!exposed.find(ExposedCaps::Part::sphere, caps, &f)) return false;
  uint32_t kept = 0;
  for (const uint32_t k : exposed.kept()) {
    f.x[kept] = f.x[k];
    f.y[kept] = f.y[k];
    f.z[kept] = f.z[k];
    f.b[kept++] = f.b[k];
  }
  f.pad(kept);
  caps.keep(exposed.kept());
  return true;
}

uint32_t SearchInLanes::find(const BallSet &balls, Caps &caps, VertexFinder &finder, const FreeIntervals &idle,
                             FixedVector<VertexRecord> &vertices, FixedVector<CircleRecord> &circles) {
  constexpr uint32_t most_in_pairs = 1024;
  GivesUp gives_up = small_code ? GivesUp::never : GivesUp::soon;
  if (ExposedCaps::are_many(caps)) {
    if (!keep_exposed(caps, finder.exposed_caps())) return 0;
    gives_up = GivesUp::never;
  }
  if (NearCaps::are_many(caps, sweep_.caps.b)) {
    caps.make_doubles();
    finder.find(balls, caps, idle.near_caps(), vertices, circles);
    return 0;
  }
  if (CapBoxes::are_many(caps)) {
    // If floats are certain of most pairs, they are quicker than boxes.
    if (caps.count < most_in_pairs && find_many(balls, caps, finder, GivesUp::late, vertices, circles)) return 0;
    caps.make_doubles();
    const Span<uint32_t> idle_rows(reinterpret_cast<uint32_t *>(rows_.data()), rows_.size());
    finder.find(balls, caps, CapBoxes(idle_rows), vertices, circles);
    return 0;
  }
  while (caps.count > most_few_caps) {
    if (find_many(balls, caps, finder, gives_up, vertices, circles)) return 0;
    if (!keep_exposed(caps, finder.exposed_caps())) return 0;
    gives_up = GivesUp::never;
  }
  FewCaps found;
  if (!find_few(caps, found)) {
    finder.cull_and_find(balls, caps, vertices, circles);
    return 0;
  }
  exact::count_answer(exact::Question::vertex_pair, exact::Stage::lanes, found.crossing);
  const auto push = [&](uint32_t j, uint32_t k, uint32_t flags) {
    vertices.push({{caps.origin, caps.ball[j], caps.ball[k]}, flags});
  };
  for (uint32_t p = 0; p < found.points; ++p) {
    push(found.point[p].j, found.point[p].k, found.point[p].positive != 0 ? VertexRecord::positive_bit : 0U);
  }
  for (uint32_t bits = found.free_circles; bits != 0; bits &= bits - 1) {
    circles.push({{caps.origin, caps.ball[static_cast<uint32_t>(__builtin_ctz(bits))]}, {no_id, no_id}});
  }
  return found.clusters;
}

bool SearchInLanes::find_many(const BallSet &balls, Caps &caps, VertexFinder &finder, GivesUp gives_up,
                              FixedVector<VertexRecord> &vertices, FixedVector<CircleRecord> &circles) {
  // In molecules large caps leave fewer circles exposed.
  constexpr uint32_t many_circles = 32;
  const uint64_t known = vertices.required();
  bool prepared = false;
  [[maybe_unused]] uint32_t passed_on = 0;
  const auto prepare = [&]() {
    if (prepared) return;
    caps.make_doubles();
    finder.start(caps);
    prepared = true;
  };
  sweep_.count = caps.count;
  sweep_.first_later = caps.first_later;
  start_sweep(target_, sweep_);
  if (gives_up == GivesUp::soon && sweep_.exposed_count >= many_circles) return false;
  OpenPair pairs[PairSweep::batch];
  while (const uint32_t found = next_open_pairs(target_, sweep_, pairs)) {
    for (const OpenPair &pair : Span<const OpenPair>(pairs, found)) {
      if (!pair.certain || !floats) {
        prepare();
        ++passed_on;
        finder.decide_pair(balls, caps, pair.j, pair.k, vertices);
        if (gives_up == GivesUp::never || !finder.asks_much()) continue;
        vertices.set_count(known);
        return false;
      }
      const uint32_t j = caps.ball[pair.j], k = caps.ball[pair.k];
      if (pair.minus) vertices.push({{caps.origin, j, k}, 0});
      if (pair.plus) vertices.push({{caps.origin, j, k}, VertexRecord::positive_bit});
    }
  }
  exact::count_answer(exact::Question::vertex_pair, exact::Stage::lanes, sweep_.crossing - passed_on);
  const uint32_t uncrossed = uncrossed_caps(target_, sweep_, uncrossed_.data());
  for (const uint32_t j : uncrossed_.part(0, uncrossed)) {
    prepare();
    finder.decide_circle(caps, j, circles);
  }
  return true;
}

}  // namespace hsp
