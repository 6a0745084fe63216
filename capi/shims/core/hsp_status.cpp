#include "hardsphere.h"

uint32_t hsp_version(void) {
  return HSP_VERSION_NUMBER;
}

uint32_t hsp_abi(void) {
  return HSP_ABI_NUMBER;
}

uint32_t hsp_provisional(void) {
  return HSP_PROVISIONAL_NUMBER;
}

uint32_t hsp_numerics(void) {
  return HSP_NUMERICS_NUMBER;
}

uint32_t hsp_provisional_numerics(void) {
  return HSP_PROVISIONAL_NUMERICS_NUMBER;
}

const char *hsp_status_text(int32_t status) {
  switch (status) {
    case HSP_OK:
      return "success";
    case HSP_E_ARGUMENT:
      return "a null pointer, an unknown option, or a value that is not allowed there";
    case HSP_E_CAPACITY:
      return "an output array or a limit is too small; what suffices is reported";
    case HSP_E_MEMORY:
      return "the memory is smaller than required";
    case HSP_E_STATE:
      return "nothing there to read, continue or undo, or what it was made from has changed";
    case HSP_E_ID:
      return "nothing has this id, number or name, or one is listed twice";
    case HSP_E_CHECK:
      return "a violated invariant, or results that contradict each other: please report it";
    case HSP_E_SINK:
      return "the caller's byte sink refused bytes";
    case HSP_E_HANDLE:
      return "no live handle of this kind: overwritten, moved, or of another kind";
    case HSP_E_VERSION:
      return "a bad struct_size, or more asked for than this version of the library knows";
    case HSP_E_NOT_FINITE:
      return "a value is NaN or infinite";
    case HSP_E_NEGATIVE:
      return "a radius, the probe or another length is negative";
    case HSP_E_RANGE:
      return "a value lies beyond the lattice or its range, or is no rotation or direction";
    case HSP_E_CONFLICT:
      return "parts that do not fit together: sticks, bricks; which ones is reported";
    case HSP_E_EXECUTOR:
      return "the caller's executor failed, or did not call every task exactly once";
    case HSP_E_DEGENERATE:
      return "ties or near ties of the input that could not be resolved";
    case HSP_E_STOPPED:
      return "the caller's executor said not to go on";
    case HSP_E_DAMAGED:
      return "bytes that are no result of this library, or not as they were written";
    default:
      return "unknown status";
  }
}
