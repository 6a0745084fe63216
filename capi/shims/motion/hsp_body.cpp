#include "hsp_body.hpp"

#include <type_traits>

#include "caller_executor.hpp"
#include "hsp_model.hpp"
#include "poses/pose_queries.hpp"

using namespace hsp::capi;

namespace {

// The type of pose that is made of the numbers of a type.
template <class Numbers>
using PoseOf = std::conditional_t<std::is_same_v<Numbers, hsp_pose>, hsp::Pose, hsp::RationalPose>;

template <class Numbers>
int32_t make_pose(const hsp_body *posed, const Numbers &numbers, PoseOf<Numbers> &pose) {
  return to_c(hsp::make_pose(posed->tree, numbers.quaternion, numbers.translation, pose));
}

int32_t check_bodies(const hsp_body *fixed, const hsp_body *posed, bool bad) {
  const int32_t refused = first_failure(check_handle(fixed), check_handle(posed, bad));
  if (refused != HSP_OK) return refused;
  if (!fixed->has_results() || !posed->has_results()) return HSP_E_STATE;
  return fixed->tree.lattice().step() == posed->tree.lattice().step() ? HSP_OK : HSP_E_ARGUMENT;
}

// Checks all poses before anything is written, then calls answer(k, pose) for each.
template <class Numbers, class Answer>
int32_t for_each_pose(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const Numbers *numbers,
                      const void *out, uint32_t *first_bad, Answer answer) {
  const bool bad = poses > 0 && (numbers == nullptr || out == nullptr);
  if (const int32_t status = name_none(check_bodies(fixed, posed, bad), first_bad); status != HSP_OK) return status;
  PoseOf<Numbers> pose;
  for (uint32_t k = 0; k < poses; ++k) {
    const int32_t status = make_pose(posed, numbers[k], pose);
    if (status == HSP_OK) continue;
    if (first_bad != nullptr) *first_bad = k;
    return status;
  }
  for (uint32_t k = 0; k < poses; ++k) {
    static_cast<void>(make_pose(posed, numbers[k], pose));
    answer(k, pose);
  }
  return HSP_OK;
}

template <class Numbers>
int32_t find_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const Numbers *pose, uint32_t *hit,
                  uint32_t *first_bad) {
  hsp::PairRanks witness;
  return for_each_pose(fixed, posed, poses, pose, hit, first_bad, [&](uint32_t k, const auto &at) {
    hit[k] = hsp::any_balls_meet(fixed->tree, posed->tree, at, witness) ? 1 : 0;
  });
}

template <class Numbers>
int32_t find_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const Numbers *pose,
                        double margin, uint32_t *hit, uint32_t *first_bad) {
  const bool bad = poses > 0 && (pose == nullptr || hit == nullptr);
  if (const int32_t status = name_none(check_bodies(fixed, posed, bad), first_bad); status != HSP_OK) return status;
  if (!hsp::is_finite(margin)) return HSP_E_NOT_FINITE;
  if (margin < 0.0) return HSP_E_RANGE;
  hsp::GapBudget known(fixed->tree.lattice().steps(margin));
  return for_each_pose(fixed, posed, poses, pose, hit, first_bad, [&](uint32_t k, const auto &at) {
    hit[k] = hsp::any_balls_meet(fixed->tree, posed->tree, at, known) ? 1 : 0;
  });
}

template <class Numbers>
int32_t find_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const Numbers *pose, hsp_body_gap *gap,
                  uint32_t *first_bad) {
  hsp::PairRanks witness;
  return for_each_pose(fixed, posed, poses, pose, gap, first_bad, [&](uint32_t k, const auto &at) {
    const hsp::PairGap found = hsp::least_gap(fixed->tree, posed->tree, at, witness);
    gap[k] = {fixed->tree.lattice().length(found.gap), found.fixed, found.moving};
  });
}

template <class Numbers>
int32_t list_pairs(const hsp_body *fixed, const hsp_body *posed, const Numbers *pose, uint32_t *pair, uint32_t capacity,
                   uint32_t *needed) {
  const bool bad = pose == nullptr || (pair == nullptr && capacity > 0);
  if (const int32_t refused = check_bodies(fixed, posed, bad); refused != HSP_OK) return refused;
  PoseOf<Numbers> at;
  if (const int32_t status = make_pose(posed, *pose, at); status != HSP_OK) return status;
  // Two walks: the first counts, as nothing is written to `pair` unless all pairs fit.
  const uint32_t count = hsp::clamped_count(hsp::list_meeting_pairs(fixed->tree, posed->tree, at, {}));
  if (count == hsp::no_id) return HSP_E_RANGE;
  const int32_t status = check_output(capacity, count, needed);
  if (status != HSP_OK) return status;
  hsp::list_meeting_pairs(fixed->tree, posed->tree, at, {reinterpret_cast<hsp::MeetingPair *>(pair), count});
  return HSP_OK;
}

}  // namespace

int32_t hsp_body_bytes(uint32_t balls, size_t *bytes) {
  if (bytes == nullptr) return HSP_E_ARGUMENT;
  if (balls > HSP_MAX_BALLS) return HSP_E_RANGE;
  return get_bytes<hsp_body>(balls, bytes);
}

int32_t hsp_body_init(void *memory, size_t bytes, uint32_t balls, hsp_body **body) {
  if (memory == nullptr || body == nullptr) return HSP_E_ARGUMENT;
  if (balls > HSP_MAX_BALLS) return HSP_E_RANGE;
  return init(memory, bytes, balls, body);
}

int32_t hsp_body_set(hsp_body *body, const hsp_model *model) {
  return hsp_body_set_with(body, model, nullptr);
}

int32_t hsp_body_set_with(hsp_body *body, const hsp_model *model, const hsp_body_request *request) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_handle(body); status != HSP_OK) return status;
  body->tree.clear();
  body->complete = false;
  hsp_body_request asked;
  Executor executor(arithmetic);
  if (const int32_t status = read_for_results(model, request, asked, executor); status != HSP_OK) return status;
  const hsp::Status status = body->tree.build(model->balls(), hsp::Patience(&executor));
  body->complete = status == hsp::Status::ok;
  return to_c(status);
}

int32_t hsp_pose_from_matrix(const double *matrix, const double *translation, hsp_pose *pose) {
  LibraryArithmetic arithmetic;
  if (matrix == nullptr || translation == nullptr || pose == nullptr) return HSP_E_ARGUMENT;
  hsp_pose found;
  const hsp::Status status = hsp::quaternion_of_rotation(matrix, found.quaternion);
  if (status != hsp::Status::ok) return to_c(status);
  for (int k = 0; k < 3; ++k) {
    if (!hsp::is_finite(translation[k])) return HSP_E_NOT_FINITE;
    found.translation[k] = translation[k];
  }
  *pose = found;
  return HSP_OK;
}

int32_t hsp_body_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose, uint32_t *hit,
                      uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  return find_hits(fixed, posed, poses, pose, hit, first_bad);
}

int32_t hsp_body_rational_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses,
                               const hsp_rational_pose *pose, uint32_t *hit, uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  return find_hits(fixed, posed, poses, pose, hit, first_bad);
}

int32_t hsp_body_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
                            double margin, uint32_t *hit, uint32_t *first_bad) {
  LibraryArithmetic arithmetic(margin);
  return find_hits_along(fixed, posed, poses, pose, margin, hit, first_bad);
}

int32_t hsp_body_rational_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses,
                                     const hsp_rational_pose *pose, double margin, uint32_t *hit, uint32_t *first_bad) {
  LibraryArithmetic arithmetic(margin);
  return find_hits_along(fixed, posed, poses, pose, margin, hit, first_bad);
}

int32_t hsp_body_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
                      hsp_body_gap *gap, uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  return find_gaps(fixed, posed, poses, pose, gap, first_bad);
}

int32_t hsp_body_rational_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses,
                               const hsp_rational_pose *pose, hsp_body_gap *gap, uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  return find_gaps(fixed, posed, poses, pose, gap, first_bad);
}

int32_t hsp_body_overlaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses, const hsp_pose *pose,
                          hsp_body_overlap *overlap, uint32_t *first_bad) {
  LibraryArithmetic arithmetic;
  return for_each_pose(fixed, posed, poses, pose, overlap, first_bad, [&](uint32_t k, const hsp::Pose &at) {
    const hsp::Overlap found = hsp::sum_overlaps(fixed->tree, posed->tree, at);
    overlap[k] = {fixed->tree.lattice().volume(found.volume), hsp::clamped_count(found.pairs), 0};
  });
}

int32_t hsp_body_pairs(const hsp_body *fixed, const hsp_body *posed, const hsp_pose *pose, uint32_t *pair,
                       uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return list_pairs(fixed, posed, pose, pair, capacity, needed);
}

int32_t hsp_body_rational_pairs(const hsp_body *fixed, const hsp_body *posed, const hsp_rational_pose *pose,
                                uint32_t *pair, uint32_t capacity, uint32_t *needed) {
  LibraryArithmetic arithmetic;
  return list_pairs(fixed, posed, pose, pair, capacity, needed);
}
