# Of `objdump -dr --no-show-raw-insn` of an archive for x86-64: whether each function of the interface sets the
# floating-point environment, and if not, whether arithmetic of floating-point numbers can be reached from it.
#   awk -f floating_point.awk DISASSEMBLY DISASSEMBLY
# prints lines "NAME guarded|unguarded|none". A function reaches what it calls or takes the address of.
function reach(from, to) {
  if (from != to && !((from, to) in seen)) {
    seen[from, to] = 1
    callers[to] = callers[to] " " from
  }
}
# A name that other files can see is the same in all of them. The compiler's own copies of functions are its file's.
function key(name) { return (object, name) in local ? object ":" name : name }
function function_named(line) {
  sub(/^[0-9a-f]+ </, "", line)
  sub(/>:$/, "", line)
  return line
}
FNR == NR { # first time: which functions are in which file and section
  if (/file format/) object = $1
  else if (/^Disassembly of section/) section = substr($4, 1, length($4) - 1)
  else if (/^[0-9a-f]+ <.*>:$/) {
    name = function_named($0)
    if (name ~ /\.|GLOBAL__N/) local[object, name] = 1
    in_section[object, section] = in_section[object, section] " " key(name)
  }
  next
}
/file format/ { object = $1; next }
/^[0-9a-f]+ <.*>:$/ {
  name = function_named($0)
  current = key(name)
  if (name ~ /^hsp_[a-z_]+$/) entry[name] = 1
  # Code that the compiler has put apart belongs to the function.
  if (name ~ /\.cold/) { whole = name; sub(/\.cold.*/, "", whole); reach(key(whole), current) }
  next
}
/R_X86_64_/ {
  name = $3
  sub(/[-+]0x[0-9a-f]+$/, "", name)
  if ((object, name) in in_section) {
    count = split(in_section[object, name], there, " ")
    for (k = 1; k <= count; ++k) reach(current, there[k])
  } else {
    reach(current, key(name))
  }
  next
}
/<[^>]*>/ { # a jump or call within the section
  name = $0
  sub(/^[^<]*</, "", name)
  sub(/>.*/, "", name)
  sub(/[-+]0x[0-9a-f]+$/, "", name)
  reach(current, key(name))
}
$2 ~ /^v?(add|sub|mul|div|sqrt|min|max|ucomi|comi|cmp[a-z_]*|round|dp|hadd|hsub|addsub|rcp|rsqrt|fn?m(add|sub)[0-9a-z]*)(ss|sd|ps|pd)$/ ||
  $2 ~ /^v?cvt/ || $2 ~ /^f[a-z]/ { if (!(current in computes)) { computes[current] = 1; todo[++last] = current } }
$2 == "stmxcsr" || $2 == "vstmxcsr" { own[current] = 1 }
END {
  # Backwards, from what computes to what it is reached from, as far as somebody who looks at the environment.
  for (first = 1; first <= last; ++first) {
    if (todo[first] in own) continue
    count = split(callers[todo[first]], above, " ")
    for (k = 1; k <= count; ++k) {
      if (!(above[k] in computes)) { computes[above[k]] = 1; todo[++last] = above[k] }
    }
  }
  for (name in entry) print name, (name in own ? "guarded" : name in computes ? "unguarded" : "none")
}
