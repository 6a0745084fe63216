#include "names.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <stdexcept>

namespace report {
namespace {

constexpr int most_passes = 8;

bool replace_names(std::string &text, const Names &names) {
  bool replaced = false;
  for (size_t at = text.find('$'); at != std::string::npos; at = text.find('$', at + 1)) {
    const auto end = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(at) + 1, text.end(),
                                  [](unsigned char c) { return std::isalnum(c) == 0; });
    const size_t length = static_cast<size_t>(end - text.begin()) - at;
    const auto found = names.find(std::string_view(text).substr(at + 1, length - 1));
    if (found == names.end()) continue;
    text.replace(at, length, found->second);
    replaced = true;
  }
  return replaced;
}

}  // namespace

std::string without_blanks(std::string_view text) {
  const size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(' ') + 1 - first));
}

std::string with_names(std::string text, const Names &names) {
  for (int pass = 0; replace_names(text, names); ++pass) {
    if (pass == most_passes) throw std::runtime_error("names that stand for each other: " + text);
  }
  return text;
}

std::vector<std::string> split(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  for (;;) {
    const size_t end = text.find(separator);
    parts.push_back(without_blanks(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + separator.size());
  }
}

}  // namespace report
