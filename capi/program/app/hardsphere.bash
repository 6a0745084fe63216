# Completion for bash, written by: hardsphere completion bash
_hardsphere() {
  local command=${COMP_WORDS[1]} word=${COMP_WORDS[COMP_CWORD]} words=
  if [ "$COMP_CWORD" -eq 1 ]; then
    words="model boundary measure voids contacts complex cells path gate pores clash query mesh map pick draw completion help --help --version"
  elif [[ $word == -* ]]; then
    words="--help --format --radii --radius --probe --json --no-water --no-hetatm --no-hydrogens --only --hide --index --model --models --altloc --chains --assembly --threads"
    case $command in
      model) words+="" ;;
      boundary) words+=" --shells --csv --box" ;;
      measure) words+=" --surface --outer --per-ball --gradient --curvature --weights --polar --by --of --relative --interface --csv --pdb-out --trajectory --frames --begin --end --interval --mean --box" ;;
      voids) words+=" --min-volume --balls --csv" ;;
      contacts) words+=" --by --cells --least --csv --map --dark --trajectory --frames --begin --end --interval --box" ;;
      complex) words+="" ;;
      cells) words+="" ;;
      path) words+=" --from --to" ;;
      gate) words+=" --from --to" ;;
      pores) words+=" --probe --least --gates --regions --pockets --balls --tunnels-from --tunnels-to --cheapest --tunnels --points --tunnels-out --profile --tree --csv --box" ;;
      clash) words+=" --rotate --translate" ;;
      query) words+=" --point --ball" ;;
      mesh) words+=" -o --output --edge --surface --triangles --view --up --rotate --cut --dark --pockets --least" ;;
      map) words+=" --view --up --rotate --per-ball" ;;
      pick) words+=" --at --view --up --rotate" ;;
      draw) words+=" -o --output --picture --view --up --rotate --spin --look --style --palette --colour --range --highlight --occlusion --fog --outline --outline-colour --ink --ink-width --ink-colour --classes --tooltips --width --height --unit --margin --scale --centre --crop --background --fog-colour --label --scale-bar --legend --title --water --pieces --all-balls --as --ball-size --stick" ;;
    esac
  else
    case "$command ${COMP_WORDS[COMP_CWORD - 1]}" in
      "help help") words="model boundary measure voids contacts complex cells path gate pores clash query mesh map pick draw " ;;
      "completion completion") words="bash zsh" ;;
      *" --format") words="xyzr pdb pqr xyz cif gro sdf mol2 pdbqt" ;;
      *" --radii") words="bondi chem3d protor naccess list" ;;
      *" --models") words="merged" ;;
      *" --altloc") words="first occupancy" ;;
      *" --chains") words="auth label" ;;
      "measure --surface") words="sas ses" ;;
      "measure --by") words="residue chain group" ;;
      "contacts --by") words="residue chain" ;;
      "mesh --surface") words="vdw sas ses" ;;
      "mesh --triangles") words="ply obj stl vert svg" ;;
      "draw --picture") words="svg eps pdf" ;;
      "draw --look") words="paper goodsell slide print" ;;
      "draw --style") words="flat headlight soft" ;;
      "draw --palette") words="soft jmol chain" ;;
      "draw --colour") words="element chain residue area bfactor charge plddt" ;;
      "draw --unit") words="px mm" ;;
      "draw --background") words="none" ;;
      "draw --label") words="atom residue chain" ;;
      "draw --pieces") words="g h visible" ;;
      "draw --as") words="balls ball-and-stick" ;;
      "boundary --box" | "measure --box" | "contacts --box" | "pores --box") words="file p1" ;;
    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o bashdefault -o default -F _hardsphere hardsphere
