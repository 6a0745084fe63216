// A JSON document as a tree: as much of JSON as the files of Google Benchmark have.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace report {

struct JsonValue {
  enum class Kind { null, boolean, number, text, array, object };

  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0;
  std::string text;
  std::vector<JsonValue> array;
  std::map<std::string, JsonValue> object;

  // The member of an object; a null value if there is none.
  const JsonValue &operator[](const std::string &key) const;
};

// Parse one document. Throws std::runtime_error with the offset where it stops being JSON. \u escapes become '?'.
JsonValue parse_json(std::string_view document);

}  // namespace report
