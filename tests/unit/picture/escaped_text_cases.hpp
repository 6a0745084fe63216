// Texts with markup, control characters and broken UTF-8, escaped for XML, PostScript and PDF.
#pragma once

#include "cases.hpp"
#include "kept_text.hpp"
#include "picture/escaped_text.hpp"

namespace cases {

struct Escaped {
  const char *text, *expected;
};
constexpr Escaped for_xml[] = {{"a<b>&\"c\"", "a&lt;b&gt;&amp;&quot;c&quot;"},
                               {"\x01\x1F\x7F\t\n\r", "???\t\n?"},
                               // Characters of two, three and four bytes; broken off, stray and overlong ones.
                               {"\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80", "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"},
                               {"\xC3", "?"},
                               {"\xE2\x82x", "??x"},
                               {"\x80\xFF\xC0\xAF", "????"},
                               {"\xE0\x80\x80\xF0\x80\x80\x80", "???????"},
                               // Surrogates, beyond the last code point, and what XML forbids.
                               {"\xED\xA0\x80", "???"},
                               {"\xF4\x90\x80\x80", "????"},
                               {"\xEF\xBF\xBE\xEF\xBF\xBF\xEF\xBF\xBD", "??\xEF\xBF\xBD"},
                               {"\xC2\x85\xC2\xA0", "?\xC2\xA0"}};

inline uint32_t texts_for_xml() {
  return first_failing(for_xml, [](const Escaped &c) {
    return text_of([&c](hsp::ByteSink &sink) { hsp::put_xml_text(sink, c.text); }).is(c.expected);
  });
}

// The rest stands behind the parenthesis.
struct Parenthesized {
  const char *text;
  uint32_t most;
  const char *expected;
};
constexpr Parenthesized in_parentheses[] = {{"a(b)\\c", 0, "(a\\(b\\)\\\\c)"},
                                            {"\xC3\xA9t\xE2\x82\n", 0, "(?t?\?\?)"},
                                            {"((((", 2, "(\\(\\()(("},
                                            {"\x1F ~\x7F", 0, "(? ~?)"},
                                            {"", 0, "()"}};

inline uint32_t texts_in_parentheses() {
  return first_failing(in_parentheses, [](const Parenthesized &c) {
    const auto put = [&c](hsp::ByteSink &sink) { sink.put(hsp::put_parenthesized(sink, c.text, c.most)); };
    return text_of(put).is(c.expected);
  });
}

// Beyond ASCII the units of UTF-16, two of them for what needs more than one; control characters stay what they are.
constexpr Escaped for_pdf[] = {{"a(b)\\c", "(a\\(b\\)\\\\c)"},
                               {"", "()"},
                               {"\xCE\xB2-\xC3\x85", "<FEFF03B2002D00C5>"},
                               {"\xE2\x82\xAC\xF0\x9F\x98\x80", "<FEFF20ACD83DDE00>"},
                               {"(\n", "<FEFF0028000A>"},
                               {"x\xC3", "<FEFF0078003F>"}};

inline uint32_t texts_for_pdf() {
  return first_failing(for_pdf, [](const Escaped &c) {
    return text_of([&c](hsp::ByteSink &sink) { hsp::put_pdf_text(sink, c.text); }).is(c.expected);
  });
}

inline constexpr Check picture_escaped_text[] = {
    {"texts_for_xml", texts_for_xml}, {"texts_in_parentheses", texts_in_parentheses}, {"texts_for_pdf", texts_for_pdf}};

}  // namespace cases
