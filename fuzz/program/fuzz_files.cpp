// The file readers of the program: any bytes are either read in full or refused with one line; what is read is sound,
// does not depend on line ends, and survives being written as .xyzr and read again; other locations and all models have
// the same atoms, and an assembly is made or refused; a model that is read alone has the same atoms and lines as one of
// many that are read one by one. The first byte, a digit in the corpus, chooses the format.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "fuzz_input.hpp"

extern "C" {
#include "read/failure.h"
#include "read/molecule.h"
#include "read/radii.h"
#include "read/read_molecule.h"
}

namespace {

struct Reading {
  bool done = false;
  int exit_status = 0;
  std::string reason;
  uint64_t line = 0;
  uint64_t models = 0;
  uint64_t others = 0;          // atoms of other models
  uint64_t atoms = 0;           // that were read, at other locations too
  std::vector<double> numbers;  // x y z r of every atom
};

constexpr file_choice first_of_all = FILE_CHOICE_FIRST;

std::string written(const std::string &text, const std::string &extension) {
  static const std::string folder = [] {
    const char *given = std::getenv("TMPDIR");
    return std::string(given != nullptr ? given : "/tmp");
  }();
  std::string path = folder + "/hardsphere-fuzz-" + std::to_string(getpid()) + extension;
  std::FILE *file = std::fopen(path.c_str(), "wb");
  FUZZ_REQUIRE(file != nullptr, path.c_str());
  FUZZ_REQUIRE(std::fwrite(text.data(), 1, text.size(), file) == text.size(), "temporary file");
  FUZZ_REQUIRE(std::fclose(file) == 0, "temporary file");
  return path;
}

Reading read(const std::string &text, const std::string &extension, const file_choice &choice = first_of_all) {
  const std::string path = written(text, extension);
  radii table;
  radii_take_set(&table, &radii_bondi);
  const radii_table no_table = RADII_TABLE_NONE;
  molecule atoms;
  failure why;
  std::memset(&why, 0, sizeof why);
  Reading reading;
  const file_format *format = file_format_of(path.c_str(), &why);
  FUZZ_REQUIRE(format != nullptr, "extension");
  reading.done = read_molecule(path.c_str(), format, &choice, KEEP_PLACES | KEEP_EXTRAS, &atoms, &why);
  reading.atoms = atoms.read + atoms.left_out.alternate_locations;
  reading.others = atoms.left_out.other_models;
  text_buffer names = TEXT_BUFFER_EMPTY;
  if (reading.done) FUZZ_REQUIRE(assemblies_list_others(&atoms, &names), "names of assemblies");
  text_buffer_free(&names);
  reading.done = reading.done && molecule_take_radii(&atoms, &table, &no_table, &why);
  reading.exit_status = why.exit_status;
  reading.reason = why.reason;
  reading.line = why.line;
  reading.models = atoms.models;
  if (reading.done) {
    FUZZ_REQUIRE(why.exit_status == 0, "success with an exit status");
    for (uint32_t i = 0; i < atoms.atoms; ++i) {
      for (int k = 0; k < 3; ++k) reading.numbers.push_back(atoms.xyz[3 * i + static_cast<uint32_t>(k)]);
      reading.numbers.push_back(atoms.radius[i]);
      FUZZ_REQUIRE(atoms.radius[i] >= 0.0, "negative radius");
      // A line of CIF may hold several atoms.
      const uint64_t least = i == 0 ? 1 : atoms.line[i - 1] + (std::strcmp(format->name, "cif") == 0 ? 0 : 1);
      FUZZ_REQUIRE(choice.assembly != nullptr || atoms.line[i] >= least, "line numbers");
    }
    for (const double number : reading.numbers) FUZZ_REQUIRE(std::isfinite(number), "not finite");
  } else {
    FUZZ_REQUIRE(why.exit_status == EXIT_BAD_INPUT, "refusal without exit status 1");
    FUZZ_REQUIRE(why.reason[0] != '\0', "refusal without a reason");
  }
  molecule_free(&atoms);
  std::remove(path.c_str());
  return reading;
}

bool same(const Reading &a, const Reading &b) {
  return a.done == b.done && a.numbers.size() == b.numbers.size() &&
         (a.numbers.empty() ||
          std::memcmp(a.numbers.data(), b.numbers.data(), a.numbers.size() * sizeof(double)) == 0) &&
         a.reason == b.reason && a.line == b.line;
}

// Each of many against the same model of the file, if that can be read.
void check_one_by_one(const std::string &text, const std::string &extension, const file_format *format) {
  enum { MOST = 4 };
  struct Atoms {
    bool done;
    std::vector<double> xyz;
    std::vector<uint32_t> lines;
  };
  const auto atoms_of = [](const molecule &from, bool done) {
    const size_t atoms = done ? from.atoms : 0;
    return Atoms{done, {from.xyz, from.xyz + 3 * atoms}, {from.line, from.line + atoms}};
  };
  std::vector<Atoms> one_by_one;
  molecule_texts texts;
  molecule_text part;
  molecule own;
  failure why;
  std::memset(&part, 0, sizeof part);
  std::memset(&own, 0, sizeof own);
  std::memset(&why, 0, sizeof why);
  const std::string path = written(text, extension);
  FUZZ_REQUIRE(molecule_texts_open(&texts, path.c_str(), format, &why), "opened");
  line_status status;
  while ((status = molecule_texts_next(&texts, &part, &why)) == LINE_READ) {
    FUZZ_REQUIRE(why.exit_status == 0, "success with an exit status");
    FUZZ_REQUIRE(part.text.length <= 2 * text.size() + 2, "more than there is");
    FUZZ_REQUIRE(part.text.length == 0 || format->title(part.text.text, part.text.length).length <= part.text.length,
                 "title");
    failure fault;
    std::memset(&fault, 0, sizeof fault);
    const bool done = read_molecule_text(&part, format, &first_of_all, KEEP_PLACES | KEEP_EXTRAS, &own, &fault);
    FUZZ_REQUIRE(done == (fault.exit_status == 0) && (done || fault.reason[0] != '\0'), "refusal without a reason");
    one_by_one.push_back(atoms_of(own, done));
    FUZZ_REQUIRE(part.number == one_by_one.size(), "numbers of molecules");
  }
  FUZZ_REQUIRE(status == LINE_END || why.exit_status == EXIT_BAD_INPUT, "broken off without a reason");
  if (own.format != nullptr) molecule_free(&own);
  text_buffer_free(&part.text);
  molecule_texts_close(&texts);
  for (uint64_t k = 1; k <= MOST; ++k) {
    file_choice choice = first_of_all;
    choice.model = k;
    molecule alone;
    std::memset(&why, 0, sizeof why);
    const bool done = read_molecule(path.c_str(), format, &choice, KEEP_PLACES | KEEP_EXTRAS, &alone, &why);
    if (done) {
      FUZZ_REQUIRE(k <= one_by_one.size() && one_by_one[k - 1].done, "a model that is none of many");
      const Atoms expected = atoms_of(alone, true);
      FUZZ_REQUIRE(one_by_one[k - 1].xyz == expected.xyz, "atoms of one of many");
      FUZZ_REQUIRE(one_by_one[k - 1].lines == expected.lines, "lines of one of many");
    }
    molecule_free(&alone);
  }
  std::remove(path.c_str());
}

std::string with_line_ends(const std::string &text, const char *line_end) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += line_end;
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size == 0) return 0;
  std::vector<std::string> extensions;
  const file_format *format;
  for (size_t i = 0; (format = file_format_at(i)) != nullptr; ++i) {
    if (file_format_has(format, FILE_ATOMS)) extensions.push_back(std::string(".") + format->name);
  }
  const std::string &extension = extensions[static_cast<uint8_t>(data[0] - '0') % extensions.size()];
  const std::string text(reinterpret_cast<const char *>(data) + 1, size - 1);
  const Reading reading = read(text, extension);
  FUZZ_REQUIRE(same(reading, read(text, extension)), "another answer the second time");
  if (text.find('\r') == std::string::npos) {
    FUZZ_REQUIRE(same(reading, read(with_line_ends(text, "\r\n"), extension)), "CRLF");
    FUZZ_REQUIRE(same(reading, read(with_line_ends(text, "\r"), extension)), "CR");
  }
  file_choice choice = first_of_all;
  choice.model = 2;
  const Reading second = read(text, extension, choice);
  if (second.done) FUZZ_REQUIRE(second.models >= 2, "a second model of one");
  if (reading.done && second.done) FUZZ_REQUIRE(second.models == reading.models, "the number of models");
  choice.model = EVERY_MODEL;
  const Reading merged = read(text, extension, choice);
  if (reading.done && merged.done) FUZZ_REQUIRE(merged.atoms >= reading.atoms, "all models");
  const bool counted = extension == ".pdb" || extension == ".pqr";  // atoms of other models, not announcements of them
  if (reading.done && merged.done && counted) {
    FUZZ_REQUIRE(merged.atoms == reading.atoms + reading.others, "atoms of all models");
  }
  choice = first_of_all;
  for (const char location : {static_cast<char>(LOCATION_BY_OCCUPANCY), 'B'}) {
    choice.location = location;
    const Reading chosen = read(text, extension, choice);
    if (reading.done && chosen.done) FUZZ_REQUIRE(chosen.atoms == reading.atoms, "other locations");
  }
  format = file_format_named(extension.c_str() + 1, FILE_ATOMS);
  if (file_format_has(format, FILE_MOLECULES)) check_one_by_one(text, extension, format);
  choice.label_chains = true;
  choice.assembly = "1";
  read(text, extension, choice);
  if (reading.done) {
    std::string plain;
    for (size_t k = 0; k < reading.numbers.size(); k += 4) {
      char line[160];
      std::snprintf(line, sizeof line, "%.17g %.17g %.17g %.17g\n", reading.numbers[k], reading.numbers[k + 1],
                    reading.numbers[k + 2], reading.numbers[k + 3]);
      plain += line;
    }
    const Reading again = read(plain, ".xyzr");
    FUZZ_REQUIRE(again.done && again.numbers == reading.numbers, "written and read again");
  }
  return 0;
}
