// Balls that move, one or several at a time, with some moves taken back: every number must have the same bits as the
// library's boundary and measures of a new model of the same balls, and of the model that the handle itself gives.
// Moves that are refused; limits that are too small.
#include <cstring>
#include <limits>
#include <vector>

#include "computed_set.hpp"
#include "owned_motion.hpp"
#include "required_limits.hpp"
#include "topology_input.hpp"

namespace {

constexpr double tension = 1.25, pressure = -0.5;

// Everything that both a boundary and balls that move tell.
struct Numbers {
  hsp_totals totals{};
  hsp_energy energy{};
  std::vector<double> area, volume, centre, radius;
  std::vector<uint32_t> flags;

  explicit Numbers(uint32_t n) : area(n), volume(n), centre(3 * size_t{n}), radius(n), flags(n) {}
};

template <class T>
bool same_bytes(const std::vector<T> &p, const std::vector<T> &q) {
  return p.size() == q.size() && fuzz::same(p.data(), q.data(), static_cast<uint32_t>(p.size()));
}

void require_same(const Numbers &p, const Numbers &q) {
  FUZZ_REQUIRE(same_bytes(p.area, q.area) && same_bytes(p.volume, q.volume), "measures after moves");
  FUZZ_REQUIRE(same_bytes(p.centre, q.centre) && same_bytes(p.radius, q.radius), "gradients after moves");
  FUZZ_REQUIRE(p.flags == q.flags, "flags after moves");
  FUZZ_REQUIRE(fuzz::same(&p.totals, &q.totals, 1), "totals after moves");
  FUZZ_REQUIRE(fuzz::same(&p.energy, &q.energy, 1), "energies after moves");
}

// The harness's own copy of the balls, the largest radius that they may have, and their weights.
struct Balls {
  support::BallList list;
  std::vector<double> sigma;
  hsp_model_options options{};

  uint32_t n() const { return list.size(); }
};

Balls balls_from(const fuzz::ScaledBalls &set, fuzz::Bytes &bytes) {
  Balls balls;
  balls.list = set.in_lengths();
  balls.options = fuzz::options_of(set);
  int64_t largest = 1;
  for (const oracle::LatticeBall &ball : set.balls) largest = ball.radius > largest ? ball.radius : largest;
  balls.options.largest_radius = set.length(largest);
  for (uint32_t i = 0; i < balls.n(); ++i) balls.sigma.push_back(0.5 * bytes.below(5));
  return balls;
}

Numbers numbers_of(const hsp_moving *moving, uint32_t n) {
  Numbers result(n);
  uint32_t needed = 7;
  FUZZ_REQUIRE(
      hsp_moving_measure(moving, &result.totals, result.area.data(), result.volume.data(), n, &needed) == HSP_OK &&
          needed == n,
      "measures");
  FUZZ_REQUIRE(hsp_moving_gradient(moving, &result.energy, result.centre.data(), result.radius.data(),
                                   result.flags.data(), n, &needed) == HSP_OK &&
                   needed == n,
               "gradients");
  return result;
}

// Also compares what is counted.
Numbers fresh_numbers(const hsp_model *model, const hsp_moving *moving, const Balls &balls) {
  const uint32_t n = balls.n();
  Numbers result(n);
  support::OwnedBoundary boundary;
  boundary.take(support::default_boundary_limits(n));
  boundary.compute(
      [&](hsp_boundary *handle, hsp_boundary_limits *limits) { return hsp_boundary_compute(handle, model, limits); });
  const hsp_boundary *const b = boundary.get();
  FUZZ_REQUIRE(
      hsp_boundary_measure(b, nullptr, &result.totals, result.area.data(), result.volume.data(), n, nullptr) == HSP_OK,
      "measures of a new model");
  hsp_gradient_request request{};
  request.struct_size = sizeof request;
  request.tangency = HSP_TANGENT_OVERLAP;
  request.tension = tension;
  request.pressure = pressure;
  request.sigma = balls.sigma.data();
  hsp_gradient_outputs outputs{};
  outputs.struct_size = sizeof outputs;
  outputs.capacity = n;
  outputs.energy = &result.energy;
  outputs.d_centre = result.centre.data();
  outputs.d_radius = result.radius.data();
  outputs.flags = result.flags.data();
  FUZZ_REQUIRE(hsp_boundary_get_gradient(b, &request, &outputs) == HSP_OK, "gradients of a new model");
  hsp_boundary_counts counts{};
  hsp_moving_info info{};
  FUZZ_REQUIRE(hsp_boundary_get_counts(b, &counts) == HSP_OK && hsp_moving_get_info(moving, &info) == HSP_OK, "counts");
  FUZZ_REQUIRE(info.balls == counts.balls && info.exposed_balls == counts.exposed_balls &&
                   info.contained_balls == counts.contained_balls && info.components == counts.components,
               "counts of balls");
  FUZZ_REQUIRE(info.vertices == counts.vertices && info.arcs == counts.arcs && info.circles == counts.circles &&
                   info.faces == counts.faces && info.loops == counts.loops,
               "counts of vertices, arcs and faces");
  return result;
}

void require_fresh(const hsp_moving *moving, const Balls &balls) {
  const uint32_t n = balls.n();
  const Numbers known = numbers_of(moving, n);
  support::OwnedModel model(n);
  FUZZ_REQUIRE(model.set(balls.list, &balls.options) == HSP_OK, "a new model");
  require_same(known, fresh_numbers(model.get(), moving, balls));
  support::OwnedModel given(n);
  FUZZ_REQUIRE(hsp_moving_get_model(moving, given.get()) == HSP_OK, "the model that is given");
  require_same(known, fresh_numbers(given.get(), moving, balls));
  std::vector<uint32_t> ids;
  for (uint32_t i = n; i > 0; --i) ids.push_back(i - 1);
  std::vector<hsp_moving_ball> each(n);
  FUZZ_REQUIRE(hsp_moving_get_balls(moving, n, ids.data(), each.data()) == HSP_OK, "balls");
  for (uint32_t k = 0; k < n; ++k) {
    const uint32_t i = ids[k];
    FUZZ_REQUIRE(fuzz::same(&each[k].area, &known.area[i], 1) &&
                     fuzz::same(each[k].d_centre, &known.centre[3 * i], 3) && each[k].gradient_flags == known.flags[i],
                 "a ball by itself");
  }
}

struct Moves {
  std::vector<uint32_t> ball;
  support::BallList to;
};

// Mostly to places of other balls, one step aside, or touching another one.
Moves moves_from(const Balls &balls, const fuzz::ScaledBalls &set, fuzz::Bytes &bytes) {
  Moves moves;
  std::vector<uint32_t> order = fuzz::shuffled(balls.n(), bytes);
  order.resize(bytes.one_in(3) ? bytes.below(balls.n() + 1) : 1);
  moves.ball = order;
  for (const uint32_t i : order) {
    const uint32_t kind = bytes.below(5);
    const uint32_t other = bytes.below(balls.n());
    const uint32_t from = kind == 0 ? i : other;
    const double *const at = &balls.list.xyz[3 * size_t{from}];
    double to[3] = {at[0], at[1], at[2]};
    double r = balls.list.radius[bytes.one_in(2) ? i : other];
    const size_t axis = bytes.below(3);
    if (kind < 2) to[axis] += set.length(bytes.below(3)) - set.step();
    if (kind == 2) to[axis] += balls.list.radius[other] + r + 2 * balls.options.probe;
    if (kind == 3) to[axis] += balls.list.radius[other] - r;
    if (bytes.one_in(6)) r = bytes.one_in(2) ? 0.0 : balls.options.largest_radius;
    moves.to.add(to[0], to[1], to[2], r);
  }
  return moves;
}

int32_t move(hsp_moving *moving, const Moves &moves, hsp_moving_limits *limits) {
  uint32_t first_bad = 7;
  const int32_t status = hsp_moving_move(moving, static_cast<uint32_t>(moves.ball.size()), moves.ball.data(),
                                         moves.to.xyz.data(), moves.to.radius.data(), limits, &first_bad);
  FUZZ_REQUIRE(status == HSP_OK || status == HSP_E_CAPACITY, "a move");
  FUZZ_REQUIRE(first_bad == HSP_NONE, "a move that is to blame");
  return status;
}

void apply(const Moves &moves, Balls &balls) {
  for (size_t k = 0; k < moves.ball.size(); ++k) {
    const uint32_t i = moves.ball[k];
    for (size_t axis = 0; axis < 3; ++axis) balls.list.xyz[3 * size_t{i} + axis] = moves.to.xyz[3 * k + axis];
    balls.list.radius[i] = moves.to.radius[k];
  }
}

// The list of changed balls must have every ball whose numbers have changed, and every ball that moved.
void require_listed(const hsp_moving *moving, const Numbers &before, const Numbers &after) {
  const auto changed = support::all_records<uint32_t>(
      [&](auto... out) { return hsp_moving_get_changed(moving, out...); }, "hsp_moving_get_changed");
  std::vector<bool> listed(before.area.size());
  for (size_t k = 0; k < changed.size(); ++k) {
    FUZZ_REQUIRE(changed[k] < listed.size() && (k == 0 || changed[k] > changed[k - 1]), "the order of the list");
    listed[changed[k]] = true;
  }
  for (size_t i = 0; i < listed.size(); ++i) {
    const bool same = fuzz::same(&before.area[i], &after.area[i], 1) &&
                      fuzz::same(&before.volume[i], &after.volume[i], 1) &&
                      fuzz::same(&before.centre[3 * i], &after.centre[3 * i], 3) &&
                      fuzz::same(&before.radius[i], &after.radius[i], 1) && before.flags[i] == after.flags[i];
    FUZZ_REQUIRE(same || listed[i], "a ball that has changed and is not listed");
  }
}

// A refused call changes nothing.
void require_refusals(hsp_moving *moving, const Balls &balls, fuzz::Bytes &bytes) {
  const uint32_t n = balls.n();
  const Numbers before = numbers_of(moving, n);
  const uint32_t kind = bytes.below(6);
  uint32_t ids[2] = {bytes.below(n), n};
  double to[6] = {1, 2, 3, 4, 5, 6}, radii[2] = {0, 0};
  int32_t expected = HSP_E_ID;
  if (kind == 0) ids[1] = ids[0];
  if (kind >= 2) {
    ids[1] = ids[0] == 0 ? 1 : 0;
    if (ids[1] >= n) return;
  }
  if (kind == 2) to[4] = std::numeric_limits<double>::quiet_NaN(), expected = HSP_E_NOT_FINITE;
  if (kind == 3) radii[1] = -0.5, expected = HSP_E_NEGATIVE;
  if (kind == 4) to[3] = 0x1p52 * balls.options.step, expected = HSP_E_RANGE;
  if (kind == 5) radii[1] = 2 * balls.options.largest_radius, expected = HSP_E_RANGE;
  uint32_t first_bad = 7;
  FUZZ_REQUIRE(hsp_moving_move(moving, 2, ids, to, radii, nullptr, &first_bad) == expected, "a refused move");
  FUZZ_REQUIRE(first_bad == 1, "which move is to blame");
  require_same(before, numbers_of(moving, n));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz::Bytes bytes(data, size);
  const fuzz::ScaledBalls set = fuzz::topology_set(bytes);
  Balls balls = balls_from(set, bytes);
  const uint32_t n = balls.n();
  support::OwnedModel model(n);
  FUZZ_REQUIRE(model.set(balls.list, &balls.options) == HSP_OK, "a model");
  const auto take_all = [&](const hsp_model *from) {
    return [&balls, from](hsp_moving *handle, hsp_moving_limits *limits) {
      return hsp_moving_set(handle, from, balls.sigma.data(), tension, pressure, HSP_TANGENT_OVERLAP, limits, nullptr);
    };
  };
  hsp_moving_limits limits{};
  FUZZ_REQUIRE(hsp_moving_limits_init(&limits, sizeof limits, n) == HSP_OK, "limits");
  limits.neighbours = 1 + bytes.below(8);
  support::OwnedHandle<support::MovingKind> moving;
  moving.take(limits);
  moving.compute(take_all(model.get()));
  require_fresh(moving.get(), balls);
  const Numbers start = numbers_of(moving.get(), n);
  const hsp_moving_limits needed = moving.needed();

  for (int k = 0; k < 6 && n > 0; ++k) {
    const Moves moves = moves_from(balls, set, bytes);
    const Numbers before = numbers_of(moving.get(), n);
    limits.struct_size = sizeof limits;
    int32_t status = move(moving.get(), moves, &limits);
    if (status == HSP_E_CAPACITY) {
      // A larger handle takes the balls over.
      require_same(before, numbers_of(moving.get(), n));
      FUZZ_REQUIRE(hsp_moving_undo(moving.get()) == HSP_E_STATE, "undo after a failure");
      support::OwnedModel given(n);
      FUZZ_REQUIRE(hsp_moving_get_model(moving.get(), given.get()) == HSP_OK, "the model of a small handle");
      moving.take(limits);
      moving.compute(take_all(given.get()));
      require_same(before, numbers_of(moving.get(), n));
      status = move(moving.get(), moves, &limits);
    }
    FUZZ_REQUIRE(status == HSP_OK, "a move with the limits that were asked for");
    require_listed(moving.get(), before, numbers_of(moving.get(), n));
    if (bytes.one_in(3)) {
      FUZZ_REQUIRE(hsp_moving_undo(moving.get()) == HSP_OK, "undo");
      FUZZ_REQUIRE(hsp_moving_undo(moving.get()) == HSP_E_STATE, "undo twice");
      require_same(before, numbers_of(moving.get(), n));
    } else {
      apply(moves, balls);
    }
    require_fresh(moving.get(), balls);
    require_refusals(moving.get(), balls, bytes);
  }

  fuzz::require_limits<support::MovingKind>(needed, bytes, take_all(model.get()), [&](const hsp_moving *handle) {
    hsp_moving_info info{};
    const int32_t status = hsp_moving_get_info(handle, &info);
    if (status == HSP_OK) require_same(start, numbers_of(handle, n));
    return status;
  });
  return 0;
}
