#include "json_value.hpp"

#include <charconv>
#include <cstddef>
#include <stdexcept>

namespace report {
namespace {

constexpr int deepest = 64;

class Parser {
 public:
  explicit Parser(std::string_view document) : rest_(document), whole_(document.size()) {}

  JsonValue document() {
    JsonValue result = value(0);
    skip_blanks();
    if (!rest_.empty()) fail("text after the document");
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string &what) const {
    throw std::runtime_error("JSON, offset " + std::to_string(whole_ - rest_.size()) + ": " + what);
  }

  void skip_blanks() {
    const size_t first = rest_.find_first_not_of(" \t\r\n");
    rest_.remove_prefix(first == std::string_view::npos ? rest_.size() : first);
  }

  bool accept(std::string_view token) {
    skip_blanks();
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  void expect(std::string_view token) {
    if (!accept(token)) fail("expected " + std::string(token));
  }

  JsonValue value(int depth) {
    if (depth > deepest) fail("nested too deeply");
    JsonValue result;
    skip_blanks();
    if (rest_.empty()) fail("the document ends early");
    if (rest_.front() == '{') {
      read_object(result, depth);
    } else if (rest_.front() == '[') {
      read_array(result, depth);
    } else if (rest_.front() == '"') {
      result.kind = JsonValue::Kind::text;
      result.text = string();
    } else if (accept("true")) {
      result.kind = JsonValue::Kind::boolean;
      result.boolean = true;
    } else if (accept("false")) {
      result.kind = JsonValue::Kind::boolean;
    } else if (!accept("null")) {
      read_number(result);
    }
    return result;
  }

  void read_object(JsonValue &result, int depth) {
    result.kind = JsonValue::Kind::object;
    expect("{");
    if (accept("}")) return;
    do {
      skip_blanks();
      const std::string key = string();
      expect(":");
      result.object[key] = value(depth + 1);
    } while (accept(","));
    expect("}");
  }

  void read_array(JsonValue &result, int depth) {
    result.kind = JsonValue::Kind::array;
    expect("[");
    if (accept("]")) return;
    do {
      result.array.push_back(value(depth + 1));
    } while (accept(","));
    expect("]");
  }

  void read_number(JsonValue &result) {
    result.kind = JsonValue::Kind::number;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), result.number);
    if (error != std::errc()) fail("not a value");
    rest_.remove_prefix(static_cast<size_t>(end - rest_.data()));
  }

  std::string string() {
    expect("\"");
    std::string text;
    while (!rest_.empty() && rest_.front() != '"') {
      char c = rest_.front();
      rest_.remove_prefix(1);
      if (c == '\\') {
        if (rest_.empty()) fail("the document ends early");
        c = rest_.front();
        rest_.remove_prefix(1);
        if (c == 'u') {
          if (rest_.size() < 4) fail("the document ends early");
          rest_.remove_prefix(4);
          c = '?';
        } else if (c == 'n' || c == 't' || c == 'r' || c == 'b' || c == 'f') {
          c = ' ';
        }
      }
      text += c;
    }
    expect("\"");
    return text;
  }

  std::string_view rest_;
  size_t whole_;
};

}  // namespace

const JsonValue &JsonValue::operator[](const std::string &key) const {
  static const JsonValue null;
  const auto found = object.find(key);
  return found == object.end() ? null : found->second;
}

JsonValue parse_json(std::string_view document) {
  return Parser(document).document();
}

}  // namespace report
