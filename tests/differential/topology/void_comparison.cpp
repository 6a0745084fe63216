#include "void_comparison.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "cell_comparison.hpp"
#include "cell_pairs.hpp"
#include "finding.hpp"
#include "random_balls.hpp"

namespace {

using oracle::Balls;
using oracle::Box;
using oracle::FloodFill;
using oracle::LatticePoint;
using Region = FloodFill::Region;

// Larger by a margin on all sides, with its low corner on columns of any width that divides the coarse one.
Box widened(const Box &box, int64_t margin, const LatticePoint &origin, int64_t grid) {
  Box result = box;
  for (size_t k = 0; k < 3; ++k) {
    const int64_t steps = (box.low[k] - margin - origin[k]) / grid - 1;
    result.low[k] = origin[k] + steps * grid;
    result.high[k] += margin;
  }
  return result;
}

Balls balls_meeting_box(const Balls &balls, const Box &box) {
  Balls result;
  for (const oracle::LatticeBall &b : balls) {
    const LatticePoint centre = oracle::centre_of(b);
    bool near = true;
    for (size_t k = 0; k < 3; ++k)
      near = near && centre[k] + b.radius >= box.low[k] && centre[k] - b.radius <= box.high[k];
    if (near) result.push_back(b);
  }
  return result;
}

void include(Box &box, const Box &other) {
  for (size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(box.low[k], other.low[k]);
    box.high[k] = std::max(box.high[k], other.high[k]);
  }
}

class Comparison {
 public:
  Comparison(const Balls &balls, const VoidSettings &settings)
      : balls_(balls),
        settings_(settings),
        topology_(balls),
        cells_(topology_.cells()),
        shells_(topology_.shells()),
        complex_(balls),
        whole_(oracle::box_around(balls, 2 * settings.coarse)),
        coarse_(balls, whole_, settings.coarse) {}

  VoidFindings result() {
    finding_.require(cells_.size() == complex_.cells(), cells_.size() - 1, "voids instead of", complex_.cells() - 1);
    const std::string lists = cell_balls_disagree(topology_, complex_);
    finding_.require(lists.empty(), lists);
    locate_regions();
    locate_samples();
    for (uint32_t cell = 1; cell < cells_.size() && !finding_.any(); ++cell) bound_void(cell);
    findings_.regions = coarse_.certain().size();
    findings_.voids = cells_.size() - 1;
    for (const hsp_region &cell : cells_) findings_.volume += static_cast<long double>(cell.volume);
    findings_.wrong = finding_.text();
    return findings_;
  }

 private:
  // The cell of a free point by the library, which is the dual complex's too.
  uint32_t compared_cell(const LatticePoint &point) {
    const uint32_t cell = topology_.cell_of(point);
    finding_.require(cell < cells_.size(), "a free point is located in no cell:", text_of(point));
    const uint32_t expected = complex_.cell_of(point[0], point[1], point[2]);
    finding_.require(pairs_.pair(cell, expected), "the point", text_of(point), "is located in cell", cell);
    return cell;
  }

  void locate_regions() {
    for (const Region &region : coarse_.certain()) {
      cell_of_region_.push_back(compared_cell(region.point));
      finding_.require(cell_of_region_.back() == 0 || !region.reaches_border, "the outside is located in cell",
                       cell_of_region_.back());
    }
  }

  // All points of a certain region lie in one cell.
  void locate_samples() {
    const std::vector<FloodFill::Sample> samples = coarse_.certain_samples();
    oracle::RandomSource random(61);
    for (int k = 0; k < settings_.samples; ++k) {
      const FloodFill::Sample &sample =
          samples[static_cast<size_t>(random.in(0, static_cast<int64_t>(samples.size()) - 1))];
      finding_.require(compared_cell(sample.point) == cell_of_region_[sample.region], "the point",
                       text_of(sample.point), "is not where others of its region are");
    }
  }

  [[nodiscard]] std::optional<Box> extent_of(uint32_t cell) const {
    std::optional<Box> box;
    for (size_t r = 0; r < coarse_.certain().size(); ++r) {
      if (cell_of_region_[r] != cell) continue;
      if (!box) box = coarse_.certain()[r].extent;
      include(*box, coarse_.certain()[r].extent);
    }
    return box;
  }

  void bound_void(uint32_t cell) {
    std::optional<Box> box = extent_of(cell);
    if (!box) {
      const double *point = shells_[cells_[cell].enclosing_shell].point;
      box.emplace();
      for (size_t k = 0; k < 3; ++k) box->low[k] = box->high[k] = static_cast<int64_t>(point[k]);
    }
    for (const int64_t side : settings_.fine)
      if (bounded_in(*box, side, cell)) return;
  }

  // Is the void closed off by columns of this width, alone if these are not the narrowest? Then its volume is
  // compared.
  bool bounded_in(const Box &box, int64_t side, uint32_t cell) {
    const Box local = widened(box, settings_.margin, whole_.low, settings_.coarse);
    const FloodFill fill(balls_meeting_box(balls_, local), local, side);
    std::optional<uint32_t> around;
    for (const Region &region : fill.certain()) {
      if (fill.perhaps()[region.perhaps].reaches_border || region.perhaps == around) continue;
      if (topology_.cell_of(region.point) == cell) {
        finding_.require(!around, "void", cell, "lies in two regions that are proved to be separate");
        around = region.perhaps;
      }
    }
    if (!around) return false;
    std::set<uint32_t> cells;
    std::map<uint32_t, long double> least;
    for (const Region &region : fill.certain()) {
      if (region.perhaps != *around) continue;
      const uint32_t other = topology_.cell_of(region.point);
      finding_.require(other != 0 && other < cells_.size(), "a point of a void is located in cell", other);
      if (finding_.any()) return true;
      cells.insert(other);
      least[other] += region.volume;
    }
    long double sum = 0;
    for (const uint32_t other : cells) sum += static_cast<long double>(cells_[other].volume);
    const long double most = fill.perhaps()[*around].volume;
    const long double width = (most - least[cell]) / most;
    if ((cells.size() > 1 || width > settings_.width) && side != settings_.fine.back()) return false;
    ++findings_.bounded;
    findings_.bounded_volume += static_cast<long double>(cells_[cell].volume);
    findings_.told_apart += cells.size() == 1 ? 1 : 0;
    const long double rounding = 1e-9L * sum + 1;
    for (const auto &[other, volume] : least)
      finding_.require(static_cast<long double>(cells_[other].volume) >= volume - rounding, "void", other,
                       "has the volume", cells_[other].volume, "but holds columns of", static_cast<double>(volume));
    finding_.require(sum <= most + rounding, "void", cell, "and those beside it have the volume",
                     static_cast<double>(sum), "in a space of", static_cast<double>(most));
    if (most > settings_.large) findings_.widest = std::max(findings_.widest, width);
    return true;
  }

  static std::string text_of(const LatticePoint &point) {
    return std::to_string(point[0]) + " " + std::to_string(point[1]) + " " + std::to_string(point[2]);
  }

  const Balls &balls_;
  const VoidSettings &settings_;
  LibraryTopology topology_;
  std::vector<hsp_region> cells_;
  std::vector<hsp_shell> shells_;
  oracle::DualComplex complex_;
  CellPairs pairs_;
  Box whole_;
  FloodFill coarse_;
  std::vector<uint32_t> cell_of_region_;
  VoidFindings findings_;
  Finding finding_;
};

}  // namespace

VoidFindings compare_voids(const Balls &balls, const VoidSettings &settings) {
  return Comparison(balls, settings).result();
}
