// Moves of atoms as Monte-Carlo programs make them: one atom, or a few that lie together, by a fraction of an Angstrom.
#pragma once

#include <vector>

#include "handles.hpp"
#include "owned_motion.hpp"

namespace bench {

// hsp_moving of a molecule, with moves to make: each shifts some atoms that lie together by 0.3 Angstrom along each
// axis, one way or the other.
class MovingAtoms {
 public:
  MovingAtoms(const Balls &balls, double probe, uint32_t moves, uint32_t atoms_a_move);

  // Makes all moves, one after the other, each there and back again by another move. After each move the energy and all
  // numbers of the changed balls are read. Returns the number of changed balls.
  uint64_t move_all();
  // The same, but each is taken back.
  uint64_t move_and_undo_all();
  uint32_t size() const { return model_.size(); }

  // Computes the same numbers from the coordinates, as a program without updates does after each move.
  hsp_energy compute_anew();

 private:
  struct Move {
    std::vector<uint32_t> ball;
    std::vector<double> there, back;
  };
  void move(const Move &move, const std::vector<double> &to);
  uint64_t read();

  Model model_;
  Boundary boundary_;
  support::OwnedHandle<support::MovingKind> moving_;
  std::vector<Move> moves_;
  std::vector<uint32_t> changed_;
  std::vector<hsp_moving_ball> records_;
};

}  // namespace bench
