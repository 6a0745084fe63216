# The functions of the header, which comes without comments and directives and on one line, one line each:
#   name result argument:type:way ...
# way: value, in (pointer to const) or inout. Handles and memory are addresses, whatever they point to.

function without_spaces(text) {
  gsub(/^ +| +$/, "", text)
  return text
}

function type_name(text) {
  if (text ~ /^u?int32_t$/) return "int32"
  if (text ~ /^u?int8_t$/) return "int8"
  if (text ~ /^u?int64_t$/) return "int64"
  if (text == "size_t") return "size"
  if (text in functions) return "function"
  return text
}

function is_address(type) {
  return type == "void" || type == "char" || (type in opaque)
}

function argument(text,    name, type, stars, way) {
  text = without_spaces(text)
  way = text ~ /^const / ? "in" : "inout"
  sub(/^const /, "", text)
  stars = gsub(/\*/, " ", text)
  type = text
  name = text
  sub(/ .*/, "", type)
  sub(/.* /, "", name)
  if (is_address(type)) {
    type = "address"
    --stars
  }
  return name ":" type_name(type) ":" (stars == 0 ? "value" : way)
}

{
  rest = $0
  while (match(rest, /typedef struct hsp_[a-z_]+ hsp_[a-z_]+;/)) {
    name = substr(rest, RSTART, RLENGTH - 1)
    sub(/.* /, "", name)
    opaque[name] = 1
    rest = substr(rest, RSTART + RLENGTH)
  }
  rest = $0
  while (match(rest, /typedef [a-z0-9_]+ \(\*hsp_[a-z_]+\)/)) {
    name = substr(rest, RSTART, RLENGTH - 1)
    sub(/.*\*/, "", name)
    functions[name] = 1
    rest = substr(rest, RSTART + RLENGTH)
  }
  rest = $0
  while (match(rest, /HSP_API [^;#]*;/)) {
    text = substr(rest, RSTART + 8, RLENGTH - 9)
    rest = substr(rest, RSTART + RLENGTH)
    open = index(text, "(")
    head = without_spaces(substr(text, 1, open - 1))
    list = substr(text, open + 1, length(text) - open - 1)
    name = head
    sub(/.*[ *]/, "", name)
    line = name " " (head ~ /\*/ ? "address" : type_name(substr(head, 1, index(head, " ") - 1)))
    count = without_spaces(list) == "void" ? 0 : split(list, part, ",")
    for (i = 1; i <= count; ++i) line = line " " argument(part[i])
    print line
  }
}
