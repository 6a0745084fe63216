#!/usr/bin/env bash
# How README.md and the pages of the guide say to install, build, link and call the library: every block is run as it is
# there, in order, in an empty folder with a home of its own, beside a link `hardsphere` to the sources and the example
# programs that the pages name. The blocks in C and Fortran of languages.md are readme_example.sh's and guide_pages.sh's.
#   readme_blocks.sh SOURCE-FOLDER WORK-FOLDER
# Blocks in Fortran, Python and for microcontrollers are left out where their tools are missing, and named.
set -euo pipefail
source=$1 work=$2
rm -rf "$work"
mkdir -p "$work/home"
blocks=()
take() { # page, section of it or all, kinds of blocks
  local folder
  folder=$work/blocks/$(basename "$1" .md)
  mkdir -p "$folder"
  awk -v folder="$folder" -v section="$2" -f "$source/tests/packaging/page_blocks.awk" "$source/$1"
  for kind in $3; do blocks+=("$folder"/*."$kind"); done
}
take README.md "## Install" sh
take capi/guide/building.md "" "sh cmake"
take capi/guide/microcontrollers.md "" sh
take capi/guide/languages.md "" python
[ ${#blocks[@]} -ge 7 ] || { echo "only ${#blocks[@]} blocks were found" && exit 1; }

cd "$work"
export HOME=$work/home
# Nothing is compiled twice or runs for long here, so that large units do, and no optimisation, whatever the blocks say
# of the build. For a microcontroller nothing is compiled: firmware_size.sh does.
cmake() {
  local options=()
  if [ "$*" = "--build firmware" ]; then set -- "$@" -- -n; fi
  [ "$1" != -S ] || options=(-DCMAKE_{C,CXX}_FLAGS_{RELEASE,MINSIZEREL}=-O0)
  CXXFLAGS=-O0 command cmake "${options[@]}" "$@"
}
export -f cmake
ln -s "$source" hardsphere
cp "$source/capi/examples/minimal.c" .
cp "$source"/capi/fortran/{water,minimise}.f90 .

missing() { # tool that a block needs
  case $1 in
    *gfortran*) command -v gfortran >/dev/null || echo gfortran ;;
    *import\ cffi*) /usr/bin/python3 -c 'import cffi, setuptools' 2>/dev/null || echo "cffi of Python" ;;
    *cortex_m.cmake*) command -v arm-none-eabi-g++ >/dev/null || echo arm-none-eabi-g++ ;;
  esac
}
run() {
  "$@" >"$work/log" 2>&1 || { echo "in ${block##*/}:" && tail -n 30 "$work/log" && exit 1; }
}
for block in "${blocks[@]}"; do
  tool=$(missing "$(cat "$block")")
  if [ -n "$tool" ]; then
    echo "${block##*/} is left out: there is no $tool here"
    continue
  fi
  case $block in
    *.sh)
      # Exported variables serve the blocks below.
      run bash -euc ". '$block'; export -p > exported"
      # shellcheck disable=SC1091 # written by the line above
      . ./exported
      ;;
    *.cmake)
      mkdir project
      cp "$block" project/CMakeLists.txt
      cp minimal.c project
      ln -s "$source" project/hardsphere
      run cmake -S project -B project/build -DCMAKE_PREFIX_PATH="$HOME/.local"
      run cmake --build project/build --parallel 2
      run project/build/water
      rm -rf project
      ;;
    *.python)
      cp "$block" neighbours.py
      run /usr/bin/python3 neighbours.py
      grep -qxF 'ball 1 meets [0, 2]' "$work/log" || { cat "$work/log" && exit 1; }
      ;;
    *) echo "nobody knows how to run ${block##*/}" && exit 1 ;;
  esac
  echo "${block##*/}: $(tail -n 1 "$work/log")"
done
for program in water water_module water_source minimise_source; do
  [ ! -e $program ] || run ./$program
done
rm -rf build firmware
