# The prose of files, paragraph by paragraph: comments of sources, text of pages. Prints phrases of the list, and
# sentences that begin with What or Who and ask nothing.
#   awk -f plain_words.awk plain_words.txt FILES
FNR == NR {
  if ($0 !~ /^#/ && split($0, part, /  +/) == 2) { phrase[++phrases] = part[1]; cure[phrases] = part[2] }
  next
}
FNR == 1 { finish(); begin_file() }
{
  text = page ? page_text($0) : comment_text($0)
  # A table's row or a list's item is a paragraph of its own, as is a comment behind code.
  if (text == "" || text ~ /^ *([-|] |\|[-|]*$|[0-9]+\. )/ || behind) finish()
  if (text == "") next
  if (paragraph == "") first = FNR
  paragraph = paragraph (paragraph == "" ? "" : "\n") text
  if (behind) finish()
}
END {
  finish()
  print paragraphs + 0 " paragraphs, " phrases " phrases"
  exit failed || paragraphs == 0
}

function begin_file() {
  file = FILENAME
  page = file ~ /\.md$/
  hash = file ~ /\.(sh|cmake|awk|py)$|CMakeLists\.txt$|\/run$/
  code = comment = 0
}

function page_text(line) {
  if (line ~ /^ *```/) { code = !code; return "" }
  return code || line ~ /^(#|    )/ ? "" : line
}

# The comment on a line; sets `behind` if it follows code.
function comment_text(line,   at, mark) {
  behind = 0
  if (comment) {
    if (line ~ /\*\//) { comment = 0; sub(/\*\/.*/, "", line) }
    sub(/^ *\*? ?/, "", line)
    return strip(line)
  }
  mark = hash ? "(^|[ \t])#+ " : file ~ /\.f90$/ ? "!<? " : "//|/\\*+<?"
  if (!match(line, mark)) return ""
  at = RSTART
  behind = substr(line, 1, at - 1) ~ /[^ \t]/
  mark = substr(line, at, RLENGTH)
  line = substr(line, at + RLENGTH)
  if (mark ~ /^\/\*/ && !sub(/\*\/.*/, "", line)) comment = 1
  return strip(line)
}

function strip(text) {
  gsub(/@[a-z]+ +(HSP_[A-Z_]+)? */, "", text)
  sub(/^ *- Property [0-9]+: /, "", text)
  sub(/^ +/, "", text)
  return text
}

function finish(   k, low, rest, from, begin, end) {
  if (paragraph == "") return
  ++paragraphs
  low = " " tolower(paragraph) " "
  gsub(/\n/, " ", low)
  for (k = 1; k <= phrases; ++k)
    if (match(low, "[^a-z](" phrase[k] ")[^a-z]")) complain(RSTART, "\"" substr(low, RSTART + 1, RLENGTH - 2) "\": " cure[k])
  rest = paragraph
  gsub(/\n/, " ", rest)
  from = 1
  while (match(substr(rest, from), /(^|[.:!?|*)`>] |^[0-9]+\. )[*|]*(What|Who|Whoever|Whatever|Whichever) /)) {
    begin = from + RSTART - 1
    end = match(substr(rest, begin + 2), /[.?!|]( |$)/) ? begin + 1 + RSTART : length(rest)
    if (substr(rest, end, 1) != "?") complain(begin, "a sentence that begins so: " substr(rest, begin, 50))
    from = begin + RLENGTH + 5
  }
  paragraph = ""
}

function complain(at, what,   before) {
  before = substr(paragraph, 1, at)
  print file ":" first + gsub(/\n/, "", before) ": " what
  failed = 1
}
