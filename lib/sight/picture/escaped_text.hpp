// Titles and descriptions, made fit for each format.
#pragma once

#include "picture/byte_sink.hpp"

namespace hsp {

// No text.
inline bool is_blank(const char *text) {
  return text == nullptr || *text == '\0';
}

// UTF-8 for XML: & < > and " become entities; bytes that are no UTF-8 and characters that XML forbids become '?'.
void put_xml_text(ByteSink &sink, const char *text);

// One character of a text in printable ASCII; every other character becomes one '?'. Moves `text` on.
char next_ascii(const char *&text);

// A PostScript string with its parentheses. At most `most` characters, or all if it is 0; returns what is left.
const char *put_parenthesized(ByteSink &sink, const char *text, uint32_t most = 0);

// A text string of a PDF file: in parentheses if it is printable ASCII, else UTF-16 in hexadecimal digits, big-endian
// and behind a byte-order mark. Bytes that are no UTF-8 become '?'.
void put_pdf_text(ByteSink &sink, const char *text);

}  // namespace hsp
