// The program's reader of index files: any bytes are read in full or refused with one line. The groups must be those
// that a second reader, written here, finds; the same with other line ends, and after writing the plain form and
// reading it again.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz_input.hpp"

extern "C" {
#include "read/failure.h"
#include "read/index_file.h"
}

namespace {

using Places = std::set<uint32_t>;

// The file in the plain form, or what was wrong with it.
struct Reading {
  bool done;
  std::string text;
  std::vector<Places> groups;

  bool operator==(const Reading &) const = default;
};

void check_group(const index_file &file, size_t k) {
  const index_group &group = file.group[k];
  const std::string name = group.name;
  FUZZ_REQUIRE(!name.empty(), "a group without a name");
  size_t first = 0;
  while (name != file.group[first].name) ++first;
  FUZZ_REQUIRE(index_file_find(&file, {name.c_str(), name.size()}) == &file.group[first], "not found by its name");
  const std::string number = std::to_string(k);
  const index_group *found = index_file_find(&file, {number.c_str(), number.size()});
  FUZZ_REQUIRE(found == &group || (found != nullptr && number == found->name), "not found by its number");
  const Places places(group.place, group.place + group.count);
  for (size_t i = 1; i < group.count; ++i) FUZZ_REQUIRE(group.place[i - 1] <= group.place[i], "order");
  for (const uint32_t place : places) {
    FUZZ_REQUIRE(index_group_has(&group, place), "has");
    FUZZ_REQUIRE(index_group_has(&group, place + 1) == places.contains(place + 1), "has what it has not");
  }
}

// A molecule with as many atoms as the largest number suits, and one with fewer does not.
void check_size(const index_file &file, const std::vector<Places> &groups) {
  uint32_t least = 0;
  for (const Places &places : groups) least = places.empty() ? least : std::max(least, *places.rbegin() + 1);
  failure why;
  std::memset(&why, 0, sizeof why);
  FUZZ_REQUIRE(index_file_suits(&file, "x.ndx", least, &why) && why.exit_status == 0, "as many atoms as it names");
  if (least == 0) return;
  FUZZ_REQUIRE(!index_file_suits(&file, "x.ndx", least - 1, &why) && why.exit_status == EXIT_BAD_INPUT, "fewer");
}

Reading read(const std::string &text) {
  static const std::string path = [] {
    const char *folder = std::getenv("TMPDIR");
    return std::string(folder != nullptr ? folder : "/tmp") + "/hardsphere-fuzz-index-" + std::to_string(getpid());
  }();
  std::FILE *file = std::fopen(path.c_str(), "wb");
  FUZZ_REQUIRE(file != nullptr, path.c_str());
  FUZZ_REQUIRE(std::fwrite(text.data(), 1, text.size(), file) == text.size(), "temporary file");
  FUZZ_REQUIRE(std::fclose(file) == 0, "temporary file");

  index_file index = INDEX_FILE_NONE;
  failure why;
  std::memset(&why, 0, sizeof why);
  Reading reading;
  reading.done = index_file_read(&index, path.c_str(), &why);
  FUZZ_REQUIRE(why.exit_status == (reading.done ? 0 : EXIT_BAD_INPUT), "exit status");
  FUZZ_REQUIRE(reading.done == (why.reason[0] == '\0'), "a refusal and its reason");
  if (!reading.done) reading.text = why.reason + std::to_string(why.line);
  for (size_t k = 0; reading.done && k < index.count; ++k) {
    check_group(index, k);
    const index_group &group = index.group[k];
    reading.text += "[ " + std::string(group.name) + " ]\n";
    for (size_t i = 0; i < group.count; ++i) reading.text += std::to_string(uint64_t{group.place[i]} + 1) + '\n';
    reading.groups.emplace_back(group.place, group.place + group.count);
  }
  if (reading.done) check_size(index, reading.groups);
  index_file_free(&index);
  std::remove(path.c_str());
  return reading;
}

// The groups of a file that was taken. A CR ends a line, too, and a byte-order mark may stand before the first.
std::vector<Places> groups_of(std::string text) {
  std::vector<Places> groups;
  std::replace(text.begin(), text.end(), '\r', '\n');
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find(';')));
    for (std::string word; words >> word;) {
      if (word[0] == '[') {
        groups.emplace_back();
        break;
      }
      FUZZ_REQUIRE(!groups.empty(), "atoms before a group");
      groups.back().insert(static_cast<uint32_t>(std::stoull(word) - 1));
    }
  }
  return groups;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  // Bytes that are no text make what these files have.
  static constexpr const char *words[] = {"[ ", " ]\n",  "\n", " ", ";", "1", "17",         "0",
                                          "A",  "A_&_B", "2",  "]", "[", "4", "4294967295", "4294967296"};
  std::string text;
  for (size_t i = 0; i < size; ++i) {
    if (data[i] >= 0x80) {
      text += words[data[i] % 16];
      if (data[i] >= 0xC0) text += ' ';
    } else {
      text += static_cast<char>(data[i]);
    }
  }
  const Reading reading = read(text);
  if (reading.done) FUZZ_REQUIRE(reading.groups == groups_of(text), "other groups");
  if (text.find('\r') == std::string::npos) {
    std::string crlf;
    for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    FUZZ_REQUIRE(reading == read(crlf), "CRLF");
  }
  // A name that was cut off may end in a blank.
  if (reading.done) FUZZ_REQUIRE(reading.groups == read(reading.text).groups, "written and read again");
  return 0;
}
