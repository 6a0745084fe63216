// The library's exact predicates compiled once more, with limbs of the other size (32 or 64 bits) than the library uses
// here, for tests that compare the two.
#include <type_traits>

#include "exact/exact_predicates.cpp"
#include "exact/power_vertex.cpp"

#if defined(__SIZEOF_INT128__)
namespace hsp::exact {

using OtherLimb = std::conditional_t<sizeof(FastLimb) == 8, uint32_t, uint64_t>;
template struct ExactPredicates<OtherLimb>;
template class PowerVertexOf<OtherLimb>;

}  // namespace hsp::exact
#endif
