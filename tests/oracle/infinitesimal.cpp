#include "infinitesimal.hpp"

#include <iterator>
#include <stdexcept>

namespace oracle {

Infinitesimal::Infinitesimal(Int128 value) {
  if (value != 0) terms_.emplace_back(0, BigInteger(value));
}

Infinitesimal Infinitesimal::epsilon(unsigned k) {
  if (k >= variables) throw std::out_of_range("no such infinitesimal");
  Infinitesimal result;
  result.terms_.emplace_back(Monomial{1} << (6 * k), BigInteger(1));
  return result;
}

// Adds b times a coefficient and a monomial to a.
void Infinitesimal::add_product(const Infinitesimal &b, const BigInteger &coefficient, Monomial monomial) {
  std::vector<Term> sum;
  sum.reserve(terms_.size() + b.terms_.size());
  auto own = terms_.begin();
  for (const auto &[of_b, coefficient_of_b] : b.terms_) {
    while (own != terms_.end() && own->first < monomial + of_b) sum.push_back(std::move(*own++));
    sum.emplace_back(monomial + of_b, coefficient * coefficient_of_b);
    if (own == terms_.end() || own->first != monomial + of_b) continue;
    sum.back().second = sum.back().second + own++->second;
    if (sum.back().second.sign() == 0) sum.pop_back();
  }
  sum.insert(sum.end(), std::make_move_iterator(own), std::make_move_iterator(terms_.end()));
  terms_ = std::move(sum);
}

Infinitesimal operator+(const Infinitesimal &a, const Infinitesimal &b) {
  Infinitesimal sum = a;
  sum.add_product(b, BigInteger(1), 0);
  return sum;
}

Infinitesimal operator-(const Infinitesimal &a, const Infinitesimal &b) {
  Infinitesimal difference = a;
  difference.add_product(b, BigInteger(-1), 0);
  return difference;
}

Infinitesimal operator*(const Infinitesimal &a, const Infinitesimal &b) {
  Infinitesimal product;
  for (const auto &[monomial, coefficient] : a.terms_) product.add_product(b, coefficient, monomial);
  return product;
}

}  // namespace oracle
