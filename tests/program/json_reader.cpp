#include "json_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace {

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::optional<Json> whole() {
    Json value;
    skip_space();
    if (!read_value(value, 0)) return std::nullopt;
    skip_space();
    if (at_ != text_.size()) return std::nullopt;
    return value;
  }

 private:
  static constexpr int deepest = 100;

  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  bool take(char c) {
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  bool take_word(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  void skip_space() {
    while (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r') ++at_;
  }

  bool read_value(Json &value, int depth) {
    if (depth > deepest) return false;
    switch (peek()) {
      case '{':
        return read_object(value, depth);
      case '[':
        return read_array(value, depth);
      case '"':
        value.kind = Json::Kind::string;
        return read_string(value.text);
      case 't':
        value.kind = Json::Kind::boolean;
        value.boolean = true;
        return take_word("true");
      case 'f':
        value.kind = Json::Kind::boolean;
        return take_word("false");
      case 'n':
        return take_word("null");
      default:
        return read_number(value);
    }
  }

  bool read_object(Json &value, int depth) {
    value.kind = Json::Kind::object;
    take('{');
    skip_space();
    if (take('}')) return true;
    do {
      skip_space();
      std::string key;
      if (!read_string(key)) return false;
      if (std::find(value.keys.begin(), value.keys.end(), key) != value.keys.end()) return false;
      skip_space();
      if (!take(':')) return false;
      skip_space();
      Json item;
      if (!read_value(item, depth + 1)) return false;
      value.keys.push_back(key);
      value.items.push_back(item);
      skip_space();
    } while (take(','));
    return take('}');
  }

  bool read_array(Json &value, int depth) {
    value.kind = Json::Kind::array;
    take('[');
    skip_space();
    if (take(']')) return true;
    do {
      skip_space();
      Json item;
      if (!read_value(item, depth + 1)) return false;
      value.items.push_back(item);
      skip_space();
    } while (take(','));
    return take(']');
  }

  bool read_string(std::string &string) {
    if (!take('"')) return false;
    while (at_ < text_.size() && text_[at_] != '"') {
      if (static_cast<unsigned char>(text_[at_]) < 0x20) return false;
      if (take('\\')) {
        if (!read_escape(string)) return false;
      } else {
        string.push_back(text_[at_++]);
      }
    }
    return take('"');
  }

  // The character after a backslash. Pairs of surrogates are refused: this program has no use for them.
  bool read_escape(std::string &string) {
    static constexpr std::string_view letters = "\"\\/bfnrt";
    static constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
    const size_t which = letters.find(peek());
    if (at_ < text_.size() && which != std::string_view::npos) {
      ++at_;
      string.push_back(meanings[which]);
      return true;
    }
    if (!take('u')) return false;
    unsigned code = 0;
    for (int i = 0; i < 4; ++i) {
      static constexpr std::string_view digits = "0123456789abcdef";
      const char c = peek();
      const size_t digit = digits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
      if (at_ == text_.size() || digit == std::string_view::npos) return false;
      code = 16 * code + static_cast<unsigned>(digit);
      ++at_;
    }
    if (code >= 0xD800 && code < 0xE000) return false;
    append_utf8(string, code);
    return true;
  }

  static void append_utf8(std::string &string, unsigned code) {
    if (code < 0x80) {
      string.push_back(static_cast<char>(code));
    } else if (code < 0x800) {
      string.push_back(static_cast<char>(0xC0 | (code >> 6)));
      string.push_back(static_cast<char>(0x80 | (code & 0x3F)));
    } else {
      string.push_back(static_cast<char>(0xE0 | (code >> 12)));
      string.push_back(static_cast<char>(0x80 | ((code >> 6) & 0x3F)));
      string.push_back(static_cast<char>(0x80 | (code & 0x3F)));
    }
  }

  size_t digits() {
    const size_t begin = at_;
    while (peek() >= '0' && peek() <= '9') ++at_;
    return at_ - begin;
  }

  // -? (0 | [1-9][0-9]*) (. [0-9]+)? ([eE] [+-]? [0-9]+)?
  bool read_number(Json &value) {
    const size_t begin = at_;
    take('-');
    const bool zero = peek() == '0';
    const size_t whole = digits();
    if (whole == 0 || (zero && whole > 1)) return false;
    if (take('.') && digits() == 0) return false;
    if (peek() == 'e' || peek() == 'E') {
      ++at_;
      if (peek() == '+' || peek() == '-') ++at_;
      if (digits() == 0) return false;
    }
    value.kind = Json::Kind::number;
    value.text = text_.substr(begin, at_ - begin);
    value.number = std::strtod(value.text.c_str(), nullptr);
    return std::isfinite(value.number);
  }

  std::string_view text_;
  size_t at_ = 0;
};

}  // namespace

const Json &Json::operator[](const std::string &key) const & {
  static const Json none;
  for (size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == key) return items[i];
  }
  return none;
}

Json Json::operator[](const std::string &key) && {
  return std::as_const(*this)[key];
}

std::optional<Json> read_json(const std::string &text) {
  return Reader(text).whole();
}
