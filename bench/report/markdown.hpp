// Markdown tables and numbers that a person can read.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace report {

class Table {
 public:
  explicit Table(std::vector<std::string> heads);

  // One cell per head.
  void row(std::vector<std::string> cells);

  // Columns padded to one width, the first to the left, the others to the right.
  void write(std::ostream &out) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

// Three significant digits, no exponent: 0.00123, 12.3, 1230.
std::string three_digits(double value);

// Three significant digits and a power of ten: 1.32e-4.
std::string scientific(double value);

// A fixed number of decimals.
std::string fixed(double value, int decimals);

// A whole number with the thousands set apart by commas.
std::string grouped(double value);

}  // namespace report
