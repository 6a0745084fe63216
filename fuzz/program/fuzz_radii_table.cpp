// Files of radii: any bytes are either read in full or refused with one line; what is read does not depend on line
// ends, and survives being written in the plain form and read again.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "fuzz_input.hpp"

extern "C" {
#include "read/failure.h"
#include "read/radii_table.h"
}

namespace {

// The table in the plain form, or what was wrong with the file.
struct Reading {
  bool done;
  std::string text;
};

Reading read(const std::string &text) {
  static const std::string path = [] {
    const char *folder = std::getenv("TMPDIR");
    return std::string(folder != nullptr ? folder : "/tmp") + "/hardsphere-fuzz-radii-" + std::to_string(getpid());
  }();
  std::FILE *file = std::fopen(path.c_str(), "wb");
  FUZZ_REQUIRE(file != nullptr, path.c_str());
  FUZZ_REQUIRE(std::fwrite(text.data(), 1, text.size(), file) == text.size(), "temporary file");
  FUZZ_REQUIRE(std::fclose(file) == 0, "temporary file");

  radii_table table = RADII_TABLE_NONE;
  failure why;
  std::memset(&why, 0, sizeof why);
  Reading reading;
  reading.done = radii_table_read(&table, path.c_str(), &why);
  FUZZ_REQUIRE(why.exit_status == (reading.done ? 0 : EXIT_BAD_INPUT), "exit status");
  if (reading.done) {
    const char *residue, *atom;
    double radius;
    for (size_t i = 0; radii_table_get(&table, i, &residue, &atom, &radius); ++i) {
      FUZZ_REQUIRE(std::isfinite(radius) && radius >= 0.0, "radius");
      double found = -1.0;
      FUZZ_REQUIRE(radii_table_find(&table, residue, atom, &found) && found == radius, "not found");
      char line[80];
      std::snprintf(line, sizeof line, "%s %s %.17g\n", residue, atom, radius);
      reading.text += line;
    }
    FUZZ_REQUIRE(!reading.text.empty(), "empty");
  } else {
    FUZZ_REQUIRE(why.reason[0] != '\0', "refusal without a reason");
    reading.text = why.reason + std::to_string(why.line);
  }
  radii_table_free(&table);
  std::remove(path.c_str());
  return reading;
}

bool same(const Reading &a, const Reading &b) {
  return a.done == b.done && a.text == b.text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  // Bytes that are no text make words that these files have.
  static constexpr const char *words[] = {"types:", "atoms:", "name:", "ALA", "ANY",     "*", "CB",   "\n",
                                          " ",      "1.5",    "HOH",   "N",   "RESIDUE", "#", "ATOM", "polar"};
  std::string text;
  for (size_t i = 0; i < size; ++i) {
    if (data[i] >= 0x80) {
      text += words[data[i] % 16];
      if (data[i] >= 0xA0) text += ' ';
    } else {
      text += static_cast<char>(data[i]);
    }
  }
  const Reading reading = read(text);
  if (text.find('\r') == std::string::npos) {
    std::string crlf;
    for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    FUZZ_REQUIRE(same(reading, read(crlf)), "CRLF");
  }
  if (reading.done) FUZZ_REQUIRE(same(reading, read(reading.text)), "written and read again");
  return 0;
}
