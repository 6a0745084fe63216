// Whether little code matters more than speed: the compiler says so with -Os. Then one plain way does where otherwise a
// faster one is chosen by the input; the results are the same.
#pragma once

namespace hsp {

#if defined(__OPTIMIZE_SIZE__)
inline constexpr bool small_code = true;
#else
inline constexpr bool small_code = false;
#endif

}  // namespace hsp
