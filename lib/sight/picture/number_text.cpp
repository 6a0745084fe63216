#include "picture/number_text.hpp"

#include "exact/lattice.hpp"

namespace hsp {

int64_t scaled(double value, int decimals) {
  return nearest(value * power_of_ten[decimals]);
}

void put_scaled(ByteSink &sink, int64_t n, int decimals) {
  if (n == 0) {
    sink.put('0');
    return;
  }
  if (n < 0) sink.put('-');
  uint64_t rest = n < 0 ? 0 - static_cast<uint64_t>(n) : static_cast<uint64_t>(n);
  for (; decimals > 0 && rest % 10 == 0; --decimals) rest /= 10;
  const auto unit = static_cast<uint64_t>(power_of_ten[decimals]);
  const uint64_t whole = rest / unit;
  if (whole > 0 || decimals == 0) put_integer(sink, whole);
  if (decimals == 0) return;
  sink.put('.');
  put_integer(sink, rest % unit, decimals);
}

void put_integer(ByteSink &sink, uint64_t n, int digits) {
  char text[20];
  int count = 0;
  for (; n > 0 || count < digits; n /= 10) text[count++] = static_cast<char>('0' + n % 10);
  while (count > 0) sink.put(text[--count]);
}

void put_colour(ByteSink &sink, uint32_t colour) {
  for (int shift = 20; shift >= 0; shift -= 4) sink.put("0123456789abcdef"[colour >> shift & 15]);
}

}  // namespace hsp
