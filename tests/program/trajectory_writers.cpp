#include "trajectory_writers.hpp"

#include <algorithm>
#include <cstring>

namespace trajectories {
namespace {

// By index, from the description of the format.
constexpr uint32_t radices[] = {
    0,       0,       0,       0,       0,        0,        0,       0,       0,       8,       10,
    12,      16,      20,      25,      32,       40,       50,      64,      80,      101,     128,
    161,     203,     256,     322,     406,      512,      645,     812,     1024,    1290,    1625,
    2048,    2580,    3250,    4096,    5060,     6501,     8192,    10321,   13003,   16384,   20642,
    26007,   32768,   41285,   52015,   65536,    82570,    104031,  131072,  165140,  208063,  262144,
    330280,  416127,  524287,  660561,  832255,   1048576,  1321122, 1664510, 2097152, 2642245, 3329021,
    4194304, 5284491, 6658042, 8388607, 10568983, 13316085, 16777216};
constexpr int last_index = 72;

class BitWriter {
 public:
  void put(uint64_t value, int count) {
    for (int bit = count - 1; bit >= 0; --bit) put_bit((value >> bit & 1) != 0);
  }
  // ((x * size[1]) + y) * size[2] + z, as so many bits, lowest byte first.
  void put_packed(const std::array<uint64_t, 3> &digit, const std::array<uint64_t, 3> &size, int bits) {
    std::vector<uint64_t> number(12, 0);
    for (size_t axis = 0; axis < 3; ++axis) {
      uint64_t carry = digit[axis];
      for (uint64_t &byte : number) {
        const uint64_t sum = byte * size[axis] + carry;
        byte = sum & 255;
        carry = sum >> 8;
      }
    }
    for (size_t i = 0; bits > 0; ++i, bits -= 8) put(number[i], std::min(bits, 8));
  }
  [[nodiscard]] const Bytes &bytes() const { return bytes_; }

 private:
  void put_bit(bool bit) {
    if (used_ % 8 == 0) bytes_ += '\0';
    if (bit) bytes_.back() = static_cast<char>(static_cast<unsigned char>(bytes_.back()) | (128U >> (used_ % 8)));
    ++used_;
  }
  Bytes bytes_;
  size_t used_ = 0;
};

// Bits of a number, and of the product of three.
int length_of(uint64_t value) {
  int bits = 0;
  for (; value > 0; value /= 2) ++bits;
  return bits;
}
int length_of(const std::array<uint64_t, 3> &size) {
  std::vector<uint64_t> number(12, 0);
  number[0] = 1;
  for (const uint64_t factor : size) {
    uint64_t carry = 0;
    for (uint64_t &byte : number) {
      const uint64_t product = byte * factor + carry;
      byte = product & 255;
      carry = product >> 8;
    }
  }
  int bits = 0;
  for (size_t i = 0; i < number.size(); ++i) {
    if (number[i] > 0) bits = static_cast<int>(8 * i) + length_of(number[i]);
  }
  return bits;
}

// Whether b less a is written as a small difference.
bool is_small(const Place &a, const Place &b, int index) {
  const int64_t radix = radices[index], half = radix / 2;
  for (size_t axis = 0; axis < 3; ++axis) {
    const int64_t difference = b[axis] - a[axis] + half;
    if (difference < 0 || difference >= radix) return false;
  }
  return true;
}

void put_small(BitWriter &bits, const Place &a, const Place &b, int index) {
  const uint64_t radix = radices[index];
  std::array<uint64_t, 3> digit{};
  for (size_t axis = 0; axis < 3; ++axis) {
    digit[axis] = static_cast<uint64_t>(b[axis] - a[axis] + static_cast<int64_t>(radix / 2));
  }
  bits.put_packed(digit, {radix, radix, radix}, index);
}

// The order in which the small ones of a group are written: the first atom, then the third and so on.
size_t small_atom(size_t first, size_t k) {
  return k == 0 ? first : first + k + 1;
}

// How many of the atoms from `first` on, besides one, are near enough to be small differences.
size_t longest_run(const std::vector<Place> &atoms, size_t first, size_t most, int index) {
  size_t run = 0;
  while (run < most && first + run + 1 < atoms.size()) {
    const Place &before = run == 0 ? atoms[first + 1] : atoms[small_atom(first, run - 1)];
    if (!is_small(before, atoms[small_atom(first, run)], index)) break;
    ++run;
  }
  return run;
}

Bytes packed(const std::vector<Place> &atoms, const Place &least, const std::array<uint64_t, 3> &size, int index,
             std::mt19937 &random) {
  BitWriter bits;
  const bool apart = *std::max_element(size.begin(), size.end()) > 0xFFFFFF;
  size_t run_before = 0;
  for (size_t atom = 0; atom < atoms.size();) {
    const size_t run = longest_run(atoms, atom, random() % 11, index);
    const Place &whole = atoms[run == 0 ? atom : atom + 1];
    std::array<uint64_t, 3> digit{};
    for (size_t axis = 0; axis < 3; ++axis) digit[axis] = static_cast<uint64_t>(whole[axis] - least[axis]);
    for (size_t axis = 0; apart && axis < 3; ++axis) bits.put(digit[axis], length_of(size[axis]));
    if (!apart) bits.put_packed(digit, size, length_of(size));
    int change = static_cast<int>(random() % 3) - 1;
    if (run == 10) change = std::min(change, 0); /* the code has five bits */
    if (index + change < 9 || index + change > last_index) change = 0;
    if (run == run_before && change == 0 && random() % 2 == 0) {
      bits.put(0, 1);
    } else {
      bits.put(1, 1);
      bits.put(3 * run + static_cast<uint64_t>(change + 1), 5);
    }
    for (size_t k = 0; k < run; ++k) {
      put_small(bits, k == 0 ? whole : atoms[small_atom(atom, k - 1)], atoms[small_atom(atom, k)], index);
    }
    atom += run + 1;
    run_before = run;
    index += change;
  }
  return bits.bytes();
}

}  // namespace

Bytes bytes_of(uint64_t value, int count, bool highest_first) {
  Bytes bytes;
  for (int i = 0; i < count; ++i) {
    bytes += static_cast<char>(static_cast<unsigned char>(value >> (8 * (highest_first ? count - 1 - i : i)) & 255));
  }
  return bytes;
}

uint32_t bits_of(float value) {
  uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

Bytes xtc_frame(const std::vector<Place> &atoms, const XtcOptions &options, std::mt19937 &random) {
  const auto number = [](int64_t value) { return bytes_of(static_cast<uint32_t>(value), 4, true); };
  const auto real = [](float value) { return bytes_of(bits_of(value), 4, true); };
  Bytes frame = number(options.large ? 2023 : 1995) + number(static_cast<int64_t>(atoms.size())) +
                number(options.step) + real(options.time);
  for (int k = 0; k < 9; ++k) frame += real(k % 4 == 0 ? options.box : 0.0F);
  frame += number(static_cast<int64_t>(atoms.size()));
  if (atoms.size() <= 9) {
    for (const Place &atom : atoms) {
      for (const int64_t coordinate : atom) frame += real(static_cast<float>(coordinate) / options.precision);
    }
    return frame;
  }
  Place least = atoms[0], greatest = atoms[0];
  for (const Place &atom : atoms) {
    for (size_t axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], atom[axis]);
      greatest[axis] = std::max(greatest[axis], atom[axis]);
    }
  }
  std::array<uint64_t, 3> size{};
  for (size_t axis = 0; axis < 3; ++axis) size[axis] = static_cast<uint64_t>(greatest[axis] - least[axis]) + 1;
  frame += real(options.precision);
  for (const Place &corner : {least, greatest}) {
    for (const int64_t coordinate : corner) frame += number(coordinate);
  }
  Bytes bytes = packed(atoms, least, size, options.first_index, random);
  frame += number(options.first_index) + bytes_of(bytes.size(), options.large ? 8 : 4, true);
  while (bytes.size() % 4 != 0) bytes += '\0';
  return frame + bytes;
}

namespace {

Bytes record(const Bytes &bytes, const DcdOptions &options) {
  const Bytes length = bytes_of(bytes.size(), 4, options.highest_first);
  return length + bytes + length;
}

}  // namespace

Bytes dcd_header(uint32_t atoms, const DcdOptions &options) {
  const auto number = [&options](uint64_t value) { return bytes_of(value, 4, options.highest_first); };
  std::array<uint32_t, 20> control{};
  control[0] = options.frames;
  control[1] = options.first_step;
  control[2] = options.interval;
  if (!options.free_atoms.empty()) control[8] = atoms - static_cast<uint32_t>(options.free_atoms.size());
  control[9] = bits_of(options.delta);
  control[10] = options.cell ? 1 : 0;
  control[11] = options.fourth ? 1 : 0;
  control[19] = options.charmm ? options.version : 0;
  Bytes first = "CORD";
  for (const uint32_t value : control) first += number(value);
  if (!options.charmm) {
    const double delta = static_cast<double>(options.delta);
    uint64_t bits = 0;
    std::memcpy(&bits, &delta, sizeof bits);
    first.replace(4 + 4 * 9, 8, bytes_of(bits, 8, options.highest_first));
  }
  Bytes header = record(first, options);
  header += record(number(2) + Bytes(160, ' '), options) + record(number(atoms), options);
  Bytes list;
  for (const uint32_t atom : options.free_atoms) list += number(atom);
  return list.empty() ? header : header + record(list, options);
}

Bytes dcd_frame(const Floats &atoms, bool first, const DcdOptions &options) {
  Bytes frame;
  if (options.cell) {
    Bytes cell;
    for (const double value : options.numbers) {
      uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      cell += bytes_of(bits, 8, options.highest_first);
    }
    frame += record(cell, options);
  }
  for (size_t axis = 0; axis < (options.fourth ? 4 : 3); ++axis) {
    Bytes row;
    const auto add = [&](size_t atom) {
      row += bytes_of(axis == 3 ? 0 : bits_of(atoms[atom][axis]), 4, options.highest_first);
    };
    if (first || options.free_atoms.empty()) {
      for (size_t atom = 0; atom < atoms.size(); ++atom) add(atom);
    } else {
      for (const uint32_t atom : options.free_atoms) add(atom - 1);
    }
    frame += record(row, options);
  }
  return frame;
}

Bytes trr_frame(const Floats &atoms, const TrrOptions &options) {
  const uint64_t width = options.wide ? 8 : 4, all = 3 * atoms.size() * width;
  const auto number = [&](double value) {
    uint64_t bits = 0;
    if (options.wide) {
      std::memcpy(&bits, &value, 8);
      return bytes_of(bits, 8, true);
    }
    return bytes_of(bits_of(static_cast<float>(value)), 4, true);
  };
  const auto block = [&](bool there, uint64_t bytes) { return bytes_of(there ? bytes : 0, 4, true); };
  const Bytes nothing = bytes_of(0, 4, true);
  Bytes frame = bytes_of(1993, 4, true) + bytes_of(13, 4, true) + bytes_of(12, 4, true) + "GMX_trn_file";
  frame += nothing + nothing + block(options.box, 9 * width) + block(options.virial, 9 * width) + nothing + nothing +
           nothing + block(options.coordinates, all) + block(options.velocities, all) + block(options.forces, all);
  frame += bytes_of(atoms.size(), 4, true) + bytes_of(static_cast<uint32_t>(options.step), 4, true) + nothing;
  frame += number(static_cast<double>(options.time)) + number(0.5);
  for (int k = 0; options.box && k < 9; ++k) frame += number(k % 4 == 0 ? 3 + k : 0);
  for (int k = 0; options.virial && k < 9; ++k) frame += number(-k);
  for (const bool there : {options.coordinates, options.velocities, options.forces}) {
    if (!there) continue;
    for (const auto &atom : atoms) {
      for (const float coordinate : atom) frame += number(static_cast<double>(coordinate));
    }
  }
  return frame;
}

namespace {

// Of the NetCDF classic formats: names, counts and offsets by the version.
class NcWriter {
 public:
  explicit NcWriter(const NcOptions &options) : options_(options) {}
  [[nodiscard]] Bytes count(uint64_t value) const { return bytes_of(value, options_.version == 5 ? 8 : 4, true); }
  [[nodiscard]] Bytes text(const std::string &value) const { return count(value.size()) + filled(value); }
  [[nodiscard]] Bytes list(uint32_t tag, const std::vector<Bytes> &items) const {
    Bytes all = bytes_of(items.empty() ? 0 : tag, 4, true) + count(items.size());
    for (const Bytes &item : items) all += item;
    return all;
  }
  [[nodiscard]] Bytes label(const std::string &name, const std::string &value) const {
    return text(name) + bytes_of(2, 4, true) + text(value);
  }
  [[nodiscard]] Bytes number(double value, bool wide) const {
    uint64_t bits = 0;
    std::memcpy(&bits, &value, 8);
    return wide ? bytes_of(bits, 8, true) : bytes_of(bits_of(static_cast<float>(value)), 4, true);
  }
  [[nodiscard]] Bytes variable(const std::string &name, const std::vector<uint64_t> &dimensions,
                               const std::vector<Bytes> &attributes, uint32_t kind, uint64_t size,
                               uint64_t begin) const {
    Bytes all = text(name) + count(dimensions.size());
    for (const uint64_t dimension : dimensions) all += count(dimension);
    return all + list(12, attributes) + bytes_of(kind, 4, true) + count(size) +
           bytes_of(begin, options_.version == 1 ? 4 : 8, true);
  }

 private:
  static Bytes filled(Bytes bytes) {
    while (bytes.size() % 4 != 0) bytes += '\0';
    return bytes;
  }
  const NcOptions &options_;
};

}  // namespace

Bytes nc_file(const std::vector<Floats> &frames, const NcOptions &options) {
  const NcWriter writer(options);
  const uint64_t atoms = frames.at(0).size(), width = options.wide ? 8 : 4;
  enum : uint64_t { FRAME, SPATIAL, ATOM, CELL, ANGULAR };
  const uint32_t kind = options.wide ? 6 : 5;
  // Where variables begin, once the length of what is before them is known.
  const auto header = [&](uint64_t length) {
    std::vector<Bytes> variables, of_coordinates = {writer.label("units", options.unit)};
    if (options.scale != 1) {
      of_coordinates.push_back(writer.text("scale_factor") + bytes_of(6, 4, true) + writer.count(1) +
                               writer.number(options.scale, true));
    }
    uint64_t at = length + (options.labels ? 4 : 0);
    if (options.labels) variables.push_back(writer.variable("spatial", {SPATIAL}, {}, 2, 4, length));
    if (options.time) {
      variables.push_back(writer.variable("time", {FRAME}, {writer.label("units", "picosecond")}, 5, 4, at));
      at += 4;
    }
    if (options.velocities) {
      variables.push_back(writer.variable("velocities", {FRAME, ATOM, SPATIAL}, {}, 5, 12 * atoms, at));
      at += 12 * atoms;
    }
    variables.push_back(
        writer.variable("coordinates", {FRAME, ATOM, SPATIAL}, of_coordinates, kind, 3 * width * atoms, at));
    at += 3 * width * atoms;
    if (options.flags) {
      variables.push_back(writer.variable("flags", {FRAME}, {}, 3, 4, at));
      at += 4;
    }
    if (options.cell) {
      variables.push_back(writer.variable("cell_lengths", {FRAME, CELL}, {}, 6, 24, at));
      variables.push_back(writer.variable("cell_angles", {FRAME, ANGULAR}, {}, 6, 24, at + 24));
    }
    const uint64_t none = ~uint64_t{0};
    return Bytes("CDF") + options.version + writer.count(options.streamed ? none : frames.size()) +
           writer.list(10, {writer.text("frame") + writer.count(0), writer.text("spatial") + writer.count(3),
                            writer.text("atom") + writer.count(atoms), writer.text("cell_spatial") + writer.count(3),
                            writer.text("cell_angular") + writer.count(3)}) +
           writer.list(12, {writer.label("Conventions", "AMBER"), writer.label("ConventionVersion", "1.0")}) +
           writer.list(11, variables);
  };
  Bytes file = header(header(0).size());
  if (options.labels) file += Bytes("xyz") + '\0';
  for (size_t k = 0; k < frames.size(); ++k) {
    const auto place = static_cast<double>(k);
    if (options.time) file += writer.number(0.5 * place, false);
    for (uint64_t i = 0; options.velocities && i < 3 * atoms; ++i) file += writer.number(1e30, false);
    for (const auto &atom : frames[k]) {
      for (const float x : atom) file += writer.number(static_cast<double>(x) / options.scale, options.wide);
    }
    if (options.flags) file += Bytes("\x7f\x01\0\0", 4);
    const double cell[] = {30 + place, 40, 50, 90, 90, 60};
    for (const double number : cell) {
      if (options.cell) file += writer.number(number, true);
    }
  }
  return file;
}

}  // namespace trajectories
