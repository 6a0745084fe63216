#include "measurements.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "json_value.hpp"

namespace report {
namespace {

double seconds_per(const std::string &unit) {
  if (unit == "ns") return 1e-9;
  if (unit == "us") return 1e-6;
  if (unit == "ms") return 1e-3;
  if (unit == "s") return 1;
  throw std::runtime_error("unknown time unit: " + unit);
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

void add(Run &run, const JsonValue &entry) {
  if (entry["run_type"].text != "iteration") return;
  // A suite that fixes the number of iterations has it added to its names.
  const std::string name = entry["run_name"].text.substr(0, entry["run_name"].text.find("/iterations:"));
  if (!run.benchmarks.contains(name)) run.order.push_back(name);
  Measurement &measurement = run.benchmarks[name];
  if (entry["error_occurred"].boolean) {
    measurement.error = entry["error_message"].text;
    return;
  }
  measurement.seconds.push_back(entry["cpu_time"].number * seconds_per(entry["time_unit"].text));
  for (const auto &[key, value] : entry.object) {
    if (value.kind == JsonValue::Kind::number) measurement.counters[key].push_back(value.number);
  }
}

void add_context(Run &run, const JsonValue &context) {
  for (const auto &[key, value] : context.object) {
    if (value.kind == JsonValue::Kind::text) run.context[key] = value.text;
    if (value.kind == JsonValue::Kind::number) run.context[key] = std::to_string(static_cast<long>(value.number));
  }
  const JsonValue &load = context["load_avg"];
  if (!load.array.empty()) run.loads.push_back(load.array.front().number);
}

}  // namespace

double Measurement::median() const {
  return median_of(seconds);
}

double Measurement::least() const {
  return *std::min_element(seconds.begin(), seconds.end());
}

double Measurement::counter(const std::string &name) const {
  const auto found = counters.find(name);
  return found == counters.end() ? 0 : median_of(found->second);
}

double Measurement::least(const std::string &name) const {
  const auto found = counters.find(name);
  return found == counters.end() ? 0 : *std::min_element(found->second.begin(), found->second.end());
}

const Measurement *Run::find(const std::string &name) const {
  const auto found = benchmarks.find(name);
  return found == benchmarks.end() || !found->second.measured() ? nullptr : &found->second;
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path &folder, const std::string &ending) {
  std::vector<std::filesystem::path> files;
  for (const auto &entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ending) files.push_back(entry.path());
  }
  if (files.empty()) throw std::runtime_error(folder.string() + ": no " + ending + " files");
  std::sort(files.begin(), files.end());
  return files;
}

Run read_run(const std::filesystem::path &folder) {
  Run run;
  for (const auto &file : files_of(folder, ".json")) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    try {
      const JsonValue document = parse_json(text);
      add_context(run, document["context"]);
      for (const JsonValue &entry : document["benchmarks"].array) add(run, entry);
    } catch (const std::exception &error) {
      throw std::runtime_error(file.string() + ": " + error.what());
    }
  }
  return run;
}

}  // namespace report
