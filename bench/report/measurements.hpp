// The results of a run: everything the benchmark programs wrote into a folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace report {

// All repetitions of one benchmark.
struct Measurement {
  std::vector<double> seconds;                          // CPU time of one iteration, one entry per repetition
  std::map<std::string, std::vector<double>> counters;  // one entry per repetition
  std::string error;                                    // why there are no times, or empty

  bool measured() const { return !seconds.empty(); }
  double median() const;                          // seconds; only if measured
  double least() const;                           // seconds; only if measured
  double counter(const std::string &name) const;  // median; 0 if there is none of that name
  double least(const std::string &name) const;    // likewise, the least
};

struct Run {
  std::map<std::string, Measurement> benchmarks;  // by name
  std::map<std::string, std::string> context;     // date, num_cpus, cpu_model, compiler, flags, ...
  std::vector<std::string> order;                 // names in the order in which they ran
  std::vector<double> loads;                      // the machine's load average when each program began

  // The measurement of this name, or nullptr if it is missing or failed.
  const Measurement *find(const std::string &name) const;
};

// The files of a folder with this ending, in the order of their names. Throws std::runtime_error if there is none.
std::vector<std::filesystem::path> files_of(const std::filesystem::path &folder, const std::string &ending);

// Read every .json file of the folder, in that order.
Run read_run(const std::filesystem::path &folder);

}  // namespace report
