#include "growth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace report {

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

double growth_exponent(const std::vector<std::pair<double, double>> &amounts) {
  if (amounts.size() < 3) return std::nan("");
  const double count = static_cast<double>(amounts.size());
  double mean_x = 0;
  double mean_y = 0;
  for (const auto &[n, amount] : amounts) {
    mean_x += std::log(n) / count;
    mean_y += std::log(amount) / count;
  }
  double products = 0;
  double squares = 0;
  for (const auto &[n, amount] : amounts) {
    products += (std::log(n) - mean_x) * (std::log(amount) - mean_y);
    squares += (std::log(n) - mean_x) * (std::log(n) - mean_x);
  }
  return products / squares;
}

}  // namespace report
