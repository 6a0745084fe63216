// The conversion of values at the C interface: statuses, vectors, output arrays, violations.
#pragma once

#include <limits>

#include "core/id_range.hpp"
#include "core/status.hpp"
#include "core/vec3.hpp"
#include "core/violation.hpp"
#include "handle_tag.hpp"
#include "hardsphere.h"
#include "lanes/floating_point.hpp"
#include "library_arithmetic.hpp"

namespace hsp::capi {

constexpr int32_t to_c(Status status) {
  return static_cast<int32_t>(status);
}

static_assert(to_c(Status::ok) == HSP_OK && to_c(Status::argument) == HSP_E_ARGUMENT);
static_assert(to_c(Status::capacity) == HSP_E_CAPACITY && to_c(Status::memory) == HSP_E_MEMORY);
static_assert(to_c(Status::state) == HSP_E_STATE && to_c(Status::id) == HSP_E_ID);
static_assert(to_c(Status::check) == HSP_E_CHECK && to_c(Status::sink) == HSP_E_SINK);
static_assert(to_c(Status::not_finite) == HSP_E_NOT_FINITE && to_c(Status::negative) == HSP_E_NEGATIVE);
static_assert(to_c(Status::range) == HSP_E_RANGE && to_c(Status::conflict) == HSP_E_CONFLICT);
static_assert(to_c(Status::executor) == HSP_E_EXECUTOR && to_c(Status::degenerate) == HSP_E_DEGENERATE);
static_assert(to_c(Status::stopped) == HSP_E_STOPPED);
static_assert(no_id == HSP_NONE && max_count == HSP_MAX_BALLS);

// The first of some statuses that is not HSP_OK. Functions check handles, then versions, other arguments, states,
// values and capacities, as the header says (STATUS).
constexpr int32_t first_failure(int32_t first, int32_t second, int32_t third = HSP_OK) {
  if (first != HSP_OK) return first;
  return second != HSP_OK ? second : third;
}

// The status for two structs or arguments: a wrong version comes before all else.
constexpr int32_t versions_first(int32_t first, int32_t second) {
  return second == HSP_E_VERSION ? second : first_failure(first, second);
}

// The check of a handle in every function. Null is a bad argument like others; any other pointer that is no live handle
// of this kind has a status of its own. bad: whether other arguments are bad.
template <class Handle>
int32_t check_handle(const Handle *handle, bool bad = false) {
  if (handle == nullptr) return HSP_E_ARGUMENT;
  if (!is_live(handle)) return HSP_E_HANDLE;
  return bad ? HSP_E_ARGUMENT : HSP_OK;
}

// The same for a handle whose results are asked for.
template <class Handle>
int32_t check_results(const Handle *handle, bool bad = false) {
  const int32_t status = check_handle(handle, bad);
  return status == HSP_OK && !handle->has_results() ? HSP_E_STATE : status;
}

// Stands for the volume if only some balls were looked at.
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

inline void to_array(const Vec3 &v, double out[3]) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

// Writes row i of an array [n][3], which may be null.
inline void put_vector(const double vector[3], double *array, uint32_t i) {
  if (array == nullptr) return;
  for (size_t axis = 0; axis < 3; ++axis) array[3 * static_cast<size_t>(i) + axis] = vector[axis];
}

// The part that all (out, capacity, needed) functions share. HSP_OK: exactly `count` records have to be written. needed
// may be null. It has been checked that there is an array if the capacity is above 0.
inline int32_t check_output(uint32_t capacity, uint32_t count, uint32_t *needed) {
  if (needed != nullptr) *needed = count;
  return count > capacity ? HSP_E_CAPACITY : HSP_OK;
}

// The same for functions with several arrays, all of which may be null; then the capacity does not count.
inline bool fits(bool wanted, uint32_t capacity, uint32_t count, uint32_t *needed) {
  if (needed != nullptr) *needed = count;
  return !wanted || capacity >= count;
}

// Sets first_bad, which may be null, to HSP_NONE. It stays as it is if the handle is refused.
inline int32_t name_none(int32_t status, uint32_t *first_bad) {
  if (first_bad != nullptr && status != HSP_E_HANDLE) *first_bad = HSP_NONE;
  return status;
}

// Names the first weight of a range that is not finite; weights and first_bad may be null.
inline int32_t check_weights(const double *sigma, IdRange range, uint32_t *first_bad) {
  if (first_bad != nullptr) *first_bad = HSP_NONE;
  for (uint32_t i = range.first; sigma != nullptr && i < range.last; ++i) {
    if (is_finite(sigma[i])) continue;
    if (first_bad != nullptr) *first_bad = i;
    return HSP_E_NOT_FINITE;
  }
  return HSP_OK;
}

// The checks of every copying function of a computed handle: arguments, state, and that exactly count(*handle) records
// fit.
template <class Handle, class Count>
int32_t check_request(const Handle *handle, const void *out, uint32_t capacity, uint32_t *needed, Count count) {
  const int32_t status = check_results(handle, out == nullptr && capacity > 0);
  if (status != HSP_OK) return status;
  return check_output(capacity, count(*handle), needed);
}

// The same for functions that write the records `first` to `first + count - 1` of number(*handle). out: null if the
// caller gave no array.
template <class Handle, class Number>
int32_t check_range(const Handle *handle, uint32_t first, uint32_t count, const void *out, Number number) {
  if (const int32_t status = check_results(handle, out == nullptr && count > 0); status != HSP_OK) return status;
  const uint32_t there = number(*handle);
  return first > there || count > there - first ? HSP_E_ID : HSP_OK;
}

// The end of every check of a computed handle: hands back the first violated invariant and the id at which it fails.
template <class Invariant>
int32_t report(const Violation<Invariant> &violation, uint32_t *invariant, uint32_t *id) {
  *invariant = static_cast<uint32_t>(violation.invariant);
  *id = violation.id;
  return *invariant == 0 ? HSP_OK : HSP_E_CHECK;
}

}  // namespace hsp::capi
