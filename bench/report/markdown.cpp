#include "markdown.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <utility>

namespace report {
namespace {

// Characters, not bytes: UTF-8 continuation bytes take no room.
size_t width(const std::string &text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

Table::Table(std::vector<std::string> heads) {
  rows_.push_back(std::move(heads));
}

void Table::row(std::vector<std::string> cells) {
  rows_.push_back(std::move(cells));
}

void Table::write(std::ostream &out) const {
  std::vector<size_t> widths(rows_.front().size(), 4);
  for (const auto &row : rows_) {
    for (size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  for (size_t r = 0; r < rows_.size(); ++r) {
    out << '|';
    for (size_t i = 0; i < widths.size(); ++i) {
      const std::string padding(widths[i] - width(rows_[r][i]), ' ');
      out << ' ' << (i == 0 ? rows_[r][i] + padding : padding + rows_[r][i]) << " |";
    }
    out << '\n';
    if (r != 0) continue;
    out << '|';
    for (size_t i = 0; i < widths.size(); ++i) {
      out << (i == 0 ? " :" + std::string(widths[i] - 1, '-') : ' ' + std::string(widths[i] - 1, '-') + ':') << " |";
    }
    out << '\n';
  }
  out << '\n';
}

std::string three_digits(double value) {
  if (!(value > 0)) return fixed(value, 0);
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(value)));
  if (decimals < 0) {
    const double unit = std::pow(10.0, -decimals);
    return grouped(std::round(value / unit) * unit);
  }
  return fixed(value, decimals);
}

std::string scientific(double value) {
  if (!(value > 0)) return fixed(value, 0);
  int exponent = static_cast<int>(std::floor(std::log10(value)));
  double mantissa = value / std::pow(10.0, exponent);
  if (mantissa >= 9.995) {
    mantissa /= 10;
    ++exponent;
  }
  return fixed(mantissa, 2) + 'e' + std::to_string(exponent);
}

std::string fixed(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string grouped(double value) {
  std::string text = fixed(value, 0);
  for (size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, 1, ',');
  return text;
}

}  // namespace report
