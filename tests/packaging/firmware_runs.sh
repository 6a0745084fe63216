#!/usr/bin/env bash
# Molecules on emulated microcontrollers: from coordinates to areas, volume, gradient and topology, with the same bits as
# here. Caffeine in 64 KiB of RAM and crambin in 1 MiB, stack included, with limits that are exact; instructions and stack
# of each call are held to budgets.
#   firmware_runs.sh CORTEX SOURCE-FOLDER WORK-FOLDER LIBRARY-FOLDER NATIVE-LIBRARY C-COMPILER
# CORTEX: m3, m4 or m7. LIBRARY-FOLDER: what firmware_size.sh leaves, compiled for it. Exit status 77: something is missing here.
set -euo pipefail
cortex=$1 source=$2 work=$3 library=$4/libhardsphere.a native=$5 cc=$6
here=$(cd "$(dirname "$0")/firmware" && pwd)
for needed in arm-none-eabi-gcc qemu-system-arm; do
  command -v $needed >/dev/null || { echo "skipped: there is no $needed here" && exit 77; }
done
[ -e "$library" ] || { echo "skipped: there is no library for this processor" && exit 77; }
read -ra flags <"$4/flags"
board=$(bash "$here/board.sh" "$cortex")
rm -rf "$work"
mkdir -p "$work"
failed=0

# Thousands of instructions, and bytes of stack, that a call may take.
budget_of() { # molecule, step
  awk -v key="$cortex $1 $2" '$1 " " $2 " " $3 == key {print $4, $5}' "$here/budgets.txt"
}

run_molecule() { # name, bytes of RAM, bytes of stack
  local name=$1 ram=$2 stack=$3
  local folder=$work/$name
  mkdir "$folder"
  awk 'BEGIN { radius["C"] = 1.7; radius["N"] = 1.55; radius["O"] = 1.52; radius["S"] = 1.8; radius["H"] = 1.1 }
    /^(ATOM|HETATM)/ {
      element = substr($0, 77, 2)
      gsub(/ /, "", element)
      xyz = xyz sprintf("  %s, %s, %s,\n", substr($0, 31, 8), substr($0, 39, 8), substr($0, 47, 8))
      radii = radii sprintf("  %s,\n", radius[element])
      ++n
    }
    END {
      printf "#define BALLS %d\n", n
      printf "static const double xyz[3 * BALLS] = {\n%s};\nstatic const double radius[BALLS] = {\n%s};\n", xyz, radii
    }' "$source/bench/molecules/$name.pdb" >"$folder/balls.h"
  local sources=(-std=c99 -Os -Wall -Wextra -Werror -I"$source/include" -I"$here" -DMOLECULE="\"$folder/balls.h\"" "$here/molecule.c")

  # Here, which needs the library for this machine: once to find the exact limits, then with them.
  "$cc" "${sources[@]}" "$here/machine_native.c" "$native" -lm -o "$folder/native"
  "$folder/native" >"$folder/first"
  # shellcheck disable=SC2046 # words
  set -- $(awk '$1 == "boundary" || $1 == "topology" {kept[$1] = $0} END {print kept["boundary"], kept["topology"]}' "$folder/first")
  local exact=(-DEXACT_NEIGHBOURS="$2" -DEXACT_VERTICES="$3" -DEXACT_CIRCLES="$4" -DEXACT_EDGES="$6" -DEXACT_CUT_ARCS="$7"
    -DEXACT_SHELLS="$8")
  "$cc" "${sources[@]}" "${exact[@]}" "$here/machine_native.c" "$native" -lm -o "$folder/native"
  "$folder/native" | grep -v '^#' >"$folder/wanted"

  sed -e "s/@RAM@/$ram/g" -e "s/@STACK@/$stack/g" "$here/memory.ld.in" >"$folder/memory.ld"
  arm-none-eabi-gcc "${flags[@]}" "${sources[@]}" "${exact[@]}" "$here/machine_mps2.c" "$library" -nostartfiles \
    -T "$folder/memory.ld" --specs=nano.specs -Wl,--gc-sections,--no-warn-rwx-segments -lm -o "$folder/image.elf"
  local status=0
  timeout 100 qemu-system-arm -M "$board" -nographic -monitor none -serial null -icount shift=5 \
    -semihosting-config enable=on,target=native -kernel "$folder/image.elf" >"$folder/output" 2>&1 </dev/null || status=$?
  [ $status -eq 0 ] || { echo "$name: exit status $status" && tail -n 3 "$folder/output" | cut -c 1-200 && failed=1 && return; }
  grep -v '^#' "$folder/output" >"$folder/shown"
  cmp "$folder/wanted" "$folder/shown" || { echo "$name: other digits" && failed=1 && return; }
  echo "Cortex-${cortex^^}, $name: $(wc -l <"$folder/wanted") lines of the same digits in $ram bytes of RAM, $(
    arm-none-eabi-size "$folder/image.elf" | awk 'NR == 2 {print $1 + $2}') bytes of flash"
  while read -r _ step instructions used; do
    if [ "$step" = memory ]; then
      echo "  memory without stack: $instructions bytes"
      continue
    fi
    local budget_instructions=0 budget_stack=0
    read -r budget_instructions budget_stack <<<"$(budget_of "$name" "$step")" || true
    printf '  %-9s %8d thousand instructions of %8d, %6d bytes of stack of %6d\n' "$step" "$instructions" \
      "${budget_instructions:-0}" "$used" "${budget_stack:-0}"
    if [ "$instructions" -gt "${budget_instructions:-0}" ] || [ "$used" -gt "${budget_stack:-0}" ]; then
      echo "  beyond its budget in tests/packaging/firmware/budgets.txt: $cortex $name $step"
      failed=1
    fi
  done < <(grep '^#' "$folder/output")
}
run_molecule caffeine 64K 12K
run_molecule crambin 1M 16K
exit $failed
