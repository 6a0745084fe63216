# shellcheck shell=bash disable=SC2034
# Debian packages that the scripts of this repository need. To be sourced by bash:
#   . .ci/install.sh
#   install_packages PACKAGE...            installs those that are missing; fails if one cannot be had
#   install_optional_packages PACKAGE...   says which cannot be had, and goes on
# As root, or as a user who may use sudo. Where there is no dpkg, people install what is missing themselves.

# Needed by tests/run.sh: compilers, GoogleTest, the programs that read pictures and look at the format, and a parser of
# C for capi/interface.
packages_for_tests=(cmake ninja-build gcc g++ libc6-dev binutils gfortran pkg-config libgtest-dev libbenchmark-dev
  clang-format-14 libxml2-utils ghostscript poppler-utils librsvg2-bin zlib1g-dev python3-pycparser)
# Needed besides by `tests/run.sh --all`: sanitizers of clang, other linkers, C libraries and processors, documentation,
# a count of instructions.
packages_for_all_tests=(clang clang-14 lld musl-tools libclang-rt-14-dev g++-mips-linux-gnu g++-mingw-w64-x86-64 qemu-user
  doxygen python3-cffi python3-setuptools python3-dev gcc-arm-none-eabi libnewlib-arm-none-eabi
  libstdc++-arm-none-eabi-dev valgrind python3-numpy)
# MPI, machines without an operating system, packages that the Python module serves, proofs of error bounds.
optional_packages_for_all_tests=(openmpi-bin libopenmpi-dev qemu-system-arm python3-mdanalysis python3-ase rustc lammps
  liblammps-dev libopenmm-dev xtb python3-scipy abigail-tools minisign gappa)
# Needed besides by the preset long: other processors, WebAssembly and the page that uses it, packages, and programs that
# draw pictures.
packages_for_long_tests=(g++-aarch64-linux-gnu g++-arm-linux-gnueabihf g++-s390x-linux-gnu g++-riscv64-linux-gnu
  g++-powerpc64le-linux-gnu g++-mips64el-linux-gnuabi64 g++-i686-linux-gnu googletest wasi-libc libclang-rt-14-dev-wasm32
  libc++-14-dev-wasm32 libc++abi-14-dev-wasm32 nodejs chromium wine64 debootstrap dpkg-dev debhelper dh-python lintian
  cairosvg inkscape mupdf-tools clang-19 llvm-19 libclang-rt-19-dev)
# Programs that `bench/run.sh --peers` times beside the library. FreeSASA's archive needs two libraries that it reads
# files with.
packages_of_peers=(freesasa libxml2-dev libjson-c-dev libcgal-dev libnanoflann-dev gemmi-dev tao-pegtl-dev libfcl-dev
  python3 gromacs python3-mdtraj)

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "not root and no sudo"
    return 1
  fi
}

apt_install() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@"
}

# Most packages have a program of their name. It may have come from elsewhere.
is_there() {
  local program=$1
  case $program in
    ninja-build) program=ninja ;;
    binutils) program=ld ;;
    mupdf-tools) program=mutool ;;
  esac
  command -v "$program" >/dev/null || [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Installs what is missing of the packages named. Packages that could not be installed are left in `missing`, the reason
# in `reason`.
try_to_install() {
  missing=() reason=
  command -v dpkg-query >/dev/null || return 0
  local package
  for package in "$@"; do
    is_there "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "installing: ${missing[*]}"
  local log
  log=$(mktemp)
  if as_root apt-get update -qq >"$log" 2>&1; then
    if apt_install "${missing[@]}" >"$log" 2>&1; then
      missing=()
    else
      # One by one, so that one that does not exist does not keep out the others.
      local left=()
      for package in "${missing[@]}"; do
        apt_install "$package" >"$log" 2>&1 || { left+=("$package") && reason=$(tail -n 1 "$log"); }
      done
      missing=("${left[@]}")
    fi
  else
    reason="apt-get update: $(tail -n 1 "$log")"
  fi
  rm -f "$log"
}

install_packages() {
  try_to_install "$@"
  [ ${#missing[@]} -eq 0 ] || { echo "cannot install ${missing[*]}: $reason" >&2 && return 1; }
}

install_optional_packages() {
  try_to_install "$@"
  [ ${#missing[@]} -eq 0 ] || echo "cannot install ${missing[*]}: $reason"
}
