#include "figure.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "growth.hpp"
#include "markdown.hpp"

namespace report {
namespace {

const double missing = std::nan("");

// Computes a figure while reading it. `benchmark` is the one that was named last.
class Expression {
 public:
  Expression(std::string_view text, const Scope &scope, std::string &benchmark)
      : rest_(text), whole_(text), scope_(scope), benchmark_(benchmark) {}

  double value() {
    const double result = sum();
    skip_blanks();
    if (!rest_.empty()) fail();
    return result;
  }

 private:
  [[noreturn]] void fail() const {
    throw std::runtime_error("'" + std::string(whole_) + "' is no figure from '" + std::string(rest_) + "' on");
  }

  void skip_blanks() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
  }

  bool accept(char c) {
    skip_blanks();
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  std::string_view take(size_t length) {
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(taken.size());
    return taken;
  }

  double sum() {
    double result = product();
    for (;;) {
      if (accept('+')) {
        result += product();
      } else if (accept('-')) {
        result -= product();
      } else {
        return result;
      }
    }
  }

  double product() {
    double result = factor();
    for (;;) {
      if (accept('*')) {
        result *= factor();
      } else if (accept('/')) {
        result /= factor();
      } else {
        return result;
      }
    }
  }

  double factor() {
    if (accept('-')) return -factor();
    if (accept('(')) {
      const double result = sum();
      if (!accept(')')) fail();
      return result;
    }
    if (accept('[')) {
      benchmark_ = bracketed();
      return factor();
    }
    skip_blanks();
    if (!rest_.empty() && std::isdigit(static_cast<unsigned char>(rest_.front())) != 0) {
      double number = 0;
      const char *const end = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number).ptr;
      rest_.remove_prefix(static_cast<size_t>(end - rest_.data()));
      return number;
    }
    const auto is_part = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    const std::string name(
        take(static_cast<size_t>(std::find_if_not(rest_.begin(), rest_.end(), is_part) - rest_.begin())));
    if (name.empty()) fail();
    return accept('(') ? call(name, arguments()) : counter(name, false);
  }

  // The text before a bracket that closes.
  std::string bracketed() {
    const size_t end = rest_.find(']');
    if (end == std::string_view::npos) fail();
    std::string text(take(end));
    rest_.remove_prefix(1);
    return text;
  }

  // The texts of the arguments, up to the closing parenthesis.
  std::vector<std::string> arguments() {
    std::vector<std::string> found{""};
    for (int depth = 0; !rest_.empty();) {
      const char c = take(1).front();
      if (c == ')' && depth == 0) return found;
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (c == ',' && depth == 0) {
        found.emplace_back();
      } else {
        found.back() += c;
      }
    }
    fail();
  }

  double counter(const std::string &name, bool least) const {
    const Measurement *m = scope_.run.find(benchmark_);
    if (m == nullptr) return missing;
    if (name == "time") return least ? m->least() : m->median();
    if (!m->counters.contains(name)) return missing;
    return least ? m->least(name) : m->counter(name);
  }

  double value_of(const std::string &text) { return Expression(text, scope_, benchmark_).value(); }

  // Pairs of n and an amount, of the benchmarks with a prefix; the argument is [PREFIX*].
  std::vector<std::pair<double, double>> amounts(const std::vector<std::string> &arguments) {
    std::vector<std::pair<double, double>> found;
    const std::string prefix = prefix_of(arguments.at(1));
    for (const std::string &molecule : molecules_by_size(scope_.run, prefix)) {
      std::string benchmark = prefix + molecule;
      const Measurement *m = scope_.run.find(benchmark);
      if (m == nullptr || m->counter("atoms") < value_of(arguments.at(0))) continue;
      const double value = Expression(arguments.at(2), scope_, benchmark).value();
      if (!std::isnan(value)) found.emplace_back(m->counter("atoms"), value);
    }
    return found;
  }

  std::string prefix_of(const std::string &argument) const {
    const size_t begin = argument.find('['), end = argument.find("*]");
    if (begin == std::string::npos || end == std::string::npos) fail();
    return argument.substr(begin + 1, end - begin - 1);
  }

  double call(const std::string &name, const std::vector<std::string> &arguments) {
    if (name == "least") return counter(without_blanks(arguments.at(0)), true);
    if (name == "count") {
      const size_t count = molecules_by_size(scope_.run, prefix_of(arguments.at(0))).size();
      return count > 0 ? static_cast<double>(count) : missing;
    }
    if (name == "exponent") {
      // A stage that is not measured for some balls has no prefix for these, and is no part of a maximum.
      if (without_blanks(arguments.at(1)) == "[]") return -INFINITY;
      return growth_exponent(amounts(arguments));
    }
    if (name == "largest") {
      double largest = missing;
      for (const auto &[n, value] : amounts(arguments)) {
        if (!(value <= largest)) largest = value;
      }
      return largest;
    }
    if (name == "over") {
      std::vector<double> values;
      const auto list = scope_.lists.find(arguments.at(0));
      if (list == scope_.lists.end()) fail();
      for (const Names &row : list->second.rows) values.push_back(value_of(with_names(joined(arguments), row)));
      return extreme(values, true);
    }
    if (name == "either") {
      const double first = value_of(arguments.at(0));
      return std::isnan(first) ? value_of(arguments.at(1)) : first;
    }
    std::vector<double> values;
    for (const std::string &argument : arguments) values.push_back(value_of(argument));
    if (name == "abs") return std::fabs(values.at(0));
    if (name == "positive") return values.at(0) > 0 ? values[0] : missing;
    if (name == "min" || name == "max") return extreme(values, name == "max");
    fail();
  }

  // All arguments but the first, joined again: they are one expression that has commas.
  static std::string joined(const std::vector<std::string> &arguments) {
    std::string text = arguments.at(1);
    for (size_t i = 2; i < arguments.size(); ++i) text += ',' + arguments[i];
    return text;
  }

  static double extreme(const std::vector<double> &values, bool largest) {
    for (const double value : values) {
      if (std::isnan(value)) return missing;
    }
    return largest ? *std::max_element(values.begin(), values.end()) : *std::min_element(values.begin(), values.end());
  }

  std::string_view rest_;
  std::string_view whole_;
  const Scope &scope_;
  std::string &benchmark_;
};

struct Parts {
  std::string expression;
  std::optional<double> unit;  // times this much
  std::string divisor;         // a counter, or empty
  std::string format;
};

Parts parts_of(std::string_view figure) {
  Parts parts;
  const size_t colon = figure.find(" : ");
  parts.expression = figure.substr(0, colon);
  if (colon == std::string_view::npos) return parts;
  constexpr std::pair<std::string_view, double> units[] = {{"ns", 1e9}, {"us", 1e6}, {"ms", 1e3}, {"%", 100}, {"", 1}};
  for (const std::string &word : split(figure.substr(colon + 3), " ")) {
    const std::string name = word.substr(0, word.find('/'));
    const auto *unit = std::find_if(std::begin(units), std::end(units), [&](const auto &u) { return u.first == name; });
    if (unit == std::end(units)) {
      parts.format = word;
    } else {
      parts.unit = unit->second;
      if (name.size() < word.size()) parts.divisor = word.substr(name.size() + 1);
    }
  }
  return parts;
}

double amount_of(const Parts &parts, const Scope &scope) {
  std::string benchmark = scope.benchmark;
  const double value = Expression(parts.expression, scope, benchmark).value();
  const double each = parts.divisor.empty() ? 1 : Expression(parts.divisor, scope, benchmark).value();
  return value / each * parts.unit.value_or(1);
}

}  // namespace

double amount(std::string_view figure, const Scope &scope) {
  return amount_of(parts_of(figure), scope);
}

double plain_amount(std::string_view figure, const Scope &scope) {
  return amount_of({parts_of(figure).expression, {}, "", ""}, scope);
}

std::string written(std::string_view figure, const Scope &scope) {
  const Parts parts = parts_of(figure);
  const double value = amount_of(parts, scope), shown = std::isfinite(value) ? value : 0;
  const std::string &format = parts.format;
  std::string text;
  if (format == "verdict") {
    return std::isnan(value) ? "not measured" : value >= 0 ? "goal" : "**missed**";
  } else if (format == "3") {
    text = three_digits(shown);
  } else if (format == "e") {
    text = scientific(shown);
  } else if (format == ",") {
    text = grouped(shown);
  } else if (format.size() == 2 && format[0] == '.' && std::isdigit(static_cast<unsigned char>(format[1])) != 0) {
    text = fixed(shown, format[1] - '0');
  } else {
    throw std::runtime_error("'" + std::string(figure) + "' has no format");
  }
  return !std::isfinite(value) ? "-" : parts.unit == 100 ? text + " %" : text;
}

}  // namespace report
