// A tiny PostScript machine: numbers, arrays and the handful of names that pictures draw with.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "picture_paths.hpp"

namespace {

constexpr double degree = std::numbers::pi / 180;

class Machine {
 public:
  explicit Machine(PictureFile &file) : file_(file) {}

  void run(const std::string &word) {
    char *end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (*end == '\0') {
      stack_.push_back(value);
    } else if (word.starts_with("16#")) {
      colour_ = word;
    } else if (word == "[" || word == "]") {
      return;
    } else if (word == "M") {
      const std::vector<double> a = take(2);
      path_.loops.push_back({});
      path_.loops.back().start = here_ = {a[0], a[1]};
    } else if (word == "L") {
      const std::vector<double> a = take(2);
      Segment line;
      line.start = here_;
      line.end = {a[0], a[1]};
      add(line);
    } else if (word == "A" || word == "B") {
      const std::vector<double> a = take(5);
      add_arc({a[0], a[1]}, {a[2], 0}, {0, a[2]}, a[3], a[4], word == "A");
    } else if (word == "E" || word == "D") {
      const std::vector<double> a = take(8);
      add_arc({a[6], a[7]}, {a[2], a[3]}, {a[4], a[5]}, a[0], a[1], word == "E");
    } else if (word == "V") {
      const std::vector<double> a = take(6);
      Segment curve;
      curve.kind = Segment::Kind::cubic;
      curve.start = here_;
      curve.handle = {{{a[0], a[1]}, {a[2], a[3]}}};
      curve.end = {a[4], a[5]};
      add(curve);
    } else if (word == "J") {
      path_.paint = colour_;
      path_.behind = file_.paths.size();
      file_.ink.push_back(path_);
      path_ = {};
    } else if (word == "Z") {
      path_.loops.back().closed = true;
    } else if (word == "F") {
      path_.paint = colour_;
      finish();
    } else if (word == "G") {
      const std::vector<double> a = take(4);
      path_.paint = std::to_string(a[3]);
      finish();
    } else if (word == "stroke") {
      file_.lines.push_back(path_);
      path_ = {};
    } else {
      stack_.clear();  // the page's beginning
    }
  }

 private:
  std::vector<double> take(size_t count) {
    if (stack_.size() != count) throw std::runtime_error("eps: operands");
    std::vector<double> taken;
    taken.swap(stack_);
    return taken;
  }
  void add_arc(PagePoint centre, PagePoint major, PagePoint minor, double from, double to, bool forward) {
    Segment arc;
    arc.kind = Segment::Kind::arc;
    arc.centre = centre;
    arc.axis = {major, minor};
    arc.from = from * degree;
    arc.to = to * degree;
    if (forward ? arc.to < arc.from : arc.to > arc.from) throw std::runtime_error("eps: an arc that goes backwards");
    arc.start = arc.at(0);
    arc.end = arc.at(1);
    add(arc);
  }
  void add(const Segment &segment) {
    if (path_.loops.empty() || path_.loops.back().closed) throw std::runtime_error("eps: no current point");
    path_.loops.back().segments.push_back(segment);
    here_ = segment.end;
  }
  void finish() {
    file_.paths.push_back(path_);
    path_ = {};
  }

  PictureFile &file_;
  PaintedPath path_;
  PagePoint here_{};
  std::string colour_;
  std::vector<double> stack_;
};

}  // namespace

PictureFile read_eps(const std::string &text) {
  PictureFile file;
  const size_t box = text.find("%%HiResBoundingBox:");
  if (box == std::string::npos ||
      std::sscanf(text.c_str() + box, "%%%%HiResBoundingBox: 0 0 %lf %lf", &file.width, &file.height) != 2) {
    throw std::runtime_error("eps: no box");
  }
  file.width /= 0.75;
  file.height /= 0.75;
  const size_t page = text.find("%%Page: 1 1\n");
  const size_t end = text.find("showpage", page);
  if (page == std::string::npos || end == std::string::npos) throw std::runtime_error("eps: no page");
  std::string words;
  for (const char c : text.substr(page + 12, end - page - 12)) {
    if (c == '[' || c == ']') {
      words += {' ', c, ' '};
    } else {
      words += c;
    }
  }
  std::istringstream input(words);
  Machine machine(file);
  for (std::string word; input >> word;) machine.run(word);
  return file;
}
