// The floating-point environment of a thread: how it rounds, whether it flushes subnormal numbers to zero, which
// exceptions trap, and the flags of those that have occurred. A program sets it as it likes, or its compiler does
// (-ffast-math, -ffpe-trap); the library computes in the default one: to nearest, nothing flushed, no traps.
//
//   int32_t hsp_noun_verb(hsp_noun *noun, double value) {
//     LibraryArithmetic arithmetic(value);   // first of all: comparisons raise exceptions, too
//     ..
//   }                                        // the caller's environment again, with the flags that it had
//
// A function without any of it has no arithmetic that could raise, round or flush; copies of doubles have not. A test
// reads the code that the compiler has made of them (tests/packaging/floating_point.sh).
#pragma once

#include <cstdint>

#include "core/small_code.hpp"

namespace hsp::capi {

// The control and flag bits of one thread, as they are in its registers, and what the library's control bits are.
#if defined(__SSE2__)

struct FloatingPoint {
  uint32_t mxcsr;

  static FloatingPoint now() {
    FloatingPoint found;
    asm volatile("stmxcsr %0" : "=m"(found.mxcsr) : : "memory");
    return found;
  }
  void set() const { asm volatile("ldmxcsr %0" : : "m"(mxcsr) : "memory"); }
  // All exceptions masked; bits of rounding, of flushing results and of taking subnormal operands for zero.
  FloatingPoint of_library() const { return {(mxcsr & ~UINT32_C(0xFFC0)) | UINT32_C(0x1F80)}; }
  bool operator==(const FloatingPoint &) const = default;
};

#elif defined(__aarch64__)

struct FloatingPoint {
  uint64_t fpcr, fpsr;

  static FloatingPoint now() {
    FloatingPoint found;
    asm volatile("mrs %0, fpcr" : "=r"(found.fpcr) : : "memory");
    asm volatile("mrs %0, fpsr" : "=r"(found.fpsr) : : "memory");
    return found;
  }
  void set() const {
    asm volatile("msr fpcr, %0" : : "r"(fpcr) : "memory");
    asm volatile("msr fpsr, %0" : : "r"(fpsr) : "memory");
  }
  FloatingPoint of_library() const { return {0, fpsr}; }
  bool operator==(const FloatingPoint &) const = default;
};

#elif defined(__arm__) && defined(__ARM_FP)

struct FloatingPoint {
  uint32_t fpscr;

  static FloatingPoint now() {
    FloatingPoint found;
    asm volatile("vmrs %0, fpscr" : "=r"(found.fpscr) : : "memory");
    return found.without_conditions();
  }
  void set() const { asm volatile("vmsr fpscr, %0" : : "r"(fpscr) : "memory"); }
  // The results of comparisons are in there too, and nobody's to keep.
  FloatingPoint without_conditions() const { return {fpscr & UINT32_C(0x0FFFFFFF)}; }
  // Default NaN, flushing, rounding, traps.
  FloatingPoint of_library() const { return {fpscr & ~UINT32_C(0x03C89F00)}; }
  bool operator==(const FloatingPoint &) const = default;
};

#elif defined(__riscv_flen)

struct FloatingPoint {
  uintptr_t fcsr;

  static FloatingPoint now() {
    FloatingPoint found;
    asm volatile("frcsr %0" : "=r"(found.fcsr) : : "memory");
    return found;
  }
  void set() const { asm volatile("fscsr %0" : : "r"(fcsr) : "memory"); }
  FloatingPoint of_library() const { return {fcsr & ~uintptr_t{0xE0}}; }
  bool operator==(const FloatingPoint &) const = default;
};

#elif defined(__s390__)

struct FloatingPoint {
  uint32_t fpc;

  static FloatingPoint now() {
    FloatingPoint found;
    asm volatile("efpc %0" : "=d"(found.fpc) : : "memory");
    return found;
  }
  void set() const { asm volatile("sfpc %0" : : "d"(fpc) : "memory"); }
  // Masks of traps; binary rounding.
  FloatingPoint of_library() const { return {fpc & ~UINT32_C(0xF8000007)}; }
  bool operator==(const FloatingPoint &) const = default;
};

#elif defined(__mips_hard_float)

struct FloatingPoint {
  uint32_t fcsr;

  static FloatingPoint now() {
    FloatingPoint found;
    asm volatile("cfc1 %0, $31" : "=r"(found.fcsr) : : "memory");
    return found.without_conditions();
  }
  void set() const { asm volatile("ctc1 %0, $31" : : "r"(fcsr) : "memory"); }
  // Results of comparisons, and which exceptions the last operation had.
  FloatingPoint without_conditions() const { return {fcsr & ~UINT32_C(0xFE83F000)}; }
  // Flushing, of several kinds; traps; rounding.
  FloatingPoint of_library() const { return {fcsr & ~UINT32_C(0x01600F83)}; }
  bool operator==(const FloatingPoint &) const = default;
};

#elif defined(__powerpc__) && !defined(_SOFT_FLOAT) && !defined(__NO_FPRS__)

struct FloatingPoint {
  uint64_t fpscr;

  static FloatingPoint now() {
    double found;
    asm volatile("mffs %0" : "=d"(found) : : "memory");
    return FloatingPoint{__builtin_bit_cast(uint64_t, found)}.without_conditions();
  }
  void set() const { asm volatile("mtfsf 255, %0" : : "d"(__builtin_bit_cast(double, fpscr)) : "memory"); }
  // How the last operation was rounded, and the class of its result.
  FloatingPoint without_conditions() const { return {fpscr & ~UINT64_C(0x7F000)}; }
  // Traps, flushing, rounding.
  FloatingPoint of_library() const { return {fpscr & ~UINT64_C(0xFF)}; }
  bool operator==(const FloatingPoint &) const = default;
};

#else

// WebAssembly and arithmetic in software have nothing that could be set.
struct FloatingPoint {
  static FloatingPoint now() { return {}; }
  void set() const {}
  FloatingPoint of_library() const { return {}; }
  bool operator==(const FloatingPoint &) const = default;
};

#endif

// The library's environment, for as long as this lives.
class LibraryArithmetic {
 public:
  // Doubles that the caller has passed by value: nothing is computed of them before this. Compilers do not know that
  // operations depend on the environment, but they do not move what is in memory.
  template <class... Double>
  explicit LibraryArithmetic(Double &...by_value) {
    begin();
    (hold(by_value), ...);
  }
  ~LibraryArithmetic() { leave(); }
  LibraryArithmetic(const LibraryArithmetic &) = delete;
  LibraryArithmetic &operator=(const LibraryArithmetic &) = delete;

 private:
  friend class CallersArithmetic;

  // Most programs have the default environment: then nothing is written.
  HSP_APART_IF_SMALL void begin() {
    callers_ = FloatingPoint::now();
    const FloatingPoint own = callers_.of_library();
    if (!(own == callers_)) own.set();
  }
  HSP_APART_IF_SMALL void leave() const {
    if (!(FloatingPoint::now() == callers_)) callers_.set();
  }
  static void hold(double &value) { asm volatile("" : "+m"(value)); }

  FloatingPoint callers_;
};

// The caller's environment again, while a function of the caller's runs. Flags that it raises, and what it sets, stay.
class CallersArithmetic {
 public:
  explicit CallersArithmetic(LibraryArithmetic &library) : library_(library) { library_.leave(); }
  ~CallersArithmetic() { library_.begin(); }
  CallersArithmetic(const CallersArithmetic &) = delete;
  CallersArithmetic &operator=(const CallersArithmetic &) = delete;

 private:
  LibraryArithmetic &library_;
};

}  // namespace hsp::capi
