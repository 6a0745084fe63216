// Elliptical arcs from their ends to their centres: appendix F.6.5 of the standard. A ball with light is a group whose
// unit circle is its disc: its number and colour are the group's.
#include <cctype>
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

// The origin of a path's own coordinates, y down, and how long 1 is.
struct Frame {
  PagePoint origin{0, 0};
  double unit = 1;
};

class PathReader {
 public:
  PathReader(const std::string &text, double height, const Frame &frame = {})
      : text_(text), height_(height), frame_(frame) {}

  std::vector<Loop> read() {
    char command = '\0';
    for (skip(); place_ < text_.size(); skip()) {
      // A command goes on where there is none.
      if (std::isalpha(static_cast<unsigned char>(text_[place_])) != 0) {
        command = text_[place_++];
      } else if (std::string("laq").find(command) == std::string::npos) {
        throw std::runtime_error("svg: numbers without a command");
      }
      if (command == 'M') {
        loops_.push_back({});
        here_ = point();
        loops_.back().start = here_;
        continue;
      }
      if (loops_.empty() || loops_.back().closed) throw std::runtime_error("svg: a path without M");
      if (command == 'Z') {
        loops_.back().closed = true;
      } else if (command == 'a') {
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
    return {frame_.origin[0] + frame_.unit * x, height_ - frame_.origin[1] - frame_.unit * number()};
  }

  // From here.
  PagePoint step() {
    const double x = number();
    return {here_[0] + frame_.unit * x, here_[1] - frame_.unit * number()};
  }

  void read_arc() {
    double a = frame_.unit * number();
    double b = frame_.unit * number();
    const double rotation = -number() * std::numbers::pi / 180;
    const bool large = number() != 0;
    const bool counter_clockwise = number() == 0;
    Segment arc;
    arc.kind = Segment::Kind::arc;
    arc.start = here_;
    arc.end = here_ = step();
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
  Frame frame_;
  size_t place_ = 0;
  PagePoint here_{};
  std::vector<Loop> loops_;
};

}  // namespace

// Its number in data-ball, or in an id; 0xFFFFFFFF if there is none.
static uint32_t ball_of(const std::string &element) {
  const std::string ball = attribute(element, "data-ball");
  if (!ball.empty()) return static_cast<uint32_t>(std::stoul(ball));
  const std::string id = attribute(element, "id");
  if (!id.starts_with("a")) return 0xFFFFFFFFU;
  return static_cast<uint32_t>(std::stoul(id.substr(id.find('-') + 1)));
}

// A whole circle, as its leftmost point and two halves.
static Loop circle(const std::string &element, double height, const Frame &frame) {
  const auto number = [&](const char *name) {
    const std::string value = attribute(element, name);
    return value.empty() ? 0.0 : std::stod(value);
  };
  const double radius = frame.unit * number("r");
  Segment half;
  half.kind = Segment::Kind::arc;
  half.centre = {frame.origin[0] + frame.unit * number("cx"), height - frame.origin[1] - frame.unit * number("cy")};
  half.axis[0] = {radius, 0};
  half.axis[1] = {0, radius};
  Loop loop;
  loop.closed = true;
  for (const double from : {-std::numbers::pi, 0.0}) {
    half.from = from;
    half.to = from + std::numbers::pi;
    const double side = from < 0 ? -radius : radius;
    half.start = {half.centre[0] + side, half.centre[1]};
    half.end = {half.centre[0] - side, half.centre[1]};
    loop.segments.push_back(half);
  }
  loop.start = loop.segments.front().start;
  return loop;
}

// The loops of a path or circle.
static std::vector<Loop> loops_of(const std::string &element, double height, const Frame &frame = {}) {
  if (element.starts_with("<circle")) return {circle(element, height, frame)};
  return PathReader(attribute(element, "d"), height, frame).read();
}

PictureFile read_svg(const std::string &text) {
  PictureFile file;
  std::string lit;  // the group of a ball with light, while it is open
  Frame frame;
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
    if (element.starts_with("<g ") && element.find("transform=") != std::string::npos) {
      lit = element;
      const std::string transform = attribute(element, "transform");
      const char *const form = "translate(%lf %lf)scale(%lf)";
      if (std::sscanf(transform.c_str(), form, &frame.origin[0], &frame.origin[1], &frame.unit) != 3) {
        throw std::runtime_error("svg: " + element);
      }
    }
    if (element.starts_with("</g")) lit.clear();
    if (!element.starts_with("<path") && !element.starts_with("<circle")) continue;
    PaintedPath path;
    if (!lit.empty()) {
      path.paint = attribute(lit, "fill");
      path.ball = ball_of(lit);
      path.loops = loops_of(element, file.height, frame);
      file.paths.push_back(path);
      continue;
    }
    path.name = attribute(element, "class");
    if (path.name == "border" || path.name == "group" || path.name == "depth") {
      path.ball = file.paths.back().ball;
      path.behind = file.paths.size();
      path.loops = loops_of(element, file.height);
      file.ink.push_back(path);
      continue;
    }
    path.paint = attribute(element, "fill");
    path.ball = ball_of(element);
    path.loops = loops_of(element, file.height);
    (path.paint.empty() ? file.lines : file.paths).push_back(path);
  }
  return file;
}
