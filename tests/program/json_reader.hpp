// A strict reader of JSON (RFC 8259): what it takes, every other reader takes.
#pragma once

#include <optional>
#include <string>
#include <vector>

struct Json {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0;
  std::string text;               // of a string; of a number: as it was written
  std::vector<Json> items;        // of an array, or the values of an object
  std::vector<std::string> keys;  // of an object, one for each item

  // The value under that key; null if there is none. A copy, if nothing else keeps what was read.
  const Json &operator[](const std::string &key) const &;
  Json operator[](const std::string &key) &&;
};

// One JSON value, followed by at most white space. Nothing if the text is anything else, if a key comes twice in one
// object, or if a number does not fit a double.
std::optional<Json> read_json(const std::string &text);
