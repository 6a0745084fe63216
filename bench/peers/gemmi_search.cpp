#include "peers/gemmi_search.hpp"

#include <algorithm>
#include <cstddef>
#include <gemmi/neighbor.hpp>
#include <gemmi/version.hpp>
#include <utility>

namespace bench {

struct GemmiSearch::Cells {
  const support::BallList *balls;
  double largest;
  gemmi::Model model{"1"};
  gemmi::NeighborSearch search;
};

GemmiSearch::GemmiSearch() = default;
GemmiSearch::~GemmiSearch() = default;

void GemmiSearch::prepare(const support::BallList &balls) {
  cells_ = std::make_unique<Cells>();
  cells_->balls = &balls;
  cells_->largest = *std::max_element(balls.radius.begin(), balls.radius.end());
  gemmi::Residue residue;
  residue.atoms.resize(balls.size());
  for (size_t i = 0; i < balls.size(); ++i) {
    residue.atoms[i].pos = {balls.xyz[3 * i], balls.xyz[3 * i + 1], balls.xyz[3 * i + 2]};
    residue.atoms[i].element = gemmi::El::C;
  }
  gemmi::Chain chain("A");
  chain.residues.push_back(std::move(residue));
  cells_->model.chains.push_back(std::move(chain));
}

void GemmiSearch::build(double largest_query) {
  // A little more than what is asked for: coordinates are rounded to single precision.
  const double reach = 1.001 * (largest_query + cells_->largest);
  cells_->search = gemmi::NeighborSearch(cells_->model, gemmi::UnitCell(), reach);
  cells_->search.populate();
}

void GemmiSearch::meeting(const double *centre, double radius, Hits &hits) const {
  const support::BallList &balls = *cells_->balls;
  const double x = centre[0], y = centre[1], z = centre[2];
  const float reach = static_cast<float>(1.0005 * (radius + cells_->largest));
  cells_->search.for_each({x, y, z}, '\0', reach, [&](const gemmi::NeighborSearch::Mark &mark, float) {
    const uint32_t i = static_cast<uint32_t>(mark.atom_idx);
    const double dx = balls.xyz[3 * size_t{i}] - x;
    const double dy = balls.xyz[3 * size_t{i} + 1] - y;
    const double dz = balls.xyz[3 * size_t{i} + 2] - z;
    const double sum = balls.radius[i] + radius;
    hits.ids[std::min(hits.count, hits.capacity - 1)] = i;
    hits.count += dx * dx + dy * dy + dz * dz <= sum * sum ? 1 : 0;
  });
}

std::string gemmi_release() {
  return GEMMI_VERSION;
}

}  // namespace bench
