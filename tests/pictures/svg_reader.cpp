// Elliptical arcs from their ends to their centres: appendix F.6.5 of the standard.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include "picture_paths.hpp"

namespace {

std::string attribute(const std::string &element, const std::string &name) {
  const std::string key = " " + name + "=\"";
  const size_t from = element.find(key);
  if (from == std::string::npos) return "";
  const size_t first = from + key.size();
  return element.substr(first, element.find('"', first) - first);
}

class PathReader {
 public:
  PathReader(const std::string &text, double height) : text_(text), height_(height) {}

  std::vector<Loop> read() {
    for (skip(); place_ < text_.size(); skip()) {
      const char command = text_[place_++];
      if (command == 'M') {
        loops_.push_back({});
        here_ = point();
        loops_.back().start = here_;
        continue;
      }
      if (loops_.empty() || loops_.back().closed) throw std::runtime_error("svg: a path without M");
      if (command == 'Z') {
        loops_.back().closed = true;
      } else if (command == 'L') {
        Segment line;
        line.start = here_;
        line.end = here_ = point();
        loops_.back().segments.push_back(line);
      } else if (command == 'A') {
        read_arc();
      } else if (command == 'l') {
        Segment line;
        line.start = here_;
        line.end = here_ = step();
        loops_.back().segments.push_back(line);
      } else if (command == 'q') {
        const PagePoint control = step();
        loops_.back().segments.push_back(quadratic(here_, control, step()));
        here_ = loops_.back().segments.back().end;
      } else {
        throw std::runtime_error(std::string("svg: command ") + command);
      }
    }
    return loops_;
  }

 private:
  void skip() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
  }
  double number() {
    char *end = nullptr;
    const double value = std::strtod(text_.c_str() + place_, &end);
    const auto read = static_cast<size_t>(end - text_.c_str());
    if (read == place_) throw std::runtime_error("svg: no number in " + text_.substr(place_, 20));
    place_ = read;
    return value;
  }
  // With y up.
  PagePoint point() {
    const double x = number();
    return {x, height_ - number()};
  }

  // From here.
  PagePoint step() {
    const double x = number();
    return {here_[0] + x, here_[1] - number()};
  }

  void read_arc() {
    double a = number();
    double b = number();
    const double rotation = -number() * std::numbers::pi / 180;
    const bool large = number() != 0;
    const bool counter_clockwise = number() == 0;
    Segment arc;
    arc.kind = Segment::Kind::arc;
    arc.start = here_;
    arc.end = here_ = point();
    if (arc.start == arc.end) return;  // which the standard wants left out
    const double c = std::cos(rotation);
    const double s = std::sin(rotation);
    // Where the ellipse is the unit circle: half the chord, and the centre from the middle of the chord.
    const double dx = (arc.end[0] - arc.start[0]) / 2;
    const double dy = (arc.end[1] - arc.start[1]) / 2;
    double u = (c * dx + s * dy) / a;
    double v = (-s * dx + c * dy) / b;
    const double half = std::hypot(u, v);
    if (half > 1) {  // the standard enlarges axes that are too short
      a *= half;
      b *= half;
      u /= half;
      v /= half;
    }
    double away = half > 0 ? std::sqrt(std::fmax(0, 1 - half * half)) / half : 0;
    if (large == counter_clockwise) away = -away;
    const double p = -v * away;
    const double q = u * away;
    for (size_t k = 0; k < 2; ++k) {
      arc.axis[0][k] = a * (k == 0 ? c : s);
      arc.axis[1][k] = b * (k == 0 ? -s : c);
      arc.centre[k] = (arc.start[k] + arc.end[k]) / 2 + p * arc.axis[0][k] + q * arc.axis[1][k];
    }
    arc.from = std::atan2(-v - q, -u - p);
    arc.to = std::atan2(v - q, u - p);
    if (counter_clockwise && arc.to < arc.from) arc.to += 2 * std::numbers::pi;
    if (!counter_clockwise && arc.to > arc.from) arc.to -= 2 * std::numbers::pi;
    loops_.back().segments.push_back(arc);
  }

  const std::string &text_;
  double height_;
  size_t place_ = 0;
  PagePoint here_{};
  std::vector<Loop> loops_;
};

}  // namespace

PictureFile read_svg(const std::string &text) {
  PictureFile file;
  size_t place = 0;
  while ((place = text.find('<', place)) != std::string::npos) {
    const size_t end = text.find('>', place);
    if (end == std::string::npos) throw std::runtime_error("svg: an element without end");
    const std::string element = text.substr(place, end - place);
    place = end;
    if (element.starts_with("<svg ")) {
      const std::string box = attribute(element, "viewBox");
      if (std::sscanf(box.c_str(), "0 0 %lf %lf", &file.width, &file.height) != 2) throw std::runtime_error("viewBox");
    }
    if (!element.starts_with("<path")) continue;
    PaintedPath path;
    path.name = attribute(element, "class");
    if (path.name == "border" || path.name == "group" || path.name == "depth") {
      path.ball = file.paths.back().ball;
      path.behind = file.paths.size();
      path.loops = PathReader(attribute(element, "d"), file.height).read();
      file.ink.push_back(path);
      continue;
    }
    path.paint = attribute(element, "fill");
    const std::string ball = attribute(element, "data-ball");
    if (!ball.empty()) path.ball = static_cast<uint32_t>(std::stoul(ball));
    path.loops = PathReader(attribute(element, "d"), file.height).read();
    (path.paint.empty() ? file.lines : file.paths).push_back(path);
  }
  return file;
}
