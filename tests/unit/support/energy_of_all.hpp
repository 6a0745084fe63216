// The energy of all balls by one thread, ball by ball.
#pragma once

#include "measure/energy.hpp"

namespace support {

// Calls sink(i, gradient) for every ball i of the input, and returns the energy.
template <class Sink>
hsp::Energy differentiate_energy(const hsp::CubeGrid &grid, const hsp::Boundary &boundary,
                                 const hsp::EnergyTerms &terms, Sink sink) {
  struct {
    Sink &sink;
    void operator()(uint32_t i, const hsp::EnergyGradient &gradient) { sink(i, gradient); }
    void operator()(hsp::IdRange run, const hsp::EnergyGradient &gradient) {
      for (const uint32_t i : run) sink(i, gradient);
    }
  } each{sink};
  hsp::Energy energy;
  hsp::differentiate_energy(hsp::Executor(), grid, boundary, terms, energy, each);
  return energy;
}

}  // namespace support
