# A public header as Doxygen reads it: its opening comment documents the file, the first line in brief and the rest as it
# stands; that of hardsphere.h is the first page.
#   awk -f opening_comment.awk HEADER
FNR == 1 {
  documents = FILENAME ~ /(^|\/)hardsphere\.h$/ ? "@mainpage hardsphere" : "@file"
  sub(/^\/\* /, "/** " documents "\n")
  inside = !sub(/ *\*\/$/, "\n*/")
  print
  if (inside) print "\n@verbatim"
  next
}
inside {
  inside = !sub(/ *\*\/$/, "\n@endverbatim */")
  sub(/^ \* ?/, "")
}
{ print }
