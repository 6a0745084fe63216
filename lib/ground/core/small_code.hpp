// Whether little code matters more than speed: the compiler says so with -Os. Then one plain way does where otherwise a
// faster one is chosen by the input; the results are the same.
#pragma once

namespace hsp {

#if defined(__OPTIMIZE_SIZE__)
inline constexpr bool small_code = true;
#define HSP_INLINE_UNLESS_SMALL
// For what is short and called in many places.
#define HSP_APART_IF_SMALL [[gnu::noinline]]
#define HSP_APART_UNLESS_SMALL
#else
inline constexpr bool small_code = false;
// For what is called for each ball: in large units g++ inlines less of its own accord.
#define HSP_INLINE_UNLESS_SMALL [[gnu::always_inline]]
#define HSP_APART_IF_SMALL
// For a loop that needs all registers.
#define HSP_APART_UNLESS_SMALL [[gnu::noinline]]
#endif

}  // namespace hsp
