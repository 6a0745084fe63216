// Asks a question in numbers of ever greater width, until one answers (actual_balls.hpp).
#pragma once

#include "surface/actual_balls.hpp"
#include "surface/actual_points.hpp"

namespace hsp {

// A vector of the number type of these points.
template <class Number>
NumberVector<Number> vector_of(const ActualPoints<Number> &) {
  return {};
}

template <class Question>
int ActualBalls::decide_about(uint32_t ball, Question question) const {
  const int sure = question(ActualPoints<BoundedDouble>({balls_, boundary_, kept_}, ball));
  if (sure == 0) return decide_in_floats(ball, question);
  ++answers_.by_doubles;
  return sure;
}

template <class Question>
int ActualBalls::decide_in_floats(uint32_t ball, Question question) const {
  for (const uint32_t bits : widths) {
    const int fine = question(ActualPoints<WideFloat>({balls_, boundary_, kept_, bits}, ball));
    if (fine != 0) {
      ++answers_.by_floats;
      return fine;
    }
  }
  ++answers_.by_none;
  return 0;
}

template <class Question>
int ActualBalls::decide_at(uint32_t vertex, Question question) const {
  if constexpr (small_code) {
    return decide_in_floats(boundary_.vertex(vertex).ball[0], question);
  } else {
    return decide_about(boundary_.vertex(vertex).ball[0], question);
  }
}

template <class Question>
int ActualBalls::measure_at(uint32_t vertex, Question question) const {
  return decide_about(boundary_.vertex(vertex).ball[0], question);
}

}  // namespace hsp
