// The inside of the handle hsp_sticks.
#pragma once

#include "hsp_model.hpp"
#include "maps/stick_view_builder.hpp"

struct hsp_sticks : hsp::capi::FromModel<hsp::StickViewBuilder> {
  static constexpr auto kind = hsp::capi::HandleKind::sticks;
  using Given = hsp_sticks_limits;
  using Limits = hsp::capi::LimitFields<hsp::StickLimits, Given, offsetof(Given, balls), offsetof(Given, sticks),
                                        offsetof(Given, pairs), offsetof(Given, edges)>;

  bool has_map() const { return has_results() && map().exist; }
  const hsp::StickMap &map() const { return builder.map(); }
  auto sight() const { return builder.sight(); }
  // The number of balls, and of halves of sticks, two for each.
  uint32_t bodies() const { return balls().n + 2 * structure().sticks.size(); }
  // The caller's number of a ball or half of a stick.
  uint32_t caller(uint32_t body) const {
    const uint32_t n = balls().n;
    if (body == hsp::no_id) return HSP_NONE;
    if (body < n) return balls().caller[body];
    const hsp::Stick &stick = structure().sticks[(body - n) / 2];
    return n + 2 * stick.caller + stick.half_of((body - n) % 2);
  }
  uint32_t first_face_of(uint32_t number) const { return map().first_face_of(body(number)); }
  // Whether another handle has the same sticks, which may be moved a little.
  bool has_same_sticks(const hsp_sticks &other) const {
    const hsp::Span<const hsp::Stick> mine = structure().sticks.items(), others = other.structure().sticks.items();
    if (mine.size() != others.size()) return false;
    for (uint32_t k = 0; k < mine.size(); ++k) {
      const hsp::Stick &a = mine[k], &b = others[k];
      const bool same = a.radius == b.radius && a.ball[a.turned] == b.ball[b.turned] &&
                        a.ball[1 - a.turned] == b.ball[1 - b.turned] &&
                        (a.owner[0] == a.owner[1]) == (b.owner[0] == b.owner[1]);
      if (!same) return false;
    }
    return true;
  }
  // The body with a number of the caller's. The second half of a whole stick is not seen.
  uint32_t body(uint32_t number) const {
    const uint32_t n = balls().n;
    if (number < n) return model->grid.grid_index(number);
    const hsp::Stick &stick = structure().sticks[(number - n) / 2];
    const uint32_t half = (number - n) % 2;
    return number - half + (stick.parts == 2 ? half ^ stick.turned : half);
  }
};
