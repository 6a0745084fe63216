#include "raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace {

std::string contents_of(const std::filesystem::path &file) {
  std::ifstream input(file, std::ios::binary);
  if (!input) throw std::runtime_error("no file " + file.string());
  return {std::istreambuf_iterator<char>(input), {}};
}

int largest_step(const uint8_t *a, const uint8_t *b) {
  int step = 0;
  for (int k = 0; k < 3; ++k) step = std::max(step, std::abs(a[k] - b[k]));
  return step;
}

bool has_near(const Raster &picture, size_t x, size_t y, const uint8_t *pixel) {
  for (size_t v = y > 0 ? y - 1 : 0; v <= y + 1 && v < picture.height; ++v) {
    for (size_t u = x > 0 ? x - 1 : 0; u <= x + 1 && u < picture.width; ++u) {
      if (largest_step(picture.pixel(u, v), pixel) <= 64) return true;
    }
  }
  return false;
}

}  // namespace

Raster read_ppm(const std::string &bytes) {
  Raster raster;
  unsigned most = 0;
  int read = 0;
  if (std::sscanf(bytes.c_str(), "P6 %zu %zu %u%n", &raster.width, &raster.height, &most, &read) != 3) {
    // Ghostscript writes a comment.
    if (std::sscanf(bytes.c_str(), "P6 #%*[^\n] %zu %zu %u%n", &raster.width, &raster.height, &most, &read) != 3) {
      throw std::runtime_error("no PPM");
    }
  }
  const size_t first = static_cast<size_t>(read) + 1;
  if (most != 255 || bytes.size() != first + 3 * raster.width * raster.height) throw std::runtime_error("PPM: size");
  raster.rgb.assign(bytes.begin() + static_cast<ptrdiff_t>(first), bytes.end());
  return raster;
}

RasterDifference difference(const Raster &a, const Raster &b) {
  const size_t width = std::min(a.width, b.width);
  const size_t height = std::min(a.height, b.height);
  if (std::max(a.width, b.width) > width + 1 || std::max(a.height, b.height) > height + 1) {
    throw std::runtime_error("pictures of different sizes");
  }
  double sum = 0;
  double far = 0;
  double displaced = 0;
  for (size_t y = 0; y < height; ++y) {
    for (size_t x = 0; x < width; ++x) {
      const uint8_t *p = a.pixel(x, y);
      const uint8_t *q = b.pixel(x, y);
      for (int k = 0; k < 3; ++k) sum += std::abs(p[k] - q[k]);
      if (largest_step(p, q) > 96) ++far;
      if (!has_near(b, x, y, p) || !has_near(a, x, y, q)) ++displaced;
    }
  }
  const auto pixels = static_cast<double>(width * height);
  return {sum / (3 * pixels), far / pixels, displaced / pixels};
}

Raster averaged(const Raster &large, size_t factor) {
  Raster small;
  small.width = large.width / factor;
  small.height = large.height / factor;
  small.rgb.reserve(3 * small.width * small.height);
  const size_t count = factor * factor;
  for (size_t y = 0; y < small.height; ++y) {
    for (size_t x = 0; x < small.width; ++x) {
      size_t sum[3] = {count / 2, count / 2, count / 2};
      for (size_t k = 0; k < count; ++k) {
        const uint8_t *pixel = large.pixel(x * factor + k % factor, y * factor + k / factor);
        for (int c = 0; c < 3; ++c) sum[c] += pixel[c];
      }
      for (const size_t value : sum) small.rgb.push_back(static_cast<uint8_t>(value / count));
    }
  }
  return small;
}

bool has_program(const std::string &name) {
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

std::string run_on(const std::string &contents, const std::string &input, const std::string &command,
                   const std::string &output) {
  std::string pattern = (std::filesystem::temp_directory_path() / "hardsphere-picture-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder");
  const std::filesystem::path folder = pattern;
  std::ofstream(folder / input, std::ios::binary) << contents;
  const int status = std::system(("cd '" + folder.string() + "' && " + command + " 2>errors").c_str());
  const std::string errors = contents_of(folder / "errors");
  std::string result;
  if (status == 0 && !output.empty()) result = contents_of(folder / output);
  std::filesystem::remove_all(folder);
  if (status != 0 || !errors.empty()) throw std::runtime_error(command + ": " + errors);
  return result;
}
