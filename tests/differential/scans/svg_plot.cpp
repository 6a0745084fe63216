#include "svg_plot.hpp"

#include <cmath>
#include <utility>

namespace {

// A decimal number with so many digits behind the point, made from an integer: no locale, no binary fractions.
std::string decimal(double value, int digits) {
  const long long scale = digits == 0 ? 1 : digits == 1 ? 10 : 100;
  const long long hundredths = std::llround(value * static_cast<double>(scale));
  const long long size = hundredths < 0 ? -hundredths : hundredths;
  std::string text = hundredths < 0 ? "-" : "";
  text += std::to_string(size / scale);
  if (digits == 0) return text;
  const std::string fraction = std::to_string(size % scale);
  return text + "." + std::string(static_cast<size_t>(digits) - fraction.size(), '0') + fraction;
}

std::string pixel(double value) {
  return decimal(value, 2);
}

// A minus sign instead of a hyphen, and as many digits as the step has.
std::string tick_label(double value, double step) {
  const std::string text = decimal(value, step == std::floor(step) ? 0 : 1);
  return text.front() == '-' ? "\xE2\x88\x92" + text.substr(1) : text;
}

const char *stroke_class(PlotStroke stroke) {
  return stroke == PlotStroke::thick ? "thick" : stroke == PlotStroke::thin ? "thin" : "dashed";
}

std::string line(const char *kind, const std::string &x1, const std::string &y1, const std::string &x2,
                 const std::string &y2, const std::string &colour = "") {
  return std::string("<line class=\"") + kind + "\" x1=\"" + x1 + "\" y1=\"" + y1 + "\" x2=\"" + x2 + "\" y2=\"" + y2 +
         (colour.empty() ? "" : "\" stroke=\"" + colour) + "\"/>\n";
}

std::string text_at(const char *kind, const std::string &x, const std::string &y, const std::string &text) {
  return std::string("<text class=\"") + kind + "\" x=\"" + x + "\" y=\"" + y + "\">" + text + "</text>\n";
}

}  // namespace

PlotPanel::PlotPanel(PlotFrame frame, PlotAxis x, PlotAxis y) : frame_(frame), x_(std::move(x)), y_(std::move(y)) {
  draw_axes();
}

std::string PlotPanel::pixel_x(double x) const {
  return pixel(frame_.left + (x - x_.first) / (x_.last - x_.first) * frame_.width);
}
std::string PlotPanel::pixel_y(double y) const {
  return pixel(frame_.top + (y_.last - y) / (y_.last - y_.first) * frame_.height);
}

void PlotPanel::draw_axes() {
  const std::string left = pixel(frame_.left);
  const std::string right = pixel(frame_.left + frame_.width);
  const std::string top = pixel(frame_.top);
  const double bottom = frame_.top + frame_.height;
  for (int k = 0; y_.first + k * y_.step <= y_.last + y_.step / 100; ++k) {
    const double value = y_.first + k * y_.step;
    svg_ += line("grid", left, pixel_y(value), right, pixel_y(value));
    const double height = frame_.top + (y_.last - value) / (y_.last - y_.first) * frame_.height;
    svg_ += text_at("end", pixel(frame_.left - 6), pixel(height + 4), tick_label(value, y_.step));
  }
  for (int k = 0; x_.first + k * x_.step <= x_.last + x_.step / 100; ++k) {
    const double value = x_.first + k * x_.step;
    svg_ += line("axis", pixel_x(value), pixel(bottom), pixel_x(value), pixel(bottom + 4));
    svg_ += text_at("middle", pixel_x(value), pixel(bottom + 17), tick_label(value, x_.step));
  }
  svg_ += line("axis", left, top, left, pixel(bottom)) + line("axis", left, pixel(bottom), right, pixel(bottom));
  svg_ += text_at("middle", pixel(frame_.left + frame_.width / 2), pixel(bottom + 35), x_.label);
  const std::string y = pixel(frame_.top + frame_.height / 2);
  const std::string x = pixel(frame_.left - 36);
  svg_ += "<text class=\"middle\" transform=\"translate(" + x + " " + y + ") rotate(-90)\">" + y_.label + "</text>\n";
}

void PlotPanel::title(const std::string &text) {
  svg_ += text_at("title", pixel(frame_.left), pixel(frame_.top - 12), text);
}

void PlotPanel::mark(double x, const std::string &at_bottom, const std::string &at_top) {
  svg_ += line("mark", pixel_x(x), pixel(frame_.top), pixel_x(x), pixel(frame_.top + frame_.height));
  const double across = frame_.left + (x - x_.first) / (x_.last - x_.first) * frame_.width;
  const auto upwards = [&](const char *anchor, double left, double y, const std::string &text) {
    if (!text.empty())
      svg_ += std::string("<text class=\"note ") + anchor + "\" transform=\"translate(" + pixel(left) + " " + pixel(y) +
              ") rotate(-90)\">" + text + "</text>\n";
  };
  upwards("start", across - 4, frame_.top + frame_.height - 6, at_bottom);
  upwards("end", across + 12, frame_.top + 2, at_top);
}

void PlotPanel::curve(const std::vector<PlotPoint> &points, const std::string &colour, PlotStroke stroke) {
  svg_ += std::string("<polyline class=\"") + stroke_class(stroke) + "\" stroke=\"" + colour + "\" points=\"";
  for (size_t k = 0; k < points.size(); ++k) {
    if (k > 0) svg_ += ' ';
    svg_ += pixel_x(points[k].x) + "," + pixel_y(points[k].y);
  }
  svg_ += "\"/>\n";
}

void PlotPanel::dot(PlotPoint point, const std::string &colour, bool filled) {
  svg_ += "<circle cx=\"" + pixel_x(point.x) + "\" cy=\"" + pixel_y(point.y) + "\" r=\"3.5\" fill=\"" +
          (filled ? colour : "#ffffff") + "\" stroke=\"" + colour + "\" stroke-width=\"1.5\"/>\n";
}

void PlotPanel::legend(PlotPoint place, int row, const std::string &text, const std::string &colour,
                       PlotStroke stroke) {
  const double x = frame_.left + (place.x - x_.first) / (x_.last - x_.first) * frame_.width;
  const double y = frame_.top + (y_.last - place.y) / (y_.last - y_.first) * frame_.height + 16 * row;
  svg_ += line(stroke_class(stroke), pixel(x), pixel(y - 4), pixel(x + 22), pixel(y - 4), colour);
  svg_ += text_at("note", pixel(x + 28), pixel(y), text);
}

std::string svg_file(double width, double height, const std::string &description,
                     const std::vector<PlotPanel> &panels) {
  const std::string w = pixel(width);
  const std::string h = pixel(height);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
                    "\" viewBox=\"0 0 " + w + " " + h + "\" role=\"img\">\n<title>" + description + "</title>\n";
  svg +=
      "<style>\n"
      "text { font: 12px sans-serif; fill: #222222 }\n"
      ".title { font-size: 14px; font-weight: bold }\n"
      ".middle { text-anchor: middle }\n"
      ".end { text-anchor: end }\n"
      ".note { font-size: 11px; fill: #444444 }\n"
      "line, polyline { fill: none }\n"
      ".axis { stroke: #222222 }\n"
      ".grid { stroke: #e4e4e4 }\n"
      ".mark { stroke: #888888; stroke-dasharray: 2 3 }\n"
      ".thick { stroke-width: 2.4 }\n"
      ".thin { stroke-width: 1.4 }\n"
      ".dashed { stroke-width: 1.4; stroke-dasharray: 6 4 }\n"
      "</style>\n";
  svg += "<rect width=\"" + w + "\" height=\"" + h + "\" fill=\"#ffffff\"/>\n";
  for (const PlotPanel &panel : panels) svg += "<g>\n" + panel.svg() + "</g>\n";
  return svg + "</svg>\n";
}
