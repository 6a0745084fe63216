#!/usr/bin/env bash
# Programs of version 0.2.0, its examples, clients and the blocks of its pages, after the steps of capi/guide/migration.md:
# they compile without a warning, and the pages' programs print what the pages of 0.2.0 say.
#   migration.sh SOURCE-FOLDER ARCHIVE WORK-FOLDER C-COMPILER C++-COMPILER [FORTRAN-COMPILER MODULES]
# Exit status 77: the history of the sources is not here.
set -euo pipefail
source=$(cd "$1" && pwd) archive=$2 work=$3 cc=$4 cxx=$5 fortran=${6:-} modules=${7:-}
version=dc341627
git -C "$source" cat-file -e $version^{commit} 2>/dev/null || { echo "skipped: version 0.2.0 is not here" && exit 77; }
rm -rf "$work"
mkdir -p "$work/blocks"
cd "$work"
git -C "$source" archive $version README.md capi bench/molecules/crambin.pdb | tar -x
cp bench/molecules/crambin.pdb .
for page in README.md capi/guide/*.md; do
  name=$(tr / _ <<<"${page%.md}")
  mkdir "blocks/$name"
  awk -v folder="blocks/$name" -f "$source/tests/packaging/page_blocks.awk" "$page"
done
files=(capi/examples/*.[ch] capi/examples/*.cpp capi/clients/*.h blocks/*/*.c blocks/*/*.cpp)
changed=0 lines=0
for file in "${files[@]}"; do
  sed -f "$source/tests/packaging/migration.sed" "$file" >after
  differ=$(diff "$file" after | grep -c '^>') || true
  [ "$differ" -eq 0 ] || changed=$((changed + 1)) lines=$((lines + differ))
  mv after "$file"
done
if echo 'int main(void) { return 0; }' | "$cc" -fopenmp -x c -o /dev/null - 2>/dev/null; then openmp=-fopenmp; else openmp=; fi
compile() { # compiler, standard, files and options
  "$1" "$2" $openmp -Wall -Wextra -Werror -Wno-unknown-pragmas -I"$source/include" "${@:3}"
}
tried=0
for file in capi/examples/*.c; do
  case $file in
    */split_mpi.c) continue ;; # mpi.h
    */split_threads.c) compile "$cc" -std=c11 -fsyntax-only "$file" ;;
    *) compile "$cc" -std=c99 -fsyntax-only "$file" ;;
  esac
  tried=$((tried + 1))
done
compile "$cc" -std=c99 -fsyntax-only -x c capi/clients/surface_forces.h
for file in capi/examples/*.cpp blocks/*/*.cpp; do compile "$cxx" -std=c++20 -fsyntax-only "$file"; done
if [ -n "$fortran" ]; then
  cat blocks/capi_guide_languages/*.fortran >blocks/languages.f90
  for file in capi/fortran/{draw,labels,minimise,water}.f90 capi/clients/exact_sasa.f90 blocks/languages.f90; do
    "$fortran" -fsyntax-only -Werror -I"$modules" "$file"
  done
fi
# The balls of a gate are in the order of positions now.
printed=0
for folder in blocks/*/; do
  page=$(basename "$folder")
  cat "$folder"*.c >"$page.c" 2>/dev/null || continue
  grep -q 'int main' "$page.c" || { compile "$cc" -std=c99 -fsyntax-only "$page.c" && continue; }
  compile "$cc" -std=c99 "$page.c" "$archive" -lm -o "$page"
  "./$page" crambin.pdb >is
  diff <(sort -u "$folder"*.text) <(sort -u is) || { echo "$page: < the page of 0.2.0, > what is printed" && exit 1; }
  printed=$((printed + $(wc -l <is)))
done
[ $tried -ge 20 ] && [ $printed -ge 30 ] && [ $changed -ge 10 ]
echo "$tried examples, $printed lines printed; $lines lines of $changed files changed"
