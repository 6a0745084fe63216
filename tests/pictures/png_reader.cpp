// Portable Network Graphics, as far as renderers write it: RFC 1950 and 1951 for the compressed bytes, then the five
// filters of rows.
#include <array>
#include <stdexcept>

#include "raster.hpp"

namespace {

class Inflater {
 public:
  explicit Inflater(const std::string &bytes) : bytes_(bytes), place_(2) {}  // after the two bytes of RFC 1950

  std::string inflate() {
    for (bool last = false; !last;) {
      last = bits(1) != 0;
      switch (bits(2)) {
        case 0:
          copy();
          break;
        case 1:
          read_fixed_codes();
          read_block();
          break;
        case 2:
          read_codes();
          read_block();
          break;
        default:
          throw std::runtime_error("PNG: block");
      }
    }
    return out_;
  }

 private:
  // A canonical prefix code: how many codes have each length, and the symbols in the order of their codes.
  struct Code {
    std::array<unsigned, 16> count{};
    std::vector<unsigned> symbol;
  };

  unsigned bit() {
    if (left_ == 0) {
      if (place_ >= bytes_.size()) throw std::runtime_error("PNG: cut off");
      byte_ = static_cast<unsigned char>(bytes_[place_++]);
      left_ = 8;
    }
    const unsigned value = byte_ & 1U;
    byte_ >>= 1U;
    --left_;
    return value;
  }
  unsigned bits(unsigned count) {
    unsigned value = 0;
    for (unsigned k = 0; k < count; ++k) value |= bit() << k;
    return value;
  }
  static Code code_of(const std::vector<unsigned> &lengths) {
    Code code;
    for (unsigned length = 1; length < 16; ++length) {
      for (unsigned symbol = 0; symbol < lengths.size(); ++symbol) {
        if (lengths[symbol] != length) continue;
        ++code.count[length];
        code.symbol.push_back(symbol);
      }
    }
    return code;
  }
  unsigned decode(const Code &code) {
    unsigned value = 0;
    unsigned first = 0;
    unsigned index = 0;
    for (unsigned length = 1; length < 16; ++length) {
      value |= bit();
      if (value < first + code.count[length]) return code.symbol.at(index + value - first);
      index += code.count[length];
      first = (first + code.count[length]) << 1U;
      value <<= 1U;
    }
    throw std::runtime_error("PNG: code");
  }
  void copy() {
    left_ = 0;
    if (place_ + 4 > bytes_.size()) throw std::runtime_error("PNG: cut off");
    const size_t count = static_cast<unsigned char>(bytes_[place_]) +
                         256U * static_cast<unsigned>(static_cast<unsigned char>(bytes_[place_ + 1]));
    out_ += bytes_.substr(place_ + 4, count);
    place_ += 4 + count;
  }
  void read_fixed_codes() {
    std::vector<unsigned> lengths(288, 8);
    for (unsigned k = 144; k < 256; ++k) lengths[k] = 9;
    for (unsigned k = 256; k < 280; ++k) lengths[k] = 7;
    literal_ = code_of(lengths);
    distance_ = code_of(std::vector<unsigned>(30, 5));
  }
  void read_codes() {
    static constexpr std::array<unsigned, 19> order = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                       11, 4,  12, 3, 13, 2, 14, 1, 15};
    const unsigned literals = bits(5) + 257;
    const unsigned distances = bits(5) + 1;
    const unsigned given = bits(4) + 4;
    std::vector<unsigned> lengths(19, 0);
    for (unsigned k = 0; k < given; ++k) lengths[order[k]] = bits(3);
    const Code code = code_of(lengths);
    lengths.clear();
    while (lengths.size() < literals + distances) {
      const unsigned symbol = decode(code);
      if (symbol < 16) {
        lengths.push_back(symbol);
      } else {
        const unsigned value = symbol == 16 ? lengths.at(lengths.size() - 1) : 0;
        const unsigned times = symbol == 16 ? 3 + bits(2) : symbol == 17 ? 3 + bits(3) : 11 + bits(7);
        lengths.insert(lengths.end(), times, value);
      }
    }
    const auto middle = lengths.begin() + literals;
    literal_ = code_of({lengths.begin(), middle});
    distance_ = code_of({middle, lengths.end()});
  }
  void read_block() {
    static constexpr std::array<unsigned, 29> base = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                                      31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
    static constexpr std::array<unsigned, 30> far = {1,    2,    3,    4,    5,    7,    9,    13,    17,    25,
                                                     33,   49,   65,   97,   129,  193,  257,  385,   513,   769,
                                                     1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
    for (;;) {
      const unsigned symbol = decode(literal_);
      if (symbol == 256) return;
      if (symbol < 256) {
        out_ += static_cast<char>(symbol);
        continue;
      }
      const unsigned k = symbol - 257;
      const unsigned length = base.at(k) + bits(k < 8 || k == 28 ? 0 : (k - 4) / 4);
      const unsigned d = decode(distance_);
      const size_t back = far.at(d) + bits(d < 4 ? 0 : (d - 2) / 2);
      if (back > out_.size()) throw std::runtime_error("PNG: distance");
      for (unsigned i = 0; i < length; ++i) out_ += out_[out_.size() - back];
    }
  }

  const std::string &bytes_;
  size_t place_;
  unsigned byte_ = 0;
  unsigned left_ = 0;
  Code literal_, distance_;
  std::string out_;
};

unsigned number_at(const std::string &bytes, size_t place) {
  unsigned value = 0;
  for (size_t k = 0; k < 4; ++k) value = value << 8U | static_cast<unsigned char>(bytes.at(place + k));
  return value;
}

int nearest_of(int a, int b, int c) {
  const int p = a + b - c;
  const int pa = std::abs(p - a);
  const int pb = std::abs(p - b);
  const int pc = std::abs(p - c);
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

}  // namespace

Raster read_png(const std::string &bytes) {
  Raster raster;
  std::string packed;
  size_t channels = 0;
  for (size_t place = 8; place + 12 <= bytes.size();) {
    const size_t length = number_at(bytes, place);
    const std::string kind = bytes.substr(place + 4, 4);
    if (kind == "IHDR") {
      raster.width = number_at(bytes, place + 8);
      raster.height = number_at(bytes, place + 12);
      const std::string form = bytes.substr(place + 16, 5);
      channels = form[1] == 2 ? 3 : 4;
      if (form[0] != 8 || (form[1] != 2 && form[1] != 6) || form[4] != 0) throw std::runtime_error("PNG: form");
    }
    if (kind == "IDAT") packed += bytes.substr(place + 8, length);
    place += length + 12;
  }
  std::string rows = Inflater(packed).inflate();
  const size_t row = raster.width * channels;
  if (rows.size() != raster.height * (row + 1)) throw std::runtime_error("PNG: size");
  const auto value = [&](size_t y, size_t x) { return static_cast<unsigned char>(rows[y * (row + 1) + 1 + x]); };
  for (size_t y = 0; y < raster.height; ++y) {
    for (size_t x = 0; x < row; ++x) {
      const int left = x >= channels ? value(y, x - channels) : 0;
      const int up = y > 0 ? value(y - 1, x) : 0;
      const int corner = x >= channels && y > 0 ? value(y - 1, x - channels) : 0;
      int guess = 0;
      switch (rows[y * (row + 1)]) {
        case 1:
          guess = left;
          break;
        case 2:
          guess = up;
          break;
        case 3:
          guess = (left + up) / 2;
          break;
        case 4:
          guess = nearest_of(left, up, corner);
          break;
        default:
          break;
      }
      rows[y * (row + 1) + 1 + x] = static_cast<char>(value(y, x) + guess);
    }
    for (size_t x = 0; x < raster.width; ++x) {
      const unsigned opacity = channels == 4 ? value(y, 4 * x + 3) : 255U;
      for (size_t k = 0; k < 3; ++k) {
        const unsigned colour = value(y, channels * x + k);
        raster.rgb.push_back(static_cast<uint8_t>((colour * opacity + 255 * (255 - opacity)) / 255));
      }
    }
  }
  return raster;
}
