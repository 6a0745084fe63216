#!/usr/bin/env bash
# The case tables of the unit tests, which need neither heap nor streams, as one image on an emulated microcontroller.
#   firmware_cases.sh CORTEX SOURCE-FOLDER WORK-FOLDER LIBRARY-FOLDER ROOM...
# LIBRARY-FOLDER: what firmware_size.sh leaves, compiled for the processor. Exit status 77: something is missing here.
set -euo pipefail
cortex=$1 source=$2 work=$3 library=$4
shift 4
here=$(cd "$(dirname "$0")/firmware" && pwd)
for needed in arm-none-eabi-g++ qemu-system-arm; do
  command -v $needed >/dev/null || { echo "skipped: there is no $needed here" && exit 77; }
done
[ -e "$library/libinner.a" ] || { echo "skipped: there is no library for this processor" && exit 77; }
read -ra flags <"$library/flags"
board=$(bash "$here/board.sh" "$cortex")
rm -rf "$work"
mkdir -p "$work"

# One unit with all tables: two of the same name would not compile.
{
  echo '#include <cstdint>'
  echo 'extern "C" {'
  echo '#include "machine.h"'
  echo '}'
  # Small code, -Os, has no directories of rows.
  (cd "$source/tests/unit" && for room in "$@"; do ls -- "$room"/*_cases.hpp; done) |
    grep -vE '/(row_directory|packing_statistics)_' >"$work/headers"
  sed 's/.*/#include "&"/' "$work/headers"
  cat <<'MAIN'
namespace {
uint32_t held = 0, failed = 0;
void print_number(uint32_t number) {
  if (number >= 10) print_number(number / 10);
  const char digit[2] = {static_cast<char>('0' + number % 10), '\0'};
  machine_print(digit);
}
template <std::size_t n>
void run(const char *table, const cases::Check (&checks)[n]) {
  for (const cases::Check &check : checks) {
    const uint32_t failing = check.run();
    if (failing == cases::all_hold) {
      ++held;
      continue;
    }
    ++failed;
    machine_print(table);
    machine_print(": case ");
    print_number(failing);
    machine_print(" fails in ");
    machine_print(check.name);
    machine_print("\n");
  }
}
}  // namespace
extern "C" int main() {
MAIN
  sed -E 's|(.*)/(.*)_cases.hpp|  run("\1/\2", cases::\1_\2);|' "$work/headers"
  cat <<'MAIN'
  print_number(held);
  machine_print(" checks hold\n");
  return failed == 0 ? 0 : 1;
}
MAIN
} >"$work/cases.cpp"

wings=("$source"/lib/*/)
arm-none-eabi-g++ "${flags[@]}" -std=c++20 -Os -DNDEBUG -ffp-contract=off -DHSP_NO_CONTRACTION=1 -fno-exceptions -fno-rtti -fno-threadsafe-statics \
  -ffunction-sections -fdata-sections -I"$source/include" "${wings[@]/#/-I}" -I"$source/tests/unit" -I"$source/tests/unit/support" \
  -I"$here" -c "$work/cases.cpp" -o "$work/cases.o"
sed -e "s/@RAM@/4M/g" -e "s/@STACK@/64K/g" "$here/memory.ld.in" >"$work/memory.ld"
# By the compiler for C: no C++ run time.
arm-none-eabi-gcc "${flags[@]}" -std=c99 -Os -I"$here" "$here/machine_mps2.c" "$work/cases.o" "$library/libinner.a" \
  -nostartfiles -T "$work/memory.ld" --specs=nano.specs -Wl,--gc-sections,--no-warn-rwx-segments -lm -o "$work/image.elf"
if arm-none-eabi-readelf -SW "$work/image.elf" | grep -E 'init_array'; then
  echo "something would have to be initialised at run time"
  exit 1
fi
status=0
timeout 900 qemu-system-arm -M "$board" -nographic -monitor none -serial null -semihosting-config enable=on,target=native \
  -kernel "$work/image.elf" >"$work/output" 2>&1 </dev/null || status=$?
echo "Cortex-${cortex^^}: $(wc -l <"$work/headers") tables, $(arm-none-eabi-size "$work/image.elf" | awk 'NR == 2 {print $1 + $2}') bytes"
tail -n 40 "$work/output" | cut -c 1-200
[ $status -eq 0 ] || { echo "exit status $status" && exit 1; }
grep -qE '^[1-9][0-9]* checks hold$' "$work/output"
