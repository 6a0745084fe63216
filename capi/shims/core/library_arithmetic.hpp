// The floating-point environment of a thread: how it rounds, whether it flushes subnormal numbers to zero, which
// exceptions trap, and the flags of those that have occurred. A program sets it as it likes, or its compiler does
// (-ffast-math, -ffpe-trap); the library computes in the default one: to nearest, nothing flushed, no traps.
//
//   int32_t hsp_noun_verb(hsp_noun *noun, double value) {
//     LibraryArithmetic arithmetic(value);   // first of all: comparisons raise exceptions, too
//     ..
//   }                                        // the caller's environment again, with the flags that it had
//
// A function without it has no arithmetic that could raise, round or flush; copies of doubles do not. A test reads the
// compiled code of these functions (tests/packaging/floating_point.sh).
#pragma once

#include <cstdint>

#include "core/small_code.hpp"

namespace hsp::capi {

// For each processor: how the registers are read and set, and three masks of their bits. controls: rounding, flushing
// and traps; of_library: the bits set in the library's environment; passing: results of comparisons and of the last
// operation, which are not kept.
#if defined(__SSE2__)
struct FloatingPointRegisters {
  using Word = uint32_t;
  static constexpr Word controls = 0xFFC0, of_library = 0x1F80, passing = 0;  // where a trap is masked its bit is set
  static void read(Word &word) { asm volatile("stmxcsr %0" : "=m"(word) : : "memory"); }
  static void set(const Word &word) { asm volatile("ldmxcsr %0" : : "m"(word) : "memory"); }
};
#elif defined(__aarch64__)
// FPCR above FPSR, which have 32 bits each.
struct FloatingPointRegisters {
  using Word = uint64_t;
  static constexpr Word controls = UINT64_C(0xFFFFFFFF) << 32, of_library = 0, passing = 0;
  static void read(Word &word) {
    uint64_t fpcr, fpsr;
    asm volatile("mrs %0, fpcr" : "=r"(fpcr) : : "memory");
    asm volatile("mrs %0, fpsr" : "=r"(fpsr) : : "memory");
    word = fpcr << 32 | fpsr;
  }
  static void set(Word word) {
    asm volatile("msr fpcr, %0" : : "r"(word >> 32) : "memory");
    asm volatile("msr fpsr, %0" : : "r"(word & UINT64_C(0xFFFFFFFF)) : "memory");
  }
};
#elif defined(__arm__) && defined(__ARM_FP)
struct FloatingPointRegisters {
  using Word = uint32_t;
  static constexpr Word controls = 0x03C89F00, of_library = 0, passing = 0xF0000000;
  static void read(Word &word) { asm volatile("vmrs %0, fpscr" : "=r"(word) : : "memory"); }
  static void set(Word word) { asm volatile("vmsr fpscr, %0" : : "r"(word) : "memory"); }
};
#elif defined(__riscv_flen)
struct FloatingPointRegisters {
  using Word = uintptr_t;
  static constexpr Word controls = 0xE0, of_library = 0, passing = 0;
  static void read(Word &word) { asm volatile("frcsr %0" : "=r"(word) : : "memory"); }
  static void set(Word word) { asm volatile("fscsr %0" : : "r"(word) : "memory"); }
};
#elif defined(__s390__)
struct FloatingPointRegisters {
  using Word = uint32_t;
  static constexpr Word controls = 0xF8000007, of_library = 0, passing = 0;
  static void read(Word &word) { asm volatile("efpc %0" : "=d"(word) : : "memory"); }
  static void set(Word word) { asm volatile("sfpc %0" : : "d"(word) : "memory"); }
};
#elif defined(__mips_hard_float)
struct FloatingPointRegisters {
  using Word = uint32_t;
  static constexpr Word controls = 0x01600F83, of_library = 0, passing = 0xFE83F000;
  static void read(Word &word) { asm volatile("cfc1 %0, $31" : "=r"(word) : : "memory"); }
  static void set(Word word) { asm volatile("ctc1 %0, $31" : : "r"(word) : "memory"); }
};
#elif defined(__powerpc__) && !defined(_SOFT_FLOAT) && !defined(__NO_FPRS__)
struct FloatingPointRegisters {
  using Word = uint64_t;
  static constexpr Word controls = 0xFF, of_library = 0, passing = 0x7F000;
  static void read(Word &word) {
    double found;
    asm volatile("mffs %0" : "=d"(found) : : "memory");
    word = __builtin_bit_cast(uint64_t, found);
  }
  static void set(Word word) { asm volatile("mtfsf 255, %0" : : "d"(__builtin_bit_cast(double, word)) : "memory"); }
};
#else
// WebAssembly and arithmetic in software have no settings.
struct FloatingPointRegisters {
  using Word = uint32_t;
  static constexpr Word controls = 0, of_library = 0, passing = 0;
  static void read(Word &word) { word = 0; }
  static void set(Word) {}
};
#endif

// The library's environment, as long as this object lives.
class LibraryArithmetic {
 public:
  // by_value: doubles that the caller has passed by value. Nothing is computed of them before this: compilers do not
  // know that operations depend on the environment, but they do not move accesses to memory across it.
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
  friend class CallersQuestion;
  using Registers = FloatingPointRegisters;
  using Word = Registers::Word;

  static Word now() {
    Word word = 0;  // clang's memory sanitizer does not see what assembly writes
    Registers::read(word);
    return word & ~Registers::passing;
  }
  // If the program has the default environment, as most have, nothing is written.
  HSP_APART_IF_SMALL void begin() {
    callers_ = now();
    const Word own = (callers_ & ~Registers::controls) | Registers::of_library;
    if (own != callers_) Registers::set(own);
  }
  HSP_APART_IF_SMALL void leave() const {
    if (now() != callers_) Registers::set(callers_);
  }
  static void hold(double &value) { asm volatile("" : "+m"(value)); }

  Word callers_;
};

// The caller's environment again, while a function of the caller runs. Flags that it raises, and settings that it
// makes, stay.
class CallersArithmetic {
 public:
  explicit CallersArithmetic(LibraryArithmetic &library) : library_(library) { library_.leave(); }
  ~CallersArithmetic() { library_.begin(); }
  CallersArithmetic(const CallersArithmetic &) = delete;
  CallersArithmetic &operator=(const CallersArithmetic &) = delete;

 private:
  LibraryArithmetic &library_;
};

// A copy of the caller's environment, in any thread of an executor, while a question to the caller runs. Flags and
// settings of the copy are lost afterwards.
class CallersQuestion {
 public:
  explicit CallersQuestion(const LibraryArithmetic &library) : own_(LibraryArithmetic::now()) {
    if (library.callers_ != own_) LibraryArithmetic::Registers::set(library.callers_);
  }
  ~CallersQuestion() {
    if (LibraryArithmetic::now() != own_) LibraryArithmetic::Registers::set(own_);
  }
  CallersQuestion(const CallersQuestion &) = delete;
  CallersQuestion &operator=(const CallersQuestion &) = delete;

 private:
  LibraryArithmetic::Word own_;
};

}  // namespace hsp::capi
