// A figure of the report: what is computed from counters of benchmarks, and how it is written.
//
//   [BENCHMARK] COUNTER   that counter, the median of the repetitions; without a benchmark that of the counter before,
//                         or that of the row. `time` is the time itself, in seconds
//   least(COUNTER)        the least of the repetitions
//   + - * / ( ) numbers, abs(), min(,) and max(,)
//   positive(F)           F if it is positive, otherwise as if it had not been measured; either(F, G): F, else G
//   exponent(N, [PREFIX*], F)   e of F ~ n^e over all benchmarks PREFIX..., of sets of at least N balls
//   largest(N, [PREFIX*], F)    the largest F of these
//   count([PREFIX*])            how many there are, failed or not
//   over(LIST, F)         the largest F over the rows of a list
//
// Behind a colon a unit, in which F is given: ns, us, ms or %, each also per COUNTER as in us/atoms, or /atoms alone;
// and a format: 3 significant digits, .2 decimals, e for a power of ten, `,` for thousands, `verdict` of what must not
// be negative.
#pragma once

#include <string>
#include <string_view>

#include "measurements.hpp"
#include "names.hpp"

namespace report {

// Where names and counters come from.
struct Scope {
  const Run &run;
  const Lists &lists;
  std::string benchmark = "";  // of the row
};

// The computed value, in the unit; NaN if a part of it was not measured.
double amount(std::string_view figure, const Scope &scope);
// Without the unit.
double plain_amount(std::string_view figure, const Scope &scope);
// As it is written; a dash if a part of it was not measured.
std::string written(std::string_view figure, const Scope &scope);

}  // namespace report
