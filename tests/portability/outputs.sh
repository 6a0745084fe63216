#!/usr/bin/env bash
# Runs a build's programs on a list of inputs and writes what they print, and their exit statuses, into a folder.
#   outputs.sh SOURCE-FOLDER OUTPUT-FOLDER EMULATOR PROGRAM INTERFACE-BITS ARC-TANGENT-BITS [NAMES]
# EMULATOR may be empty. NAMES: a regular expression; only the outputs it matches. Or `few`: bits of the interface for some
# sets, crambin and caffeine, degenerate balls, a few pictures and refusals. Fails if a run that has to succeed does not.
set -euo pipefail
source=$1 outputs=$2 emulator=$3 program=$4 interface_bits=$5 arc_tangent_bits=$6 names=${7:-}
export LC_ALL=C
step=4
if [ "$names" = few ]; then
  step=16 # what an emulator runs takes a hundred times as long
  names='^(interface_bits_of_some|arc_tangent_bits|(crambin|caffeine|degenerate)(\.probe)?\.(measure|boundary)|crambin\.(contacts|map)'
  names+='|picture\.(surface|cut|tunnels|tree|contacts|labels).*|draw\.(caffeine\.soft\.svg|crambin\.faces\.pdf|degenerate\.flat\.eps)|bad\.[a-d].*)$'
fi
rm -rf "$outputs"
mkdir -p "$outputs"
cd "$source"
failed=0

record() { # name, command
  local name=$1 status=0
  shift
  [[ $name =~ $names ]] || return 0
  # shellcheck disable=SC2086 # no emulator is no word
  $emulator "$@" >"$outputs/$name" 2>&1 </dev/null || status=$?
  echo "exit status $status" >>"$outputs/$name"
}

succeed() { # name, command
  [[ $1 =~ $names ]] || return 0
  record "$@"
  if [ "$(tail -n 1 "$outputs/$1")" != "exit status 0" ]; then
    echo "$emulator ${*:2}"
    tail -n 2 "$outputs/$1" | cut -c 1-400
    failed=1
  fi
}

# A program in that floating-point environment has the same answers of the interface, if there is such an environment
# here (tests/support/host).
same_in() { # environment
  local status=0
  # shellcheck disable=SC2086
  HSP_HOST_ENVIRONMENT=$1 $emulator "$interface_bits" $step >"$outputs/$1" 2>&1 </dev/null || status=$?
  echo "exit status $status" >>"$outputs/$1"
  if [ $status -eq 77 ]; then
    echo "there is no environment $1 here"
  elif ! cmp "$outputs/bits_in_environments" "$outputs/$1"; then
    failed=1
  fi
  rm "$outputs/$1"
}

both_commands() { # record or succeed, name, options
  local how=$1 name=$2
  shift 2
  $how "$name.measure" "$program" measure --per-ball --gradient --json "$@"
  $how "$name.boundary" "$program" boundary --json --shells "$@"
}

# A picture is compared as a file of its own. Without occlusion, which is the program's, not the library's.
draw() { # name with the format's ending, options
  local name=$1
  shift
  succeed "draw.$name" "$program" draw --json --occlusion 0 --title "$name" -o "$outputs/$name" "$@"
}

succeed interface_bits "$interface_bits"
succeed interface_bits_of_some "$interface_bits" 4
if [[ interface_bits_of_some =~ $names ]]; then
  names="" record bits_in_environments "$interface_bits" $step
  for environment in flushing traps upward downward to_zero; do same_in $environment; done
  rm "$outputs/bits_in_environments"
fi
succeed arc_tangent_bits "$arc_tangent_bits"

for molecule in crambin caffeine acetyl_coa; do
  both_commands succeed $molecule bench/molecules/$molecule.pdb
  both_commands succeed $molecule.probe bench/molecules/$molecule.pdb --probe 1.4
  succeed $molecule.model "$program" model --json bench/molecules/$molecule.pdb
  succeed $molecule.query "$program" query --json bench/molecules/$molecule.pdb --ball 10 5 8 6.5
done
succeed crambin.table "$program" measure --per-ball bench/molecules/crambin.pdb
succeed crambin.csv "$program" measure --gradient --csv bench/molecules/crambin.pdb
succeed crambin.residues "$program" measure --by residue --json bench/molecules/crambin.pdb
succeed crambin.voids "$program" voids --json bench/molecules/crambin.pdb --probe 1.4
succeed crambin.pores "$program" pores --json bench/molecules/crambin.pdb --pockets 3 --tunnels-from 9.6,12.8,5.7
succeed crambin.points "$program" pores bench/molecules/crambin.pdb --probe 0.8 --pockets 3 --points -
succeed crambin.tunnels "$program" pores bench/molecules/crambin.pdb --tunnels-from 9.6,12.8,5.7 --tunnels-out -
succeed crambin.output "$program" measure bench/molecules/crambin.pdb --pdb-out "$outputs/crambin.pdb"
succeed formats "$program" measure --csv tests/program/inputs/good/water.{pdb,cif,gro}
succeed crambin.box "$program" measure --json --probe 1.4 --box 25,0,0,7,18,0,-9,5,20 --per-ball bench/molecules/crambin.pdb
succeed crambin.box.contacts "$program" contacts --json --box 40.96,18.65,22.52 bench/molecules/crambin.pdb
succeed crambin.map "$program" map --json bench/molecules/crambin.pdb --view 1,2,3
succeed crambin.pick "$program" pick --json bench/molecules/crambin.pdb --at 10,12 --view 1,2,3
succeed crambin.contacts "$program" contacts --cells --json bench/molecules/crambin.pdb --probe 1.4
succeed crambin.complex "$program" complex --json bench/molecules/crambin.pdb
succeed crambin.curvature "$program" measure --curvature --json bench/molecules/crambin.pdb
succeed crambin.cells "$program" cells --json bench/molecules/crambin.pdb --probe 1.4
succeed crambin.clash "$program" clash --json bench/molecules/c{rambin,affeine}.pdb --rotate 10,20,30 --translate 8,11,4
degenerate=tests/portability/inputs/degenerate.xyzr
both_commands succeed degenerate $degenerate
both_commands succeed degenerate.probe $degenerate --probe 0.5
succeed degenerate.voids "$program" voids --json $degenerate
succeed degenerate.pores "$program" pores --json $degenerate --pockets 1
succeed degenerate.query "$program" query --json $degenerate --point 4 0 0

for style in flat headlight soft; do
  for format in svg eps pdf; do
    draw caffeine.$style.$format bench/molecules/caffeine.pdb --style $style --rotate 30,-20,10.5
    draw degenerate.$style.$format $degenerate --style $style --all-balls
  done
  draw crambin.$style.svg bench/molecules/crambin.pdb --style $style --palette jmol
done
draw crambin.up.eps bench/molecules/crambin.pdb --style flat --view 1,2,-3 --up 0,0,1 --outline 0 --width 80 --unit mm
draw crambin.faces.pdf bench/molecules/crambin.pdb --style flat --pieces h --rotate 90,0,0 --fog 0 --background none
draw degenerate.faces.svg $degenerate --style flat --pieces h --view 1,1,1 --height 300
draw degenerate.probe.svg $degenerate --style headlight --probe 0.5 --rotate 0,90,0 --palette chain
draw crambin.seen.pdf bench/molecules/crambin.pdb --style flat --pieces visible --view 1,2,3
for pieces in "" "--pieces visible" "--pieces visible --ball-size 0.6"; do
  draw "crambin.sticks${pieces// /}.svg" bench/molecules/crambin.pdb --as ball-and-stick --view 1,2,3 $pieces
done

# Pictures that the program makes of its own, without the library's writers.
caffeine=bench/molecules/caffeine.pdb crambin=bench/molecules/crambin.pdb
succeed picture.surface "$program" mesh --json --probe 1.4 --surface ses $caffeine -o "$outputs/picture.surface.svg"
succeed picture.cut "$program" mesh --json --probe 1.4 --cut --edge 0.8 $crambin -o "$outputs/picture.cut.svg"
succeed picture.tunnels "$program" pores $crambin --tunnels-from 9.6,12.8,5.7 --profile -
succeed picture.tree "$program" pores $crambin --probe 0.5 --pockets 2 --tree -
succeed picture.pockets "$program" mesh --json --probe 0.8 --surface ses --edge 1 --pockets 3 --least 0.1 --cut $crambin \
  -o "$outputs/picture.pockets.svg"
succeed picture.contacts "$program" contacts --json --by residue $crambin --map "$outputs/picture.contacts.svg"
succeed picture.labels "$program" draw --json --as ball-and-stick --label atom --legend $caffeine \
  -o "$outputs/picture.labels.svg"

succeed crambin.drawn "$program" draw --json bench/molecules/crambin.pdb -o "$outputs/crambin.svg"

# All that the program's own tests read, and what it says to what it refuses: characters, signs, exponents.
for input in tests/program/inputs/good/*; do both_commands record "good.${input##*/}" "$input"; done
for input in tests/program/inputs/bad/*; do record "bad.${input##*/}" "$program" measure --json "$input"; done

files=("$outputs"/*)
echo "${#files[@]} outputs, $(cat "${files[@]}" | wc -c) bytes"
exit $failed
