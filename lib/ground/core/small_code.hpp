// Whether small code matters more than speed: it does if the compiler is called with -Os. Then there is one plain way
// where otherwise the input decides between ways; the results are the same.
#pragma once

namespace hsp {

#if defined(__OPTIMIZE_SIZE__)
inline constexpr bool small_code = true;
#define HSP_INLINE_UNLESS_SMALL
// For short functions that are called in many places.
#define HSP_APART_IF_SMALL [[gnu::noinline]]
#define HSP_APART_UNLESS_SMALL
#else
inline constexpr bool small_code = false;
// For functions that are called for each ball: in large translation units g++ inlines less by itself.
#define HSP_INLINE_UNLESS_SMALL [[gnu::always_inline]]
#define HSP_APART_IF_SMALL
// For functions with a loop that needs all registers.
#define HSP_APART_UNLESS_SMALL [[gnu::noinline]]
#endif

}  // namespace hsp
