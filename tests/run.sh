#!/usr/bin/env bash
# Builds and tests, from a bare Debian 12 with git and nothing else, as root or as a user who may use sudo:
#   bash tests/run.sh           g++, release, warnings are errors: all tests but the slow ones
#   bash tests/run.sh --all     as in CI, in two builds; what is quick and fails most often comes first:
#                                 dev       g++, as above
#                                 clang     clang++ with address and undefined-behaviour sanitizers, and indices checked;
#                                           without the slow tests and those that it cannot change
#                                 slow      g++, the slow tests and builds for another processor
#   bash tests/run.sh PRESET... other workflow presets of CMakePresets.json: long, evidence, portable, coverage
#   bash tests/run.sh --help    prints this
# Installs the packages that are missing, builds in build/, prints what ctest says and repeats its closing lines at the
# end; build/logs holds all of it. The exit status is 0 only if every test succeeded. Run again it builds only what has
# changed. It says how long each step took. The number of jobs, as many as there are cores unless given:
# CMAKE_BUILD_PARALLEL_LEVEL, CTEST_PARALLEL_LEVEL. HSP_MOLECULES: a folder of further molecules.
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
    presets=(dev clang slow)
    ;;
  -*)
    echo "tests/run.sh: unknown option $1, see --help" >&2
    exit 2
    ;;
  ?*) presets=("$@") ;;
esac

mkdir -p build/logs
# shellcheck source=.ci/install.sh
. .ci/install.sh
install_packages "${packages_for_tests[@]}"
if [ "${presets[*]}" != dev ]; then
  install_packages "${packages_for_all_tests[@]}"
  install_optional_packages "${optional_packages_for_all_tests[@]}"
fi
if [[ " ${presets[*]} " =~ \ (long|evidence)\  ]]; then install_optional_packages "${packages_for_long_tests[@]}"; fi
printf '== packages: %d s\n' $SECONDS | tee build/logs/steps.log

export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}
# A build folder that was made for another checkout is of no use here.
for cache in build/*/CMakeCache.txt; do
  if [ -e "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$cache"; then
    rm -rf "$cache" "$(dirname "$cache")/CMakeFiles"
  fi
done

failed=()
# Runs a step of a preset; what it prints goes to the preset's log, too.
step() { # preset, what is done, command
  local preset=$1 what=$2 begun=$SECONDS status=0
  shift 2
  "$@" 2>&1 | tee -a "build/logs/$preset.log" || status=$?
  printf '== %s, %s: %d s\n' "$preset" "$what" $((SECONDS - begun)) | tee -a build/logs/steps.log
  return $status
}
for preset in "${presets[@]}"; do
  echo "== $preset"
  : >"build/logs/$preset.log"
  case $preset in slow | long | evidence) configuration=dev ;; *) configuration=$preset ;; esac
  if ! step "$preset" configuration cmake --preset "$configuration"; then
    failed+=("$preset")
    continue
  fi
  # Tests that read sources alone fail before anything is built.
  if [ "$preset" = dev ]; then step "$preset" "tests of the text" ctest --preset text || failed+=("$preset"); fi
  if step "$preset" build cmake --build --preset "$preset"; then
    step "$preset" tests ctest --preset "$preset" || failed+=("$preset")
  else
    failed+=("$preset")
  fi
done

echo
for preset in "${presets[@]}"; do
  echo "== $preset"
  # Those of the last run of ctest.
  awk '/^[0-9]+% tests passed/ { lines = 0; ran = 1 } NF { line[++lines] = $0 }
    END { if (!ran) print "no test ran"; for (k = 1; ran && k <= lines; ++k) print line[k] }' "build/logs/$preset.log"
done | tee build/logs/closing_lines.txt
echo
cat build/logs/steps.log
if [ ${#failed[@]} -gt 0 ]; then
  echo "tests/run.sh: failed: ${failed[*]}" >&2
  exit 1
fi
