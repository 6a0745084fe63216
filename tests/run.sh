#!/usr/bin/env bash
# Builds and tests, from a bare Debian 12 with git and nothing else, as root or as a user who may use sudo:
#   bash tests/run.sh           g++, release, warnings are errors: all tests but the slow ones
#   bash tests/run.sh --all     all tests, in three builds:
#                                 all       g++, as above, with the slow tests and builds for other processors
#                                 clang     clang++ with address and undefined-behaviour sanitizers
#                                 portable  g++ without 128-bit integers
#                               clang and portable leave out the slow tests and those that they cannot change
#   bash tests/run.sh PRESET... other workflow presets of CMakePresets.json, e.g. long or coverage
#   bash tests/run.sh --help    prints this
# Installs the packages that are missing, builds in build/, prints what ctest says and repeats its closing lines at the
# end; build/logs holds all of it. The exit status is 0 only if every test succeeded. Run again it builds only what has
# changed. On two cores the first takes 8 to 20 minutes, packages included, --all 24 to 45. The number of jobs, as many as
# there are cores unless given: CMAKE_BUILD_PARALLEL_LEVEL, CTEST_PARALLEL_LEVEL. HSP_MOLECULES: a folder of further
# molecules.
set -euo pipefail
cd "$(dirname "$0")/.."

presets=(dev)
case ${1:-} in
  --help | -h)
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' tests/run.sh
    exit
    ;;
  --all)
    [ $# -eq 1 ] || { echo "tests/run.sh: nothing may follow --all" >&2 && exit 2; }
    presets=(all clang portable)
    ;;
  -*)
    echo "tests/run.sh: unknown option $1, see --help" >&2
    exit 2
    ;;
  ?*) presets=("$@") ;;
esac

# shellcheck source=.ci/install.sh
. .ci/install.sh
install_packages "${packages_for_tests[@]}"
if [ "${presets[*]}" != dev ]; then
  install_packages "${packages_for_all_tests[@]}"
  install_optional_packages "${optional_packages_for_all_tests[@]}"
fi
if [[ " ${presets[*]} " == *" long "* ]]; then install_optional_packages "${packages_for_long_tests[@]}"; fi

export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}
mkdir -p build/logs
# A build folder that was made for another checkout is of no use here.
for cache in build/*/CMakeCache.txt; do
  if [ -e "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$cache"; then
    rm -rf "$cache" "$(dirname "$cache")/CMakeFiles"
  fi
done

failed=()
for preset in "${presets[@]}"; do
  echo "== $preset"
  cmake --workflow --preset "$preset" 2>&1 | tee "build/logs/$preset.log" || failed+=("$preset")
done

echo
for preset in "${presets[@]}"; do
  echo "== $preset"
  sed -n '/^[0-9]*% tests passed/,$p' "build/logs/$preset.log" | grep . || echo "no test ran"
done | tee build/logs/closing_lines.txt
if [ ${#failed[@]} -gt 0 ]; then
  echo "tests/run.sh: failed: ${failed[*]}" >&2
  exit 1
fi
