#!/usr/bin/env bash
# How much flash the library takes on a microcontroller: text and initialized data of whole images, newlib included,
# compiled with -Os and linked with --gc-sections. An image larger than its budget fails.
#   firmware_size.sh CORTEX SOURCE-FOLDER WORK-FOLDER
# CORTEX: m3, m4 or m7. Files for others to run on it are left in WORK-FOLDER: the library, an archive of its objects
# with their inner symbols, and the flags for the processor. Exit status 77: there is no compiler for it here.
set -euo pipefail
cortex=$1 source=$2 work=$3
here=$(cd "$(dirname "$0")/firmware" && pwd)
command -v arm-none-eabi-g++ >/dev/null || { echo "skipped: there is no arm-none-eabi-g++ here" && exit 77; }
rm -rf "$work"
mkdir -p "$work"
{
  cmake -S "$source" -B "$work/build" -DCMAKE_TOOLCHAIN_FILE="$here/cortex_m.cmake" -DCORTEX="$cortex" \
    -DCMAKE_BUILD_TYPE=MinSizeRel -DHSP_WERROR=ON && cmake --build "$work/build" --parallel 2
} >"$work/log" 2>&1 || { tail -n 40 "$work/log" && exit 1; }
flags=$(sed -n 's/^CMAKE_C_FLAGS:STRING=//p' "$work/build/CMakeCache.txt")

failed=0
image() { # part (see image.c), budget in KiB, what it calls
  # shellcheck disable=SC2086 # the flags are words
  arm-none-eabi-gcc $flags -Os -std=c99 -Wall -Wextra -Werror -DPART="$1" -I"$source/include" -Wl,--gc-sections \
    --specs=nano.specs --specs=nosys.specs -o "$work/image_$1.elf" "$here/image.c" "$work/build/libhardsphere.a" -lm 2>"$work/link.log" ||
    { cat "$work/link.log" && exit 1; }
  local bytes
  bytes=$(arm-none-eabi-size "$work/image_$1.elf" | awk 'NR == 2 {print $1 + $2}')
  printf '%-52s %7d bytes, budget %3d KiB\n' "$3" "$bytes" "$2"
  [ "$bytes" -le $((1024 * $2)) ] || failed=1
}
echo "Cortex-${cortex^^}, $(arm-none-eabi-gcc --version | head -n 1), -Os"
image -1 2 "nothing of the library"
image 0 12 "a model"
image 1 15 "a model and hsp_query_ball"
image 17 24 "a model and all queries"
image 3 63 "a model, hsp_query_ball, boundary, measure, gradient"
image 7 81 "the same with topology"
image 35 123 "boundary, measure, gradient and smooth surface"
image 64 71 "a model, and balls that move"
image 128 26 "a model, hsp_body_hits and _gaps"
image 8 91 "a model, a view from it alone, pictures"
image 31 150 "all of these but the smooth surface"
mv "$work/build/libhardsphere.a" "$work/libhardsphere.a"
find "$work/build/CMakeFiles/hardsphere_objects.dir" -type f -name '*.o*' -print0 |
  xargs -0 arm-none-eabi-ar qcs "$work/libinner.a"
echo "$flags" >"$work/flags"
rm -rf "$work/build"
exit $failed
