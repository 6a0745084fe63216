#include "picture/escaped_text.hpp"

namespace hsp {
namespace {

// Length of the UTF-8 character at `text` and its code point; length 0 if there is none.
struct CodePoint {
  uint32_t value;
  uint32_t length;
};

CodePoint decode(const char *text) {
  const auto byte = [text](uint32_t k) { return static_cast<uint32_t>(static_cast<unsigned char>(text[k])); };
  const uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const uint32_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4) return {0, 0};
  uint32_t value = lead & (0x7Fu >> length);
  for (uint32_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0) != 0x80) return {0, 0};  // the terminating NUL ends the character too
    value = value << 6 | (byte(k) & 0x3F);
  }
  const uint32_t smallest = length == 2 ? 0x80 : length == 3 ? 0x800 : 0x10000;
  const bool surrogate = value >= 0xD800 && value < 0xE000;
  if (value < smallest || value > 0x10FFFF || surrogate) return {0, 0};
  return {value, length};
}

bool xml_allows(uint32_t value) {
  if (value < 0x20) return value == '\t' || value == '\n';
  return (value < 0x7F || value > 0x9F) && value != 0xFFFE && value != 0xFFFF;
}

void put_utf16_unit(ByteSink &sink, uint32_t unit) {
  constexpr char digits[] = "0123456789ABCDEF";
  for (int shift = 12; shift >= 0; shift -= 4) sink.put(digits[unit >> shift & 0xF]);
}

}  // namespace

void put_xml_text(ByteSink &sink, const char *text) {
  while (*text != '\0') {
    const CodePoint point = decode(text);
    if (point.length == 0 || !xml_allows(point.value)) {
      sink.put('?');
      text += point.length == 0 ? 1 : point.length;
      continue;
    }
    switch (point.value) {
      case '&':
        sink.put("&amp;");
        break;
      case '<':
        sink.put("&lt;");
        break;
      case '>':
        sink.put("&gt;");
        break;
      case '"':
        sink.put("&quot;");
        break;
      default:
        for (uint32_t k = 0; k < point.length; ++k) sink.put(text[k]);
    }
    text += point.length;
  }
}

char next_ascii(const char *&text) {
  const CodePoint point = decode(text);
  text += point.length == 0 ? 1 : point.length;
  return point.length == 1 && point.value >= 0x20 && point.value < 0x7F ? static_cast<char>(point.value) : '?';
}

const char *put_parenthesized(ByteSink &sink, const char *text, uint32_t most) {
  sink.put('(');
  for (uint32_t k = 0; *text != '\0' && (most == 0 || k < most); ++k) {
    const char character = next_ascii(text);
    if (character == '(' || character == ')' || character == '\\') sink.put('\\');
    sink.put(character);
  }
  sink.put(')');
  return text;
}

void put_pdf_text(ByteSink &sink, const char *text) {
  bool ascii = true;
  for (const char *rest = text; *rest != '\0'; ++rest) ascii = ascii && *rest >= 0x20 && *rest < 0x7F;
  if (ascii) {
    put_parenthesized(sink, text);
    return;
  }
  sink.put("<FEFF");
  while (*text != '\0') {
    const CodePoint point = decode(text);
    text += point.length == 0 ? 1 : point.length;
    const uint32_t value = point.length == 0 ? '?' : point.value;
    if (value < 0x10000) {
      put_utf16_unit(sink, value);
    } else {
      put_utf16_unit(sink, 0xD800 + ((value - 0x10000) >> 10));
      put_utf16_unit(sink, 0xDC00 + ((value - 0x10000) & 0x3FF));
    }
  }
  sink.put('>');
}

}  // namespace hsp
