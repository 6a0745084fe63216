#!/usr/bin/env bash
# The declarations for another language: compiled where there is a compiler, layouts of all structs as in the record of the
# binary interface, and an area.
#   lens.sh rust|julia SOURCE-FOLDER ARCHIVE WORK-FOLDER C-COMPILER
# Exit status 77: there is no compiler of that language here.
set -euo pipefail
language=$1 source=$2 archive=$3 work=$4 cc=$5
here=$(cd "$(dirname "$0")" && pwd)
case $language in
  rust) compiler=rustc ;;
  julia) compiler=julia ;;
esac
"$compiler" --version >/dev/null 2>&1 || { echo "skipped: there is no $compiler here" && exit 77; }
rm -rf "$work"
mkdir -p "$work"
cd "$work"
case $language in
  rust)
    awk '/^#/ { next }
      { split($2, number, "/"); fields = split($1, name, ".") }
      fields == 1 { print "    assert_eq!(std::mem::size_of::<" $1 ">(), " number[1] ");" }
      fields == 2 { print "    assert_eq!(offset!(" name[1] ", " name[2] "), " number[1] ");" }' \
      "$source/capi/abi/structs.txt" >rows
    [ "$(wc -l <rows)" -gt 500 ] || { echo "only $(wc -l <rows) layouts were found" && exit 1; }
    cat >layouts.rs <<RUST
macro_rules! offset {
    (\$kind:ty, \$field:ident) => {{
        let held: \$kind = unsafe { std::mem::zeroed() };
        std::ptr::addr_of!(held.\$field) as usize - std::ptr::addr_of!(held) as usize
    }};
}
fn check_layouts() {
$(cat rows)
}
RUST
    for edition in 2024 2021; do
      rustc --edition $edition --print cfg >/dev/null 2>&1 || continue # an older compiler
      rustc --edition $edition -D warnings --crate-type rlib --crate-name hardsphere \
        "$source/capi/bindings/hardsphere.rs"
    done
    HSP_LAYOUTS=$work/layouts.rs rustc --edition 2021 -D warnings --extern hardsphere=libhardsphere.rlib \
      -C link-arg="$archive" -C link-arg=-lm "$here/lens.rs"
    ./lens >printed
    ;;
  julia)
    python3 "$source/tests/python/exported.py" "$archive" "$work/libhardsphere.so.2" "$cc"
    HARDSPHERE_LIBRARY=$work/libhardsphere.so.2 julia "$here/lens.jl" "$source/capi/bindings/hardsphere.jl" \
      "$source/capi/abi/structs.txt" >printed
    ;;
esac
[ "$(cat printed)" = "18.849556 9.424778" ] || { cat printed && exit 1; }
