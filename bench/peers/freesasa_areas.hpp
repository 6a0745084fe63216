// Areas by FreeSASA (Debian's package freesasa): numerical, by slices or by points.
#pragma once

#include <string>
#include <vector>

#include "ball_list.hpp"

namespace bench {

enum class FreesasaMethod {
  lee_richards_20,    // 20 slices an atom, its default
  shrake_rupley_100,  // 100 points an atom, the default of that method
};

// The area of every ball, the probe added to every radius. One thread. Throws std::runtime_error if it fails.
std::vector<double> freesasa_areas(const support::BallList &balls, double probe, FreesasaMethod method);

// Its version.
std::string freesasa_release();

}  // namespace bench
