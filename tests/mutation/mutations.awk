# Reads mutations.txt and looks for the text that a mutation replaces, in the files of a tree. Spaces and line ends do
# not count, so that a change of format breaks no mutation.
#   awk -v root=TREE -v name=NAME -f mutations.awk mutations.txt    writes that mutant over the file in TREE
#   awk -v root=TREE -f mutations.awk mutations.txt                 names the mutations that cannot be made, and why
# Exit status 1: one cannot be made, as there is none of that name, no such file, or its text does not stand there
# exactly once.
function without_spaces(text) {
  gsub(/[ \t\n]+/, "", text)
  return text
}

function content(file,  line, whole) {
  whole = ""
  while ((getline line < file) > 0) whole = whole line "\n"
  close(file)
  return whole
}

# The position of the n-th character that is no space.
function position(whole, n,  k) {
  for (k = 1; k <= length(whole); ++k) {
    if (index(" \t\n", substr(whole, k, 1)) == 0 && --n == 0) return k
  }
}

function complain(why) {
  print current ": " why
  failed = 1
}

# The fault of the mutation just read, or nothing. Sets `place`, the position of its text in the file without spaces.
function judge(  rest) {
  if (!(file in stripped)) stripped[file] = without_spaces(content(root "/" file))
  if (stripped[file] == "") return "there is no " file
  if (without_spaces(before) == "") return "replaces nothing"
  if (without_spaces(before) == without_spaces(after)) return "changes nothing"
  place = index(stripped[file], without_spaces(before))
  if (place == 0) return "its text does not stand in " file
  rest = substr(stripped[file], place + 1)
  if (index(rest, without_spaces(before)) > 0) return "its text stands in " file " more than once"
  return ""
}

function finish_mutation(  why, whole, first, last) {
  if (current == "" || (name != "" && name != current)) return
  sub(/\n$/, "", before)
  sub(/\n$/, "", after)
  why = part == "+" ? judge() : "does not say what stands there instead"
  if (current in known) why = "a second one of this name"
  known[current] = 1
  if (why != "") {
    complain(why)
  } else if (name != "") {
    whole = content(root "/" file)
    first = position(whole, place)
    last = position(whole, place + length(without_spaces(before)) - 1)
    printf "%s%s%s", substr(whole, 1, first - 1), after, substr(whole, last + 1) > (root "/" file)
  }
}

/^#/ && part == "" { next }
/^[a-z][0-9][0-9]+ [^ ]+( [a-z0-9_]+)?$/ {
  finish_mutation()
  current = $1
  file = $2
  ended = 0
  part = before = after = ""
  next
}
# A blank line ends a mutation.
part == "+" && $0 == "" { ended = 1; next }
part == "+" && ended {
  complain("behind it stands a line without a name: " $0)
  next
}
/^- / && part == "" { part = "-"; before = substr($0, 3) "\n"; next }
(/^\+ / || $0 == "+") && part == "-" { part = "+"; after = substr($0, 3) "\n"; next }
part == "-" && $0 != "" { before = before $0 "\n" }
part == "+" && $0 != "" { after = after $0 "\n" }
END {
  finish_mutation()
  if (name != "" && !(name in known)) {
    current = name
    complain("there is no mutation of this name")
  }
  exit failed
}
