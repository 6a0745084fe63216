#include "infinitesimal.hpp"

#include <stdexcept>

namespace oracle {

Infinitesimal::Infinitesimal(Int128 value) {
  if (value != 0) terms_.emplace(0, BigInteger(value));
}

Infinitesimal Infinitesimal::epsilon(unsigned k) {
  if (k >= variables) throw std::out_of_range("no such infinitesimal");
  Infinitesimal result;
  result.terms_.emplace(Monomial{1} << (6 * k), BigInteger(1));
  return result;
}

void Infinitesimal::add_term(Monomial monomial, const BigInteger &coefficient) {
  const auto [term, is_new] = terms_.try_emplace(monomial, coefficient);
  if (!is_new) term->second = term->second + coefficient;
  if (term->second.sign() == 0) terms_.erase(term);
}

Infinitesimal operator+(const Infinitesimal &a, const Infinitesimal &b) {
  Infinitesimal sum = a;
  for (const auto &[monomial, coefficient] : b.terms_) sum.add_term(monomial, coefficient);
  return sum;
}

Infinitesimal operator-(const Infinitesimal &a, const Infinitesimal &b) {
  Infinitesimal difference = a;
  for (const auto &[monomial, coefficient] : b.terms_) difference.add_term(monomial, -coefficient);
  return difference;
}

Infinitesimal operator*(const Infinitesimal &a, const Infinitesimal &b) {
  Infinitesimal product;
  for (const auto &[monomial_a, coefficient_a] : a.terms_)
    for (const auto &[monomial_b, coefficient_b] : b.terms_)
      product.add_term(monomial_a + monomial_b, coefficient_a * coefficient_b);
  return product;
}

}  // namespace oracle
