#!/usr/bin/env bash
# Runs a test of capi/python with a shared library made of the archive.
#   module.sh VARIANT SOURCE-FOLDER ARCHIVE PROGRAM WORK-FOLDER C-COMPILER
# VARIANT
#   numpy, lists      the module with numpy, and as if there were none
#   mdanalysis, ase   what serves these packages
#   page              the page of the guide
#   wheel             the wheel, installed into an empty folder and an empty environment
# Exit status 77: a package is missing here. Debian's Python, which has Debian's packages, goes before another one in PATH.
set -euo pipefail
variant=$1 source=$2 archive=$3 program=$4 work=$5 cc=$6
here=$(cd "$(dirname "$0")" && pwd)
python=/usr/bin/python3
[ -x $python ] || python=$(command -v python3) || { echo "skipped: there is no python3 here" && exit 77; }
needs=()
test=$variant
case $variant in
  numpy) needs=(numpy) test=module ;;
  lists) test=module ;;
  page) needs=(numpy) ;;
  mdanalysis) needs=(numpy MDAnalysis) ;;
  ase) needs=(numpy ase) ;;
esac
for package in "${needs[@]}"; do
  $python -c "import $package" 2>/dev/null || { echo "skipped: there is no $package here" && exit 77; }
done
rm -rf "$work"
mkdir -p "$work"
"$python" "$here/exported.py" "$archive" "$work/libhardsphere.so.2" "$cc"
export PYTHONDONTWRITEBYTECODE=1 HSP_SOURCE=$source HSP_PROGRAM=$program
if [ "$variant" = wheel ]; then
  mkdir "$work/again" "$work/alone"
  wheel=$("$python" "$source/capi/python/wheel.py" "$work/libhardsphere.so.2" "$work" "$program")
  cmp "$wheel" "$("$python" "$source/capi/python/wheel.py" "$work/libhardsphere.so.2" "$work/again" "$program")"
  mkdir "$work/packed"
  packed=$("$python" "$source/capi/python/wheel.py" --lzma "$work/libhardsphere.so.2" "$work/packed" "$program")
  [ $(($(stat -c %s "$packed") * 8)) -lt $(($(stat -c %s "$wheel") * 7)) ] || { echo "$packed is no smaller" && exit 1; }
  # The platform by what symbols ask for, of the library and of a file that asks for more.
  alone=$("$python" "$source/capi/python/wheel.py" "$work/libhardsphere.so.2" "$work/alone")
  newer=$("$python" "$source/capi/python/wheel.py" "$work/libhardsphere.so.2" "$work/alone" /usr/bin/env)
  if command -v objdump >/dev/null && [[ $alone = *linux_x86_64.whl ]]; then
    for file in "$alone" "$newer"; do
      files=("$work/libhardsphere.so.2")
      [ "$file" = "$alone" ] || files+=(/usr/bin/env)
      least=$(for f in "${files[@]}"; do objdump -T "$f"; done | grep -oE 'GLIBC_[0-9]+\.[0-9]+' | sort -u -t. -k 2n | tail -n 1)
      [[ $file = *py3-none-manylinux_$(tr . _ <<<"${least#GLIBC_}")_x86_64.whl ]] ||
        { echo "$file, and symbols ask for $least" && exit 1; }
    done
  fi
  shot='import hardsphere, os
assert os.path.dirname(hardsphere.library._name) == os.path.dirname(hardsphere.__file__), hardsphere.library._name
print(f"{hardsphere.measure([[0, 0, 0], [1, 0, 0]], [1, 1]).area:.6f}")'
  "$python" -c 'import sys, zipfile; zipfile.ZipFile(sys.argv[1]).extractall(sys.argv[2])' "$wheel" "$work/unpacked"
  [ "$(cd / && PYTHONPATH=$work/unpacked "$python" -c "$shot")" = 18.849556 ]
  file='import hardsphere, sys
print(f"{hardsphere.read(sys.argv[1]).balls(probe=1.4).area:.6f}")'
  chmod +x "$work/unpacked/hardsphere/hardsphere" # as installers do
  area() { (cd / && PATH=/none PYTHONPATH=$1 "$python" -c "$file" "$source/bench/molecules/crambin.pdb"); }
  [ "$(area "$work/unpacked")" = 2971.323016 ]
  if installer=$(command -v pip3) && "$installer" --version >"$work/pip" 2>&1; then
    "$installer" install --quiet --disable-pip-version-check --no-index --no-deps --target "$work/installed" "$packed"
    [ "$(cd / && PYTHONPATH=$work/installed "$python" -c "$shot")" = 18.849556 ]
    [ "$(area "$work/installed")" = 2971.323016 ]
    (cd / && PYTHONPATH=$work/installed "$work/installed/bin/hardsphere" --version)
  fi
  if "$python" -m venv --without-pip "$work/environment" 2>"$work/venv"; then
    site=$("$work/environment/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
    cp -r "$work/unpacked/." "$site"
    [ "$(cd / && "$work/environment/bin/python" -c "$shot")" = 18.849556 ]
  fi
  echo "$(basename "$wheel"): $(stat -c %s "$wheel") bytes, $(stat -c %s "$packed") with --lzma"
  exit 0
fi
export HARDSPHERE_PROGRAM=$program
export HARDSPHERE_LIBRARY=$work/libhardsphere.so.2 PYTHONPATH=$source/capi/python:$here
[ "$variant" != lists ] || export HSP_WITHOUT_NUMPY=1
exec "$python" "$here/${test}_test.py"
