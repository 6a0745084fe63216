// Numbers of the ordered ring Z[eps_0, ..., eps_9] with 1 >> eps_0 >> eps_1 >> ... > 0, each infinitely small against
// every power of the one before.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "big_integer.hpp"

namespace oracle {

// A polynomial in the ten infinitesimals.
class Infinitesimal {
 public:
  static constexpr unsigned variables = 10;

  Infinitesimal() = default;
  explicit Infinitesimal(Int128 value);

  // eps_k
  static Infinitesimal epsilon(unsigned k);

  friend Infinitesimal operator+(const Infinitesimal &a, const Infinitesimal &b);
  friend Infinitesimal operator-(const Infinitesimal &a, const Infinitesimal &b);
  friend Infinitesimal operator*(const Infinitesimal &a, const Infinitesimal &b);

  // The sign of the largest monomial's coefficient; 0 for the zero polynomial only.
  [[nodiscard]] int sign() const { return terms_.empty() ? 0 : terms_.front().second.sign(); }

 private:
  // The exponent of eps_k in the bits from 6 k on. Of two monomials that one is larger which has the smaller exponent
  // in the smallest infinitesimal where they differ, so ascending keys are descending monomials; multiplication adds
  // keys. Exponents stay below 64: no predicate has a degree above 4.
  using Monomial = uint64_t;
  using Term = std::pair<Monomial, BigInteger>;
  void add_product(const Infinitesimal &b, const BigInteger &coefficient, Monomial monomial);

  std::vector<Term> terms_;  // monomials ascend, no zero coefficients
};

inline int sign_of(const Infinitesimal &value) {
  return value.sign();
}

}  // namespace oracle
