#!/usr/bin/env bash
# Builds and tests everything, from a bare Debian 12 with git and nothing else:
#   bash tests/run.sh
# as root, or as a user who may use sudo. Installs the packages that are missing, then runs the workflow presets
#   dev       g++, release, warnings are errors: all tests
#   clang     clang++ with address and undefined-behaviour sanitizers: all but slow tests and what no compiler changes
#   portable  g++ without 128-bit integers: the same, without the program
# and prints what ctest said of each. The exit status is 0 only if all three succeeded. Run again it builds only what
# has changed. HSP_WORKFLOWS="dev" runs a part; HSP_WORKFLOWS="long" runs dev with the long form of the slow tests and all
# other processors and compilers.
# Some of dev's tests build for other processors. The compilers for aarch64 and s390x are installed like all the rest;
# if those for riscv64 and armhf cannot be had, their tests are skipped.
set -euo pipefail
cd "$(dirname "$0")/.."

packages=(cmake ninja-build gcc g++ libc6-dev gfortran clang-14 clang libclang-rt-14-dev clang-format clang-format-14 libgtest-dev
  libbenchmark-dev binutils pkg-config g++-aarch64-linux-gnu g++-s390x-linux-gnu qemu-user libxml2-utils ghostscript
  poppler-utils librsvg2-bin)
optional_packages=(g++-riscv64-linux-gnu g++-arm-linux-gnueabihf)

fail() {
  echo "tests/run.sh: $*" >&2
  exit 1
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "not root and no sudo" >&2
    return 1
  fi
}

installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Those of the packages named that are not there, in `missing`.
find_missing() {
  missing=()
  local package
  for package in "$@"; do
    # pkgconf provides pkg-config on Debian 12
    if [ "$package" = pkg-config ] && command -v pkg-config >/dev/null; then continue; fi
    installed "$package" || missing+=("$package")
  done
}

# Install the packages in `missing`; what cannot be installed goes to the function named, with the reason.
install_missing() {
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "installing: ${missing[*]}"
  local package log
  log=$(mktemp)
  if ! as_root apt-get update -qq >"$log" 2>&1; then
    "$1" "${missing[*]} (apt-get update failed: $(tail -n 1 "$log"))"
  else
    for package in "${missing[@]}"; do
      as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$package" >"$log" 2>&1 ||
        "$1" "$package ($(tail -n 1 "$log"))"
    done
  fi
  rm -f "$log"
}
do_not_go_on() {
  fail "cannot install $1"
}
go_on() {
  echo "cannot install $1: tests will be skipped"
}

if command -v dpkg-query >/dev/null; then
  find_missing "${packages[@]}"
  install_missing do_not_go_on
  find_missing "${optional_packages[@]}"
  install_missing go_on
fi
command -v cmake >/dev/null || fail "cmake is missing"

# As many jobs as there are cores, unless the caller says otherwise.
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}

read -ra workflows <<<"${HSP_WORKFLOWS:-dev clang portable}"
logs=build/logs
mkdir -p "$logs"
failed=()
summary=()
for workflow in "${workflows[@]}"; do
  echo "== $workflow"
  status=0
  # A build folder that was made for another place is of no use here.
  fresh=()
  cache=build/$workflow/CMakeCache.txt
  if [ -e "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$cache"; then fresh=(--fresh); fi
  cmake --workflow --preset "$workflow" "${fresh[@]}" 2>&1 | tee "$logs/$workflow.log" || status=$?
  result=$(grep -E '^[0-9]+% tests passed' "$logs/$workflow.log" | tail -n 1 || true)
  skipped=$(grep -cE '\*\*\*Skipped' "$logs/$workflow.log" || true)
  if [ -z "$result" ]; then result="no test ran"; fi
  if [ "$skipped" -gt 0 ]; then result="$result, $skipped skipped"; fi
  summary+=("$workflow: $result")
  if [ $status -ne 0 ] || [ "$result" = "no test ran" ]; then failed+=("$workflow"); fi
done

echo
echo "== summary"
for workflow in "${workflows[@]}"; do
  # ctest's list of failed tests, if there is one
  sed -n '/^The following tests FAILED:/,/^Errors while/p' "$logs/$workflow.log" | grep -v '^Errors while' || true
done
printf '%s\n' "${summary[@]}"
if [ ${#failed[@]} -gt 0 ]; then fail "failed: ${failed[*]}"; fi
