# Applies one mutation:  awk -v name=NAME -v root=TREE -f apply.awk mutations.txt
# Writes the mutated file over the one in TREE. Exit status 3: there is no such mutation, 4: the text that it replaces
# does not stand in the file exactly once.
function finish_part() {
  sub(/\n$/, "", text)
  if (part == "-") before = text
  if (part == "+") after = text
  text = ""
}
/^#/ && !part { next }
/^[a-z][0-9][0-9] / {
  if (found) { finish_part(); part = ""; exit }
  if ($1 == name) { found = 1; file = root "/" $2 }
  next
}
!found { next }
/^- / { part = "-"; text = substr($0, 3) "\n"; next }
/^\+ / || $0 == "+" { finish_part(); part = "+"; text = substr($0, 3) "\n"; next }
$0 != "" { text = text $0 "\n" }
END {
  if (!found) exit 3
  if (part) finish_part()
  whole = ""
  while ((getline line < file) > 0) whole = whole line "\n"
  close(file)
  place = index(whole, before)
  if (before == "" || place == 0) exit 4
  rest = substr(whole, place + length(before))
  if (index(rest, before) > 0) exit 4
  printf "%s", substr(whole, 1, place - 1) after rest > file
}
