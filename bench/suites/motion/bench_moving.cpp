// Balls that move (hsp_moving): the time of a move of one, ten and a hundred atoms with areas, volume and derivatives,
// the time of taking a move back, and the time of computing everything anew.
#include <array>

#include "moving_workload.hpp"
#include "sizes.hpp"
#include "suite.hpp"

namespace bench {
namespace {

constexpr uint32_t moves = 200;
constexpr std::array<uint32_t, 3> atoms_a_move = {1, 10, 100};

enum class Then { move_back, undo };

// The time is that of all moves. Counters give the number of moves and the number of balls that each changes.
void measure_moves(benchmark::State &state, const Balls &balls, double probe, uint32_t atoms, Then then) {
  try {
    MovingAtoms moving(balls, probe, moves, atoms);
    const auto run = [&] { return then == Then::undo ? moving.move_and_undo_all() : moving.move_all(); };
    uint64_t changed = run();
    iterate(state, [&] { changed = run(); });
    const double made = then == Then::undo ? moves : 2 * moves;
    state.counters["atoms"] = balls.size();
    state.counters["moves"] = made;
    state.counters["changed_per_move"] = static_cast<double>(changed) / made;
  } catch (const std::exception &error) {
    state.SkipWithError(error.what());
  }
}

void measure_anew(benchmark::State &state, const Balls &balls, double probe) {
  try {
    MovingAtoms moving(balls, probe, 0, 1);
    iterate(state, [&] { benchmark::DoNotOptimize(moving.compute_anew()); });
    state.counters["atoms"] = balls.size();
  } catch (const std::exception &error) {
    state.SkipWithError(error.what());
  }
}

void add(const Balls &balls, const Surface &surface, const std::string &what,
         const std::function<void(benchmark::State &)> &run) {
  const std::string name = std::string("moving/") + surface.name + '/' + what + '/' + balls.name;
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_suite() {
  for (const Molecule &molecule : paper_molecules()) {
    if (molecule.name != "crambin" && molecule.name != "sod_stand_in") continue;
    const Balls balls = with_radii(molecule, Radii::van_der_waals);
    for (const Surface &surface : surfaces) {
      const double probe = surface.probe;
      for (const uint32_t atoms : atoms_a_move) {
        add(balls, surface, "move_" + std::to_string(atoms), [balls, probe, atoms](benchmark::State &state) {
          measure_moves(state, balls, probe, atoms, Then::move_back);
        });
      }
      add(balls, surface, "undo",
          [balls, probe](benchmark::State &state) { measure_moves(state, balls, probe, 1, Then::undo); });
      add(balls, surface, "anew", [balls, probe](benchmark::State &state) { measure_anew(state, balls, probe); });
    }
  }
}

}  // namespace bench
