#include "big_integer.hpp"

#include <algorithm>

namespace oracle {

BigInteger::BigInteger(Int128 value) : negative_(value < 0) {
  UInt128 rest = negative_ ? UInt128{0} - static_cast<UInt128>(value) : static_cast<UInt128>(value);
  for (; rest != 0; rest >>= 32) limbs_.push_back(static_cast<char32_t>(rest));
}

int BigInteger::compare_magnitudes(const Limbs &a, const Limbs &b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (size_t k = a.size(); k-- > 0;)
    if (a[k] != b[k]) return a[k] < b[k] ? -1 : 1;
  return 0;
}

BigInteger::Limbs BigInteger::add_magnitudes(const Limbs &a, const Limbs &b) {
  Limbs sum;
  sum.reserve(std::max(a.size(), b.size()) + 1);
  uint64_t carry = 0;
  for (size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
    carry += (k < a.size() ? a[k] : 0U);
    carry += (k < b.size() ? b[k] : 0U);
    sum.push_back(static_cast<char32_t>(carry));
    carry >>= 32;
  }
  sum.push_back(static_cast<char32_t>(carry));
  drop_leading_zeros(sum);
  return sum;
}

BigInteger::Limbs BigInteger::subtract_magnitudes(const Limbs &larger, const Limbs &smaller) {
  Limbs difference;
  difference.reserve(larger.size());
  uint64_t borrow = 0;
  for (size_t k = 0; k < larger.size(); ++k) {
    const uint64_t take = borrow + (k < smaller.size() ? smaller[k] : 0U);
    borrow = larger[k] < take ? 1 : 0;
    difference.push_back(static_cast<char32_t>((borrow << 32) + larger[k] - take));
  }
  drop_leading_zeros(difference);
  return difference;
}

void BigInteger::drop_leading_zeros(Limbs &limbs) {
  while (!limbs.empty() && limbs.back() == 0) limbs.pop_back();
}

BigInteger BigInteger::operator-() const {
  BigInteger result = *this;
  result.negative_ = !limbs_.empty() && !negative_;
  return result;
}

BigInteger operator+(const BigInteger &a, const BigInteger &b) {
  BigInteger sum;
  if (a.negative_ == b.negative_) {
    sum.limbs_ = BigInteger::add_magnitudes(a.limbs_, b.limbs_);
    sum.negative_ = a.negative_;
  } else {
    const bool a_is_larger = BigInteger::compare_magnitudes(a.limbs_, b.limbs_) >= 0;
    const BigInteger &larger = a_is_larger ? a : b;
    const BigInteger &smaller = a_is_larger ? b : a;
    sum.limbs_ = BigInteger::subtract_magnitudes(larger.limbs_, smaller.limbs_);
    sum.negative_ = larger.negative_;
  }
  if (sum.limbs_.empty()) sum.negative_ = false;
  return sum;
}

BigInteger operator*(const BigInteger &a, const BigInteger &b) {
  BigInteger product;
  if (a.limbs_.empty() || b.limbs_.empty()) return product;
  product.limbs_.assign(a.limbs_.size() + b.limbs_.size(), 0);
  for (size_t i = 0; i < a.limbs_.size(); ++i) {
    if (a.limbs_[i] == 0) continue;
    uint64_t carry = 0;
    for (size_t k = 0; k < b.limbs_.size(); ++k) {
      carry += uint64_t{a.limbs_[i]} * b.limbs_[k] + product.limbs_[i + k];
      product.limbs_[i + k] = static_cast<char32_t>(carry);
      carry >>= 32;
    }
    product.limbs_[i + b.limbs_.size()] = static_cast<char32_t>(carry);
  }
  BigInteger::drop_leading_zeros(product.limbs_);
  product.negative_ = a.negative_ != b.negative_;
  return product;
}

BigInteger BigInteger::times_power_of_two(unsigned bits) const {
  BigInteger result;
  if (limbs_.empty()) return result;
  result.negative_ = negative_;
  result.limbs_.assign(bits / 32, 0);
  uint64_t carry = 0;
  for (const uint32_t limb : limbs_) {
    carry += uint64_t{limb} << (bits % 32);
    result.limbs_.push_back(static_cast<char32_t>(carry));
    carry >>= 32;
  }
  result.limbs_.push_back(static_cast<char32_t>(carry));
  drop_leading_zeros(result.limbs_);
  return result;
}

std::string BigInteger::to_string() const {
  if (limbs_.empty()) return "0";
  std::string digits;
  for (Limbs rest = limbs_; !rest.empty(); drop_leading_zeros(rest)) {
    uint64_t remainder = 0;
    for (size_t k = rest.size(); k-- > 0;) {
      remainder = (remainder << 32) + rest[k];
      rest[k] = static_cast<char32_t>(remainder / 10);
      remainder %= 10;
    }
    digits.push_back(static_cast<char>('0' + remainder));
  }
  if (negative_) digits.push_back('-');
  std::reverse(digits.begin(), digits.end());
  return digits;
}

}  // namespace oracle
