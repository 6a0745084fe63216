// The exact stage with the limbs that the library does without, for tests that compare both.
#include <type_traits>

#include "exact/exact_predicates.cpp"

#if defined(__SIZEOF_INT128__)
namespace hsp::exact {

template struct ExactPredicates<std::conditional_t<sizeof(FastLimb) == 8, uint32_t, uint64_t>>;

}  // namespace hsp::exact
#endif
