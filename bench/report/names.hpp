// Names that stand for text in the report's source: $name.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace report {

using Names = std::map<std::string, std::string, std::less<>>;

// Rows that each give the same names a text.
struct List {
  std::vector<Names> rows;
};
using Lists = std::map<std::string, List, std::less<>>;

// The text with every known $name replaced, also within the texts that replace names.
std::string with_names(std::string text, const Names &names);

std::string without_blanks(std::string_view text);  // at either end

// The text between separators, without blanks around it.
std::vector<std::string> split(std::string_view text, std::string_view separator);

}  // namespace report
