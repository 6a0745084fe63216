// Trajectories as simulation programs write them, after descriptions of the formats, with no code of the program.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace trajectories {

using Bytes = std::string;

// The number with its highest or its lowest byte first.
Bytes bytes_of(uint64_t value, int count, bool highest_first);
uint32_t bits_of(float value);

// Whole coordinates in units of 1/precision nanometres.
using Place = std::array<int64_t, 3>;

struct XtcOptions {
  int32_t step = 0;
  float time = 0;
  float precision = 1000;
  float box = 5;
  int first_index = 20;  // of the radices of small differences
  bool large = false;    // the magic number of very large files
};

// One frame. How atoms are grouped is drawn at random, as far as the format leaves that open.
Bytes xtc_frame(const std::vector<Place> &atoms, const XtcOptions &options, std::mt19937 &random);

struct DcdOptions {
  bool highest_first = false;
  bool charmm = true;  // else X-PLOR
  bool cell = false;
  std::array<double, 6> numbers = {50, 90, 60, 90, 90, 70};  // of the cell
  uint32_t version = 24;                                     // of CHARMM
  bool fourth = false;
  uint32_t frames = 0;
  uint32_t first_step = 1000;
  uint32_t interval = 100;
  float delta = 0.5F;
  std::vector<uint32_t> free_atoms;  // counted from 1; if any, the others are fixed
};

using Floats = std::vector<std::array<float, 3>>;

Bytes dcd_header(uint32_t atoms, const DcdOptions &options);
Bytes dcd_frame(const Floats &atoms, bool first, const DcdOptions &options);

struct TrrOptions {
  bool wide = false;  // doubles
  bool box = true, virial = false, coordinates = true, velocities = false, forces = false;
  int32_t step = 0;
  float time = 0;
};

// One frame, of nanometres.
Bytes trr_frame(const Floats &atoms, const TrrOptions &options);

struct NcOptions {
  char version = 1;
  bool wide = false;      // doubles
  bool streamed = false;  // the number of frames is not stated
  bool time = true, cell = false, velocities = false, labels = false;
  bool flags = false;  // a number of 16 bits for each frame, which is filled up
  double scale = 1;    // of the coordinates, which are divided by it; 1: it is not stated
  std::string unit = "angstrom";
};

// A whole file. Frame k, from 0 on, is at time k / 2, with a cell of 30 + k, 40 and 50 at 90, 90 and 60 degrees.
Bytes nc_file(const std::vector<Floats> &frames, const NcOptions &options);

}  // namespace trajectories
