// Selections of atoms, as users write them: any text is either evaluated or refused with a reason. The atoms must be
// those that a second evaluation, written here by splitting and comparing texts, takes; --hide must take what --only
// does not. Groups of atoms must be those of their parts, or are refused.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "fuzz_input.hpp"
#include "hardsphere.h"

extern "C" {
#include "read/failure.h"
#include "read/selection.h"
#include "read/selection_groups.h"
}

namespace {

struct Atom {
  const char *name;
  const char *chain;
  const char *residue;
  const char *number;
  const char *insertion;
  const char *element;
  bool hetatm;
  bool water;
};

constexpr Atom atoms[] = {
    {"CA", "A", "ALA", "1", "", "C", false, false},    {"CA", "B", "ALA", "-5", "", "C", false, false},
    {"H1", "A", "HOH", "7", "", "H", true, true},      {"FE", "", "017", "52", "A", "Fe", true, false},
    {"c1", "a", "LIG", "A000", "", "C", true, false},  {"", "", "", "", "", "Ca", false, false},
    {"O", "LONG", "SOL", "40", "B", "O", false, true}, {"HG", "1", "52A", "0", "", "H", false, false},
};

std::vector<std::string> split(const std::string &text, char at) {
  std::vector<std::string> parts = {""};
  for (const char c : text) {
    if (c == at) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::string capitals(std::string text) {
  for (char &c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

// The number that a text is; those of more digits than a file has room for are all alike.
std::optional<long long> number(const std::string &text) {
  const std::string digits = text.substr(0, 1) == "-" ? text.substr(1) : text;
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  const size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  if (digits.size() - first > 12) return text[0] == '-' ? -1000000000000 : 1000000000000;
  return std::atoll(text.c_str());
}

// Numbers with insertion codes; 0 where there is none.
struct Range {
  long long low;
  long long high;
  int low_code = 0;
  int high_code = 0;
};

// A number with a code or without one; the code of the text is taken off.
std::optional<long long> end_of_range(std::string text, int &code) {
  const bool letter = text.size() > 1 && std::isalpha(static_cast<unsigned char>(text.back())) != 0;
  code = letter ? capitals(text.substr(text.size() - 1))[0] : 0;
  if (letter) text.pop_back();
  return number(text);
}

// Every way to split the item at a hyphen is tried.
std::optional<Range> range(const std::string &item) {
  if (const auto alone = number(item)) return Range{*alone, *alone};
  for (size_t i = 1; i < item.size(); ++i) {
    Range found{0, 0};
    const auto low = end_of_range(item.substr(0, i), found.low_code);
    const auto high = end_of_range(item.substr(i + 1), found.high_code);
    if (item[i] != '-' || !low || !high) continue;
    found.low = *low;
    found.high = *high;
    return found;
  }
  return std::nullopt;
}

bool is_empty(const Range &range) {
  return range.low > range.high ||
         (range.low == range.high && range.high_code != 0 && range.low_code > range.high_code);
}

bool is_in(const Range &range, long long own, const char *insertion) {
  const int code = *insertion == '\0' ? 0 : capitals(insertion)[0];
  if (own < range.low || own > range.high) return false;
  if (own == range.low && range.low_code > code) return false;
  return own != range.high || range.high_code == 0 || code <= range.high_code;
}

bool is_symbol(const std::string &text) {
  return !text.empty() && text.size() <= 2 &&
         std::all_of(text.begin(), text.end(), [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
}

// Whether the term holds; nothing if it is none.
std::optional<bool> holds(const std::string &term, const Atom &atom) {
  if (term == "water") return atom.water;
  if (term == "hetatm") return atom.hetatm;
  if (term == "hydrogen") return std::string(atom.element) == "H";
  const size_t colon = term.find(':');
  if (colon == std::string::npos) return std::nullopt;
  const std::string key = term.substr(0, colon);
  bool any = false;
  for (const std::string &item : split(term.substr(colon + 1), ',')) {
    if (item.empty() || item.find(':') != std::string::npos) return std::nullopt;
    if (key == "chain") {
      any |= *atom.chain == '\0' ? item == "." || item == ".1" : item == atom.chain;
    } else if (key == "element") {
      if (!is_symbol(item)) return std::nullopt;
      any |= capitals(item) == capitals(atom.element) ||
             ((capitals(item) == "D" || capitals(item) == "T") && std::string(atom.element) == "H");
    } else if (key == "group") {
      // There is no index file: no atom is in its groups.
    } else if (key == "atom") {
      any |= capitals(item) == capitals(atom.name);
    } else if (key == "residue") {
      const auto numbers = range(item);
      const auto own = number(atom.number);
      if (numbers && is_empty(*numbers)) return std::nullopt;
      any |= numbers && own && is_in(*numbers, *own, atom.insertion);
      any |= capitals(item) == capitals(atom.residue);
      any |= !numbers && capitals(item) == capitals(std::string(atom.number) + atom.insertion);
    } else {
      return std::nullopt;
    }
  }
  return any;
}

std::optional<bool> selects(const std::string &text, const Atom &atom) {
  bool all = true;
  std::vector<std::string> terms;
  for (const std::string &part : split(text, '&')) {
    const bool goes_on = !terms.empty() && terms.back().starts_with("group:") && terms.back().ends_with('_');
    if (goes_on && part.starts_with('_')) {
      terms.back() += '&' + part;  // as in the names that gmx make_ndx gives
    } else {
      terms.push_back(part);
    }
  }
  for (const std::string &term : terms) {
    const auto one = holds(term, atom);
    if (!one) return std::nullopt;
    all = all && *one;
  }
  return all;
}

atom_label label_of(const Atom &atom, residue_label &residue) {
  atom_label label;
  std::memset(&label, 0, sizeof label);
  std::memset(&residue, 0, sizeof residue);
  label.residue = &residue;
  std::strcpy(label.name, atom.name);
  std::strcpy(residue.chain, atom.chain);
  std::strcpy(residue.name, atom.residue);
  std::strcpy(residue.number, atom.number);
  std::strcpy(residue.insertion, atom.insertion);
  std::strcpy(label.element.text, atom.element);
  label.hetatm = atom.hetatm;
  return label;
}

void check(const std::string &text, bool hide) {
  selection made = {nullptr, 0, 0, false};
  failure why;
  std::memset(&why, 0, sizeof why);
  const bool taken = selection_add(&made, hide ? "--hide" : "--only", text.c_str(), hide, &why);
  FUZZ_REQUIRE(taken == (why.exit_status == 0), "success and a status");
  FUZZ_REQUIRE(taken || (why.exit_status == EXIT_BAD_USAGE && why.reason[0] != '\0'), "refused without a reason");
  for (const Atom &atom : atoms) {
    const auto expected = selects(text, atom);
    FUZZ_REQUIRE(expected.has_value() == taken, "taken or refused, against the grammar");
    residue_label residue;
    atom_label label = label_of(atom, residue);
    molecule alone;
    std::memset(&alone, 0, sizeof alone);
    alone.label = &label;
    if (taken) FUZZ_REQUIRE(selection_takes(&made, &alone, 0) == (*expected != hide), "another answer");
  }
  selection_free(&made);
}

// Each atom is in the first group that takes it, and nothing else is said of the groups than the text does.
void check_groups(const std::string &text) {
  selection_groups groups;
  failure why;
  std::memset(&groups, 0, sizeof groups);
  std::memset(&why, 0, sizeof why);
  const bool taken = selection_groups_parse(&groups, "--between", text.c_str(), &why);
  FUZZ_REQUIRE(taken == (why.exit_status == 0), "groups: success and a status");
  FUZZ_REQUIRE(taken || (why.exit_status == EXIT_BAD_USAGE && why.reason[0] != '\0'), "groups: no reason");
  std::string names;
  for (uint32_t g = 0; taken && g < groups.count; ++g) names += (g == 0 ? "" : ",") + std::string(groups.group[g].name);
  if (taken) FUZZ_REQUIRE(names == (groups.chains ? "" : text), "groups: names");
  for (const Atom &atom : atoms) {
    residue_label residue;
    atom_label label = label_of(atom, residue);
    molecule alone;
    std::memset(&alone, 0, sizeof alone);
    alone.label = &label;
    alone.atoms = 1;
    if (!taken || groups.chains) continue;
    found_groups found;
    std::memset(&why, 0, sizeof why);
    const bool done = selection_groups_find(&groups, "--between", &alone, &found, &why);
    FUZZ_REQUIRE(!done && why.reason[0] != '\0', "groups: two groups of one atom");
    uint32_t first = HSP_NONE, rest = HSP_NONE;
    for (uint32_t g = groups.count; g-- > 0;) {
      if (groups.group[g].rest) {
        rest = g;
      } else if (selection_takes(&groups.group[g].selection, &alone, 0)) {
        first = g;
      }
    }
    FUZZ_REQUIRE(found.of[0] == (first != HSP_NONE ? first : rest), "groups: another one");
    found_groups_free(&found);
  }
  selection_groups_free(&groups);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  // Bytes that are no text make keys and items that are.
  static constexpr const char *words[] = {"chain:",   "residue:", "element:", "atom:", "water",  "hetatm",
                                          "hydrogen", ",",        "&",        "-",     "A",      "HOH",
                                          "17",       "H",        "52A",      ".",     "group:", "_&_"};
  std::string text;
  for (size_t i = 0; i < size && data[i] != 0; ++i) {
    if (data[i] >= 0xFC) {
      text += data[i] >= 0xFE ? "+" : "rest";
    } else if (data[i] >= 0x80) {
      text += words[data[i] % 18];
    } else {
      text += static_cast<char>(data[i]);
    }
  }
  check(text, false);
  check(text, true);
  check_groups(text);
  return 0;
}
