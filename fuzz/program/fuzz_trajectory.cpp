// The readers of trajectories: from any bytes they read frames of finite coordinates, and then an end or a refusal with
// the frame's number. A second reading gives the same, and frames that are skipped change nothing in those that are
// read. The first byte of the input, a digit in the corpus, chooses the format, the second, a letter from A, the number
// of atoms.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz_input.hpp"

extern "C" {
#include "read/trajectory.h"
}

namespace {

struct Reading {
  std::vector<std::vector<double>> frames;  // xyz, time and step; those that were stepped over are empty
  std::string reason;
  uint64_t line = 0;
};

// Every `every`th frame is read.
Reading read(const std::string &path, uint32_t atoms, uint64_t every) {
  trajectory run;
  failure why;
  std::memset(&why, 0, sizeof why);
  Reading reading;
  FUZZ_REQUIRE(trajectory_format_of(path.c_str(), file_format_named("xyz", FILE_ATOMS), &run, &why), "extension");
  line_status status = LINE_FAILED;
  if (trajectory_open(&run, path.c_str(), atoms, &why)) {
    do {
      const bool wanted = (run.frames + 1) % every == 0;
      status = trajectory_next(&run, wanted, &why);
      if (status != LINE_READ) break;
      reading.frames.emplace_back();
      if (!wanted) continue;
      std::vector<double> &frame = reading.frames.back();
      frame.assign(run.xyz, run.xyz + 3 * size_t{atoms});
      for (const double number : frame) FUZZ_REQUIRE(std::isfinite(number), "not finite");
      frame.push_back(run.stamp.timed ? run.stamp.time : -1.0);
      frame.push_back(run.stamp.stepped ? static_cast<double>(run.stamp.step) : -1.0);
    } while (reading.frames.size() < 1000);
  }
  trajectory_close(&run);
  FUZZ_REQUIRE((status == LINE_FAILED) == (why.exit_status == EXIT_BAD_INPUT), "a refusal and its exit status");
  FUZZ_REQUIRE((status == LINE_FAILED) == (why.reason[0] != '\0'), "a refusal and its reason");
  reading.reason = why.reason;
  reading.line = why.line;
  return reading;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size < 2) return 0;
  static constexpr const char *extensions[] = {".xtc", ".dcd", ".pdb", ".xyz", ".gro", ".trr", ".nc"};
  const char *given = std::getenv("TMPDIR");
  const std::string path = std::string(given != nullptr ? given : "/tmp") + "/hardsphere-fuzz-" +
                           std::to_string(getpid()) + extensions[static_cast<uint8_t>(data[0] - '0') % 7];
  const uint32_t atoms = 1 + static_cast<uint8_t>(data[1] - 'A') % 32U;
  std::FILE *file = std::fopen(path.c_str(), "wb");
  FUZZ_REQUIRE(file != nullptr, path.c_str());
  FUZZ_REQUIRE(std::fwrite(data + 2, 1, size - 2, file) == size - 2, "temporary file");
  FUZZ_REQUIRE(std::fclose(file) == 0, "temporary file");
  const Reading all = read(path, atoms, 1), again = read(path, atoms, 1), some = read(path, atoms, 2);
  std::remove(path.c_str());
  FUZZ_REQUIRE(all.frames == again.frames && all.reason == again.reason && all.line == again.line, "the second time");
  // A frame that is skipped may be damaged in a way that only reading it would show.
  FUZZ_REQUIRE(some.frames.size() >= all.frames.size(), "fewer frames where some are stepped over");
  for (size_t k = 1; k < all.frames.size(); k += 2) FUZZ_REQUIRE(some.frames[k] == all.frames[k], "stepped over");
  return 0;
}
