#include "peers/nanoflann_search.hpp"

#include <algorithm>
#include <cstddef>
#include <nanoflann.hpp>

namespace bench {
namespace {

// The centres as nanoflann reads them.
struct Centres {
  const support::BallList *balls;
  size_t kdtree_get_point_count() const { return balls->size(); }
  double kdtree_get_pt(size_t i, size_t axis) const { return balls->xyz[3 * i + axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box &) const {
    return false;
  }
};

// Takes the points that nanoflann finds within reach, and tests each with its own radius.
class Meeting {
 public:
  Meeting(const support::BallList &balls, double radius, double reach, Hits &hits)
      : balls_(&balls), radius_(radius), worst_(reach * reach), hits_(&hits) {}

  bool addPoint(double square, uint32_t i) {
    const double sum = balls_->radius[i] + radius_;
    hits_->ids[std::min(hits_->count, hits_->capacity - 1)] = i;
    hits_->count += square <= sum * sum ? 1 : 0;
    return true;
  }
  double worstDist() const { return worst_; }
  bool full() const { return true; }

 private:
  const support::BallList *balls_;
  double radius_;
  double worst_;
  Hits *hits_;
};

}  // namespace

struct NanoflannSearch::Tree {
  using Index =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Centres>, Centres, 3, uint32_t>;

  explicit Tree(const support::BallList &list)
      : balls(&list),
        largest(*std::max_element(list.radius.begin(), list.radius.end())),
        centres{&list},
        index(3, centres, nanoflann::KDTreeSingleIndexAdaptorParams(10)) {}

  const support::BallList *balls;
  double largest;
  Centres centres;
  Index index;
};

NanoflannSearch::NanoflannSearch() = default;
NanoflannSearch::~NanoflannSearch() = default;

void NanoflannSearch::build(const support::BallList &balls) {
  tree_ = std::make_unique<Tree>(balls);
}

void NanoflannSearch::meeting(const double *centre, double radius, Hits &hits) const {
  const double reach = (radius + tree_->largest) * (1 + 1e-12);  // larger: it leaves out points exactly at reach
  Meeting result(*tree_->balls, radius, reach, hits);
  tree_->index.findNeighbors(result, centre, nanoflann::SearchParams());
}

std::string nanoflann_release() {
  // Hexadecimal: major, minor and patch, a digit each.
  constexpr int version = NANOFLANN_VERSION;
  return std::to_string(version >> 8) + '.' + std::to_string(version >> 4 & 15) + '.' + std::to_string(version & 15);
}

}  // namespace bench
