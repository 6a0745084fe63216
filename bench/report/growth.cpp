#include "growth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace report {
namespace {

std::vector<const Measurement *> measured_from(const Run &run, const std::string &prefix, double from) {
  std::vector<const Measurement *> found;
  for (const std::string &molecule : molecules_by_size(run, prefix)) {
    const Measurement *m = run.find(prefix + molecule);
    if (m != nullptr && m->counter("atoms") >= from) found.push_back(m);
  }
  return found;
}

}  // namespace

std::vector<std::string> molecules_by_size(const Run &run, const std::string &prefix) {
  std::vector<std::string> names;
  for (const std::string &name : run.order) {
    if (name.starts_with(prefix)) names.push_back(name.substr(prefix.size()));
  }
  const auto size = [&](const std::string &name) {
    const Measurement *m = run.find(prefix + name);
    return m != nullptr ? m->counter("atoms") : std::numeric_limits<double>::infinity();
  };
  std::stable_sort(names.begin(), names.end(),
                   [&](const std::string &a, const std::string &b) { return size(a) < size(b); });
  return names;
}

double growth_exponent(const Run &run, const std::string &prefix, double from, const Amount &amount) {
  std::vector<double> x;
  std::vector<double> y;
  for (const Measurement *m : measured_from(run, prefix, from)) {
    x.push_back(std::log(m->counter("atoms")));
    y.push_back(std::log(amount(*m)));
  }
  if (x.size() < 3) return std::nan("");
  double mean_x = 0;
  double mean_y = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / static_cast<double>(x.size());
    mean_y += y[i] / static_cast<double>(x.size());
  }
  double products = 0;
  double squares = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    products += (x[i] - mean_x) * (y[i] - mean_y);
    squares += (x[i] - mean_x) * (x[i] - mean_x);
  }
  return products / squares;
}

double largest_amount(const Run &run, const std::string &prefix, double from, const Amount &amount) {
  double largest = std::nan("");
  for (const Measurement *m : measured_from(run, prefix, from)) {
    const double value = amount(*m);
    if (!(value <= largest)) largest = value;
  }
  return largest;
}

Amount counter_of(const std::string &name) {
  return [name](const Measurement &m) { return m.counter(name); };
}

}  // namespace report
