// The objects of a file of pictures, found through its table, and the paths of its one page.
#include <array>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include "picture_paths.hpp"

namespace {

// The text between "n 0 obj" and "endobj", looked up as a reader of PDF does it.
std::string object(const std::string &text, unsigned number) {
  const size_t last = text.rfind("startxref\n");
  if (last == std::string::npos) throw std::runtime_error("pdf: no startxref");
  const size_t table = std::stoul(text.substr(last + 10));
  unsigned first = 0;
  unsigned count = 0;
  int read = 0;
  if (table >= text.size() || std::sscanf(text.c_str() + table, "xref\n%u %u\n%n", &first, &count, &read) != 2) {
    throw std::runtime_error("pdf: no table where startxref says");
  }
  if (first != 0 || number >= count) throw std::runtime_error("pdf: an object beyond the table");
  const std::string entry = text.substr(table + static_cast<size_t>(read) + 20 * number, 20);
  if (entry.substr(10) != " 00000 n \n") throw std::runtime_error("pdf: an entry that is not 20 bytes long");
  const size_t offset = std::stoul(entry.substr(0, 10));
  const std::string head = std::to_string(number) + " 0 obj\n";
  if (text.compare(offset, head.size(), head) != 0) throw std::runtime_error("pdf: object " + head + "is not there");
  const size_t begin = offset + head.size();
  return text.substr(begin, text.find("\nendobj\n", begin) - begin);
}

// From coordinates in use to px of the page.
using Matrix = std::array<double, 6>;

Matrix before(const std::vector<double> &first, const Matrix &then) {
  if (first.size() != 6) throw std::runtime_error("pdf: cm");
  Matrix both{};
  for (size_t row = 0; row < 3; ++row) {
    for (size_t k = 0; k < 2; ++k) {
      both[2 * row + k] = first[2 * row] * then[k] + first[2 * row + 1] * then[2 + k] + (row == 2 ? then[4 + k] : 0);
    }
  }
  return both;
}
PagePoint place(const Matrix &matrix, double x, double y) {
  return {x * matrix[0] + y * matrix[2] + matrix[4], x * matrix[1] + y * matrix[3] + matrix[5]};
}

void add(PaintedPath &path, const Segment &segment) {
  if (path.loops.empty() || path.loops.back().closed) throw std::runtime_error("pdf: no current point");
  path.loops.back().segments.push_back(segment);
}

}  // namespace

PictureFile read_pdf(const std::string &text) {
  PictureFile file;
  if (!text.starts_with("%PDF-1.4\n") || !text.ends_with("%%EOF\n")) throw std::runtime_error("pdf: head or tail");
  if (object(text, 1).find("/Type/Catalog") == std::string::npos) throw std::runtime_error("pdf: no catalogue");
  const std::string page = object(text, 3);
  const size_t box = page.find("/MediaBox[");
  if (box == std::string::npos ||
      std::sscanf(page.c_str() + box, "/MediaBox[0 0 %lf %lf]", &file.width, &file.height) != 2) {
    throw std::runtime_error("pdf: no box");
  }
  file.width /= 0.75;
  file.height /= 0.75;
  const std::string contents = object(text, 5);
  const size_t start = contents.find("stream\n") + 7;
  const size_t length = std::stoul(object(text, 6));
  if (contents.substr(start + length) != "endstream") throw std::runtime_error("pdf: the stream's length is wrong");

  std::istringstream input(contents.substr(start, length));
  std::vector<double> stack;
  Matrix matrix = {1 / 0.75, 0, 0, 1 / 0.75, 0, 0};
  std::vector<Matrix> kept;
  PagePoint here{};
  PaintedPath path;
  for (std::string word; input >> word;) {
    char *end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (*end == '\0') {
      stack.push_back(value);
      continue;
    }
    if (word == "q") {
      kept.push_back(matrix);
    } else if (word == "Q") {
      if (kept.empty()) throw std::runtime_error("pdf: Q without q");
      matrix = kept.back();
      kept.pop_back();
    } else if (word == "cm") {
      matrix = before(stack, matrix);
    } else if (word == "m") {
      if (stack.size() != 2) throw std::runtime_error("pdf: m");
      path.loops.push_back({});
      path.loops.back().start = here = place(matrix, stack[0], stack[1]);
    } else if (word == "c") {
      if (stack.size() != 6) throw std::runtime_error("pdf: c");
      Segment cubic;
      cubic.kind = Segment::Kind::cubic;
      cubic.start = here;
      cubic.handle = {place(matrix, stack[0], stack[1]), place(matrix, stack[2], stack[3])};
      cubic.end = here = place(matrix, stack[4], stack[5]);
      add(path, cubic);
    } else if (word == "l") {
      if (stack.size() != 2) throw std::runtime_error("pdf: l");
      Segment line;
      line.kind = Segment::Kind::line;
      line.start = here;
      line.end = here = place(matrix, stack[0], stack[1]);
      add(path, line);
    } else if (word == "h") {
      path.loops.back().closed = true;
    } else if (word == "B" || word == "f" || word == "W") {
      path.paint = word;
      if (!path.loops.empty()) file.paths.push_back(path);  // the background is a rectangle
      path = {};
    } else if (word == "S") {
      file.lines.push_back(path);
      path = {};
    }
    stack.clear();
  }
  if (!kept.empty()) throw std::runtime_error("pdf: q without Q");
  return file;
}
