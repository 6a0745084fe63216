# Toolchain file for WebAssembly with clang and wasi-libc, the packages clang-14 lld-14 wasi-libc libclang-rt-14-dev-wasm32
# libc++-14-dev-wasm32 libc++abi-14-dev-wasm32 of Debian 12:
#   cmake -DCMAKE_TOOLCHAIN_FILE=capi/wasm/wasi.cmake -DHSP_TOOL=ON ...
# The program hardsphere.wasm is a WASI command; `node capi/wasm/run.mjs hardsphere.wasm --help` runs it. CMake 3.25 knows
# no system of this name, hence Generic: an archive, no shared library.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-14)
set(CMAKE_CXX_COMPILER clang++-14)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
# Registers of several numbers, which browsers have had since 2023, where the code asks for them. Of its own accord the
# compiler must not use them: at -O3 clang 14 makes wrong code of straight lines of doubles (portability_wasm: one number of
# a matrix that is turned became 0). -fno-slp-vectorize says the same, but only behind -O3, which CMake puts last.
set(CMAKE_C_FLAGS_INIT "-msimd128 -mllvm -vectorize-slp=false")
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -mllvm -vectorize-slp=false")
# A stack of 1 MB instead of 64 kB, which the program's measure of several files goes beyond; below all data, so that what
# goes beyond it stops instead of writing over them.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,--stack-first -Wl,-z,stack-size=1048576")
set(CMAKE_AR llvm-ar-14)
set(CMAKE_RANLIB llvm-ranlib-14)
set(CMAKE_EXECUTABLE_SUFFIX_C .wasm)
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)
# The archive keeps its objects: wasm-ld leaves out what a program does not call.
set(HSP_SINGLE_OBJECT OFF CACHE BOOL "")
