#!/usr/bin/env bash
# An example in C and its twin in C++: the same bytes on standard output but for what is said of time, and the same exit
# status.
#   cpp_example.sh EXAMPLE SOURCE-FOLDER WORK-FOLDER PROGRAM-IN-C PROGRAM-IN-C++
# The program in C++ of the guide prints what the page says.
#   cpp_example.sh page SOURCE-FOLDER WORK-FOLDER C++-COMPILER LIBRARY
set -euo pipefail
example=$1 source=$2 work=$3 c=$4 cpp=$5
export LC_ALL=C
rm -rf "$work"
mkdir -p "$work"
if [ "$example" = page ]; then
  page=$source/capi/guide/languages.md
  awk -v folder="$work" -f "$source/tests/packaging/page_blocks.awk" "$page"
  cat "$work"/*.cpp >"$work/page.cpp"
  "$c" -std=c++20 -Wall -Wextra -Werror -I"$source/include" "$work/page.cpp" "$cpp" -lm -o "$work/page"
  "$work/page" >"$work/printed"
  [ "$(head -n 1 "$work/printed")" = "$(cat "$work"/*.text)" ]
  grep -qF "\`$(tail -n 1 "$work/printed")\`" "$page"
  exit
fi
good=$source/tests/program/inputs/good
awk 'BEGIN { radius["C"] = 1.7; radius["N"] = 1.55; radius["O"] = 1.52; radius["S"] = 1.8 }
  /^(ATOM|HETATM)/ {
    element = substr($0, 77, 2)
    gsub(/ /, "", element)
    print substr($0, 31, 8), substr($0, 39, 8), substr($0, 47, 8), radius[element]
  }' "$source/bench/molecules/crambin.pdb" >"$work/crambin.xyzr"
head -n 150 "$work/crambin.xyzr" >"$work/first.xyzr"
tail -n +151 "$work/crambin.xyzr" >"$work/second.xyzr"
printf '0 0 0 -1\n' >"$work/negative.xyzr"
printf '0 0 0\n' >"$work/short.xyzr"
: >"$work/empty.xyzr"
printf '0 0 0 1e-300\n' >"$work/tiny.xyzr"
{
  printf '#%600s1 2 3 1\n' ''
  cat "$good/three_comments.xyzr"
} >"$work/comment.xyzr"

case $example in
  cavities) calls=("" "$good/cage.xyzr" "$good/cage.xyzr 0.1 3 3 3" "$work/crambin.xyzr 1.4 9.6 12.8 5.7"
    "$work/crambin.xyzr 0.3" "$work/negative.xyzr" "$work/short.xyzr" "$work/none" "$work" "$work/empty.xyzr 1 2 3 4"
    "$work/comment.xyzr 1 2 3 4") ;;
  interface) calls=("$work/first.xyzr $work/second.xyzr" "$work/first.xyzr $work/second.xyzr 0"
    "$good/one.xyzr $good/apart.xyzr" "$work/first.xyzr" "$work/negative.xyzr $work/first.xyzr"
    "$work/empty.xyzr $work/empty.xyzr" "$work/first.xyzr $work/empty.xyzr") ;;
  neighbour_list) calls=("$work/crambin.xyzr 6" "$work/crambin.xyzr 4 print" "$good/three_comments.xyzr 9 print"
    "$work/crambin.xyzr -1" "$work/crambin.xyzr" "$work/short.xyzr 3" "$work/empty.xyzr 3 print" "$work/comment.xyzr 9 print") ;;
  solvent_box) calls=("$work/crambin.xyzr 41 19 23" "$work/first.xyzr 30 30 30" "$work/crambin.xyzr 41 19"
    "$work/crambin.xyzr 1 1 1" "$work/none 30 30 30" "$work/negative.xyzr 30 30 30"
    "$work/empty.xyzr 30 30 30" "$good/one.xyzr 2900 3 3") ;;
  monte_carlo) calls=("$work/first.xyzr $work/second.xyzr 2000" "$work/second.xyzr $good/one.xyzr 500"
    "$work/first.xyzr" "$work/first.xyzr $work/negative.xyzr" "$work/empty.xyzr $work/empty.xyzr 100") ;;
  single_atoms) calls=("$work/first.xyzr 2000" "$good/cage.xyzr 500" "$work/none" "$work/negative.xyzr 10" "$work/empty.xyzr 10"
    "$work/tiny.xyzr 10") ;;
  pores) calls=("" "$work/first.xyzr 20" "$work/crambin.xyzr" "$good/one.xyzr" "$work/none" "$work/negative.xyzr" "$work/empty.xyzr") ;;
esac
refused=0
for call in "${calls[@]}"; do
  read -ra arguments <<<"$call"
  is=0 was=0
  "$c" "${arguments[@]}" >"$work/c" 2>"$work/c.err" || was=$?
  "$cpp" "${arguments[@]}" >"$work/cpp" 2>"$work/cpp.err" || is=$?
  sed -i '/ a second$/d' "$work/c" "$work/cpp"
  cmp "$work/c" "$work/cpp"
  [ $was -eq $is ] || { echo "$call: exit status $is, and $was of the one in C" && exit 1; }
  [ $is -ne 0 ] || [ -s "$work/cpp" ] || { echo "$call: nothing is printed" && exit 1; }
  [ $is -eq 0 ] || [ -s "$work/cpp.err" ] || { echo "$call: nothing is said of the failure" && exit 1; }
  [ $is -eq 0 ] || refused=$((refused + 1))
done
[ $refused -ge 2 ] || { echo "only $refused calls were refused" && exit 1; }
echo "${#calls[@]} calls, $refused of them refused"
