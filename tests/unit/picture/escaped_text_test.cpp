// Texts with markup, control characters and broken UTF-8, escaped for XML and for PostScript.
#include "picture/escaped_text.hpp"

#include <gtest/gtest.h>

#include "kept_bytes.hpp"

namespace {

std::string xml(const char *text) {
  return text_of([text](hsp::ByteSink &sink) { hsp::put_xml_text(sink, text); });
}

TEST(Texts, ForXml) {
  EXPECT_EQ(xml("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;");
  EXPECT_EQ(xml("\x01\x1F\x7F\t\n\r"), "???\t\n?");
  EXPECT_EQ(xml("\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"), "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
  EXPECT_EQ(xml("\xC3"), "?");
  EXPECT_EQ(xml("\xE2\x82x"), "??x");
  EXPECT_EQ(xml("\x80\xFF\xC0\xAF"), "????");
  EXPECT_EQ(xml("\xED\xA0\x80"), "???");
  EXPECT_EQ(xml("\xF4\x90\x80\x80"), "????");
  EXPECT_EQ(xml("\xE0\x80\x80\xF0\x80\x80\x80"), "???????");
  EXPECT_EQ(xml("\xEF\xBF\xBE\xEF\xBF\xBF\xEF\xBF\xBD"), "??\xEF\xBF\xBD");
  EXPECT_EQ(xml("\xC2\x85\xC2\xA0"), "?\xC2\xA0");
}

TEST(Texts, InParentheses) {
  const auto parenthesized = [](const char *text, uint32_t most) {
    return text_of([&](hsp::ByteSink &sink) { sink.put(hsp::put_parenthesized(sink, text, most)); });
  };
  EXPECT_EQ(parenthesized("a(b)\\c", 0), "(a\\(b\\)\\\\c)");
  EXPECT_EQ(parenthesized("\xC3\xA9t\xE2\x82\n", 0),
            "(?t??"
            "?)");
  EXPECT_EQ(parenthesized("((((", 2), "(\\(\\()((");
  EXPECT_EQ(parenthesized("\x1F ~\x7F", 0), "(? ~?)");
  EXPECT_EQ(parenthesized("", 0), "()");
}

}  // namespace
