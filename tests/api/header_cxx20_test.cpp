// The header on its own in C++20: included first, with C linkage.
#include <hardsphere.h>
// The workspace over malloc is C++ as well.
#include <hardsphere_workspace.h>
// A second time: the guards hold.
#include <hardsphere.h>

#include <cstdint>
#include <type_traits>

template <class Record>
constexpr bool is_plain = std::is_standard_layout_v<Record> &&std::is_trivial_v<Record>;

static_assert(is_plain<hsp_model_options> && is_plain<hsp_model_info> && is_plain<hsp_packing>);
static_assert(is_plain<hsp_boundary_limits> && is_plain<hsp_boundary_counts> && is_plain<hsp_vertex>);
static_assert(is_plain<hsp_arc> && is_plain<hsp_circle> && is_plain<hsp_face> && is_plain<hsp_ball>);
static_assert(is_plain<hsp_loop> && is_plain<hsp_loop_arc> && is_plain<hsp_totals>);
static_assert(std::is_same_v<decltype(hsp_version()), uint32_t>);
static_assert(std::is_same_v<decltype(HSP_NONE), decltype(UINT32_C(1))>);

// Two declarations with C linkage and the same type are the same function; otherwise this does not compile or link.
extern "C" uint32_t hsp_version(void);

int main() {
  return hsp_version() == HSP_VERSION_NUMBER ? 0 : 1;
}
