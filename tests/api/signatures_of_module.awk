# The functions that the Fortran module binds to C names, in the form of signatures_of_header.awk. An optional argument
# passes by reference as any other does, so that it does not show here.

# Characters are an address, as the address of a handle is: passed by value.
function is_text(text) {
  return text ~ /^character\(kind=c_char\)/
}

function type_name(text) {
  if (text ~ /^integer\(c_int32_t\)/) return "int32"
  if (text ~ /^integer\(c_int8_t\)/) return "int8"
  if (text ~ /^integer\(c_size_t\)/) return "size"
  if (text ~ /^integer\(c_int64_t\)/) return "int64"
  if (text ~ /^real\(c_double\)/) return "double"
  if (text ~ /^type\(c_ptr\)/ || is_text(text)) return "address"
  if (text ~ /^type\(c_funptr\)/) return "function"
  if (text ~ /^type\(hsp_[a-z_]+\)/) return substr(text, 6, index(text, ")") - 6)
  return "?" text
}

{
  sub(/ +!.*/, "")
  sub(/^ +/, "")
}

# A statement that goes on in the next line.
/&$/ {
  sub(/ *&$/, " ")
  begun = begun $0
  next
}
begun != "" {
  $0 = begun $0
  begun = ""
}

/^(pure )?function hsp_.*bind\(C, name=/ {
  sub(/^pure /, "")
  name = $0
  sub(/^function /, "", name)
  sub(/\(.*/, "", name)
  list = substr($0, index($0, "(") + 1)
  result = list
  sub(/\).*/, "", list)
  sub(/^[^)]*\) *result\(/, "", result)
  sub(/\).*/, "", result)
  bound = $0
  sub(/.*name="/, "", bound)
  sub(/".*/, "", bound)
  if (bound != name) name = bound " as " name
  split("", declared)
  inside = 1
  next
}

inside && /::/ && !/^import/ {
  dummy = $0
  sub(/.*:: */, "", dummy)
  sub(/\(.*/, "", dummy)
  # `text(3)` and `text(*)` alike are an address to C
  way = /, value/ || is_text($0) ? "value" : /intent\(in\)/ ? "in" : /intent\(inout\)/ ? "inout" : "result"
  declared[dummy] = type_name($0) ":" way
}

inside && /^end function/ {
  inside = 0
  type = declared[result]
  sub(/:.*/, "", type)
  line = name " " type
  count = split(list, part, /, */)
  for (i = 1; i <= count; ++i) line = line " " part[i] ":" declared[part[i]]
  print line
}
