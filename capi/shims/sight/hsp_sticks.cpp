#include "hsp_sticks.hpp"

#include <initializer_list>

#include "compute_from.hpp"
#include "view_options.hpp"

using namespace hsp::capi;

namespace {

static_assert(static_cast<uint32_t>(hsp::StickConflict::none) == HSP_STICKS_NO_CONFLICT &&
              static_cast<uint32_t>(hsp::StickConflict::balls_meet) == HSP_STICKS_BALLS_MEET &&
              static_cast<uint32_t>(hsp::StickConflict::no_ball) == HSP_STICKS_NO_BALL &&
              static_cast<uint32_t>(hsp::StickConflict::same_ends) == HSP_STICKS_SAME_ENDS &&
              static_cast<uint32_t>(hsp::StickConflict::thin_ball) == HSP_STICKS_THIN_BALL &&
              static_cast<uint32_t>(hsp::StickConflict::sharp_angle) == HSP_STICKS_SHARP_ANGLE &&
              static_cast<uint32_t>(hsp::StickConflict::sticks_meet) == HSP_STICKS_MEET &&
              static_cast<uint32_t>(hsp::StickConflict::stick_in_ball) == HSP_STICKS_STICK_IN_BALL &&
              static_cast<uint32_t>(hsp::StickConflict::cycle) == HSP_STICKS_CYCLE);

bool are_valid(const hsp_stick *stick, uint32_t count) {
  if (stick == nullptr) return count == 0;
  for (uint32_t k = 0; k < count; ++k) {
    if (stick[k].reserved != 0) return false;
    switch (stick[k].flags & ~HSP_STICK_WHOLE) {
      case 0:
      case HSP_STICK_DOUBLE:
      case HSP_STICK_TRIPLE:
      case HSP_STICK_AROMATIC:
        break;
      default:
        return false;
    }
  }
  return true;
}

hsp::StickStrands strands_of(uint32_t flags) {
  switch (flags & ~HSP_STICK_WHOLE) {
    case HSP_STICK_DOUBLE:
      return hsp::StickStrands::two;
    case HSP_STICK_TRIPLE:
      return hsp::StickStrands::three;
    case HSP_STICK_AROMATIC:
      return hsp::StickStrands::dashed;
    default:
      return hsp::StickStrands::one;
  }
}

// The sticks of one call, and whether a map is wanted even if there is a drawing order.
struct Given {
  const hsp_stick *stick;
  uint32_t count;
  double radius;
  bool as_map;
};

int32_t compute(LibraryArithmetic &arithmetic, hsp_sticks *sticks, const hsp_model *model,
                const hsp_view_options *options, const Given &given, hsp_sticks_conflict *conflict,
                hsp_sticks_limits *limits) {
  const auto check = [&](const hsp_view_options &) {
    return are_valid(given.stick, given.count) ? HSP_OK : HSP_E_ARGUMENT;
  };
  const auto build = [&](const hsp_view_options &wanted, Executor &executor) {
    if (!hsp::is_finite(given.radius)) return hsp::Status::not_finite;
    if (given.radius < 0.0) return hsp::Status::negative;
    if (given.radius == 0.0) return hsp::Status::range;
    sticks->model.set(model);
    const hsp::Status status = sticks->builder.build(
        model->balls(), direction_of(wanted), given.count, model->balls().lattice.steps(given.radius), given.as_map,
        [&given](uint32_t k) {
          const hsp_stick &stick = given.stick[k];
          return hsp::StickEnds{stick.ball[0], stick.ball[1], (stick.flags & HSP_STICK_WHOLE) != 0,
                                strands_of(stick.flags)};
        },
        hsp::Patience(&executor));
    if (conflict != nullptr && (status == hsp::Status::ok || status == hsp::Status::conflict)) {
      const hsp::StickViolation &violation = sticks->builder.violation();
      *conflict = {static_cast<uint32_t>(violation.conflict), violation.first, violation.second, 0};
    }
    return status;
  };
  return compute_from(arithmetic, sticks, model, options, limits, check, build);
}

}  // namespace

HSP_HANDLE_BY_BALLS(hsp_sticks);

int32_t hsp_sticks_compute(hsp_sticks *sticks, const hsp_model *model, const hsp_view_options *options,
                           const hsp_stick *stick, uint32_t count, double radius, hsp_sticks_conflict *conflict,
                           hsp_sticks_limits *limits) {
  LibraryArithmetic arithmetic(radius);
  return compute(arithmetic, sticks, model, options, {stick, count, radius, false}, conflict, limits);
}

int32_t hsp_sticks_compute_map(hsp_sticks *sticks, const hsp_model *model, const hsp_view_options *options,
                               const hsp_stick *stick, uint32_t count, double radius, hsp_sticks_conflict *conflict,
                               hsp_sticks_limits *limits) {
  LibraryArithmetic arithmetic(radius);
  return compute(arithmetic, sticks, model, options, {stick, count, radius, true}, conflict, limits);
}

int32_t hsp_sticks_get_info(const hsp_sticks *sticks, hsp_sticks_info *info) {
  LibraryArithmetic arithmetic;
  if (const int32_t status = check_results(sticks, info == nullptr); status != HSP_OK) return status;
  const hsp::StickView &of = sticks->structure();
  const ViewLengths length{sticks->balls().lattice};
  *info = {};
  put_frame(length, of.frame, *info);
  const hsp::PaintedPaths paths = sticks->builder.paths();
  for (uint32_t p = 0; p < paths.size(); ++p) {
    paths.visit(sticks->balls(), p, hsp::PathPart::outline,
                [info](const hsp::ProjectedArc &, bool, bool) { ++info->arcs; });
    const hsp::StickPath &path = of.paths[p];
    if (path.stick != hsp::no_id) continue;
    const hsp::PlacedBall &ball = of.balls[path.ball];
    const double centre[2] = {length(ball.centre.x), length(ball.centre.y)};
    const double r = length(ball.r);
    for (int k = 0; k < 2; ++k) {
      if (info->balls == 0 || centre[k] - r < info->low[k]) info->low[k] = centre[k] - r;
      if (info->balls == 0 || centre[k] + r > info->high[k]) info->high[k] = centre[k] + r;
    }
    ++info->balls;
  }
  info->paths = of.paths.size();
  info->sticks = of.sticks.size();
  return HSP_OK;
}
