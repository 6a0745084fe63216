// The inside of the handle hsp_pores.
#pragma once

#include "hsp_model.hpp"
#include "pores/pore_questions.hpp"
#include "source.hpp"

struct hsp_pores {
  using Builder = hsp::PoreQuestions;
  static constexpr auto kind = hsp::capi::HandleKind::pores;
  using Given = hsp_pores_limits;
  using Limits = hsp::capi::LimitFields<hsp::PoreQuestionLimits, Given, &Given::balls, &Given::maxima, &Given::gates,
                                        &Given::tied, &Given::candidates, &Given::neighbours, &Given::points>;

  uintptr_t tag;
  Builder builder;
  hsp::capi::Source<hsp_model> model{};
  bool complete = false;

  // Whether results may be read: computed, and the model unchanged since.
  bool has_results() const { return complete && model.is_unchanged(); }
  hsp::Span<const hsp::PoreMaximum> maxima() const { return builder.pores().maxima(); }
  hsp::Span<const hsp::PoreGate> gates() const { return builder.pores().gates(); }
  const hsp::exact::Lattice &lattice() const { return model->balls().lattice; }
};
