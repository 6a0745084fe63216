// The inside of the handle hsp_pores.
#pragma once

#include "hsp_model.hpp"
#include "hsp_periodic.hpp"
#include "pockets/pore_questions.hpp"
#include "source.hpp"

struct hsp_pores {
  using Builder = hsp::PoreQuestions;
  static constexpr auto kind = hsp::capi::HandleKind::pores;
  using Given = hsp_pores_limits;
  using Limits = hsp::capi::LimitFields<hsp::PoreQuestionLimits, Given, offsetof(Given, balls), offsetof(Given, maxima),
                                        offsetof(Given, gates), offsetof(Given, tied), offsetof(Given, candidates),
                                        offsetof(Given, neighbours), offsetof(Given, points)>;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_model> model{};
  hsp::capi::Source<hsp_periodic> periodic{};
  bool complete = false;
  bool in_box = false;       // whether the pores are those of a periodic box, else of a model
  int64_t narrow_steps = 0;  // the narrow probe of the pockets, rounded up

  // Whether results may be read: computed, and the model or box unchanged since.
  bool has_results() const { return complete && (in_box ? periodic.is_unchanged() : model.is_unchanged()); }
  hsp::Span<const hsp::PoreMaximum> maxima() const { return builder.pores().maxima(); }
  hsp::Span<const hsp::PoreGate> gates() const { return builder.pores().gates(); }
  uint32_t ball_count() const { return in_box ? periodic->balls() : model->balls().n; }
  const hsp::exact::Lattice &lattice() const { return in_box ? periodic->lattice() : model->balls().lattice; }
  // For questions about points.
  hsp::BallsAround balls_around() const {
    return in_box ? hsp::BallsAround(periodic->builder) : hsp::BallsAround(model->grid);
  }
  // A shift in multiples of the given vectors of the box; 0 without a box.
  hsp::BoxShift given(const hsp::BoxShift &shift) const {
    return in_box ? periodic->builder.images().box().in_given_vectors(shift) : shift;
  }
  // For an image the shift by which the caller's ball has to be moved.
  hsp::BoxShift image_shift(uint32_t ball, const hsp::BoxShift &shift) const {
    return in_box && ball != hsp::no_id ? given(shift - periodic->builder.images().home(ball)) : hsp::BoxShift{};
  }
  hsp::BoxShift image_shift(uint32_t ball, const hsp::SmallShift &shift) const {
    return image_shift(ball, shift.shift());
  }
};
