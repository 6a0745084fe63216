// The first thing found to be wrong.
#pragma once

#include <sstream>
#include <string>

class Finding {
 public:
  // Keeps the text, made of all parts, if this is the first condition that does not hold.
  template <class... Parts>
  bool require(bool condition, const Parts &...parts) {
    if (!condition && text_.empty()) {
      std::ostringstream text;
      ((text << parts << ' '), ...);
      text_ = text.str();
    }
    return condition;
  }

  [[nodiscard]] bool any() const { return !text_.empty(); }
  [[nodiscard]] const std::string &text() const { return text_; }

 private:
  std::string text_;
};
